/* filter.h - pairs of posed triangles: verdicts by doubles, and which of them are uncertain
 * (private; judge.c includes it once per instruction set).
 *
 * NAME(x), TARGET   a name of its own, the attribute of its functions
 * LANES             pairs at once
 * BITS(v)           sign bits of uint64_t lanes */

typedef double NAME(reals) __attribute__((vector_size(8 * LANES)));
typedef uint64_t NAME(lanes) __attribute__((vector_size(8 * LANES)));

#define R NAME(reals)
#define V NAME(lanes)
#define INLINE TARGET static inline __attribute__((always_inline))
#define LOAD(v, from) memcpy(&(v), from, sizeof(v))

#define NUMBER R
#define OF(x) NAME(x##_real)
#define TIMES(p, q) ((p) * (q))
#define PRISM(g, z) ((g) * (z))
#include "batch/sums.h"

#define WHOLE_PRODUCT(p, q) ((p) * (q))
#define WHOLE_PRISM(g, z) ((g) * (z))
#define BITS_OF(v) BITS(v)
#include "batch/whole.h"

INLINE R NAME(magnitude)(R p) { return (R)((V)p & INT64_MAX); }
INLINE R NAME(chosen)(V which, R p, R q) { return (R)(((V)p & which) | ((V)q & ~which)); }
INLINE R NAME(greater)(R p, R q) { return NAME(chosen)((V)(p > q), p, q); }
INLINE R NAME(lesser)(R p, R q) { return NAME(chosen)((V)(p < q), p, q); }

/* An edge with ends on different sides of a plane passes all edges p, q, r on one side. */
INLINE V NAME(pierces)(R from, R to, R p, R q, R r) {
  return ((V)from ^ (V)to) & ~(((V)p ^ (V)q) | ((V)q ^ (V)r));
}

/* The sign bits of three numbers are the same. */
INLINE V NAME(one_side)(const R v[3]) { return ~(((V)v[0] ^ (V)v[1]) | ((V)v[1] ^ (V)v[2])); }

/* B's vertices are posed, then A_0 becomes the origin; the largest coordinate then. */
INLINE R NAME(load)(NAME(coordinate_real) c[3], const double *from, const placement *at) {
  R most = {0};
  UNROLL for (int k = 0; k < 3; k++) {
    R b[3];
    UNROLL for (int i = 0; i < 3; i++) { LOAD(b[i], from + (6 * i + 3 + k) * LANES); }
    UNROLL for (int i = 0; i < 3; i++) {
      const double *row = at->linear[i];
      LOAD(c[i].a[k], from + (6 * i + k) * LANES);
      c[i].b[k] = b[0] * row[0] + b[1] * row[1] + b[2] * row[2] + at->offset[i];
    }
  }
  UNROLL for (int i = 0; i < 3; i++) {
    R origin = c[i].a[0];
    UNROLL for (int k = 0; k < 3; k++) {
      c[i].a[k] -= origin;
      c[i].b[k] -= origin;
      most = NAME(greater)(most, NAME(magnitude)(c[i].a[k]));
      most = NAME(greater)(most, NAME(magnitude)(c[i].b[k]));
    }
  }
  return most;
}

/* Bits of the pairs that collide, and of those that are uncertain. from[(6 i + k) LANES + n] is
 * coordinate i of vertex k of pair n, vertices 0 ... 2 A's, 3 ... 5 B's; each of B's is posed here
 * and wrong by up to d = at->error then.
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
TARGET static uint32_t NAME(judge)(const double *from, const placement *at, bool strict,
                                   uint32_t *uncertain) {
  NAME(coordinate_real) c[3];
  NAME(orient2d_real) g;
  NAME(orient3d_real) v;
  R most = NAME(load)(c, from, at);
  NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  NAME(find_orient3d_real)(&v, &g, &c[2]);
  R limit = most * most * (1024 * at->error + 8192 * 0x1p-53 * most);
  V in_range = (V)(most > 0x1p-300) & (V)(most < 0x1p300);
  V sure_s[3];
  V sure_w[3];
  V sure_d[3][3];
  UNROLL for (int i = 0; i < 3; i++) {
    sure_s[i] = (V)(NAME(magnitude)(v.s[i]) > limit);
    sure_w[i] = (V)(NAME(magnitude)(v.w[i]) > limit);
    UNROLL for (int j = 0; j < 3; j++) { sure_d[i][j] = (V)(NAME(magnitude)(v.d[i][j]) > limit); }
  }
  V all_s = sure_s[0] & sure_s[1] & sure_s[2];
  V all_w = sure_w[0] & sure_w[1] & sure_w[2];
  V all = all_s & all_w;
  V hit = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    V by_a = sure_d[i][0] & sure_d[i][1] & sure_d[i][2] & sure_w[i] & sure_w[n];
    V by_b = sure_d[0][i] & sure_d[1][i] & sure_d[2][i] & sure_s[i] & sure_s[n];
    hit |= by_a & NAME(pierces)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]);
    hit |= by_b & NAME(pierces)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    all &= by_a;
  }
  V free = (all_s & NAME(one_side)(v.s)) | (all_w & NAME(one_side)(v.w));
  V certain = all | free | (hit & (strict ? all : ~all));
  *uncertain = ~BITS(certain & in_range) & ((1U << LANES) - 1);
  return BITS(hit);
}

/* -------------------------------------------------------- pairs on a grid */

