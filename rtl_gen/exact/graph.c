/* graph.c - the exact datapath as an expression graph: the formulas of docs/exact.md. */
#include "clearance/clearance.h"
#include "exact.h"

int exact_a(int i) { return i % 3; }
int exact_b(int j) { return 3 + j % 3; }

const char *exact_projection_suffix(int projection) {
  static const char *const suffix[] = {"", "_yz", "_zx"};
  return suffix[projection];
}

/* ------------------------------------------------------------- kinds of operations */

#define SIGN(width) "{!@[" width "-1] && (@ != {" width "{1'b0}}), @[" width "-1]}"

static const graph_row trapezoid = {.symbol = "t",
                                    .module = "sepax_trapezoid_ab",
                                    .lesser = "sepax_trapezoid",
                                    .operand = {"x_from", "x_to", "y_from", "y_to"},
                                    .output = "t",
                                    .parameters = "W=W, S_W=S_W, G_W=G_W",
                                    .width = "G_W",
                                    .is_signed = true,
                                    .about = "Trapezoid terms."};
static const graph_row order_x = {.symbol = "ox", .output = "order", .width = "2"};
static const graph_row orient2d = {.symbol = "g",
                                   .module = "sepax_orient2d",
                                   .operand = {"p", "q", "r"},
                                   .negative = 1,
                                   .output = "g",
                                   .parameters = "G_W=G_W",
                                   .width = "G_W",
                                   .is_signed = true,
                                   .about = "orient2d of vertices of both triangles."};
static const graph_row own_orient2d = {.symbol = "go",
                                       .module = "sepax_own_orient2d",
                                       .operand = {"p", "q", "r"},
                                       .output = "g",
                                       .parameters = "G_W=G_W",
                                       .width = "G_W",
                                       .is_signed = true,
                                       .about = "orient2d of B, of A."};
static const graph_row sign = {.symbol = "gs",
                               .operand = {"g"},
                               .width = "2",
                               .expression = SIGN("G_W"),
                               .about = "Their signs {> 0, < 0}."};
static const graph_row zsum = {.symbol = "z",
                               .module = "sepax_zsum",
                               .lesser = "sepax_zdiff",
                               .operand = {"z_p", "?z_q", "z_r", "?z_s"},
                               .negative = 2,
                               .output = "z",
                               .parameters = "W=W, Z_W=Z_W, DIGITS=DIGITS",
                               .width = "Z_W",
                               .is_signed = true,
                               .about = "z sums."};
static const graph_row zdiff = {.symbol = "z",
                                .module = "sepax_zdiff",
                                .operand = {"z_p", "z_r"},
                                .negative = 1,
                                .output = "z",
                                .parameters = "W=W, Z_W=Z_W, DIGITS=DIGITS",
                                .width = "Z_W",
                                .is_signed = true,
                                .about = "z differences, in the same cycle."};
static const graph_row zsum_of_two = {.symbol = "z",
                                      .module = "sepax_zsum",
                                      .operand = {"diff_1", "diff_2"},
                                      .output = "z",
                                      .parameters = "Z_W=Z_W",
                                      .width = "Z_W",
                                      .is_signed = true,
                                      .about = "z sums of two differences."};
static const graph_row order_z = {.symbol = "oz",
                                  .operand = {"z"},
                                  .width = "2",
                                  .expression = "{@ > BIAS, @ < BIAS}",
                                  .about = "Signs of z differences."};
static const graph_row own_zsum = {.symbol = "zo",
                                   .module = "sepax_own_zsum",
                                   .operand = {"z_b1", "z_b2", "z_b3", "z_a1", "z_a2", "z_a3"},
                                   .negative = 3,
                                   .output = "z",
                                   .parameters = "W=W, O_W=O_W, DIGITS=OWN_DIGITS",
                                   .width = "O_W",
                                   .is_signed = true};
static const graph_row own_zsum_of_three = {
    .symbol = "zo",
    .module = "sepax_own_zsum",
    .operand = {"diff_1", "diff_2", "diff_3"},
    .output = "z",
    .parameters = "Z_W=Z_W, DIFF_DIGITS=DIGITS, O_W=O_W, DIGITS=OWN_DIGITS",
    .width = "O_W",
    .is_signed = true};
