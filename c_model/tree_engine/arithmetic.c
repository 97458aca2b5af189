/* SPDX-License-Identifier: MIT */
/* arithmetic.c - the formulas of the tree engine's modules. docs/reference/tree-engine.md,
 * Arithmetic, has the formulas, the widths and the proof that no collision is missed. */
#include "tree_engine/walk.h"

#include "util/aabb.h"

/* floor(x / 2^by); by may be negative. */
static int64_t floor_shift(int64_t x, int by) {
  return by >= 0 ? x >> by : x * (INT64_C(1) << -by);
}

static int64_t clamp(int64_t x, int64_t low, int64_t high) {
  return x < low ? low : x > high ? high : x;
}

static int64_t turned_sum(const sepax_tree_side *side, const int32_t p[3], int i) {
  int64_t sum = side->shift[i];
  for (int k = 0; k < 3; k++) {
    sum += (int64_t)side->matrix[i][k] * p[k];
  }
  return sum;
}

tree_setting sepax__tree_set_up(const sepax_tree_side *side, const tree_node *s,
                                const tree_node *t) {
  const int64_t far = INT64_C(1) << 20;
  tree_setting r;
  int e_max = s->exponent[0];
  e_max = s->exponent[1] > e_max ? s->exponent[1] : e_max;
  e_max = s->exponent[2] > e_max ? s->exponent[2] : e_max;
  for (int i = 0; i < 3; i++) {
    int g = t->exponent[i] > e_max ? t->exponent[i] : e_max;
    for (int k = 0; k < 3; k++) {
      int by = 10 + g - s->exponent[k];
      r.n[i][k] = (int32_t)((side->matrix[i][k] + (INT64_C(1) << (by - 1))) >> by);
    }
    int64_t x = turned_sum(side, s->origin, i) - t->origin[i] * (INT64_C(1) << 20);
    int64_t d = floor_shift(x, 10 + g);
    int64_t slack = 192 + ((side->sigma[i] + (INT64_C(1) << g) - 1) >> g);
    r.low[i] = (int32_t)clamp(d - slack, -far, far - 1);
    r.high[i] = (int32_t)clamp(d + 1 + slack, -far, far - 1);
    r.shift[i] = 10 + t->exponent[i] - g;
  }
  return r;
}

tree_cells sepax__tree_turn_box(const tree_setting *g, const int8_t low[3], const int8_t high[3]) {
  tree_cells r;
  for (int i = 0; i < 3; i++) {
    int32_t lo = g->low[i];
    int32_t hi = g->high[i];
    for (int k = 0; k < 3; k++) {
      bool up = g->n[i][k] >= 0;
      lo += g->n[i][k] * (up ? low[k] : high[k] + 1);
      hi += g->n[i][k] * (up ? high[k] + 1 : low[k]);
    }
    r.low[i] = (int)clamp(floor_shift(lo, g->shift[i]), -129, 128);
    r.high[i] = (int)clamp(floor_shift(hi, g->shift[i]), -129, 128);
  }
  return r;
}

uint16_t sepax__tree_hits(const tree_cells *box, const tree_node *t) {
  unsigned hits = 0;
  for (int j = 0; j < t->children; j++) {
    bool hit = true;
    for (int i = 0; i < 3; i++) {
      hit = hit && box->low[i] <= t->high[j][i] && box->high[i] >= t->low[j][i];
    }
    hits |= (unsigned)hit << j;
  }
  return (uint16_t)hits;
}

void sepax__tree_turn_vertex(int32_t v[3], const sepax_tree_side *side, const int32_t p[3]) {
  for (int i = 0; i < 3; i++) {
    v[i] = (int32_t)(turned_sum(side, p, i) >> 20);
  }
}

static aabb bounds_of(const int32_t v[3][3]) {
  aabb b;
  for (int i = 0; i < 3; i++) {
    int32_t low = v[0][i] < v[1][i] ? v[0][i] : v[1][i];
    int32_t high = v[0][i] < v[1][i] ? v[1][i] : v[0][i];
    b.low[i] = low < v[2][i] ? low : v[2][i];
    b.high[i] = high > v[2][i] ? high : v[2][i];
  }
  return b;
}

tree_pair sepax__tree_test_pair(const int32_t a[3][3], const int32_t b[3][3], int64_t margin,
                                int word) {
  aabb of_a = bounds_of(a);
  aabb of_b = bounds_of(b);
  tree_pair r = {.near = !aabb_disjoint(&of_a, &of_b, margin)};
  if (!r.near) {
    return r;
  }
  r.out_of_range = !aabb_fits(&of_b, word);
  aabb_enclose(&of_a, &of_b);
  r.thinnest = aabb_thinnest(&of_a);
  return r;
}

sepax_tri sepax__tree_thin_along_z(const int32_t v[3][3], int thinnest) {
  sepax_tri t;
  for (int k = 0; k < 3; k++) {
    t.v[k] = (sepax_vec){v[k][thinnest == 0 ? 2 : 0], v[k][thinnest == 1 ? 2 : 1], v[k][thinnest]};
  }
  return t;
}
