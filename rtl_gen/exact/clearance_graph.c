/* SPDX-License-Identifier: MIT */
/* clearance_graph.c - what a clearance adds to the expression graph: is what separates farther than
 * its limit? */
#include "clearance.h"

/* One row a kind: symbol, module, lesser module, operands, how many it subtracts, output, width,
 * signed, expression, comment, whether it commutes. */
/* clang-format off */
static const graph_row
  cross = {"c", "sepax_cross", NULL, {"p", "q"}, 1, "c", "C_W", true, NULL,
    "Components of e x f.", false},
  limit = {"l", "sepax_limit", NULL, {"x", "y", "z"}, 0, "limit", "LIMITS*L_W", false, NULL,
    "Limits on e x f, on N_B and N_A.", false},
  own_limit = {"lo", "sepax_own_limit", NULL, {"x", "y", "z"}, 0, "limit", "LIMITS*L_W", false,
    NULL, NULL, false},
  edge_limit[3] = {{"le", "sepax_edge_limit", NULL, {"x_from", "x_to", "y_from", "y_to",
    "z_from", "z_to"}, 0, "limit_xy", "M_W", false, NULL, "Limits on edges.", false},
    {"le", NULL, NULL, {NULL}, 0, "limit_yz", "M_W", false, NULL, NULL, false},
    {"le", NULL, NULL, {NULL}, 0, "limit_zx", "M_W", false, NULL, NULL, false}},
  exceeds_edge = {"ge", "sepax_exceeds_edge", NULL, {"g", "limit"}, 0, "exceeds", "LIMITS+1",
    false, NULL, "Does orient2d exceed the limit of the edge?", false},
  edge_outside = {"e", "sepax_edge_outside", NULL, {"b_1", "b_2", "b_3", "own"}, 0, "outside",
    "LIMITS", false, NULL, "Is the other triangle outside the clearance of the edge?", false},
  aabb_outside = {"box", "sepax_aabb_outside", NULL, {"a_1", "a_2", "a_3", "b_1", "b_2", "b_3"},
    0, "outside", "LIMITS", false, NULL, "Are the AABBs outside the clearance?", false},
  exceeds = {"f", "sepax_exceeds", NULL, {"v", "limit"}, 0, "exceeds", "LIMITS+2", false, NULL,
    "Does orient3d exceed the limit of the axis?", false},
  slope = {"r", "sepax_slope", NULL, {"p", "q"}, 0, "slope", "2", false, NULL,
    "How orient3d changes along an edge.", false};
/* clang-format on */

/* Components of e_i x f_j, from orient2d of e_i and both ends of f_j. */
static void make_crosses(exact_graph *e, graph_value c[3][3][3]) {
  for (int p = 0; p < 3; p++) {
    int kind = graph_kind_add(e->graph, &cross, exact_projections[p].suffix, 1, "limit");
    for (int n = 0; n < 9; n++) {
      exact_edges v = exact_edges_of(n);
      const graph_value *g = e->g[p][v.i][v.j];
      c[p][v.i][v.k - 3] =
          graph_add(e->graph, kind, GRAPH_OF(v.i, v.j, v.k, v.l), GRAPH_IN(g[v.l], -g[v.k]), 0);
    }
  }
}

/* Edges of A, then of B: the limits in the three projections, from one unit. */
static void make_edge_limits(exact_plan *p, graph_value le[3][6]) {
  exact_graph *e = &p->graph;
  const graph_value *x = e->coordinate[0];
  const graph_value *y = e->coordinate[1];
  const graph_value *z = e->coordinate[2];
  int kind[3];
  for (int n = 0; n < 3; n++) {
    kind[n] = graph_kind_add(e->graph, &edge_limit[n], exact_projections[n].suffix,
                             3 + p->stages.total, "limit");
  }
  for (int v = 0; v < 6; v++) {
    int to = exact_next(v);
    le[0][v] = graph_add(e->graph, kind[0], GRAPH_OF(v, to),
                         GRAPH_IN(x[v], x[to], y[v], y[to], z[v], z[to]), 0);
    for (int n = 1; n < 3; n++) {
      le[n][v] = graph_add(e->graph, kind[n], GRAPH_OF(v, to), GRAPH_NONE, le[0][v]);
    }
  }
}

/* In a projection: whether orient2d of an edge and the other triangle's vertices exceed its limit;
 * whether all do on the side where its own triangle is not. */
static void make_edges(exact_graph *e, int p, const graph_value le[6], graph_value outside[6]) {
  graph_value(*g)[6][6] = e->g[p];
  graph_value found[6][6]; /* of edge v and a vertex of the other triangle */
  int kind = graph_kind_add(e->graph, &exceeds_edge, exact_projections[p].suffix, 1, "edge");
  int all = graph_kind_add(e->graph, &edge_outside, exact_projections[p].suffix, 1, "edge");
  for (int n = 0; n < 18; n++) {
    exact_triangle v = exact_triangle_of(n);
    graph_value of = g[v.i][v.j][v.k];
    found[v.i][v.k] = exact_add(e, kind, v, GRAPH_IN(of, le[v.i]), of);
  }
  for (int v = 0; v < 6; v++) { /* operands by class, so that a rotation changes no unit */
    int i = v % 3;
    const graph_value *f = found[v];
    outside[v] =
        graph_add(e->graph, all, GRAPH_OF(v, exact_next(v)),
                  v < 3 ? GRAPH_IN(f[exact_b(i)], f[exact_b(i + 1)], f[exact_b(i + 2)], g[0][1][2])
                        : GRAPH_IN(f[i], f[exact_a(i + 2)], f[exact_a(i + 1)], g[3][4][5]),
                  0);
  }
}

