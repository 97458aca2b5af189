/* SPDX-License-Identifier: MIT */
/* exact_sums.h - the products and sums of exact.c, for one type of integers (private; exact.c
 * includes it once for each). It needs SIMD_NAME and SIMD_UNROLL of util/simd.h, and SIMD_NUMBER,
 * an unsigned type.
 *
 * All arithmetic is modulo 2^bits of SIMD_NUMBER: the signs are right if 3W + 2 bits fit. */

/* One coordinate of the six vertices. */
typedef struct {
  SIMD_NUMBER a[3], b[3];
} SIMD_NAME(coordinate);

/* g_ijk, orient2d in the projection on x and y (above 0 if clockwise), of 2W + 1 bits: of triangle
 * A, of B, of edge e_i and vertex B_k (a[i][k]), of edge f_j and vertex A_k (b[j][k]). */
typedef struct {
  SIMD_NUMBER own_a, own_b, a[3][3], b[3][3];
} SIMD_NAME(orient2d);

/* h_ijk, signed prism volumes, modulo 2^(3W + 2): g_ijk times the z sum; h of A itself is 0. */
typedef struct {
  SIMD_NUMBER own_b, a[3][3], b[3][3];
} SIMD_NAME(prisms);

static int SIMD_NAME(sign)(SIMD_NUMBER value) {
  return (value != 0) - 2 * (int)(value >> (8 * sizeof value - 1));
}

static void SIMD_NAME(load)(SIMD_NAME(coordinate) c[3], const sepax_tri *a, const sepax_tri *b) {
  SIMD_UNROLL for (int k = 0; k < 3; k++) {
    c[0].a[k] = (SIMD_NUMBER)a->v[k].x;
    c[1].a[k] = (SIMD_NUMBER)a->v[k].y;
    c[2].a[k] = (SIMD_NUMBER)a->v[k].z;
    c[0].b[k] = (SIMD_NUMBER)b->v[k].x;
    c[1].b[k] = (SIMD_NUMBER)b->v[k].y;
    c[2].b[k] = (SIMD_NUMBER)b->v[k].z;
  }
}

/* t_ij, 15 products. */
static SIMD_NUMBER SIMD_NAME(trapezoid)(SIMD_NUMBER xi, SIMD_NUMBER yi, SIMD_NUMBER xj,
                                        SIMD_NUMBER yj) {
  return (xj - xi) * (yi + yj);
}

static void SIMD_NAME(find_orient2d)(SIMD_NAME(orient2d) * g, const SIMD_NAME(coordinate) * x,
                                     const SIMD_NAME(coordinate) * y) {
  SIMD_NUMBER ta[3];
  SIMD_NUMBER tb[3];
  SIMD_NUMBER t[3][3];
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    ta[i] = SIMD_NAME(trapezoid)(x->a[i], y->a[i], x->a[n], y->a[n]);
    tb[i] = SIMD_NAME(trapezoid)(x->b[i], y->b[i], x->b[n], y->b[n]);
    SIMD_UNROLL for (int j = 0; j < 3; j++) {
      t[i][j] = SIMD_NAME(trapezoid)(x->a[i], y->a[i], x->b[j], y->b[j]);
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

/* 19 products. */
static void SIMD_NAME(find_prisms)(SIMD_NAME(prisms) * h, const SIMD_NAME(orient2d) * g,
                                   const SIMD_NAME(coordinate) * z) {
  SIMD_NUMBER origin = z->a[0] + z->a[1] + z->a[2];
  h->own_b = g->own_b * (z->b[0] + z->b[1] + z->b[2] - origin);
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_NUMBER edge_a = z->a[i] + z->a[next[i]] - origin;
    SIMD_NUMBER edge_b = z->b[i] + z->b[next[i]] - origin;
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      h->a[i][k] = g->a[i][k] * (edge_a + z->b[k]);
      h->b[i][k] = g->b[i][k] * (edge_b + z->a[k]);
    }
  }
}

static orient3d_signs SIMD_NAME(orient3d_signs)(const SIMD_NAME(coordinate) c[3]) {
  SIMD_NAME(orient2d) g;
  SIMD_NAME(prisms) h;
  SIMD_NAME(find_orient2d)(&g, &c[0], &c[1]);
  SIMD_NAME(find_prisms)(&h, &g, &c[2]);
  orient3d_signs v;
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    v.s[i] = SIMD_NAME(sign)(h.a[0][i] + h.a[1][i] + h.a[2][i]);
    v.w[i] = SIMD_NAME(sign)(h.b[0][i] + h.b[1][i] + h.b[2][i] - h.own_b);
    SIMD_UNROLL for (int j = 0; j < 3; j++) {
      v.d[i][j] = SIMD_NAME(sign)(h.a[i][j] - h.a[i][next[j]] + h.b[j][i] - h.b[j][n]);
    }
  }
  return v;
}

static orient2d_signs SIMD_NAME(orient2d_signs)(const SIMD_NAME(coordinate) * x,
                                                const SIMD_NAME(coordinate) * y) {
  SIMD_NAME(orient2d) g;
  SIMD_NAME(find_orient2d)(&g, x, y);
  orient2d_signs s = {.own_a = SIMD_NAME(sign)(g.own_a), .own_b = SIMD_NAME(sign)(g.own_b)};
  SIMD_UNROLL for (int i = 0; i < 3; i++) {
    SIMD_UNROLL for (int k = 0; k < 3; k++) {
      s.a[i][k] = SIMD_NAME(sign)(g.a[i][k]);
      s.b[i][k] = SIMD_NAME(sign)(g.b[i][k]);
    }
  }
  return s;
}

static sepax_verdict SIMD_NAME(verdict)(const sepax_tri *a, const sepax_tri *b) {
  SIMD_NAME(coordinate) c[3];
  SIMD_NAME(load)(c, a, b);
  orient3d_signs v = SIMD_NAME(orient3d_signs)(c);
  if (!all_zero_3d(&v)) {
    return judged_in_space(&v);
  }
  for (int pass = 0; pass < 3; pass++) {
    orient2d_signs s = SIMD_NAME(orient2d_signs)(&c[pass], &c[next[pass]]);
    if (!all_zero_2d(&s)) {
      return judged_in_plane(edge_separates(&s));
    }
  }
  return judged_in_plane(aabbs_disjoint(a, b));
}
