/* SPDX-License-Identifier: MIT */
/* lanes.h - the exact verdicts of SIMD_LANES pairs at once (private; pairs.c includes it once for
 * each instruction set). Beyond the macros of util/simd.h:
 *
 * SIMD_LOAD(from)          the next SIMD_LANES int32_t, sign-extended
 * SIMD_LOAD_REALS(from)    the same as doubles
 * SIMD_PRODUCT(p, q)       product of the low 32 bits of each lane, signed. It may be undefined:
 *                          then sepax_exact judges the pairs that doubles leave uncertain
 * SIMD_LEAST_REAL(p, q)    the lesser of doubles
 * SIMD_BITS_OF_SHORTS(v)   the sign bits of a vector of int32_t as a number
 * SIMD_LEAST(p, q)         the lesser int32_t
 * SIMD_MOST(p, q)          the greater int32_t
 *
 * In doubles all products and sums of coordinates of 25 bits are exact, up to orient2d. The 19
 * products of orient2d and z sums round, and so do orient3d, their sums of up to four. With
 * orient2d up to 2^(2n) and sums of z up to 6 * 2^(n-1) they round by less than 2^12 in all if
 * coordinates have n = 20 bits, by less than 2^28 for n = 25. Where all 15 orient3d are larger,
 * their signs are certain. Elsewhere they are summed modulo 2^64: with 20 bits that is all of them;
 * with 25 bits the doubles give the sign of those from 2^62 upwards. */

typedef uint64_t SIMD_NAME(lanes) __attribute__((vector_size(8 * SIMD_LANES)));
typedef int64_t SIMD_NAME(signed_lanes) __attribute__((vector_size(8 * SIMD_LANES)));
typedef double SIMD_NAME(reals) __attribute__((vector_size(8 * SIMD_LANES)));
typedef int32_t SIMD_NAME(shorts) __attribute__((vector_size(8 * SIMD_LANES)));
enum { SIMD_NAME(SHORT_LANES) = 2 * SIMD_LANES };

/* -------------------------------------------------------------------- sums */

#ifdef SIMD_PRODUCT
/* The product modulo 2^64. z fits 32 bits, but g need not. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(prism)(SIMD_WHOLE g, SIMD_WHOLE z) {
  return SIMD_PRODUCT(g, z) + (SIMD_PRODUCT((g + (UINT64_C(1) << 31)) >> 32, z) << 32);
}

#endif

#define SIMD_NUMBER SIMD_REAL
#define SIMD_OF(x) SIMD_NAME(x##_real)
#define SIMD_TIMES(p, q) ((p) * (q))
#define SIMD_PRISM(g, z) ((g) * (z))
#include "sums.h"

SIMD_INLINE SIMD_REAL SIMD_NAME(all_real)(int32_t value) { return (SIMD_REAL){0} + (double)value; }

SIMD_INLINE void SIMD_NAME(find_real)(SIMD_NAME(orient3d_real) * v, const sepax_tri *one,
                                      const block *in, size_t at) {
  SIMD_NAME(coordinate_real) c[3];
  SIMD_UNROLL for (int axis = 0; axis < 3; axis++) {
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      c[axis].a[k] = one != NULL ? SIMD_NAME(all_real)(coordinate(one, k, axis))
                                 : SIMD_LOAD_REALS(in->a[k][axis] + at);
      c[axis].b[k] = SIMD_LOAD_REALS(in->b[k][axis] + at);
    }
  }
  SIMD_NAME(orient2d_real) g;
  SIMD_NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  SIMD_NAME(find_orient3d_real)(v, &g, &c[2]);
}

/* ------------------------------------------------------- verdicts by doubles */

SIMD_INLINE SIMD_REAL SIMD_NAME(least_size)(SIMD_REAL least, SIMD_REAL value) {
  return SIMD_LEAST_REAL(least, (SIMD_REAL)((SIMD_WHOLE)value & INT64_MAX));
}

/* An edge with ends on different sides of a plane passes all edges p, q, r on one side. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(pierces)(SIMD_REAL from, SIMD_REAL to, SIMD_REAL p, SIMD_REAL q,
                                          SIMD_REAL r) {
  return ((SIMD_WHOLE)from ^ (SIMD_WHOLE)to) &
         ~(((SIMD_WHOLE)p ^ (SIMD_WHOLE)q) | ((SIMD_WHOLE)q ^ (SIMD_WHOLE)r));
}

/* Judge by doubles. Returns the bits of the colliding pairs; *uncertain receives the bits of pairs
 * with an uncertain sign. */
