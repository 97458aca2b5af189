/* SPDX-License-Identifier: MIT */
/* random.c - the random numbers of the families: splitmix64, and uniform integers of a range. */
#include "sepax_vectors.h"

#include <assert.h>

typedef unsigned __int128 uwide;

uint64_t sepax_random_next(sepax_random *random) {
  random->state += UINT64_C(0x9e3779b97f4a7c15);
  uint64_t z = random->state;
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/* Lemire's method: the high half of a product, rejecting the surplus values. */
int64_t sepax_random_range(sepax_random *random, int64_t lo, int64_t hi) {
  assert(lo <= hi);
  uint64_t width = (uint64_t)hi - (uint64_t)lo;
  uint64_t draw = sepax_random_next(random);
  if (width == UINT64_MAX) {
    return (int64_t)draw;
  }
  uint64_t span = width + 1;
  uwide product = (uwide)draw * span;
  if ((uint64_t)product < span) {
    uint64_t surplus = (0 - span) % span;
    while ((uint64_t)product < surplus) {
      product = (uwide)sepax_random_next(random) * span;
    }
  }
  return (int64_t)((uint64_t)lo + (uint64_t)(product >> 64));
}
