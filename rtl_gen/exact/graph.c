/* SPDX-License-Identifier: MIT */
/* graph.c - the exact datapath as an expression graph: the formulas of docs/reference/exact.md. */
#include "clearance.h"
#include "exact.h"

#include <string.h>

int exact_a(int i) { return i % 3; }
int exact_b(int j) { return 3 + j % 3; }
int exact_next(int v) { return v / 3 * 3 + (v + 1) % 3; }

exact_triangle exact_triangle_of(int n) {
  int c = n % 3;
  int r = n / 3 % 3;
  return n < 9 ? (exact_triangle){exact_a(c), exact_a(c + 1), exact_b(c + r)}
               : (exact_triangle){exact_b(c + r), exact_b(c + r + 1), exact_a(c)};
}

exact_edges exact_edges_of(int n) {
  int c = n % 3;
  int r = n / 3;
  return (exact_edges){exact_a(c), exact_a(c + 1), exact_b(c + r), exact_b(c + r + 1)};
}

const exact_projection exact_projections[] = {
    {"", NULL, NULL}, {"_yz", "yz", "g_yz"}, {"_zx", "zx", "g_zx"}};

/* ------------------------------------------------------------- kinds of operations */

#define SIGN_OF(width) "{!@[" width "-1] && (@ != {" width "{1'b0}}), @[" width "-1]}"

/* One row a kind: symbol, module, lesser module, operands, how many it subtracts, output, width,
 * signed, expression, comment, whether it commutes. */
/* clang-format off */
static const graph_row
  trapezoid = {"t", "sepax_trapezoid_ab", "sepax_trapezoid", {"x_from", "x_to", "y_from",
    "y_to"}, 0, "t", "G_W", true, NULL, "Trapezoid terms.", false},
  orient2d = {"g", "sepax_orient2d", NULL, {"p", "q", "r"}, 1, "g", "G_W", true, NULL,
    "orient2d of vertices of both triangles.", true},
  own_orient2d = {"go", "sepax_own_orient2d", NULL, {"p", "q", "r"}, 0, "g", "G_W", true, NULL,
    "orient2d of B, of A.", true},
  own_orient2d_running = {"go", "sepax_own_orient2d", NULL, {"p", "q"}, 0, "sum", "G_W", true, NULL,
    "orient2d of B, of A, term by term.", false},
  zsum = {"z", "sepax_zsum", "sepax_zdiff", {"z_p", "?z_q", "z_r", "?z_s"}, 2, "z", "Z_W", true,
    NULL, "z sums.", false},
  zdiff = {"z", "sepax_zdiff", NULL, {"z_p", "z_r"}, 1, "z", "Z_W", true, NULL,
    "z differences, in the same cycle.", false},
  zsum_of_two = {"z", "sepax_zsum", NULL, {"diff_1", "diff_2"}, 0, "z", "Z_W", true, NULL,
    "z sums of two differences.", false},
  own_zsum = {"zo", "sepax_own_zsum", NULL, {"z_b1", "z_b2", "z_b3", "z_a1", "z_a2", "z_a3"}, 3,
    "z", "O_W", true, NULL, NULL, false},
  own_zsum_of_three = {"zo", "sepax_own_zsum", NULL, {"diff_1", "diff_2", "diff_3"}, 0, "z",
    "O_W", true, NULL, NULL, false},
  own_zsum_running = {"zo", "sepax_own_zsum", NULL, {"so_far", "z_b", "z_a"}, 1, "z", "O_W",
    true, NULL, NULL, false},
  own_zdiff = {"zd", "sepax_zdiff", NULL, {"z_p", "z_r"}, 1, "z", "Z_W", true, NULL,
    "z differences of B's z sum.", false},
  own_zsum_of_diffs = {"zo", "sepax_own_zsum", NULL, {"so_far", "diff"}, 0, "z", "O_W", true,
    NULL, NULL, false},
  prism = {"h", "sepax_prism", NULL, {"g", "z"}, 0, "h", "V_W", true, NULL,
    "Signed prism volumes.", false},
  prism_of_two = {"h", "sepax_prism_2", NULL, {"g", "z"}, 0, "h", "V_W", true, NULL, NULL, false},
  own_prism = {"ho", "sepax_own_prism", NULL, {"g", "z"}, 0, "h", "V_W", true, NULL, NULL, false},
  running_sum = {"v", "sepax_orient3d_a", NULL, {"p", "q"}, 0, "sum", "V_W", true, NULL,
    "orient3d of A's plane and B's vertices, term by term.", false},
  orient3d_a = {"s", "sepax_orient3d_a", NULL, {"p", "q", "r"}, 0, "sign", "2", false, NULL,
    "orient3d.", true},
  orient3d_b = {"w", "sepax_orient3d_b", NULL, {"p", "q", "r", "s"}, 1, "sign", "2", false, NULL,
    NULL, true},
  orient3d_edges = {"d", "sepax_orient3d_edges", NULL, {"p", "q", "r", "s"}, 2, "sign", "2",
    false, NULL, NULL, true},
  order_x = {"ox", NULL, NULL, {NULL}, 0, "order", "2", false, NULL, NULL, false},
  sign = {"gs", NULL, NULL, {"g"}, 0, NULL, "2", false, SIGN_OF("G_W"),
    "Signs {> 0, < 0} of orient2d.", false},
  own_sign = {"gos", NULL, NULL, {"g"}, 0, NULL, "2", false, SIGN_OF("G_W"), NULL, false},
  sum_sign = {"s", NULL, NULL, {"sum"}, 0, NULL, "2", false, SIGN_OF("V_W"), "Their signs.", false};