static const graph_row own_zsum_running = {.symbol = "zo",
                                           .module = "sepax_own_zsum",
                                           .operand = {"so_far", "z_b", "z_a"},
                                           .negative = 1,
                                           .output = "z",
                                           .parameters = "W=W, O_W=O_W",
                                           .width = "O_W",
                                           .is_signed = true};
static const graph_row prism = {.symbol = "h",
                                .module = "sepax_prism",
                                .operand = {"g", "z"},
                                .output = "h",
                                .parameters = "G_W=G_W, Z_W=Z_W, V_W=V_W",
                                .width = "V_W",
                                .is_signed = true,
                                .about = "Signed prism volumes."};
static const graph_row prism_of_two = {.symbol = "h",
                                       .module = "sepax_prism_2",
                                       .operand = {"g", "z"},
                                       .output = "h",
                                       .parameters = "G_W=G_W, Z_W=Z_W, V_W=V_W",
                                       .width = "V_W",
                                       .is_signed = true};
static const graph_row own_prism = {.symbol = "ho",
                                    .module = "sepax_own_prism",
                                    .operand = {"g", "z"},
                                    .output = "h",
                                    .parameters = "G_W=G_W, Z_W=O_W, V_W=V_W",
                                    .width = "V_W",
                                    .is_signed = true};
static const graph_row running_sum = {.symbol = "v",
                                      .module = "sepax_orient3d_a",
                                      .operand = {"p", "q"},
                                      .output = "sum",
                                      .parameters = "V_W=V_W",
                                      .width = "V_W",
                                      .is_signed = true,
                                      .about =
                                          "orient3d of A's plane and B's vertices, term by term."};
static const graph_row sum_sign = {.symbol = "s",
                                   .operand = {"sum"},
                                   .width = "2",
                                   .expression = SIGN("V_W"),
                                   .about = "Their signs."};
static const graph_row orient3d[3] = {{.symbol = "s",
                                       .module = "sepax_orient3d_a",
                                       .operand = {"p", "q", "r"},
                                       .about = "orient3d of A's plane and B's vertices."},
                                      {.symbol = "w",
                                       .module = "sepax_orient3d_b",
                                       .operand = {"p", "q", "r", "s"},
                                       .negative = 1,
                                       .about = "orient3d of B's plane and A's vertices."},
                                      {.symbol = "d",
                                       .module = "sepax_orient3d_edges",
                                       .operand = {"p", "q", "r", "s"},
                                       .negative = 2,
                                       .about = "orient3d of an edge of A and an edge of B."}};

/* -------------------------------------------------------------------------- nodes */

