/* SPDX-License-Identifier: MIT */
/* whole.h - verdicts of SIMD_LANES pairs of triangles by whole numbers (private; lanes.h and
 * body/filter.h include it, after sums of doubles, which sums.h makes as SIMD_NAME(x##_real)).
 * Beyond the macros of util/simd.h:
 *
 * SIMD_WHOLE_PRODUCT(p, q)   product of differences and sums of coordinates, modulo 2^64
 * SIMD_WHOLE_PRISM(g, z)     product of an orient2d and a z sum, modulo 2^64
 * SIMD_BITS_OF(v)            the sign bits of a vector of uint64_t as a number */

#define SIMD_NUMBER SIMD_WHOLE
#define SIMD_OF(x) SIMD_NAME(x##_whole)
#define SIMD_TIMES(p, q) SIMD_WHOLE_PRODUCT(p, q)
#define SIMD_PRISM(g, z) SIMD_WHOLE_PRISM(g, z)
#include "batch/sums.h"

/* A sign by two sign bits: that of an orient3d and that of its opposite. */
typedef struct {
  SIMD_WHOLE low, high;
} SIMD_NAME(sign);

typedef struct {
  SIMD_NAME(sign) s[3], w[3], d[3][3];
} SIMD_NAME(signs);

/* Combine a number known modulo 2^64 with a rough double that is right from 2^62 upwards, so that
 * the result has the right sign bit, and its opposite has the right one, too. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(merged)(SIMD_WHOLE low, SIMD_REAL rough) {
  const uint64_t limit = UINT64_C(1085) << 52; /* bits of a double's exponent for 2^62 */
  SIMD_WHOLE bits = (SIMD_WHOLE)rough;
  SIMD_WHOLE below = -(((bits & (UINT64_C(0x7ff) << 52)) - limit) >> 63);
  return (low & below) | (bits & ~below);
}

SIMD_INLINE SIMD_NAME(sign) SIMD_NAME(sign_of)(SIMD_WHOLE v) { return (SIMD_NAME(sign)){v, -v}; }

/* Find the signs of all orient3d. If `rough` is NULL, then orient3d fit 64 bits. */
SIMD_INLINE void SIMD_NAME(find_signs)(SIMD_NAME(signs) * signs,
                                       const SIMD_NAME(orient3d_whole) * v,
                                       const SIMD_NAME(orient3d_real) * rough) {
#define SIMD_SIGN(m) \
  signs->m = SIMD_NAME(sign_of)(rough != NULL ? SIMD_NAME(merged)(v->m, rough->m) : v->m)
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_SIGN(s[i]);
    SIMD_SIGN(w[i]);
    SIMD_UNROLL for (int j = 0; j < 3; j++) { SIMD_SIGN(d[i][j]); }
  }
#undef SIMD_SIGN
}

SIMD_INLINE void SIMD_NAME(merge_orient2d)(SIMD_NAME(orient2d_whole) * g,
                                           const SIMD_NAME(orient2d_real) * rough) {
  g->own_a = SIMD_NAME(merged)(g->own_a, rough->own_a);
  g->own_b = SIMD_NAME(merged)(g->own_b, rough->own_b);
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      g->a[i][k] = SIMD_NAME(merged)(g->a[i][k], rough->a[i][k]);
      g->b[i][k] = SIMD_NAME(merged)(g->b[i][k], rough->b[i][k]);
    }
  }
}

/* True if an edge crosses or touches the other triangle: its ends are not on the same side of the
 * plane, and no two of the other triangle's edges pass it on different sides. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(edge_hits)(SIMD_NAME(sign) from, SIMD_NAME(sign) to,
                                            SIMD_NAME(sign) p, SIMD_NAME(sign) q,
                                            SIMD_NAME(sign) r) {
  SIMD_WHOLE sides = (from.low ^ to.low) | (from.high ^ to.high);
  return sides & ~((p.low | q.low | r.low) & (p.high | q.high | r.high));
}

/* True if, in a projection on two coordinates, an edge has the other triangle strictly on the side
 * opposite to its own third vertex. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(edge_separates)(const SIMD_WHOLE side[3], SIMD_WHOLE own) {
  SIMD_WHOLE low = side[0] & side[1] & side[2];
  SIMD_WHOLE high = -side[0] & -side[1] & -side[2];
  return (low & ~own) | (high & ~-own);
}

SIMD_INLINE SIMD_WHOLE SIMD_NAME(separate_in_plane)(const SIMD_NAME(orient2d_whole) * g) {
  SIMD_WHOLE disjoint = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    disjoint |=
        SIMD_NAME(edge_separates)(g->a[i], g->own_a) | SIMD_NAME(edge_separates)(g->b[i], g->own_b);
  }
  return disjoint;
}

/* Sign bits of the lanes in which some orient2d is not zero. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(has_orient2d)(const SIMD_NAME(orient2d_whole) * g) {
  SIMD_WHOLE any = g->own_a | g->own_b;
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_UNROLL for (int k = 0; k < 3; k++) { any |= g->a[i][k] | g->b[i][k]; }
  }
  return any | -any;
}

/* All ones in the lanes in which the six values are not all equal. */
SIMD_INLINE SIMD_WHOLE SIMD_NAME(varies)(const SIMD_NAME(coordinate_whole) * c) {
  SIMD_WHOLE any = {0};
  SIMD_UNROLL for (int k = 0; k < 3; k++) { any |= (c->a[k] ^ c->a[0]) | (c->b[k] ^ c->a[0]); }
  return -((any | -any) >> 63);
}

