/* SPDX-License-Identifier: MIT */
/* bytes.c - memset and memcpy, to which the compiler makes calls, for firmware without a C
 * library. The bytes are volatile, or the compiler would make a call to memset of its loop. */
#include "bytes.h"

#include <stdint.h>

void *memset(void *to, int value, size_t count) {
  volatile uint8_t *byte = to;
  while (count-- > 0) {
    *byte++ = (uint8_t)value;
  }
  return to;
}

void *memcpy(void *restrict to, const void *restrict from, size_t count) {
  volatile uint8_t *byte = to;
  const uint8_t *next = from;
  while (count-- > 0) {
    *byte++ = *next++;
  }
  return to;
}
