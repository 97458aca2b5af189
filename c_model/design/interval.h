/* SPDX-License-Identifier: MIT */
/* interval.h - interval analysis: how many bits hold every value. */
#ifndef SEPAX_INTERVAL_H
#define SEPAX_INTERVAL_H

#include "util/wide.h"

typedef struct {
  wide lo, hi;
} interval;

static inline interval interval_hull(interval p, interval q) {
  return (interval){p.lo < q.lo ? p.lo : q.lo, p.hi > q.hi ? p.hi : q.hi};
}

static inline interval difference(interval p, interval q) {
  return (interval){p.lo - q.hi, p.hi - q.lo};
}

static inline interval product(interval p, interval q) {
  wide corner[] = {p.lo * q.lo, p.lo * q.hi, p.hi * q.lo, p.hi * q.hi};
  interval r = {corner[0], corner[0]};
  for (int i = 1; i < 4; i++) {
    r = interval_hull(r, (interval){corner[i], corner[i]});
  }
  return r;
}

static inline interval sum_of_three(interval p) { return (interval){3 * p.lo, 3 * p.hi}; }

/* The least width of a two's complement number that holds all values of the interval. */
static inline int bits_of(interval p) {
  int bits = 1;
  while (p.lo < -((wide)1 << (bits - 1)) || p.hi >= (wide)1 << (bits - 1)) {
    bits++;
  }
  return bits;
}

/* The bits of a coordinate after the AABB test. Coordinates count from the lowest corner of the
 * object with the larger extent. Only pairs pass whose AABBs overlap or are at most the margin
 * apart. So coordinates of this object are at most its extent. Those of the other object lie
 * between minus its extent and the sum of both extents, plus the margin on either side. */
static inline int bits_behind_aabb_test(int64_t extent_a, int64_t extent_b, int64_t margin) {
  int64_t lesser = extent_a < extent_b ? extent_a : extent_b;
  int64_t range = extent_a + extent_b + lesser + 2 * margin;
  int bits = SEPAX_WORD_MIN;
  while (range >> bits != 0) {
    bits++;
  }
  return bits;
}

static inline interval signed_word(int bits) {
  wide half = (wide)1 << (bits - 1);
  return (interval){-half, half - 1};
}

#endif
