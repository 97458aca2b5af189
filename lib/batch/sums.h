/* SPDX-License-Identifier: MIT */
/* sums.h - products and sums of lanes.h, for whole numbers modulo 2^64 and for doubles (private;
 * it is included once for each). Beyond the macros of util/simd.h:
 *
 * SIMD_NUMBER          the type of a vector
 * SIMD_OF(x)           x with a suffix of that type
 * SIMD_TIMES(p, q)     product of differences and sums of coordinates
 * SIMD_PRISM(g, z)     product of an orient2d and a z sum
 *
 * The formulas are those of exact.c. */

/* One coordinate of the six vertices. */
typedef struct {
  SIMD_NUMBER a[3], b[3];
} SIMD_OF(coordinate);

/* g_ijk, orient2d, above 0 if clockwise: of A, of B, of edge e_i and vertex B_k (a[i][k]), of f_j
 * and A_k (b[j][k]). */
typedef struct {
  SIMD_NUMBER own_a, own_b, a[3][3], b[3][3];
} SIMD_OF(orient2d);

typedef struct {
  SIMD_NUMBER s[3], w[3], d[3][3];
} SIMD_OF(orient3d);

SIMD_INLINE SIMD_NUMBER SIMD_OF(trapezoid)(SIMD_NUMBER xi, SIMD_NUMBER yi, SIMD_NUMBER xj,
                                           SIMD_NUMBER yj) {
  return SIMD_TIMES(xj - xi, yi + yj);
}

SIMD_INLINE void SIMD_OF(find_orient2d)(SIMD_OF(orient2d) * g, const SIMD_OF(coordinate) * x,
                                        const SIMD_OF(coordinate) * y) {
  SIMD_NUMBER ta[3];
  SIMD_NUMBER tb[3];
  SIMD_NUMBER t[3][3];
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    ta[i] = SIMD_OF(trapezoid)(x->a[i], y->a[i], x->a[n], y->a[n]);
    tb[i] = SIMD_OF(trapezoid)(x->b[i], y->b[i], x->b[n], y->b[n]);
    SIMD_UNROLL for (int j = 0; j < 3; j++) {
      t[i][j] = SIMD_OF(trapezoid)(x->a[i], y->a[i], x->b[j], y->b[j]);
    }
  }
  g->own_a = ta[0] + ta[1] + ta[2];
  g->own_b = tb[0] + tb[1] + tb[2];
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      g->a[i][k] = ta[i] + t[next[i]][k] - t[i][k];
      g->b[i][k] = tb[i] + t[k][i] - t[k][next[i]];
    }
  }
}

SIMD_INLINE void SIMD_OF(find_orient3d)(SIMD_OF(orient3d) * v, const SIMD_OF(orient2d) * g,
                                        const SIMD_OF(coordinate) * z) {
  SIMD_NUMBER ha[3][3];
  SIMD_NUMBER hb[3][3];
  SIMD_NUMBER origin = z->a[0] + z->a[1] + z->a[2];
  SIMD_NUMBER own_b = SIMD_PRISM(g->own_b, z->b[0] + z->b[1] + z->b[2] - origin);
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_NUMBER edge_a = z->a[i] + z->a[next[i]] - origin;
    SIMD_NUMBER edge_b = z->b[i] + z->b[next[i]] - origin;
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      ha[i][k] = SIMD_PRISM(g->a[i][k], edge_a + z->b[k]);
      hb[i][k] = SIMD_PRISM(g->b[i][k], edge_b + z->a[k]);
    }
  }
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    v->s[i] = ha[0][i] + ha[1][i] + ha[2][i];
    v->w[i] = hb[0][i] + hb[1][i] + hb[2][i] - own_b;
    SIMD_UNROLL for (int j = 0; j < 3; j++) {
      v->d[i][j] = ha[i][j] - ha[i][next[j]] + hb[j][i] - hb[j][next[i]];
    }
  }
}

#undef SIMD_NUMBER
#undef SIMD_OF
#undef SIMD_TIMES
#undef SIMD_PRISM
