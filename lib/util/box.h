/* SPDX-License-Identifier: MIT */
/* box.h - boxes of four floats, the last of which does not belong to the box; and least and most of
 * two doubles at once (private). */
#ifndef SEPAX_BOX_H
#define SEPAX_BOX_H

#include <float.h>
#include <stdbool.h>
#include <stdint.h>

#if defined __SSE2__
#include <emmintrin.h>
#endif

typedef float corner __attribute__((vector_size(16)));
typedef int32_t corner_bits __attribute__((vector_size(16)));

typedef double real_pair __attribute__((vector_size(16)));
typedef int64_t real_pair_bits __attribute__((vector_size(16)));

typedef struct {
  corner low, high;
} box4;

#if defined __SSE2__
static inline corner corner_least(corner p, corner q) { return _mm_min_ps(p, q); }
static inline corner corner_most(corner p, corner q) { return _mm_max_ps(p, q); }
static inline int corner_signs(corner_bits v) { return _mm_movemask_ps((__m128)v); }
static inline real_pair real_pair_least(real_pair p, real_pair q) { return _mm_min_pd(p, q); }
static inline real_pair real_pair_most(real_pair p, real_pair q) { return _mm_max_pd(p, q); }
#else
static inline corner corner_chosen(corner_bits which, corner p, corner q) {
  return (corner)(((corner_bits)p & which) | ((corner_bits)q & ~which));
}
static inline corner corner_least(corner p, corner q) { return corner_chosen(p < q, p, q); }
static inline corner corner_most(corner p, corner q) { return corner_chosen(p > q, p, q); }
static inline int corner_signs(corner_bits v) {
  return (v[0] < 0) | (v[1] < 0) << 1 | (v[2] < 0) << 2 | (v[3] < 0) << 3;
}
static inline real_pair real_pair_chosen(real_pair_bits which, real_pair p, real_pair q) {
  return (real_pair)(((real_pair_bits)p & which) | ((real_pair_bits)q & ~which));
}
static inline real_pair real_pair_least(real_pair p, real_pair q) {
  return real_pair_chosen(p < q, p, q);
}
static inline real_pair real_pair_most(real_pair p, real_pair q) {
  return real_pair_chosen(p > q, p, q);
}
#endif

/* A number that is carried in the fourth float. */
static inline uint32_t box4_number(const box4 *b) { return (uint32_t)((corner_bits)b->low)[3]; }
static inline void box4_set_number(box4 *b, uint32_t number) {
  corner_bits low = (corner_bits)b->low;
  low[3] = (int32_t)number;
  b->low = (corner)low;
}

/* The box of nothing. */
static inline box4 box4_of_none(void) {
  return (box4){{FLT_MAX, FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX, -FLT_MAX}};
}

static inline void box4_enclose(box4 *b, const box4 *other) {
  b->low = corner_least(b->low, other->low);
  b->high = corner_most(b->high, other->high);
}

static inline bool box4_disjoint(const box4 *a, const box4 *b) {
  return (corner_signs((a->low > b->high) | (b->low > a->high)) & 7) != 0;
}

static inline int box4_longest_axis(const box4 *b) {
  corner size = b->high - b->low;
  int axis = size[1] > size[0] ? 1 : 0;
  return size[2] > size[axis] ? 2 : axis;
}

#endif