/* clang-format on */

static int add_kind(exact_graph *e, const graph_row *row, int latency) {
  return graph_kind_add(e->graph, row, "", latency, NULL);
}

/* -------------------------------------------------------------------------- nodes */

static const exact_triangle own_a = {0, 1, 2};
static const exact_triangle own_b = {3, 4, 5};

graph_value exact_add(exact_graph *e, int kind, exact_triangle v, const graph_value operand[],
                      graph_value beside) {
  const int *label = v.i > v.k ? GRAPH_OF(v.k, v.i, v.j) : GRAPH_OF(v.i, v.j, v.k);
  return graph_add(e->graph, kind, label, operand, beside);
}

/* A value and its permutations: the sign is that of the permutation. */
static void permute(graph_value f[6][6][6], exact_triangle v, graph_value value) {
  f[v.i][v.j][v.k] = f[v.j][v.k][v.i] = f[v.k][v.i][v.j] = value;
  f[v.j][v.i][v.k] = f[v.i][v.k][v.j] = f[v.k][v.j][v.i] = -value;
}

/* t_ij = (x_j - x_i) (y_i + y_j) */
static void make_trapezoid(exact_graph *e, int p, int i, int j) {
  const graph_value *x = e->coordinate[p];
  const graph_value *y = e->coordinate[(p + 1) % 3];
  e->t[p][i][j] = graph_add(e->graph, e->kind.trapezoid[p], GRAPH_OF(i, j),
                            GRAPH_IN(x[i], x[j], y[i], y[j]), 0);
  e->t[p][j][i] = -e->t[p][i][j];
}

/* g_ijk = t_ij + t_jk + t_ki */
static void make_orient2d(exact_graph *e, int p, int kind, exact_triangle v) {
  graph_value(*t)[6] = e->t[p];
  permute(e->g[p], v, exact_add(e, kind, v, GRAPH_IN(t[v.i][v.j], t[v.j][v.k], t[v.k][v.i]), 0));
}

/* Of A or of B; term by term in a unit of its own, where the sum runs. */
static void make_own_orient2d(exact_plan *p, int projection, exact_triangle v) {
  exact_graph *e = &p->graph;
  int kind = e->kind.own_orient2d[projection];
  if (!p->own_running) {
    make_orient2d(e, projection, kind, v);
    return;
  }
  const graph_value(*t)[6] = e->t[projection];
  graph_value sum = graph_constant(e->graph, "{G_W{1'b0}}", "G_W");
  sum = graph_add(e->graph, kind, GRAPH_OF(v.i, v.j), GRAPH_IN(sum, t[v.i][v.j]), 0);
  sum = graph_add(e->graph, kind, GRAPH_OF(v.j, v.k), GRAPH_IN(sum, t[v.j][v.k]), 0);
  sum = exact_add(e, kind, v, GRAPH_IN(sum, t[v.k][v.i]), 0);
  permute(e->g[projection], v, sum);
}