static void make_boxes(exact_graph *e, graph_value outside[3]) {
  int kind = graph_kind_add(e->graph, &aabb_outside, "", 2, "box");
  for (int axis = 0; axis < 3; axis++) {
    const graph_value *x = e->coordinate[axis];
    outside[axis] = graph_add(e->graph, kind, GRAPH_OF(GRAPH_AXIS + axis),
                              GRAPH_IN(x[0], x[1], x[2], x[3], x[4], x[5]), 0);
  }
}

/* The limit of the normal of a triangle. */
static graph_value add_own_limit(exact_graph *e, int kind, int v) {
  return graph_add(
      e->graph, kind, GRAPH_OF(v, v + 1, v + 2),
      GRAPH_IN(e->g[0][v][v + 1][v + 2], e->g[1][v][v + 1][v + 2], e->g[2][v][v + 1][v + 2]), 0);
}

/* orient3d against the limits of its axis; bus 0, 1, 2: s, w, d. */
static void make_exceeds(exact_plan *p, graph_value c[3][3][3], exact_bus *bus) {
  exact_graph *e = &p->graph;
  graph *g = e->graph;
  int latency = 3 + p->stages.most + p->stages.total;
  int of_edges = graph_kind_add(g, &limit, "", latency, "limit");
  int own = graph_kind_add(g, &own_limit, "", latency, "limit");
  graph_value l[3][3];
  for (int n = 0; n < 9; n++) {
    exact_edges v = exact_edges_of(n);
    int i = v.i;
    int j = v.k - 3;
    l[i][j] = graph_add(g, of_edges, GRAPH_OF(v.i, v.j, v.k, v.l),
                        GRAPH_IN(c[0][i][j], c[1][i][j], c[2][i][j]), 0);
  }
  graph_value of_b = add_own_limit(e, own, 3);
  graph_value of_a = add_own_limit(e, own, 0);
  int kind_s = graph_kind_add(g, &exceeds, "s", 1, "exceeds");
  int kind_w = graph_kind_add(g, &exceeds, "w", 1, "exceeds");
  int kind_d = graph_kind_add(g, &exceeds, "d", 1, "exceeds");
  for (int i = 0; i < 3; i++) {
    bus[0].value[i] = graph_add(g, kind_s, GRAPH_OF(exact_b(i)), GRAPH_IN(e->s[i], of_a), 0);
    bus[1].value[i] = graph_add(g, kind_w, GRAPH_OF(i), GRAPH_IN(e->w[i], of_b), 0);
  }
  for (int n = 0; n < 9; n++) {
    exact_edges v = exact_edges_of(n);
    int j = v.k - 3;
    bus[2].value[3 * v.i + j] =
        graph_add(g, kind_d, GRAPH_OF(v.i, v.j, v.k, v.l), GRAPH_IN(e->d[v.i][j], l[v.i][j]), 0);
  }
}

/* How s changes along B's edges, w along A's. */
static void make_slopes(exact_graph *e, exact_bus *bus) {
  int kind_s = graph_kind_add(e->graph, &slope, "s", 1, "exceeds");
  int kind_w = graph_kind_add(e->graph, &slope, "w", 1, "exceeds");
  for (int i = 0; i < 3; i++) {
    int j = exact_next(i);
    bus[0].value[i] = graph_add(e->graph, kind_s, GRAPH_OF(exact_b(i), exact_b(j)),
                                GRAPH_IN(e->s[i], e->s[j]), 0);
    bus[1].value[i] = graph_add(e->graph, kind_w, GRAPH_OF(i, j), GRAPH_IN(e->w[i], e->w[j]), 0);
  }
}

void clearance_graph(exact_plan *p) {
  static const char *const port[] = {"f_s",  "f_w",  "f_d",  "r_s", "r_w",
                                     "e_xy", "e_yz", "e_zx", "box"};
  exact_graph *e = &p->graph;
  exact_bus *bus = e->verdict;
  graph_value c[3][3][3]; /* component n of e_i x f_j */
  graph_value le[3][6];
  for (size_t i = 0; i < sizeof port / sizeof port[0]; i++) {
    bus[i].port = port[i];
  }
  exact_graph_projection(p, 1);
  exact_graph_projection(p, 2);
  make_crosses(e, c);
  make_exceeds(p, c, bus);
  make_slopes(e, bus + 3);
  make_edge_limits(p, le);
  for (int n = 0; n < 3; n++) {
    make_edges(e, n, le[n], bus[5 + n].value);
  }
  make_boxes(e, bus[8].value);
}
