/* graph.c - what a clearance adds to the expression graph: is what separates farther than its
 * limit? */
#include "clearance.h"

/* One row a kind: symbol, module, lesser module, operands, how many it subtracts, output, width,
 * signed, expression, comment. */
/* clang-format off */
static const graph_row
  cross = {"c", "sepax_cross", NULL, {"p", "q"}, 1, "c", "C_W", true, NULL,
    "Components of e x f."},
  limit = {"l", "sepax_limit", NULL, {"x", "y", "z"}, 0, "limit", "LIMITS*L_W", false, NULL,
    "Limits on e x f, on N_B and N_A."},
  own_limit = {"lo", "sepax_own_limit", NULL, {"x", "y", "z"}, 0, "limit", "LIMITS*L_W", false,
    NULL, NULL},
  edge_limit[3] = {{"le", "sepax_edge_limit", NULL, {"x_from", "x_to", "y_from", "y_to",
    "z_from", "z_to"}, 0, "limit_xy", "M_W", false, NULL, "Limits on edges."},
    {"le", NULL, NULL, {NULL}, 0, "limit_yz", "M_W", false, NULL, NULL},
    {"le", NULL, NULL, {NULL}, 0, "limit_zx", "M_W", false, NULL, NULL}},
  exceeds_edge = {"ge", "sepax_exceeds_edge", NULL, {"g", "limit"}, 0, "exceeds", "LIMITS+1",
    false, NULL, "Does orient2d exceed the limit of the edge?"},
  edge_outside = {"e", "sepax_edge_outside", NULL, {"b_1", "b_2", "b_3", "own"}, 0, "outside",
    "LIMITS", false, NULL, "Is the other triangle outside the clearance of the edge?"},
  aabb_outside = {"box", "sepax_aabb_outside", NULL, {"a_1", "a_2", "a_3", "b_1", "b_2", "b_3"},
    0, "outside", "LIMITS", false, NULL, "Are the AABBs outside the clearance?"},
  exceeds[3] = {{"fs", "sepax_exceeds", NULL, {"v", "limit"}, 0, "exceeds", "LIMITS+2", false,
    NULL, "Does orient3d exceed the limit of the axis?"},
    {"fw", "sepax_exceeds", NULL, {"v", "limit"}, 0, "exceeds", "LIMITS+2", false, NULL, NULL},
    {"fd", "sepax_exceeds", NULL, {"v", "limit"}, 0, "exceeds", "LIMITS+2", false, NULL, NULL}},
  slope[2] = {{"rs", "sepax_slope", NULL, {"p", "q"}, 0, "slope", "2", false, NULL,
    "How orient3d changes along an edge."},
    {"rw", "sepax_slope", NULL, {"p", "q"}, 0, "slope", "2", false, NULL, NULL}};
/* clang-format on */

/* Components of e_i x f_j, from orient2d of e_i and both ends of f_j. */
static void make_crosses(exact_plan *p, graph_value c[3][3][3]) {
  exact_graph *e = &p->graph;
  for (int n = 0; n < 3; n++) {
    int kind = graph_kind_add(e->graph, &cross, exact_projection_suffix(n), 1, "limit");
    for (int r = 0; r < 3; r++) {
      for (int k = 0; k < 3; k++) {
        int i[2] = {exact_a(k), exact_a(k + 1)};
        int j[2] = {exact_b(k + r), exact_b(k + r + 1)};
        graph_value(*g)[6] = e->g[n][i[0]];
        c[n][k][j[0] - 3] = graph_add(e->graph, kind, GRAPH_OF(i[0], i[1], j[0], j[1]),
                                      GRAPH_IN(g[i[1]][j[1]], -g[i[1]][j[0]]), 0);
      }
    }
  }
}

/* Edges of A, then of B: in each projection its limit; whether orient2d of the edge and the other
 * triangle's vertices exceed it; whether all do on the side where its own triangle is not. */
static void make_edges(exact_plan *p, exact_bus *bus) {
  exact_graph *e = &p->graph;
  graph_value le[3][6];
  int limit_kind[3];
  for (int n = 0; n < 3; n++) {
    limit_kind[n] = graph_kind_add(e->graph, &edge_limit[n], exact_projection_suffix(n),
                                   3 + p->stages.total, "limit");
  }
  for (int v = 0; v < 6; v++) {
    int to = v < 3 ? exact_a(v + 1) : exact_b(v - 2);
    graph_value(*of)[6] = e->coordinate;
    le[0][v] =
        graph_add(e->graph, limit_kind[0], GRAPH_OF(v, to),
                  GRAPH_IN(of[0][v], of[0][to], of[1][v], of[1][to], of[2][v], of[2][to]), 0);
    for (int n = 1; n < 3; n++) {
      le[n][v] =
          graph_add(e->graph, limit_kind[n], GRAPH_OF(v, to), (const graph_value[]){0}, le[0][v]);
    }
  }
  static const char *const port[] = {"e_xy", "e_yz", "e_zx"};
  for (int n = 0; n < 3; n++) {
    const char *suffix = exact_projection_suffix(n);
    graph_value(*g)[6][6] = e->g[n];
    graph_value found[6][6]; /* of edge v and a vertex of the other triangle */
    int kind = graph_kind_add(e->graph, &exceeds_edge, suffix, 1, "edge");
    int outside = graph_kind_add(e->graph, &edge_outside, suffix, 1, "edge");
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        int i[2] = {exact_a(c), exact_a(c + 1)};
        int b = exact_b(c + r);
        graph_value of = g[i[0]][i[1]][b];
        found[c][b] =
            graph_add(e->graph, kind, GRAPH_OF(i[0], i[1], b), GRAPH_IN(of, le[n][c]), of);
      }
    }
    for (int r = 0; r < 3; r++) {
      for (int c = 0; c < 3; c++) {
        int j[2] = {exact_b(c + r), exact_b(c + r + 1)};
        graph_value of = g[c][j[0]][j[1]];
        found[j[0]][c] =
            graph_add(e->graph, kind, GRAPH_OF(c, j[0], j[1]), GRAPH_IN(of, le[n][j[0]]), of);
      }
    }
    bus[n].port = port[n];
    for (int v = 0; v < 6; v++) { /* operands by class, so that a rotation changes no unit */
      int i = v % 3;
      const graph_value *f = found[v];
      bus[n].value[v] = graph_add(
          e->graph, outside, GRAPH_OF(v, v < 3 ? exact_a(v + 1) : exact_b(v - 2)),
          v < 3 ? GRAPH_IN(f[exact_b(i)], f[exact_b(i + 1)], f[exact_b(i + 2)], g[0][1][2])
                : GRAPH_IN(f[i], f[exact_a(i + 2)], f[exact_a(i + 1)], g[3][4][5]),
          0);
    }
  }
}