/* h_ijk = g_ijk z_ijk, z_ijk = z_i + z_j + z_k - z_0 - z_1 - z_2 */
static void make_prism(exact_graph *e, int kind, exact_triangle v, graph_value z) {
  graph_value g = e->g[0][v.i][v.j][v.k];
  permute(e->h, v, exact_add(e, kind, v, GRAPH_IN(g, z), g));
}

/* z_ijk: common terms cancel. What is left of a triangle with an edge of A is z_k less z of A's
 * third vertex; with an edge ij of B z_i + z_j less z of A's two others. */
static graph_value make_zsum(exact_plan *p, exact_triangle v) {
  exact_graph *e = &p->graph;
  const graph_value *z = e->coordinate[2];
  graph_value g = e->g[0][v.i][v.j][v.k];
  bool edge_of_a = v.i < v.k;
  int r = exact_a(edge_of_a ? v.j + 1 : v.k + 2);
  int s = exact_a(v.k + 1);
  if (p->stages.zdiff_shared) {
    return edge_of_a
               ? e->zdiff[r][v.k] = exact_add(e, e->kind.zdiff, v, GRAPH_IN(z[v.k], -z[r]), g)
               : exact_add(e, e->kind.zsum, v, GRAPH_IN(e->zdiff[s][v.i], e->zdiff[r][v.j]), g);
  }
  return edge_of_a ? exact_add(e, e->kind.zsum, v, GRAPH_IN(z[v.k], z[v.k], -z[r], -z[v.k]), g)
                   : exact_add(e, e->kind.zsum, v, GRAPH_IN(z[v.i], z[v.j], -z[r], -z[s]), g);
}

/* ------------------------------------------------------------------- projections */

void exact_graph_projection(exact_plan *p, int projection) {
  exact_graph *e = &p->graph;
  const exact_projection *n = &exact_projections[projection];
  int *orient2d_kind = &e->kind.orient2d[projection];
  int *own_kind = &e->kind.own_orient2d[projection];
  e->kind.trapezoid[projection] =
      graph_kind_add(e->graph, &trapezoid, n->suffix, exact_trapezoid_latency(p), n->slots_t);
  int latency = exact_orient2d_latency(p);
  const char *slots_g = projection == 0 && p->stages.slot_copies ? "g" : n->slots_g;
  *orient2d_kind = graph_kind_add(e->graph, &orient2d, n->suffix, latency, slots_g);
  *own_kind = graph_kind_add(e->graph, p->own_running ? &own_orient2d_running : &own_orient2d,
                             n->suffix, p->own_running ? 1 : latency, slots_g);
  for (int v = 0; v < 6; v++) {
    make_trapezoid(e, projection, v, exact_next(v));
  }
  for (int k = 0; k < 9; k++) {
    make_trapezoid(e, projection, exact_edges_of(k).i, exact_edges_of(k).k);
  }
  for (int k = 0; k < 18; k++) {
    make_orient2d(e, projection, *orient2d_kind, exact_triangle_of(k));
  }
  make_own_orient2d(p, projection, own_b);
  if (!p->single || p->limits > 0) {
    make_own_orient2d(p, projection, own_a);
  }
}

/* -------------------------------------------------------- z sums, prisms, orient3d */

