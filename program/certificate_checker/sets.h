/* SPDX-License-Identifier: MIT */
/* sets.h - disjoint sets of numbers. */
#ifndef CERTIFICATE_SETS_H
#define CERTIFICATE_SETS_H

#include <stddef.h>

/* No number. */
#define NONE ((size_t)-1)

/* The number that stands for the set of n. up[n] == n at the beginning: each is a set of its own.
 */
static inline size_t root_of(size_t *up, size_t n) {
  while (up[n] != n)
    n = up[n] = up[up[n]];
  return n;
}

static inline void unite(size_t *up, size_t a, size_t b) { up[root_of(up, a)] = root_of(up, b); }

#endif
