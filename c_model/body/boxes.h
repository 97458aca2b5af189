/* boxes.h - one box in a pose against the eight boxes of a node, and the filter of pairs of
 * triangles (private; query.c includes it once per instruction set).
 *
 * NAME(x), TARGET   a name of its own, the attribute of its functions
 * FLOATS, LANES     boxes, pairs of triangles at once
 * MADD(p, q, r), ALL(x)  p q + r, which may be rounded once; the number in all lanes
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
#define DOT(p, q) MADD((p)[0], (q)[0], MADD((p)[1], (q)[1], (p)[2] * (q)[2]))

/* One box in the other body's coordinates. */
INLINE void NAME(turn_box)(posed_box *p, const motion *m, const body_boxes *from, int lane) {
  four_reals column[4];
  four_floats turn[3];
  UNROLL for (int k = 0; k < 3; k++) {
    LOAD(column[k], m->scaled[k]);
    LOAD(turn[k], m->turn[k]);
  }
  LOAD(column[3], m->shifted);
  four_reals at = column[0] * (double)from->centre[0][lane] +
                  (column[1] * (double)from->centre[1][lane] + column[3]) +
                  column[2] * (double)from->centre[2][lane];
  p->centre = __builtin_convertvector(at, four_floats);
  p->rest =
      __builtin_convertvector(at - __builtin_convertvector(p->centre, four_reals), four_floats);
  UNROLL for (int k = 0; k < 3; k++) {
    p->half[k] = m->ratio * from->half[k][lane] + m->lost;
    p->axis[k] = turn[0] * from->axis[k][0][lane] + turn[1] * from->axis[k][1][lane] +
                 turn[2] * from->axis[k][2][lane];
  }
}

/* The eight children of a node and one posed box: offset of the centres, and the cosines between
 * axes i of the children and k of the box, on the axes of the children. */
typedef struct {
  F along[3], half[3], cosine[3][3], size[3][3];
} NAME(facing);

INLINE M NAME(face_axes_separate)(NAME(facing) * f, const body_boxes *node, int n,
                                  const posed_box *p) {
  F t[3];
  M disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    LOAD(t[i], node->centre[i] + n);
    t[i] = p->centre[i] - t[i] + p->rest[i];
  }
  UNROLL for (int i = 0; i < 3; i++) {
    F axis[3];
    UNROLL for (int j = 0; j < 3; j++) { LOAD(axis[j], node->axis[i][j] + n); }
    LOAD(f->half[i], node->half[i] + n);
    f->along[i] = DOT(axis, t);
    F reach = f->half[i];
    UNROLL for (int k = 0; k < 3; k++) {
      f->cosine[i][k] = MADD(axis[0], ALL(p->axis[k][0]),
                             MADD(axis[1], ALL(p->axis[k][1]), axis[2] * p->axis[k][2]));
      f->size[i][k] = SIZE(f->cosine[i][k]);
      reach = MADD(f->size[i][k], ALL(p->half[k]), reach);
    }
    disjoint |= SIZE(f->along[i]) > reach;
  }
  UNROLL for (int k = 0; k < 3; k++) {
    F at = f->along[0] * f->cosine[0][k];
    F reach = MADD(f->half[0], f->size[0][k], ALL(p->half[k]));
    UNROLL for (int i = 1; i < 3; i++) {
      at = MADD(f->along[i], f->cosine[i][k], at);
      reach = MADD(f->half[i], f->size[i][k], reach);
    }
    disjoint |= SIZE(at) > reach;
  }
  return disjoint;
}

