/* graph.c - what a clearance adds to the expression graph: is what separates farther than its
 * limit? */
#include "clearance.h"

#define LIMIT_W "LIMITS*L_W"
#define EDGE_LIMIT_W "M_W"

static const graph_row cross = {.symbol = "c",
                                .module = "sepax_cross",
                                .operand = {"p", "q"},
                                .negative = 1,
                                .output = "c",
                                .parameters = "",
                                .width = "C_W",
                                .is_signed = true,
                                .about = "Components of e x f."};
static const graph_row limit = {.symbol = "l",
                                .module = "sepax_limit",
                                .operand = {"x", "y", "z"},
                                .output = "limit",
                                .parameters = "",
                                .width = LIMIT_W,
                                .about = "Limits on e x f, on N_B and N_A, on edges."};
static const graph_row own_limit = {.symbol = "lo",
                                    .module = "sepax_own_limit",
                                    .operand = {"x", "y", "z"},
                                    .output = "limit",
                                    .parameters = "",
                                    .width = LIMIT_W};
static const graph_row edge_limit = {
    .symbol = "le",
    .module = "sepax_edge_limit",
    .operand = {"x_from", "x_to", "y_from", "y_to", "z_from", "z_to"},
    .output = "limit_xy",
    .parameters = "",
    .width = EDGE_LIMIT_W};
static const graph_row more_edge_limit[2] = {
    {.symbol = "le", .output = "limit_yz", .width = EDGE_LIMIT_W},
    {.symbol = "le", .output = "limit_zx", .width = EDGE_LIMIT_W}};
static const graph_row exceeds_edge = {.symbol = "ge",
                                       .module = "sepax_exceeds_edge",
                                       .operand = {"g", "limit"},
                                       .output = "exceeds",
                                       .parameters = "",
                                       .width = "LIMITS+1",
                                       .about = "Does orient2d exceed the limit of the edge?"};
static const graph_row edge_outside = {
    .symbol = "e",
    .module = "sepax_edge_outside",
    .operand = {"b_1", "b_2", "b_3", "own"},
    .output = "outside",
    .parameters = "",
    .width = "LIMITS",
    .about = "Is the other triangle outside the clearance of the edge?"};
static const graph_row aabb_outside = {.symbol = "box",
                                       .module = "sepax_aabb_outside",
                                       .operand = {"a_1", "a_2", "a_3", "b_1", "b_2", "b_3"},
                                       .output = "outside",
                                       .parameters = "",
                                       .width = "LIMITS",
                                       .about = "Is the gap of the AABBs outside the clearance?"};
static const graph_row exceeds = {.module = "sepax_exceeds",
                                  .operand = {"v", "limit"},
                                  .output = "exceeds",
                                  .parameters = "",
                                  .width = "LIMITS+2"};
static const graph_row slope = {.module = "sepax_slope",
                                .operand = {"p", "q"},
                                .output = "slope",
                                .parameters = "",
                                .width = "2"};

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
  limit_kind[0] = graph_kind_add(e->graph, &edge_limit, "", 3 + p->stages.total, "limit");
  for (int n = 1; n < 3; n++) {
    limit_kind[n] = graph_kind_add(e->graph, &more_edge_limit[n - 1], exact_projection_suffix(n),
                                   3 + p->stages.total, NULL);
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

static int add_kind(exact_plan *p, const graph_row *of, const char *symbol, const char *about) {
  graph_row row = *of;
  row.symbol = symbol;
  row.about = about;
  return graph_kind_add(p->graph.graph, &row, "", 1, "exceeds");
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
  kind = add_kind(p, &exceeds, "fs", "Does orient3d exceed the limit of the axis?");
  int kind_w = add_kind(p, &exceeds, "fw", NULL);
  int kind_d = add_kind(p, &exceeds, "fd", NULL);
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
  int kind_s = add_kind(p, &slope, "rs", "How orient3d changes along an edge.");
  int kind_w = add_kind(p, &slope, "rw", NULL);
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
