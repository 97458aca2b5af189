/* SPDX-License-Identifier: MIT */
/* filter.h - pairs of posed triangles: verdicts by doubles, and which of them are uncertain
 * (private; judge.c includes it once for each instruction set). It needs the macros of util/simd.h,
 * SIMD_BITS of a vector of uint64_t. */

typedef double SIMD_NAME(reals) __attribute__((vector_size(8 * SIMD_LANES)));
typedef uint64_t SIMD_NAME(lanes) __attribute__((vector_size(8 * SIMD_LANES)));

#define SIMD_LOAD(v, from) memcpy(&(v), from, sizeof(v))

#define SIMD_NUMBER SIMD_REAL
#define SIMD_OF(x) SIMD_NAME(x##_real)
#define SIMD_TIMES(p, q) ((p) * (q))
#define SIMD_PRISM(g, z) ((g) * (z))
#include "batch/sums.h"

#define SIMD_WHOLE_PRODUCT(p, q) ((p) * (q))
#define SIMD_WHOLE_PRISM(g, z) ((g) * (z))
#define SIMD_BITS_OF(v) SIMD_BITS(v)
#include "batch/whole.h"

SIMD_INLINE SIMD_REAL SIMD_NAME(magnitude)(SIMD_REAL p) {
  return (SIMD_REAL)((SIMD_WHOLE)p & INT64_MAX);
}
SIMD_INLINE SIMD_REAL SIMD_NAME(chosen)(SIMD_WHOLE which, SIMD_REAL p, SIMD_REAL q) {
  return (SIMD_REAL)(((SIMD_WHOLE)p & which) | ((SIMD_WHOLE)q & ~which));
}
SIMD_INLINE SIMD_REAL SIMD_NAME(greater)(SIMD_REAL p, SIMD_REAL q) {
  return SIMD_NAME(chosen)((SIMD_WHOLE)(p > q), p, q);
}
SIMD_INLINE SIMD_REAL SIMD_NAME(lesser)(SIMD_REAL p, SIMD_REAL q) {
  return SIMD_NAME(chosen)((SIMD_WHOLE)(p < q), p, q);
}

/* An edge with ends on different sides of a plane passes all edges p, q, r on one side. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(pierces)(SIMD_REAL from, SIMD_REAL to, SIMD_REAL p, SIMD_REAL q,
                                          SIMD_REAL r) {
  return ((SIMD_WHOLE)from ^ (SIMD_WHOLE)to) &
         ~(((SIMD_WHOLE)p ^ (SIMD_WHOLE)q) | ((SIMD_WHOLE)q ^ (SIMD_WHOLE)r));
}

/* All ones in the lanes in which three numbers have the same sign bit. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(one_side)(const SIMD_REAL v[3]) {
  return ~(((SIMD_WHOLE)v[0] ^ (SIMD_WHOLE)v[1]) | ((SIMD_WHOLE)v[1] ^ (SIMD_WHOLE)v[2]));
}

/* Pose B's vertices and move the origin to A_0. Returns the largest coordinate after that. */
SIMD_INLINE SIMD_REAL SIMD_NAME(load)(SIMD_NAME(coordinate_real) c[3], const double *from,
                                      const placement *at) {
  SIMD_REAL most = {0};
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    SIMD_REAL b[3];
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      SIMD_LOAD(b[i], from + (6 * i + 3 + k) * SIMD_LANES);
    }
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      const double *row = at->linear[i];
      SIMD_LOAD(c[i].a[k], from + (6 * i + k) * SIMD_LANES);
      c[i].b[k] = b[0] * row[0] + b[1] * row[1] + b[2] * row[2] + at->offset[i];
    }
  }
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_REAL origin = c[i].a[0];
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      c[i].a[k] -= origin;
      c[i].b[k] -= origin;
      most = SIMD_NAME(greater)(most, SIMD_NAME(magnitude)(c[i].a[k]));
      most = SIMD_NAME(greater)(most, SIMD_NAME(magnitude)(c[i].b[k]));
    }
  }
  return most;
}

