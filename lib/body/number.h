/* SPDX-License-Identifier: MIT */
/* number.h - a double as an integer times a power of two (private). */
#ifndef SEPAX_NUMBER_H
#define SEPAX_NUMBER_H

#include <stdint.h>
#include <string.h>

/* The value sign * size * 2^exponent with an odd size; all fields are 0 for the value 0. */
typedef struct {
  int sign, exponent;
  uint64_t size;
} number;

static inline number number_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  uint64_t size = bits & ((UINT64_C(1) << 52) - 1);
  int biased = (int)(bits >> 52 & 2047);
  if (biased > 0) {
    size |= UINT64_C(1) << 52;
  }
  if (size == 0) {
    return (number){0, 0, 0};
  }
  int trailing = __builtin_ctzll(size);
  return (number){bits >> 63 != 0 ? -1 : 1, (biased > 0 ? biased : 1) - 1075 + trailing,
                  size >> trailing};
}

#endif