SIMD_INLINE uint32_t SIMD_NAME(judge_large)(const sepax_tri *one, const block *in, size_t at,
                                            double limit, uint32_t *uncertain) {
  SIMD_NAME(orient3d_real) v;
  SIMD_NAME(find_real)(&v, one, in, at);
  SIMD_REAL least = (SIMD_REAL)((SIMD_WHOLE)v.s[0] & INT64_MAX);
  SIMD_WHOLE hit = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    hit |= SIMD_NAME(pierces)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]) |
           SIMD_NAME(pierces)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    least = SIMD_NAME(least_size)(SIMD_NAME(least_size)(least, v.s[i]), v.w[i]);
    SIMD_UNROLL for (int j = 0; j < 3; j++) { least = SIMD_NAME(least_size)(least, v.d[i][j]); }
  }
  *uncertain = SIMD_BITS((SIMD_WHOLE)(least - limit));
  return SIMD_BITS(hit);
}

/* ------------------------------------------------- verdicts by whole numbers */

#ifdef SIMD_PRODUCT
#define SIMD_WHOLE_PRODUCT(p, q) SIMD_PRODUCT(p, q)
#define SIMD_WHOLE_PRISM(g, z) SIMD_NAME(prism)(g, z)
#define SIMD_BITS_OF(v) SIMD_BITS(v)
#include "whole.h"

SIMD_INLINE SIMD_WHOLE SIMD_NAME(all)(int32_t value) { return (SIMD_WHOLE){0} + (uint64_t)value; }

SIMD_INLINE void SIMD_NAME(load_whole)(SIMD_NAME(coordinate_whole) c[3], const sepax_tri *one,
                                       const block *in, size_t at) {
  SIMD_UNROLL for (int axis = 0; axis < 3; axis++) {
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      c[axis].a[k] =
          one != NULL ? SIMD_NAME(all)(coordinate(one, k, axis)) : SIMD_LOAD(in->a[k][axis] + at);
      c[axis].b[k] = SIMD_LOAD(in->b[k][axis] + at);
    }
  }
}

/* Judge pairs whose AABBs overlap. Returns the bits of the colliding pairs. */
SIMD_INLINE uint32_t SIMD_NAME(judge)(const sepax_tri *one, const block *in, size_t at,
                                      const SIMD_NAME(orient3d_real) * rough) {
  SIMD_NAME(coordinate_whole) c[3];
  SIMD_NAME(load_whole)(c, one, in, at);
  return SIMD_NAME(judge_whole)(c, &(SIMD_NAME(rough)){NULL, NULL, rough});
}

SIMD_TARGET static __attribute__((noinline)) uint32_t
SIMD_NAME(judge_long)(const sepax_tri *one, const block *in, size_t at) {
  SIMD_NAME(orient3d_real) rough;
  SIMD_NAME(find_real)(&rough, one, in, at);
  return SIMD_NAME(judge)(one, in, at, &rough);
}

/* Judge a group by whole numbers. Only the verdicts of `uncertain` are used. */
SIMD_INLINE uint32_t SIMD_NAME(judge_small)(const sepax_tri *one, const block *in, size_t at,
                                            bool is_long, uint32_t uncertain) {
  (void)uncertain;
  return is_long ? SIMD_NAME(judge_long)(one, in, at) : SIMD_NAME(judge)(one, in, at, NULL);
}
#else
SIMD_INLINE uint32_t SIMD_NAME(judge_small)(const sepax_tri *one, const block *in, size_t at,
                                            bool is_long, uint32_t uncertain) {
  (void)is_long;
  return (uint32_t)(judge_singly(one, in, (uint64_t)uncertain << at) >> at);
}
#endif

/* ------------------------------------------------------------------- blocks */

typedef struct {
  SIMD_SHORT least, most; /* least and greatest of all coordinates */
} SIMD_NAME(ends);

SIMD_INLINE SIMD_SHORT SIMD_NAME(short_all)(int32_t value) { return (SIMD_SHORT){0} + value; }

SIMD_INLINE SIMD_SHORT SIMD_NAME(short_load)(const int32_t *from) {
  SIMD_SHORT shorts;
  memcpy(&shorts, from, sizeof shorts);
  return shorts;
}

