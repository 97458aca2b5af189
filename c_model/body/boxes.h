/* boxes.h - one box in a pose against the eight boxes of a node, and the filter of pairs of
 * triangles (private; query.c includes it once per instruction set).
 *
 * NAME(x), TARGET   a name of its own, the attribute of its functions
 * FLOATS, LANES     boxes, pairs of triangles at once
 * BITS(v), REAL_BITS(v)  sign bits of int32_t, of uint64_t lanes */

typedef float NAME(floats) __attribute__((vector_size(4 * FLOATS)));
typedef int32_t NAME(masks) __attribute__((vector_size(4 * FLOATS)));
typedef double NAME(reals) __attribute__((vector_size(8 * LANES)));
typedef uint64_t NAME(lanes) __attribute__((vector_size(8 * LANES)));

#define F NAME(floats)
#define M NAME(masks)
#define R NAME(reals)
#define V NAME(lanes)
#define INLINE TARGET static inline __attribute__((always_inline))

#define LOAD(v, from) memcpy(&(v), from, sizeof(v))
#define SIZE(v) ((F)((M)(v)&INT32_MAX))

/* Bit k: the posed box may meet child k. */
TARGET static uint32_t NAME(overlaps)(const body_node *node, const posed_box *p) {
  uint32_t bits = 0;
  for (int n = 0; n < BODY_WIDE; n += FLOATS) {
    F t[3];
    F half[3];
    M disjoint = {0};
    UNROLL for (int i = 0; i < 3; i++) {
      LOAD(t[i], node->centre[i] + n);
      LOAD(half[i], node->half[i] + n);
      t[i] -= p->centre[i];
      disjoint |= SIZE(t[i]) > half[i] + p->reach[i];
    }
    UNROLL for (int k = 0; k < 3; k++) {
      const float *axis = p->axis[k];
      F along = t[0] * axis[0] + t[1] * axis[1] + t[2] * axis[2] - p->along[k];
      F reach = half[0] * fabsf(axis[0]) + half[1] * fabsf(axis[1]) + half[2] * fabsf(axis[2]);
      disjoint |= SIZE(along) > reach + p->own[k];
    }
    bits |= BITS(disjoint) << n;
  }
  return ~bits & ((1U << node->children) - 1);
}

/* ------------------------------------------------------- pairs of triangles */

#define NUMBER R
#define OF(x) NAME(x##_posed)
#define TIMES(p, q) ((p) * (q))
#define PRISM(g, z) ((g) * (z))
#include "batch/sums.h"

INLINE R NAME(magnitude)(R p) { return (R)((V)p & INT64_MAX); }
INLINE R NAME(chosen)(V which, R p, R q) { return (R)(((V)p & which) | ((V)q & ~which)); }
INLINE R NAME(greater)(R p, R q) { return NAME(chosen)((V)(p > q), p, q); }
INLINE R NAME(lesser)(R p, R q) { return NAME(chosen)((V)(p < q), p, q); }

/* An edge with ends on different sides of a plane passes all edges p, q, r on one side. */
INLINE V NAME(pierces)(R from, R to, R p, R q, R r) {
  return ((V)from ^ (V)to) & ~(((V)p ^ (V)q) | ((V)q ^ (V)r));
}

/* A_0 becomes the origin; the largest coordinate then. */
INLINE R NAME(load)(NAME(coordinate_posed) c[3], const double *from) {
  R most = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    R origin;
    LOAD(origin, from + 6 * i * LANES);
    UNROLL for (int k = 0; k < 3; k++) {
      LOAD(c[i].a[k], from + (6 * i + k) * LANES);
      LOAD(c[i].b[k], from + (6 * i + 3 + k) * LANES);
      c[i].a[k] -= origin;
      c[i].b[k] -= origin;
      most = NAME(greater)(most, NAME(magnitude)(c[i].a[k]));
      most = NAME(greater)(most, NAME(magnitude)(c[i].b[k]));
    }
  }
  return most;
}

/* Bits of the pairs that collide, and of those that are uncertain. from[(6 i + k) LANES + n] is
 * coordinate i of vertex k of pair n, vertices 0 ... 2 A's, 3 ... 5 B's; each of B's is wrong by up
 * to d = `error`.
 *
 * With u = 2^-53 and m the largest coordinate from A_0, a difference is wrong by d + u m at most, a
 * trapezoid term, which is up to 4 m^2, by 8 m d + 12 u m^2, orient2d by 24 m d + 60 u m^2, a prism
 * volume by 216 m^2 d + 864 u m^3, and orient3d, four of these, by 864 m^2 d + 5,184 u m^3.
 *
 * A certain collision is strict: an edge passes from one side of the other triangle's plane to the
 * other, through the inside of that triangle, so that the points of its own triangle near there are
 * in the inside of both. */
TARGET static uint32_t NAME(judge)(const double *from, double error, uint32_t *uncertain) {
  NAME(coordinate_posed) c[3];
  NAME(orient2d_posed) g;
  NAME(orient3d_posed) v;
  R most = NAME(load)(c, from);
  NAME(find_orient2d_posed)(&g, &c[0], &c[1]);
  NAME(find_orient3d_posed)(&v, &g, &c[2]);
  R least = NAME(magnitude)(v.s[0]);
  V hit = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    hit |= NAME(pierces)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]) |
           NAME(pierces)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    least = NAME(lesser)(least, NAME(magnitude)(v.s[i]));
    least = NAME(lesser)(least, NAME(magnitude)(v.w[i]));
    UNROLL for (int j = 0; j < 3; j++) { least = NAME(lesser)(least, NAME(magnitude)(v.d[i][j])); }
  }
  R limit = most * most * (1024 * error + 8192 * 0x1p-53 * most);
  *uncertain = ~REAL_BITS((V)(least > limit)) & ((1U << LANES) - 1);
  return REAL_BITS(hit);
}

#undef F
#undef M
#undef R
#undef V
#undef INLINE
#undef LANES
#undef NAME
#undef TARGET
#undef LOAD
#undef SIZE
#undef BITS
#undef REAL_BITS
#undef FLOATS
