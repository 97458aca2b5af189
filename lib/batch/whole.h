/* whole.h - verdicts of LANES pairs of triangles by whole numbers (private; lanes.h and
 * body/boxes.h include it).
 *
 * LANES, NAME(x), TARGET, INLINE  as there
 * V, R                vectors of uint64_t and of doubles
 * WHOLE_PRODUCT(p, q) modulo 2^64
 * WHOLE_PRISM(g, z)   modulo 2^64
 * BITS_OF(v)          the sign bits of lanes, as a number
 *
 * Sums of doubles (sums.h as NAME(x##_real)) come before. */

#define NUMBER V
#define OF(x) NAME(x##_whole)
#define TIMES(p, q) WHOLE_PRODUCT(p, q)
#define PRISM(g, z) WHOLE_PRISM(g, z)
#include "batch/sums.h"

/* The sign bits count: those of an orient3d, and those of its opposite. */
typedef struct {
  V low, high;
} NAME(sign);

typedef struct {
  NAME(sign) s[3], w[3], d[3][3];
} NAME(signs);

/* Of a number known modulo 2^64 and, roughly, from 2^62 upwards: what has its sign bit, and of
 * which the opposite has that of its opposite. */
INLINE V NAME(merged)(V low, R rough) {
  const uint64_t limit = UINT64_C(1085) << 52; /* the exponent of 2^62 */
  V bits = (V)rough;
  V below = -(((bits & (UINT64_C(0x7ff) << 52)) - limit) >> 63);
  return (low & below) | (bits & ~below);
}

INLINE NAME(sign) NAME(sign_of)(V v) { return (NAME(sign)){v, -v}; }

/* rough NULL: orient3d fit 64 bits. */
INLINE void NAME(find_signs)(NAME(signs) * signs, const NAME(orient3d_whole) * v,
                             const NAME(orient3d_real) * rough) {
#define SIGN(m) signs->m = NAME(sign_of)(rough != NULL ? NAME(merged)(v->m, rough->m) : v->m)
  UNROLL for (int i = 0; i < 3; i++) {
    SIGN(s[i]);
    SIGN(w[i]);
    UNROLL for (int j = 0; j < 3; j++) { SIGN(d[i][j]); }
  }
#undef SIGN
}

INLINE void NAME(merge_orient2d)(NAME(orient2d_whole) * g, const NAME(orient2d_real) * rough) {
  g->own_a = NAME(merged)(g->own_a, rough->own_a);
  g->own_b = NAME(merged)(g->own_b, rough->own_b);
  UNROLL for (int i = 0; i < 3; i++) {
    UNROLL for (int k = 0; k < 3; k++) {
      g->a[i][k] = NAME(merged)(g->a[i][k], rough->a[i][k]);
      g->b[i][k] = NAME(merged)(g->b[i][k], rough->b[i][k]);
    }
  }
}

/* An edge crosses or touches the other triangle: its ends are not on the same side of the plane,
 * and no two of the other edges pass it on different sides. */
INLINE V NAME(edge_hits)(NAME(sign) from, NAME(sign) to, NAME(sign) p, NAME(sign) q, NAME(sign) r) {
  V sides = (from.low ^ to.low) | (from.high ^ to.high);
  return sides & ~((p.low | q.low | r.low) & (p.high | q.high | r.high));
}

/* In the projection on two coordinates, an edge has the other triangle strictly on the
 * side where its own third vertex is not. */
INLINE V NAME(edge_separates)(const V side[3], V own) {
  V low = side[0] & side[1] & side[2];
  V high = -side[0] & -side[1] & -side[2];
  return (low & ~own) | (high & ~-own);
}

INLINE V NAME(separate_in_plane)(const NAME(orient2d_whole) * g) {
  V disjoint = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    disjoint |= NAME(edge_separates)(g->a[i], g->own_a) | NAME(edge_separates)(g->b[i], g->own_b);
  }
  return disjoint;
}

/* Sign bits: some orient2d is not zero. */
INLINE V NAME(has_orient2d)(const NAME(orient2d_whole) * g) {
  V any = g->own_a | g->own_b;
  UNROLL for (int i = 0; i < 3; i++) {
    UNROLL for (int k = 0; k < 3; k++) { any |= g->a[i][k] | g->b[i][k]; }
  }
  return any | -any;
}

