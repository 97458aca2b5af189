/* sums.h - products and sums of lanes.h, for whole numbers modulo 2^64 and for doubles (private;
 * lanes.h includes it once for each).
 *
 * NUMBER, OF(x)       the type of a vector, a name of its own
 * TIMES(p, q)         products of differences and sums of coordinates
 * PRISM(g, z)         products of orient2d and z sums
 *
 * The formulas are those of exact.c. */

/* One coordinate of the six vertices. */
typedef struct {
  NUMBER a[3], b[3];
} OF(coordinate);

/* g_ijk, orient2d, above 0 if clockwise: of A, of B, of edge e_i and vertex B_k (a[i][k]), of f_j
 * and A_k (b[j][k]). */
typedef struct {
  NUMBER own_a, own_b, a[3][3], b[3][3];
} OF(orient2d);

typedef struct {
  NUMBER s[3], w[3], d[3][3];
} OF(orient3d);

INLINE NUMBER OF(trapezoid)(NUMBER xi, NUMBER yi, NUMBER xj, NUMBER yj) {
  return TIMES(xj - xi, yi + yj);
}

INLINE void OF(find_orient2d)(OF(orient2d) * g, const OF(coordinate) * x,
                              const OF(coordinate) * y) {
  NUMBER ta[3];
  NUMBER tb[3];
  NUMBER t[3][3];
  UNROLL for (int i = 0; i < 3; i++) {
    int n = next[i];
    ta[i] = OF(trapezoid)(x->a[i], y->a[i], x->a[n], y->a[n]);
    tb[i] = OF(trapezoid)(x->b[i], y->b[i], x->b[n], y->b[n]);
    UNROLL for (int j = 0; j < 3; j++) {
      t[i][j] = OF(trapezoid)(x->a[i], y->a[i], x->b[j], y->b[j]);
    }
  }
  g->own_a = ta[0] + ta[1] + ta[2];
  g->own_b = tb[0] + tb[1] + tb[2];
  UNROLL for (int i = 0; i < 3; i++) {
    UNROLL for (int k = 0; k < 3; k++) {
      g->a[i][k] = ta[i] + t[next[i]][k] - t[i][k];
      g->b[i][k] = tb[i] + t[k][i] - t[k][next[i]];
    }
  }
}

INLINE void OF(find_orient3d)(OF(orient3d) * v, const OF(orient2d) * g, const OF(coordinate) * z) {
  NUMBER ha[3][3];
  NUMBER hb[3][3];
  NUMBER origin = z->a[0] + z->a[1] + z->a[2];
  NUMBER own_b = PRISM(g->own_b, z->b[0] + z->b[1] + z->b[2] - origin);
  UNROLL for (int i = 0; i < 3; i++) {
    NUMBER edge_a = z->a[i] + z->a[next[i]] - origin;
    NUMBER edge_b = z->b[i] + z->b[next[i]] - origin;
    UNROLL for (int k = 0; k < 3; k++) {
      ha[i][k] = PRISM(g->a[i][k], edge_a + z->b[k]);
      hb[i][k] = PRISM(g->b[i][k], edge_b + z->a[k]);
    }
  }
  UNROLL for (int i = 0; i < 3; i++) {
    v->s[i] = ha[0][i] + ha[1][i] + ha[2][i];
    v->w[i] = hb[0][i] + hb[1][i] + hb[2][i] - own_b;
    UNROLL for (int j = 0; j < 3; j++) {
      v->d[i][j] = ha[i][j] - ha[i][next[j]] + hb[j][i] - hb[j][next[i]];
    }
  }
}

#undef NUMBER
#undef OF
#undef TIMES
#undef PRISM