/* Bits of the pairs that collide, and of those that are uncertain. from[(6 i + k) SIMD_LANES + n]
 * is coordinate i of vertex k of pair n, vertices 0 ... 2 A's, 3 ... 5 B's; each of B's is posed
 * here and wrong by up to d = at->error then.
 *
 * With u = 2^-53 and m the largest coordinate from A_0, a difference is wrong by d + u m at most, a
 * trapezoid term, which is up to 4 m^2, by 8 m d + 12 u m^2, orient2d by 24 m d + 60 u m^2, a prism
 * volume by 216 m^2 d + 864 u m^3, and orient3d, four of these, by 864 m^2 d + 5,184 u m^3. An
 * m so large that products overflow, or so small that they lose bits, leaves a pair uncertain.
 *
 * A pair is certain where all signs are; where an edge passes through a triangle by five that are;
 * and where one triangle is on one side of the other's plane by three that are. The others do not
 * matter then, such as those of edges that are parallel.
 *
 * A collision with all signs certain is strict: an edge passes from one side of the other
 * triangle's plane to the other, through the inside of that triangle, and its own triangle has an
 * area, so that points of it near there are in the inside of both. */
SIMD_TARGET static uint32_t SIMD_NAME(judge)(const double *from, const placement *at, bool strict,
                                             uint32_t *uncertain) {
  SIMD_NAME(coordinate_real) c[3];
  SIMD_NAME(orient2d_real) g;
  SIMD_NAME(orient3d_real) v;
  SIMD_REAL most = SIMD_NAME(load)(c, from, at);
  SIMD_NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  SIMD_NAME(find_orient3d_real)(&v, &g, &c[2]);
  SIMD_REAL limit = most * most * (1024 * at->error + 8192 * 0x1p-53 * most);
  SIMD_WHOLE in_range = (SIMD_WHOLE)(most > 0x1p-300) & (SIMD_WHOLE)(most < 0x1p300);
  SIMD_WHOLE sure_s[3];
  SIMD_WHOLE sure_w[3];
  SIMD_WHOLE sure_d[3][3];
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    sure_s[i] = (SIMD_WHOLE)(SIMD_NAME(magnitude)(v.s[i]) > limit);
    sure_w[i] = (SIMD_WHOLE)(SIMD_NAME(magnitude)(v.w[i]) > limit);
    SIMD_UNROLL for (int j = 0; j < 3; j++) {
      sure_d[i][j] = (SIMD_WHOLE)(SIMD_NAME(magnitude)(v.d[i][j]) > limit);
    }
  }
  SIMD_WHOLE all_s = sure_s[0] & sure_s[1] & sure_s[2];
  SIMD_WHOLE all_w = sure_w[0] & sure_w[1] & sure_w[2];
  SIMD_WHOLE all = all_s & all_w;
  SIMD_WHOLE hit = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    SIMD_WHOLE by_a = sure_d[i][0] & sure_d[i][1] & sure_d[i][2] & sure_w[i] & sure_w[n];
    SIMD_WHOLE by_b = sure_d[0][i] & sure_d[1][i] & sure_d[2][i] & sure_s[i] & sure_s[n];
    hit |= by_a & SIMD_NAME(pierces)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]);
    hit |= by_b & SIMD_NAME(pierces)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    all &= by_a;
  }
  SIMD_WHOLE free = (all_s & SIMD_NAME(one_side)(v.s)) | (all_w & SIMD_NAME(one_side)(v.w));
  SIMD_WHOLE certain = all | free | (hit & (strict ? all : ~all));
  *uncertain = ~SIMD_BITS(certain & in_range) & ((1U << SIMD_LANES) - 1);
  return SIMD_BITS(hit);
}

/* -------------------------------------------------------- pairs on a grid */

/* x / grid as a whole number. If it is not whole or too long, then the lane of `off` becomes all
 * ones. */
SIMD_INLINE SIMD_REAL SIMD_NAME(on_grid)(SIMD_REAL x, SIMD_REAL per_grid, SIMD_WHOLE *off) {
  const double SHIFT = 0x1.8p52; /* adding SHIFT rounds x to a whole number */
  SIMD_REAL n = x * per_grid;
  *off |= (SIMD_WHOLE)(n + SHIFT - SHIFT != n) | (SIMD_WHOLE)(SIMD_NAME(magnitude)(n) > 0x1p50);
  return n;
}

/* A factor that brings the largest coordinate, `most`, of each lane into 2^32 ... 2^33. */
SIMD_INLINE SIMD_REAL SIMD_NAME(scale_of)(SIMD_REAL most, SIMD_WHOLE *off) {
  SIMD_WHOLE exponent = (SIMD_WHOLE)most & (UINT64_C(0x7ff) << 52);
  *off |= (SIMD_WHOLE)(most < 0x1p-900) | (SIMD_WHOLE)(most > 0x1p900);
  return (SIMD_REAL)((UINT64_C(2078) << 52) - exponent);
}