/* Lanes in which the six values are not all the same: all ones. */
INLINE V NAME(varies)(const NAME(coordinate_whole) * c) {
  V any = {0};
  UNROLL for (int k = 0; k < 3; k++) { any |= (c->a[k] ^ c->a[0]) | (c->b[k] ^ c->a[0]); }
  return -((any | -any) >> 63);
}

INLINE void NAME(choose)(NAME(coordinate_whole) * to, V which, const NAME(coordinate_whole) * p,
                         const NAME(coordinate_whole) * q) {
  UNROLL for (int k = 0; k < 3; k++) {
    to->a[k] = (p->a[k] & which) | (q->a[k] & ~which);
    to->b[k] = (p->b[k] & which) | (q->b[k] & ~which);
  }
}

/* The numbers of a group in doubles; orient2d NULL: those of whole numbers fit 64 bits. */
typedef struct {
  const NAME(coordinate_real) * c;
  const NAME(orient2d_real) * orient2d;
  const NAME(orient3d_real) * orient3d;
} NAME(rough);

/* The bits of the coplanar pairs `flat` that are not separated in a projection that keeps
 * their plane: x and y, of which g are the orient2d, or z and y, or z and x where y does not
 * vary. An additional projection changes nothing. On a line the AABBs decide. */
TARGET static __attribute__((noinline)) uint32_t NAME(judge_flat)(const NAME(coordinate_whole) c[3],
                                                                  NAME(orient2d_whole) * g,
                                                                  const NAME(rough) * rough,
                                                                  uint32_t flat) {
  if (rough->orient2d != NULL) {
    NAME(merge_orient2d)(g, rough->orient2d);
  }
  V disjoint = NAME(separate_in_plane)(g);
  if ((flat & ~BITS_OF(NAME(has_orient2d)(g))) != 0) {
    NAME(coordinate_whole) level;
    NAME(orient2d_whole) upright;
    V which = NAME(varies)(&c[1]);
    NAME(choose)(&level, which, &c[1], &c[0]);
    NAME(find_orient2d_whole)(&upright, &c[2], &level);
    if (rough->orient2d != NULL) {
      NAME(coordinate_real) level_rough;
      NAME(orient2d_real) upright_rough;
      UNROLL for (int k = 0; k < 3; k++) {
        level_rough.a[k] = (R)(((V)rough->c[1].a[k] & which) | ((V)rough->c[0].a[k] & ~which));
        level_rough.b[k] = (R)(((V)rough->c[1].b[k] & which) | ((V)rough->c[0].b[k] & ~which));
      }
      NAME(find_orient2d_real)(&upright_rough, &rough->c[2], &level_rough);
      NAME(merge_orient2d)(&upright, &upright_rough);
    }
    disjoint |= NAME(separate_in_plane)(&upright);
  }
  return flat & ~BITS_OF(disjoint);
}

/* The bits of the pairs that collide, if their AABBs overlap. */
INLINE uint32_t NAME(judge_whole)(const NAME(coordinate_whole) c[3], const NAME(rough) * rough) {
  NAME(orient2d_whole) g;
  NAME(orient3d_whole) orient3d;
  NAME(signs) v;
  NAME(find_orient2d_whole)(&g, &c[0], &c[1]);
  NAME(find_orient3d_whole)(&orient3d, &g, &c[2]);
  NAME(find_signs)(&v, &orient3d, rough->orient3d);
  V hit = {0};
  V solid = {0};
  UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    hit |= NAME(edge_hits)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]) |
           NAME(edge_hits)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    solid |= v.s[i].low | v.s[i].high | v.w[i].low | v.w[i].high;
    UNROLL for (int j = 0; j < 3; j++) { solid |= v.d[i][j].low | v.d[i][j].high; }
  }
  uint32_t hits = BITS_OF(hit);
  uint32_t flat = BITS_OF(~solid);
  return flat == 0 ? hits : hits | NAME(judge_flat)(c, &g, rough, flat);
}

#undef WHOLE_PRODUCT
#undef WHOLE_PRISM
#undef BITS_OF