/* The whole number x / grid; the lanes of `off` become all ones where it is none, or too long. */
INLINE R NAME(on_grid)(R x, R per_grid, V *off) {
  const double SHIFT = 0x1.8p52; /* x + SHIFT is rounded to a whole number */
  R n = x * per_grid;
  *off |= (V)(n + SHIFT - SHIFT != n) | (V)(NAME(magnitude)(n) > 0x1p50);
  return n;
}

/* What makes the largest coordinate, `most`, of each lane 2^32 ... 2^33. */
INLINE R NAME(scale_of)(R most, V *off) {
  V exponent = (V)most & (UINT64_C(0x7ff) << 52);
  *off |= (V)(most < 0x1p-900) | (V)(most > 0x1p900);
  return (R)((UINT64_C(2078) << 52) - exponent);
}

INLINE V NAME(aabbs_disjoint)(const NAME(coordinate_real) c[3]) {
  V disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    R low_a = NAME(lesser)(NAME(lesser)(c[i].a[0], c[i].a[1]), c[i].a[2]);
    R low_b = NAME(lesser)(NAME(lesser)(c[i].b[0], c[i].b[1]), c[i].b[2]);
    R high_a = NAME(greater)(NAME(greater)(c[i].a[0], c[i].a[1]), c[i].a[2]);
    R high_b = NAME(greater)(NAME(greater)(c[i].b[0], c[i].b[1]), c[i].b[2]);
    disjoint |= (V)(high_a < low_b) | (V)(high_b < low_a);
  }
  return disjoint;
}

/* Bits of the pairs that collide, and in `off` of those that are not decided, where the pose turns
 * axes into axes (at->whole). A pair is decided if its coordinates are whole multiples of the grid,
 * a power of two of which the largest coordinate from A_0, m, is less than 2^34 times. orient3d in
 * doubles is wrong by less than 5,184 * 2^-53 (m / grid)^3 < 2^62, orient2d by less (see judge), so
 * that both are known where they are added modulo 2^64, too. */
TARGET static __attribute__((noinline)) uint32_t
NAME(judge_on_grid)(const double *from, const placement *at, uint32_t *off_bits) {
  NAME(coordinate_real) c[3];
  NAME(coordinate_whole) whole[3];
  NAME(orient2d_real) g;
  NAME(orient3d_real) v;
  V off = {0};
  R scale = NAME(scale_of)(NAME(load)(c, from, at), &off);
  UNROLL for (int k = 0; k < 3; k++) {
    R b[3];
    UNROLL for (int i = 0; i < 3; i++) {
      LOAD(c[i].a[k], from + (6 * i + k) * LANES);
      LOAD(b[i], from + (6 * i + 3 + k) * LANES);
      c[i].a[k] = NAME(on_grid)(c[i].a[k], scale, &off);
      b[i] = NAME(on_grid)(b[i], scale, &off);
    }
    UNROLL for (int i = 0; i < 3; i++) {
      const double *row = at->linear[i];
      R shift = {0};
      shift = NAME(on_grid)(shift + at->offset[i], scale, &off);
      c[i].b[k] = b[0] * row[0] + b[1] * row[1] + b[2] * row[2] + shift;
    }
  }
  UNROLL for (int i = 0; i < 3; i++) {
    R origin = c[i].a[0];
    UNROLL for (int k = 0; k < 3; k++) {
      const double SHIFT = 0x1.8p52;
      c[i].a[k] -= origin;
      c[i].b[k] -= origin;
      off |= (V)(NAME(magnitude)(c[i].a[k]) > 0x1p34) | (V)(NAME(magnitude)(c[i].b[k]) > 0x1p34);
      whole[i].a[k] = (V)(c[i].a[k] + SHIFT) - (V)((R){0} + SHIFT);
      whole[i].b[k] = (V)(c[i].b[k] + SHIFT) - (V)((R){0} + SHIFT);
    }
  }
  NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  NAME(find_orient3d_real)(&v, &g, &c[2]);
  *off_bits = BITS(off);
  uint32_t hits = NAME(judge_whole)(whole, &(NAME(rough)){c, &g, &v});
  return hits & ~BITS(NAME(aabbs_disjoint)(c));
}

#undef R
#undef V
#undef INLINE
#undef LANES
#undef NAME
#undef TARGET
#undef LOAD
#undef BITS