/* A value and its permutations: the sign is that of the permutation. */
static void permute(graph_value v[6][6][6], int i, int j, int k, graph_value value) {
  v[i][j][k] = v[j][k][i] = v[k][i][j] = value;
  v[j][i][k] = v[i][k][j] = v[k][j][i] = -value;
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
static void make_orient2d(exact_graph *e, int p, int kind, int i, int j, int k) {
  graph_value(*t)[6] = e->t[p];
  const int *label = i > k ? GRAPH_OF(k, i, j) : GRAPH_OF(i, j, k);
  permute(e->g[p], i, j, k,
          graph_add(e->graph, kind, label, GRAPH_IN(t[i][j], t[j][k], t[k][i]), 0));
}

/* z_i + z_j + z_k less the sum of A's z: common terms cancel. The triangle has an edge ij of A and
 * leaves out A's third vertex, or an edge ij of B and leaves out two. */
static graph_value make_zsum(exact_plan *p, int i, int j, int k) {
  exact_graph *e = &p->graph;
  const graph_value *z = e->coordinate[2];
  const int *label = i > k ? GRAPH_OF(k, i, j) : GRAPH_OF(i, j, k);
  graph_value beside = e->g[0][i][j][k];
  int out = exact_a(i > k ? k + 2 : j + 1);
  int out_2 = exact_a(k + 1);
  if (p->stages.zdiff_shared && i > k) {
    return graph_add(e->graph, e->kind.zsum, label, GRAPH_IN(e->zdiff[out_2][i], e->zdiff[out][j]),
                     beside);
  }
  if (p->stages.zdiff_shared) {
    return e->zdiff[out][k] =
               graph_add(e->graph, e->kind.zdiff, label, GRAPH_IN(z[k], -z[out]), beside);
  }
  if (i > k) {
    return graph_add(e->graph, e->kind.zsum, label, GRAPH_IN(z[i], z[j], -z[out], -z[out_2]),
                     beside);
  }
  return graph_add(e->graph, e->kind.zsum, label, GRAPH_IN(z[k], z[k], -z[out], -z[k]), beside);
}

/* h_ijk = g_ijk (z_i + z_j + z_k - z_0 - z_1 - z_2) */
static void make_prism(exact_plan *p, int kind, int i, int j, int k) {
  exact_graph *e = &p->graph;
  graph_value g = e->g[0][i][j][k];
  const int *label = i > k ? GRAPH_OF(k, i, j) : GRAPH_OF(i, j, k);
  permute(e->h, i, j, k, graph_add(e->graph, kind, label, GRAPH_IN(g, e->z[i][j][k]), g));
}

/* ------------------------------------------------------------------- projections */

/* All triangles of both: an edge of A with a vertex of B, then an edge of B with a vertex of A, by
 * cyclic symmetry classes. */
typedef struct {
  int i, j, k;
} triangle;

static triangle triangle_of(int n) {
  int c = n % 3;
  int r = n / 3 % 3;
  return n < 9 ? (triangle){exact_a(c), exact_a(c + 1), exact_b(c + r)}
               : (triangle){exact_b(c + r), exact_b(c + r + 1), exact_a(c)};
}

void exact_graph_projection(exact_plan *p, int projection) {
  exact_graph *e = &p->graph;
  const char *suffix = exact_projection_suffix(projection);
  const char *slots_t = projection > 0 ? suffix + 1 : NULL;
  static const char *const slots[] = {NULL, "g_yz", "g_zx"};
  const exact_stages *s = &p->stages;
  e->kind.trapezoid[projection] = graph_kind_add(
      e->graph, &trapezoid, suffix, 1 + s->trapezoid_sums + s->trapezoid.ranks, slots_t);
  e->kind.orient2d[projection] = graph_kind_add(e->graph, &orient2d, suffix, 1, slots[projection]);
  e->kind.own_orient2d[projection] =
      graph_kind_add(e->graph, &own_orient2d, suffix, 1, slots[projection]);
  for (int c = 0; c < 3; c++) {
    make_trapezoid(e, projection, exact_a(c), exact_a(c + 1));
  }
  for (int c = 0; c < 3; c++) {
    make_trapezoid(e, projection, exact_b(c), exact_b(c + 1));
  }
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3; c++) {
      make_trapezoid(e, projection, exact_a(c), exact_b(c + r));
    }
  }
  for (int n = 0; n < 18; n++) {
    triangle v = triangle_of(n);
    make_orient2d(e, projection, e->kind.orient2d[projection], v.i, v.j, v.k);
  }
  make_orient2d(e, projection, e->kind.own_orient2d[projection], 3, 4, 5);
  if (!p->single || p->limits > 0) {
    make_orient2d(e, projection, e->kind.own_orient2d[projection], 0, 1, 2);
  }
}

/* -------------------------------------------------------- z sums, prisms, orient3d */

static void make_own_zsum(exact_plan *p) {
  exact_graph *e = &p->graph;
  const graph_value *z = e->coordinate[2];
  const int *b = GRAPH_OF(3, 4, 5);
  if (p->running) { /* one vertex of each triangle a cycle */
    e->kind.own_zsum = graph_kind_add(e->graph, &own_zsum_running, "", 1, NULL);
    graph_value sum = graph_constant(e->graph, "OWN_BIAS", "O_W");
    for (int k = 0; k < 3; k++) {
      sum = graph_add(e->graph, e->kind.own_zsum, k < 2 ? GRAPH_OF(3, 3 + k) : b,
                      GRAPH_IN(sum, z[exact_b(k)], -z[exact_a(k)]), 0);
    }
    e->z[3][4][5] = sum;
  } else if (p->stages.zdiff_shared) {
    e->kind.own_zsum = graph_kind_add(e->graph, &own_zsum_of_three, "", 1, NULL);
    e->z[3][4][5] = graph_add(e->graph, e->kind.own_zsum, b,
                              GRAPH_IN(e->zdiff[0][3], e->zdiff[1][4], e->zdiff[2][5]), 0);
  } else {
    e->kind.own_zsum = graph_kind_add(e->graph, &own_zsum, "", 1 + p->stages.own_zsum, NULL);
    e->z[3][4][5] = graph_add(e->graph, e->kind.own_zsum, b,
                              GRAPH_IN(z[3], z[4], z[5], -z[0], -z[1], -z[2]), 0);
  }
}