/* z of B's own triangle. */
static graph_value make_own_zsum(exact_plan *p) {
  exact_graph *e = &p->graph;
  const graph_value *z = e->coordinate[2];
  int *kind = &e->kind.own_zsum;
  if (p->stages.zdiff_shared) {
    *kind = add_kind(e, &own_zsum_of_three, exact_own_zsum_latency(p));
    return exact_add(e, *kind, own_b, GRAPH_IN(e->zdiff[0][3], e->zdiff[1][4], e->zdiff[2][5]), 0);
  }
  if (!p->running) {
    *kind = add_kind(e, &own_zsum, exact_own_zsum_latency(p));
    return exact_add(e, *kind, own_b, GRAPH_IN(z[3], z[4], z[5], -z[0], -z[1], -z[2]), 0);
  }
  if (p->own_running) {
    e->kind.own_zdiff = add_kind(e, &own_zdiff, 1);
  }
  *kind = add_kind(e, p->own_running ? &own_zsum_of_diffs : &own_zsum_running,
                   exact_own_zsum_latency(p));
  graph_value sum = graph_constant(e->graph, "OWN_BIAS", "O_W");
  for (int k = 0; k < 3; k++) { /* one vertex of each triangle a cycle */
    const int *vertex = GRAPH_OF(exact_b(k));
    graph_value z_b = z[exact_b(k)];
    graph_value z_a = z[exact_a(k)];
    if (p->own_running) {
      graph_value diff = graph_add(e->graph, e->kind.own_zdiff, vertex, GRAPH_IN(z_b, -z_a), 0);
      sum = graph_add(e->graph, *kind, vertex, GRAPH_IN(sum, diff), 0);
    } else {
      sum = graph_add(e->graph, *kind, vertex, GRAPH_IN(sum, z_b, -z_a), 0);
    }
  }
  return sum;
}

static void make_prisms(exact_plan *p) {
  exact_graph *e = &p->graph;
  const exact_stages *s = &p->stages;
  graph_value z[18];
  if (s->zdiff_shared) {
    e->kind.zdiff = add_kind(e, &zdiff, 0);
  }
  e->kind.zsum = graph_kind_add(e->graph, s->zdiff_shared ? &zsum_of_two : &zsum, "",
                                exact_zsum_latency(p), s->slot_copies ? "z" : NULL);
  for (int n = 0; n < 18; n++) {
    z[n] = make_zsum(p, exact_triangle_of(n));
  }
  graph_value own = make_own_zsum(p);
  e->kind.prism = add_kind(e, &prism, exact_prism_latency(p, &s->prism));
  int of_two = s->zdiff_shared
                   ? add_kind(e, &prism_of_two, exact_prism_latency(p, &s->prism_of_two))
                   : e->kind.prism;
  for (int n = 0; n < 18; n++) {
    make_prism(e, n < 9 ? e->kind.prism : of_two, exact_triangle_of(n), z[n]);
  }
  int kind = add_kind(e, &own_prism, exact_prism_latency(p, &s->own_prism));
  make_prism(e, kind, own_b, own);
}

/* orient3d over A, term by term at II = 3: in slot k unit r adds the prism over edge k to the sum
 * that it takes over from unit r + 1; behind slot 2 the sums are whole. */
static void make_running_sums(exact_plan *p) {
  exact_graph *e = &p->graph;
  graph_value(*h)[6][6] = e->h;
  graph_value zero = graph_constant(e->graph, "{V_W{1'b0}}", "V_W");
  graph_value sum[3] = {zero, zero, zero};
  e->kind.running_sum = add_kind(e, &running_sum, 1);
  for (int k = 0; k < 3; k++) {
    graph_value before[3] = {sum[0], sum[1], sum[2]};
    for (int r = 0; r < 3; r++) {
      graph_value term = h[exact_a(k)][exact_a(k + 1)][exact_b(k + r)];
      const int *label = k < 2 ? GRAPH_OF(exact_a(k), exact_b(k + r)) : GRAPH_OF(exact_b(k + r));
      sum[r] = graph_add(e->graph, e->kind.running_sum, label, GRAPH_IN(before[(r + 1) % 3], term),
                         term);
    }
  }
  int kind = p->limits > 0 ? -1 : add_kind(e, &sum_sign, 0);
  for (int r = 0; r < 3; r++) {
    int v = (r + 2) % 3;
    e->s[v] = p->limits > 0
                  ? sum[r]
                  : graph_add(e->graph, kind, GRAPH_OF(exact_b(v)), GRAPH_IN(sum[r]), sum[r]);
  }
}

/* Signs, or, with a clearance, whole volumes. */
static int add_orient3d(exact_plan *p, graph_row row) {
  if (p->limits > 0) {
    row.output = "volume";
    row.width = "V_W";
    row.is_signed = true;
  }
  return add_kind(&p->graph, &row, exact_orient3d_latency(p));
}

