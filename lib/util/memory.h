/* SPDX-License-Identifier: MIT */
/* memory.h - memory of the allocator that the caller brought (private). */
#ifndef SEPAX_MEMORY_H
#define SEPAX_MEMORY_H

#include "sepax.h"

#include <string.h>

/* `count` elements of `bytes` each, all zero; NULL without memory. */
static inline void *sepax__zeroed(size_t count, size_t bytes) {
  if (bytes != 0 && count > SIZE_MAX / bytes) {
    return NULL;
  }
  void *memory = sepax_allocate(count * bytes);
  return memory != NULL ? memset(memory, 0, count * bytes) : NULL;
}

#endif