static void make_prisms(exact_plan *p) {
  exact_graph *e = &p->graph;
  bool shared = p->stages.zdiff_shared;
  if (shared) {
    e->kind.zdiff = graph_kind_add(e->graph, &zdiff, "", 0, NULL);
  }
  e->kind.zsum = graph_kind_add(e->graph, shared ? &zsum_of_two : &zsum, "", 1, NULL);
  for (int n = 0; n < 18; n++) {
    triangle v = triangle_of(n);
    e->z[v.i][v.j][v.k] = make_zsum(p, v.i, v.j, v.k);
  }
  make_own_zsum(p);
  int kind = e->kind.prism = graph_kind_add(e->graph, &prism, "", 1 + p->stages.prism.ranks, NULL);
  int kind_of_two =
      shared ? graph_kind_add(e->graph, &prism_of_two, "", 1 + p->stages.prism_of_two.ranks, NULL)
             : kind;
  for (int n = 0; n < 18; n++) {
    triangle v = triangle_of(n);
    make_prism(p, n < 9 ? kind : kind_of_two, v.i, v.j, v.k);
  }
  kind = graph_kind_add(e->graph, &own_prism, "", 1 + p->stages.own_prism.ranks, NULL);
  make_prism(p, kind, 3, 4, 5);
}

/* orient3d over A, term by term at II = 3: in slot k unit r adds the prism over edge k to the sum
 * that it takes over from unit r + 1; behind slot 2 the sums are whole. */
static void make_running_sums(exact_plan *p) {
  exact_graph *e = &p->graph;
  graph_value(*h)[6][6] = e->h;
  graph_value zero = graph_constant(e->graph, "{V_W{1'b0}}", "V_W");
  graph_value sum[3] = {zero, zero, zero};
  e->kind.running_sum = graph_kind_add(e->graph, &running_sum, "", 1, NULL);
  for (int k = 0; k < 3; k++) {
    graph_value before[3] = {sum[0], sum[1], sum[2]};
    for (int r = 0; r < 3; r++) {
      graph_value term = h[exact_a(k)][exact_a(k + 1)][exact_b(k + r)];
      const int *label = k < 2 ? GRAPH_OF(exact_a(k), exact_b(k + r)) : GRAPH_OF(exact_b(k + r));
      sum[r] = graph_add(e->graph, e->kind.running_sum, label, GRAPH_IN(before[(r + 1) % 3], term),
                         term);
    }
  }
  int kind = p->limits > 0 ? -1 : graph_kind_add(e->graph, &sum_sign, "", 0, NULL);
  for (int r = 0; r < 3; r++) {
    int v = (r + 2) % 3;
    e->s[v] = p->limits > 0
                  ? sum[r]
                  : graph_add(e->graph, kind, GRAPH_OF(exact_b(v)), GRAPH_IN(sum[r]), sum[r]);
  }
}