INLINE M NAME(edge_axes_separate)(const NAME(facing) * f, const posed_box *p) {
  F slack =
      (f->half[0] + f->half[1] + f->half[2] + (p->half[0] + p->half[1] + p->half[2])) * BOX_SLACK;
  M disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int i1 = next[i];
    int i2 = next[i1];
    UNROLL for (int k = 0; k < 3; k++) {
      int k1 = next[k];
      int k2 = next[k1];
      F at = MADD(f->along[i2], f->cosine[i1][k], -f->along[i1] * f->cosine[i2][k]);
      F reach = MADD(f->half[i1], f->size[i2][k], slack);
      reach = MADD(f->half[i2], f->size[i1][k], reach);
      reach = MADD(f->size[i][k2], ALL(p->half[k1]), reach);
      reach = MADD(f->size[i][k1], ALL(p->half[k2]), reach);
      disjoint |= SIZE(at) > reach;
    }
  }
  return disjoint;
}

/* Bit k: child k of the node may meet the box `lane` of the other body. */
TARGET static uint32_t NAME(overlaps)(const body_boxes *node, const motion *m,
                                      const body_boxes *from, int lane) {
  posed_box p;
  uint32_t bits = 0;
  NAME(turn_box)(&p, m, from, lane);
  for (int n = 0; n < BODY_WIDE; n += FLOATS) {
    NAME(facing) f;
    M disjoint = NAME(face_axes_separate)(&f, node, n, &p);
    if (BITS(disjoint) != (1U << FLOATS) - 1) {
      disjoint |= NAME(edge_axes_separate)(&f, &p);
      bits |= (~BITS(disjoint) & ((1U << FLOATS) - 1)) << n;
    }
  }
  return bits;
}

/* ------------------------------------------------------- pairs of triangles */

#define NUMBER R
#define OF(x) NAME(x##_real)
#define TIMES(p, q) ((p) * (q))
#define PRISM(g, z) ((g) * (z))
#include "batch/sums.h"

#define WHOLE_PRODUCT(p, q) ((p) * (q))
#define WHOLE_PRISM(g, z) ((g) * (z))
#define BITS_OF(v) REAL_BITS(v)
#include "batch/whole.h"

INLINE R NAME(magnitude)(R p) { return (R)((V)p & INT64_MAX); }
INLINE R NAME(chosen)(V which, R p, R q) { return (R)(((V)p & which) | ((V)q & ~which)); }
INLINE R NAME(greater)(R p, R q) { return NAME(chosen)((V)(p > q), p, q); }
INLINE R NAME(lesser)(R p, R q) { return NAME(chosen)((V)(p < q), p, q); }

/* An edge with ends on different sides of a plane passes all edges p, q, r on one side. */
INLINE V NAME(pierces)(R from, R to, R p, R q, R r) {
  return ((V)from ^ (V)to) & ~(((V)p ^ (V)q) | ((V)q ^ (V)r));
}

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
 * A certain collision is strict: an edge passes from one side of the other triangle's plane to the
 * other, through the inside of that triangle, so that the points of its own triangle near there are
 * in the inside of both. */
TARGET static uint32_t NAME(judge)(const double *from, const placement *at, uint32_t *uncertain) {
  NAME(coordinate_real) c[3];
  NAME(orient2d_real) g;
  NAME(orient3d_real) v;
  R most = NAME(load)(c, from, at);
  NAME(find_orient2d_real)(&g, &c[0], &c[1]);
  NAME(find_orient3d_real)(&v, &g, &c[2]);
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
  R limit = most * most * (1024 * at->error + 8192 * 0x1p-53 * most);
  V certain = (V)(least > limit) & (V)(most > 0x1p-300) & (V)(most < 0x1p300);
  *uncertain = ~REAL_BITS(certain) & ((1U << LANES) - 1);
  return REAL_BITS(hit);
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
      R shift = NAME(on_grid)((R){0} + at->offset[i], scale, &off);
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
  *off_bits = REAL_BITS(off);
  uint32_t hits = NAME(judge_whole)(whole, &(NAME(rough)){c, &g, &v});
  return hits & ~REAL_BITS(NAME(aabbs_disjoint)(c));
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
#undef DOT
#undef MADD
#undef ALL
#undef BITS
#undef REAL_BITS
#undef FLOATS