/* orient3d(i, j, k, l) = h_jkl - h_ikl + h_ijl - h_ijk; A's own h is zero. Operands by class, so
 * that a rotation changes no operand's unit. */
static void make_orient3d(exact_plan *p) {
  exact_graph *e = &p->graph;
  graph *g = e->graph;
  graph_value(*h)[6][6] = e->h;
  if (p->running) {
    make_running_sums(p);
  } else {
    int kind = add_orient3d(p, orient3d_a);
    for (int i = 0; i < 3; i++) {
      int j = exact_next(i);
      int k = exact_next(j);
      int l = exact_b(i);
      e->s[i] = graph_add(g, kind, GRAPH_OF(l), GRAPH_IN(h[i][j][l], h[k][i][l], h[j][k][l]), 0);
    }
  }
  int kind = add_orient3d(p, orient3d_b);
  for (int i = 0; i < 3; i++) {
    int j = exact_b(i);
    int k = exact_next(j);
    int l = exact_next(k);
    e->w[i] = graph_add(g, kind, GRAPH_OF(i),
                        GRAPH_IN(h[i][j][k], h[i][k][l], h[i][l][j], -h[3][4][5]), 0);
  }
  kind = add_orient3d(p, orient3d_edges);
  for (int n = 0; n < 9; n++) {
    exact_edges v = exact_edges_of(n);
    e->d[v.i][v.k - 3] = graph_add(
        g, kind, GRAPH_OF(v.i, v.j, v.k, v.l),
        GRAPH_IN(h[v.j][v.k][v.l], -h[v.i][v.k][v.l], h[v.i][v.j][v.l], -h[v.i][v.j][v.k]), 0);
  }
}

/* -------------------------------------------------------------- what is read of it */

/* Signs for the coplanar pair, with the order of vertices in x. */
static void make_projection(exact_plan *p) {
  exact_graph *e = &p->graph;
  int in_x = add_kind(e, &order_x, exact_order_latency(p));
  int of_both = add_kind(e, &sign, 0);
  int of_one = add_kind(e, &own_sign, 0);
  enum { G_A, G_B, G_OWN, X };
  static const char *const port[] = {"g_a", "g_b", "g_own", "x_order"};
  exact_bus *bus = e->projection;
  for (size_t i = 0; i < sizeof port / sizeof port[0]; i++) {
    bus[i].port = port[i];
  }
  for (int n = 0; n < 18; n++) {
    exact_triangle v = exact_triangle_of(n);
    graph_value of = e->g[0][v.i][v.j][v.k];
    graph_value s = exact_add(e, of_both, v, GRAPH_IN(of), of);
    if (n >= 9) {
      bus[G_B].value[3 * (v.i - 3) + v.k] = s;
      continue;
    }
    int b = v.k - 3;
    bus[G_A].value[3 * v.i + b] = s;
    bus[X].value[3 * v.i + b] =
        graph_add(e->graph, in_x, GRAPH_OF(v.i, v.k), GRAPH_NONE, e->t[0][v.i][v.k]);
  }
  graph_value b = e->g[0][3][4][5];
  graph_value a = e->g[0][0][1][2];
  bus[G_OWN].value[1] = exact_add(e, of_one, own_b, GRAPH_IN(b), b);
  bus[G_OWN].value[0] = exact_add(e, of_one, own_a, GRAPH_IN(a), a);
}

void exact_graph_make(exact_plan *p) {
  exact_graph *e = &p->graph;
  e->graph = &p->datapath.graph;
  for (int axis = 0; axis < 3; axis++) {
    for (int v = 0; v < 6; v++) {
      e->coordinate[axis][v] = graph_coordinate(e->graph, axis, v);
    }
  }
  exact_graph_projection(p, 0);
  make_prisms(p);
  make_orient3d(p);
  if (!p->single) {
    make_projection(p);
  }
  if (p->limits > 0) {
    clearance_graph(p);
    return;
  }
  static const char *const port[] = {"s", "w", "d"};
  const graph_value *const value[] = {e->s, e->w, e->d[0]};
  for (int i = 0; i < 3; i++) {
    e->verdict[i].port = port[i];
    memcpy(e->verdict[i].value, value[i], (i < 2 ? 3 : 9) * sizeof(graph_value));
  }
}