SIMD_INLINE SIMD_SHORT SIMD_NAME(disjoint)(const SIMD_SHORT p[3], const SIMD_SHORT q[3],
                                           SIMD_NAME(ends) * ends) {
  SIMD_SHORT low_p = SIMD_LEAST(SIMD_LEAST(p[0], p[1]), p[2]);
  SIMD_SHORT low_q = SIMD_LEAST(SIMD_LEAST(q[0], q[1]), q[2]);
  SIMD_SHORT high_p = SIMD_MOST(SIMD_MOST(p[0], p[1]), p[2]);
  SIMD_SHORT high_q = SIMD_MOST(SIMD_MOST(q[0], q[1]), q[2]);
  ends->least = SIMD_LEAST(ends->least, SIMD_LEAST(low_p, low_q));
  ends->most = SIMD_MOST(ends->most, SIMD_MOST(high_p, high_q));
  return (SIMD_SHORT)((high_p < low_q) | (high_q < low_p));
}

/* Returns the bits of the pairs of a block whose AABBs overlap. *longest receives a number that has
 * as many bits as the longest coordinate. */
SIMD_INLINE uint64_t SIMD_NAME(aabbs_overlap)(const sepax_tri *one, const block *in,
                                              uint32_t *longest) {
  SIMD_NAME(ends) ends;
  ends.least = ends.most = (SIMD_SHORT){0};
  uint64_t disjoint = 0;
  for (size_t m = 0; m < BLOCK; m += SIMD_NAME(SHORT_LANES)) {
    SIMD_SHORT any = {0};
    SIMD_UNROLL for (int axis = 0; axis < 3; axis++) {
      SIMD_SHORT p[3];
      SIMD_SHORT q[3];
      SIMD_UNROLL for (int k = 0; k < 3; k++) {
        p[k] = one != NULL ? SIMD_NAME(short_all)(coordinate(one, k, axis))
                           : SIMD_NAME(short_load)(in->a[k][axis] + m);
        q[k] = SIMD_NAME(short_load)(in->b[k][axis] + m);
      }
      any |= SIMD_NAME(disjoint)(p, q, &ends);
    }
    disjoint |= (uint64_t)SIMD_BITS_OF_SHORTS(any) << m;
  }
  int32_t sizes[SIMD_NAME(SHORT_LANES)];
  SIMD_SHORT size = SIMD_MOST(ends.most, ~ends.least);
  memcpy(sizes, &size, sizeof size);
  *longest = 0;
  for (int k = 0; k < SIMD_NAME(SHORT_LANES); k++) {
    *longest |= (uint32_t)sizes[k];
  }
  return ~disjoint;
}

/* Judge a block. Doubles are tried first while they settle most groups of the block. */
SIMD_INLINE uint64_t SIMD_NAME(judge_block)(const sepax_tri *one, const block *in) {
  const uint64_t group = (UINT64_C(1) << SIMD_LANES) - 1;
  uint32_t longest;
  uint64_t candidates = SIMD_NAME(aabbs_overlap)(one, in, &longest);
  if (candidates == 0) {
    return 0;
  }
  if (longest >> LONG_BITS != 0) {
    return judge_singly(one, in, candidates);
  }
  bool is_long = longest >> SHORT_BITS != 0;
  double limit = is_long ? LONG_LIMIT : SHORT_LIMIT;
  uint64_t hits = 0;
  size_t tried = 0;
  size_t failed = 0;
  for (size_t m = 0; m < BLOCK; m += SIMD_LANES) {
    uint32_t wanted = (uint32_t)(candidates >> m & group);
    if (wanted == 0) {
      continue;
    }
    uint32_t found = 0;
    uint32_t uncertain = wanted;
    if (failed * 3 <= tried) {
      found = SIMD_NAME(judge_large)(one, in, m, limit, &uncertain);
      uncertain &= wanted;
      tried++;
      failed += uncertain != 0;
    }
    if (uncertain != 0) {
      found = (found & ~uncertain) |
              (uncertain & SIMD_NAME(judge_small)(one, in, m, is_long, uncertain));
    }
    hits |= (uint64_t)found << m;
  }
  return hits & candidates;
}

SIMD_TARGET static uint64_t SIMD_NAME(judge_pairs)(const block *in) {
  return SIMD_NAME(judge_block)(NULL, in);
}

SIMD_TARGET static uint64_t SIMD_NAME(judge_one)(const sepax_tri *one, const block *in) {
  return SIMD_NAME(judge_block)(one, in);
}

#undef SIMD_LANES
#undef SIMD_NAME
#undef SIMD_TARGET
#undef SIMD_LOAD
#undef SIMD_LOAD_REALS
#undef SIMD_PRODUCT
#undef SIMD_LEAST_REAL
#undef SIMD_BITS
#undef SIMD_BITS_OF_SHORTS
#undef SIMD_LEAST
#undef SIMD_MOST