SIMD_INLINE SIMD_WHOLE SIMD_NAME(aabbs_disjoint)(const SIMD_NAME(coordinate_real) c[3]) {
  SIMD_WHOLE disjoint = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_REAL low_a = SIMD_NAME(lesser)(SIMD_NAME(lesser)(c[i].a[0], c[i].a[1]), c[i].a[2]);
    SIMD_REAL low_b = SIMD_NAME(lesser)(SIMD_NAME(lesser)(c[i].b[0], c[i].b[1]), c[i].b[2]);
    SIMD_REAL high_a = SIMD_NAME(greater)(SIMD_NAME(greater)(c[i].a[0], c[i].a[1]), c[i].a[2]);
    SIMD_REAL high_b = SIMD_NAME(greater)(SIMD_NAME(greater)(c[i].b[0], c[i].b[1]), c[i].b[2]);
    disjoint |= (SIMD_WHOLE)(high_a < low_b) | (SIMD_WHOLE)(high_b < low_a);
  }
  return disjoint;
}

/* Bits of the pairs that collide, and in `off` of those that are not decided, where the pose turns
 * axes into axes (at->whole). A pair is decided if its coordinates are whole multiples of the grid,
 * a power of two of which the largest coordinate from A_0, m, is less than 2^34 times. orient3d in
 * doubles is wrong by less than 5,184 * 2^-53 (m / grid)^3 < 2^62, orient2d by less (see judge), so
 * that both are known where they are added modulo 2^64, too. */
SIMD_TARGET static __attribute__((noinline)) uint32_t
SIMD_NAME(judge_on_grid)(const double *from, const placement *at, uint32_t *off_bits) {
  SIMD_NAME(coordinate_real) c[3];
  SIMD_NAME(coordinate_whole) whole[3];
  SIMD_NAME(orient2d_real) g;
  SIMD_NAME(orient3d_real) v;
  SIMD_WHOLE off = {0};
  SIMD_REAL scale = SIMD_NAME(scale_of)(SIMD_NAME(load)(c, from, at), &off);
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    SIMD_REAL b[3];
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      SIMD_LOAD(c[i].a[k], from + (6 * i + k) * SIMD_LANES);
      SIMD_LOAD(b[i], from + (6 * i + 3 + k) * SIMD_LANES);
      c[i].a[k] = SIMD_NAME(on_grid)(c[i].a[k], scale, &off);
      b[i] = SIMD_NAME(on_grid)(b[i], scale, &off);
    }
    SIMD_UNROLL for (int i = 0; i < 3; i++) {
      const double *row = at->linear[i];
      SIMD_REAL shift = {0};
      shift = SIMD_NAME(on_grid)(shift + at->offset[i], scale, &off);
      c[i].b[k] = b[0] * row[0] + b[1] * row[1] + b[2] * row[2] + shift;
    }
  }
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_REAL origin = c[i].a[0];
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      const double SHIFT = 0x1.8p52;
      c[i].a[k] -= origin;
      c[i].b[k] -= origin;
      off |= (SIMD_WHOLE)(SIMD_NAME(magnitude)(c[i].a[k]) > 0x1p34) |
             (SIMD_WHOLE)(SIMD_NAME(magnitude)(c[i].b[k]) > 0x1p34);
      whole[i].a[k] = (SIMD_WHOLE)(c[i].a[k] + SHIFT) - (SIMD_WHOLE)((SIMD_REAL){0} + SHIFT);
      whole[i].b[k] = (SIMD_WHOLE)(c[i].b[k] + SHIFT) - (SIMD_WHOLE)((SIMD_REAL){0} + SHIFT);
    }
  }
  SIMD_NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  SIMD_NAME(find_orient3d_real)(&v, &g, &c[2]);
  *off_bits = SIMD_BITS(off);
  uint32_t hits = SIMD_NAME(judge_whole)(whole, &(SIMD_NAME(rough)){c, &g, &v});
  return hits & ~SIMD_BITS(SIMD_NAME(aabbs_disjoint)(c));
}

#undef SIMD_LANES
#undef SIMD_NAME
#undef SIMD_TARGET
#undef SIMD_LOAD
#undef SIMD_BITS