/* orient3d: whole with a clearance, else its sign. */
static int add_orient3d(exact_plan *p, int which) {
  graph_row row = orient3d[which];
  bool whole = p->limits > 0;
  row.output = whole ? "volume" : "sign";
  row.width = whole ? "V_W" : "2";
  row.is_signed = whole;
  row.parameters = "V_W=V_W";
  int registers = whole ? p->stages.orient3d / 2 : p->stages.orient3d;
  return graph_kind_add(p->graph.graph, &row, "", 1 + registers, NULL);
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
    int kind = add_orient3d(p, 0);
    for (int k = 0; k < 3; k++) {
      int a[3] = {k, exact_a(k + 2), exact_a(k + 1)}; /* edges k, k - 1, k - 2 */
      int b = exact_b(k);
      e->s[k] = graph_add(g, kind, GRAPH_OF(b),
                          GRAPH_IN(h[a[0]][a[2]][b], h[a[1]][a[0]][b], h[a[2]][a[1]][b]), 0);
    }
  }
  int kind = add_orient3d(p, 1);
  for (int i = 0; i < 3; i++) {
    int b[3] = {exact_b(i), exact_b(i + 1), exact_b(i + 2)};
    e->w[i] =
        graph_add(g, kind, GRAPH_OF(i),
                  GRAPH_IN(h[i][b[0]][b[1]], h[i][b[1]][b[2]], h[i][b[2]][b[0]], -h[3][4][5]), 0);
  }
  kind = add_orient3d(p, 2);
  for (int r = 0; r < 3; r++) {
    for (int c = 0; c < 3; c++) {
      int i[2] = {exact_a(c), exact_a(c + 1)};
      int j[2] = {exact_b(c + r), exact_b(c + r + 1)};
      e->d[i[0]][j[0] - 3] = graph_add(g, kind, GRAPH_OF(i[0], i[1], j[0], j[1]),
                                       GRAPH_IN(h[i[1]][j[0]][j[1]], -h[i[0]][j[0]][j[1]],
                                                h[i[0]][i[1]][j[1]], -h[i[0]][i[1]][j[0]]),
                                       0);
    }
  }
}

/* -------------------------------------------------------------- what is read of it */

/* Signs for the coplanar pair, with the order of vertices in x and z. */
static void make_projection(exact_plan *p) {
  exact_graph *e = &p->graph;
  graph *g = e->graph;
  graph_row own_sign = sign;
  own_sign.symbol = "gos";
  own_sign.about = NULL;
  int in_x = graph_kind_add(g, &order_x, "", 1, NULL);
  int in_z = e->kind.order_z = graph_kind_add(g, &order_z, "", 0, NULL);
  int kind = graph_kind_add(g, &sign, "", 0, NULL);
  int own = graph_kind_add(g, &own_sign, "", 0, NULL);
  static const char *const port[] = {"g_a", "g_b", "g_own", "x_order", "z_order"};
  for (int i = 0; i < 5; i++) {
    e->projection[i].port = port[i];
  }
  for (int n = 0; n < 18; n++) {
    triangle v = triangle_of(n);
    graph_value of = e->g[0][v.i][v.j][v.k];
    const int *label = n < 9 ? GRAPH_OF(v.i, v.j, v.k) : GRAPH_OF(v.k, v.i, v.j);
    graph_value s = graph_add(g, kind, label, GRAPH_IN(of), of);
    if (n < 9) {
      int third = exact_a(v.j + 1);
      e->projection[0].value[3 * v.i + v.k - 3] = s;
      e->projection[3].value[3 * v.i + v.k - 3] =
          graph_add(g, in_x, GRAPH_OF(v.i, v.k), (const graph_value[]){0}, e->t[0][v.i][v.k]);
      graph_value z = e->z[v.i][v.j][v.k];
      e->projection[4].value[3 * third + v.k - 3] =
          graph_add(g, in_z, GRAPH_OF(third, v.k), GRAPH_IN(z), z);
    } else {
      e->projection[1].value[3 * (v.i - 3) + v.k] = s;
    }
  }
  for (int n = 0; n < 2; n++) { /* B's, A's */
    graph_value of = n == 0 ? e->g[0][3][4][5] : e->g[0][0][1][2];
    const int *label = n == 0 ? GRAPH_OF(3, 4, 5) : GRAPH_OF(0, 1, 2);
    e->projection[2].value[1 - n] = graph_add(g, own, label, GRAPH_IN(of), of);
  }
}

void exact_graph_make(exact_plan *p) {
  exact_graph *e = &p->graph;
  e->graph = &p->datapath.graph;
  for (int axis = 0; axis < 3; axis++) {
    for (int v = 0; v < 6; v++) {
      e->coordinate[axis][v] = graph_coordinate(e->graph, "xyz"[axis], v);
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
  e->verdict[0].port = "s";
  e->verdict[1].port = "w";
  e->verdict[2].port = "d";
  for (int i = 0; i < 3; i++) {
    e->verdict[0].value[i] = e->s[i];
    e->verdict[1].value[i] = e->w[i];
    for (int j = 0; j < 3; j++) {
      e->verdict[2].value[3 * i + j] = e->d[i][j];
    }
  }
}