SIMD_INLINE void SIMD_NAME(choose)(SIMD_NAME(coordinate_whole) * to, SIMD_WHOLE which,
                                   const SIMD_NAME(coordinate_whole) * p,
                                   const SIMD_NAME(coordinate_whole) * q) {
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    to->a[k] = (p->a[k] & which) | (q->a[k] & ~which);
    to->b[k] = (p->b[k] & which) | (q->b[k] & ~which);
  }
}

/* The numbers of a group in doubles. If orient2d is NULL, then the whole numbers fit 64 bits. */
typedef struct {
  const SIMD_NAME(coordinate_real) * c;
  const SIMD_NAME(orient2d_real) * orient2d;
  const SIMD_NAME(orient3d_real) * orient3d;
} SIMD_NAME(rough);

/* Judge the coplanar pairs `flat`. Returns the bits of those that are not separated in a projection
 * that keeps their plane: x and y (g are its orient2d), or z and y, or z and x if y does not vary.
 * More projections would change nothing. If all vertices are on one line, then the AABBs decide. */
SIMD_TARGET static __attribute__((noinline)) uint32_t
SIMD_NAME(judge_flat)(const SIMD_NAME(coordinate_whole) c[3], SIMD_NAME(orient2d_whole) * g,
                      const SIMD_NAME(rough) * rough, uint32_t flat) {
  if (rough->orient2d != NULL) {
    SIMD_NAME(merge_orient2d)(g, rough->orient2d);
  }
  SIMD_WHOLE disjoint = SIMD_NAME(separate_in_plane)(g);
  if ((flat & ~SIMD_BITS_OF(SIMD_NAME(has_orient2d)(g))) != 0) {
    SIMD_NAME(coordinate_whole) level;
    SIMD_NAME(orient2d_whole) upright;
    SIMD_WHOLE which = SIMD_NAME(varies)(&c[1]);
    SIMD_NAME(choose)(&level, which, &c[1], &c[0]);
    SIMD_NAME(find_orient2d_whole)(&upright, &c[2], &level);
    if (rough->orient2d != NULL) {
      SIMD_NAME(coordinate_real) level_rough;
      SIMD_NAME(orient2d_real) upright_rough;
      SIMD_UNROLL for (int k = 0; k < 3; k++) {
        level_rough.a[k] = (SIMD_REAL)(((SIMD_WHOLE)rough->c[1].a[k] & which) |
                                       ((SIMD_WHOLE)rough->c[0].a[k] & ~which));
        level_rough.b[k] = (SIMD_REAL)(((SIMD_WHOLE)rough->c[1].b[k] & which) |
                                       ((SIMD_WHOLE)rough->c[0].b[k] & ~which));
      }
      SIMD_NAME(find_orient2d_real)(&upright_rough, &rough->c[2], &level_rough);
      SIMD_NAME(merge_orient2d)(&upright, &upright_rough);
    }
    disjoint |= SIMD_NAME(separate_in_plane)(&upright);
  }
  return flat & ~SIMD_BITS_OF(disjoint);
}

/* Judge pairs whose AABBs overlap. Returns the bits of the colliding pairs. */
SIMD_INLINE uint32_t SIMD_NAME(judge_whole)(const SIMD_NAME(coordinate_whole) c[3],
                                            const SIMD_NAME(rough) * rough) {
  SIMD_NAME(orient2d_whole) g;
  SIMD_NAME(orient3d_whole) orient3d;
  SIMD_NAME(signs) v;
  SIMD_NAME(find_orient2d_whole)(&g, &c[0], &c[1]);
  SIMD_NAME(find_orient3d_whole)(&orient3d, &g, &c[2]);
  SIMD_NAME(find_signs)(&v, &orient3d, rough->orient3d);
  SIMD_WHOLE hit = {0};
  SIMD_WHOLE solid = {0};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    hit |= SIMD_NAME(edge_hits)(v.w[i], v.w[n], v.d[i][0], v.d[i][1], v.d[i][2]) |
           SIMD_NAME(edge_hits)(v.s[i], v.s[n], v.d[0][i], v.d[1][i], v.d[2][i]);
    solid |= v.s[i].low | v.s[i].high | v.w[i].low | v.w[i].high;
    SIMD_UNROLL for (int j = 0; j < 3; j++) { solid |= v.d[i][j].low | v.d[i][j].high; }
  }
  uint32_t hits = SIMD_BITS_OF(hit);
  uint32_t flat = SIMD_BITS_OF(~solid);
  return flat == 0 ? hits : hits | SIMD_NAME(judge_flat)(c, &g, rough, flat);
}

#undef SIMD_WHOLE_PRODUCT
#undef SIMD_WHOLE_PRISM
#undef SIMD_BITS_OF