static void make_boxes(exact_plan *p, exact_bus *bus) {
  exact_graph *e = &p->graph;
  int kind = graph_kind_add(e->graph, &aabb_outside, "", 2, "box");
  bus->port = "box";
  for (int axis = 0; axis < 3; axis++) {
    const graph_value *x = e->coordinate[axis];
    bus->value[axis] = graph_add(e->graph, kind, GRAPH_OF(GRAPH_AXIS + axis),
                                 GRAPH_IN(x[0], x[1], x[2], x[3], x[4], x[5]), 0);
  }
}

/* orient3d against the limits of its axis; bus 0, 1, 2: s, w, d. */
static void make_exceeds(exact_plan *p, graph_value c[3][3][3], exact_bus *bus) {
  exact_graph *e = &p->graph;
  graph *g = e->graph;
  int latency = 3 + p->stages.most + p->stages.total;
  int kind = graph_kind_add(g, &limit, "", latency, "limit");
  int own_kind = graph_kind_add(g, &own_limit, "", latency, "limit");
  graph_value l[3][3];
  for (int r = 0; r < 3; r++) {
    for (int i = 0; i < 3; i++) {
      int j = exact_b(i + r) - 3;
      l[i][j] = graph_add(g, kind, GRAPH_OF(i, exact_a(i + 1), 3 + j, exact_b(j + 1)),
                          GRAPH_IN(c[0][i][j], c[1][i][j], c[2][i][j]), 0);
    }
  }
  graph_value of_b = graph_add(g, own_kind, GRAPH_OF(3, 4, 5),
                               GRAPH_IN(e->g[0][3][4][5], e->g[1][3][4][5], e->g[2][3][4][5]), 0);
  graph_value of_a = graph_add(g, own_kind, GRAPH_OF(0, 1, 2),
                               GRAPH_IN(e->g[0][0][1][2], e->g[1][0][1][2], e->g[2][0][1][2]), 0);
  kind = graph_kind_add(g, &exceeds[0], "", 1, "exceeds");
  int kind_w = graph_kind_add(g, &exceeds[1], "", 1, "exceeds");
  int kind_d = graph_kind_add(g, &exceeds[2], "", 1, "exceeds");
  static const char *const port[] = {"f_s", "f_w", "f_d"};
  for (int n = 0; n < 3; n++) {
    bus[n].port = port[n];
  }
  for (int i = 0; i < 3; i++) {
    bus[0].value[i] = graph_add(g, kind, GRAPH_OF(exact_b(i)), GRAPH_IN(e->s[i], of_a), 0);
    bus[1].value[i] = graph_add(g, kind_w, GRAPH_OF(i), GRAPH_IN(e->w[i], of_b), 0);
  }
  for (int r = 0; r < 3; r++) {
    for (int i = 0; i < 3; i++) {
      int j = exact_b(i + r) - 3;
      bus[2].value[3 * i + j] =
          graph_add(g, kind_d, GRAPH_OF(i, exact_a(i + 1), 3 + j, exact_b(j + 1)),
                    GRAPH_IN(e->d[i][j], l[i][j]), 0);
    }
  }
}

/* How s changes along B's edges, w along A's. */
static void make_slopes(exact_plan *p, exact_bus *bus) {
  exact_graph *e = &p->graph;
  int kind_s = graph_kind_add(e->graph, &slope[0], "", 1, "exceeds");
  int kind_w = graph_kind_add(e->graph, &slope[1], "", 1, "exceeds");
  bus[0].port = "r_s";
  bus[1].port = "r_w";
  for (int i = 0; i < 3; i++) {
    int next = exact_a(i + 1);
    bus[0].value[i] = graph_add(e->graph, kind_s, GRAPH_OF(exact_b(i), exact_b(next)),
                                GRAPH_IN(e->s[i], e->s[next]), 0);
    bus[1].value[i] =
        graph_add(e->graph, kind_w, GRAPH_OF(i, next), GRAPH_IN(e->w[i], e->w[next]), 0);
  }
}

void clearance_graph(exact_plan *p) {
  graph_value c[3][3][3]; /* component n of e_i x f_j */
  exact_bus *bus = p->graph.verdict;
  exact_graph_projection(p, 1);
  exact_graph_projection(p, 2);
  make_crosses(p, c);
  make_exceeds(p, c, bus);
  make_slopes(p, bus + 3);
  make_edges(p, bus + 5);
  make_boxes(p, bus + 8);
}
