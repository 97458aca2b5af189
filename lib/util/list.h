/* SPDX-License-Identifier: MIT */
/* list.h - lists that grow (private). */
#ifndef SEPAX_LIST_H
#define SEPAX_LIST_H

#include "sepax.h"

#include <stdlib.h>

/* Make room for one more element in the list `items` of `count` elements of `size` bytes. If count
 * == *capacity, then the list is moved and twice as long. Returns NULL without memory or if the
 * bytes exceed size_t; `items` and `*capacity` are then unchanged. An empty list is NULL with
 * capacity 0. */
static inline void *list_grow(void *items, size_t *capacity, size_t count, size_t size) {
  enum { FIRST = 256 };
  if (count < *capacity) {
    return items;
  }
  size_t more = *capacity == 0 ? FIRST : 2 * *capacity;
  if (*capacity > SIZE_MAX / 2 || more > SIZE_MAX / size) {
    return NULL;
  }
  void *grown = sepax_resize(items, more * size);
  *capacity = grown != NULL ? more : *capacity;
  return grown;
}

/* Append the pair (i, j); false without memory. */
static inline bool list_add_pair(sepax_pairs *pairs, size_t *capacity, size_t i, size_t j) {
  size_t(*grown)[2] = list_grow(pairs->pair, capacity, pairs->count, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  pairs->pair = grown;
  pairs->pair[pairs->count][0] = i;
  pairs->pair[pairs->count++][1] = j;
  return true;
}

#endif
