/* gen_psa.c - sepax_norm, sepax_cross and sepax_psa, or its two unshared halves: the
 * potential separating axes. */
#include "emit/gen.h"
#include "sepax_design.h"

static const char *const axis_name[] = {"x", "y", "z"};

void gen_norm(emitter *e) {
  const sepax_design *d = e->design;
  int bits = d->format[SEPAX_F_AXIS].exact;
  emit_module *m =
      emit_begin(e, "sepax_norm",
                 "Block floating point: the three components move left in common by the\n"
                 "leading bits that none of them needs, so that truncation keeps their top bits.\n"
                 "Combinational; a binary search for the first used bit, one shift a step.");
  emit_parameter(m, EMIT_PARAMETER, "S_W", bits, "bits of a component");
  emit_signal(m, EMIT_INPUT, false, "exact", "3*S_W", "{x, y, z}, signed each");
  emit_signal(m, EMIT_OUTPUT, false, "shifted", "3*S_W", "{x, y, z} times one power of 2");
  int steps = 0;
  while (2 << steps < bits) {
    steps++;
  }
  for (int s = steps; s >= -1; s--) {
    char name[EMIT_NAME];
    for (int i = 0; i < 3; i++) {
      snprintf(name, sizeof name, "%s_%d", axis_name[i], s + 1);
      emit_net(m, EMIT_WIRE, false, name, "S_W");
    }
    if (s >= 0) {
      snprintf(name, sizeof name, "move_%d", s);
      emit_signal(m, EMIT_WIRE, false, name, "", "no component uses its next %d bits", 1 << s);
    }
  }
  emit_blank(m);
  for (int i = 0; i < 3; i++) {
    emit_text(m, "assign %s_%d = %s;", axis_name[i], steps + 1, gen_part("exact", "S_W", i).text);
  }
  for (int s = steps; s >= 0; s--) {
    int move = 1 << s;
    emit_text(m, "\nassign move_%d =", s);
    for (int i = 0; i < 3; i++) {
      emit_text(m, "  %s(%s_%d[S_W-2:S_W-%d] == {%d{%s_%d[S_W-1]}})%s", i > 0 ? "&& " : "",
                axis_name[i], s + 1, move + 1, move, axis_name[i], s + 1, i == 2 ? ";" : "");
    }
    for (int i = 0; i < 3; i++) {
      emit_text(m, "assign %s_%d = move_%d ? {%s_%d[S_W-%d:0], {%d{1'b0}}} : %s_%d;", axis_name[i],
                s, s, axis_name[i], s + 1, move + 1, move, axis_name[i], s + 1);
    }
  }
  emit_text(m, "\nassign shifted = {x_0, y_0, z_0};");
  emit_end(m);
}

void gen_cross(emitter *e) {
  const sepax_design *d = e->design;
  const sepax_format *f = d->format;
  emit_module *m =
      emit_begin(e, "sepax_cross",
                 "Cross product, six multipliers:\n"
                 "  axis = {p_y q_z - p_z q_y, p_z q_x - p_x q_z, p_x q_y - p_y q_x}\n"
                 "Latency 2: products are registered by product_en, the axis by axis_en.");
  emit_parameter(m, EMIT_PARAMETER, "E_W", f[SEPAX_F_EDGE].width, "bits of an operand");
  emit_parameter(m, EMIT_PARAMETER, "M_W", f[SEPAX_F_CROSS_PRODUCT].exact,
                 "bits of an exact product");
  emit_parameter(m, EMIT_PARAMETER, "P_W", f[SEPAX_F_CROSS_PRODUCT].width, "bits kept of it");
  emit_parameter(m, EMIT_PARAMETER, "S_W", f[SEPAX_F_AXIS].exact,
                 "bits of the exact difference, P_W + 1");
  emit_parameter(m, EMIT_PARAMETER, "C_W", f[SEPAX_F_AXIS].width, "bits kept of it");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "product_en", "", "first cycle: take the products");
  emit_signal(m, EMIT_INPUT, false, "axis_en", "", "second cycle: take the axis");
  emit_signal(m, EMIT_INPUT, false, "p", "3*E_W", "{x, y, z}, signed each");
  emit_signal(m, EMIT_INPUT, false, "q", "3*E_W", "{x, y, z}, signed each");
  emit_signal(m, EMIT_OUTPUT_REG, false, "axis", "3*C_W", "{x, y, z}, signed each");
  for (int i = 0; i < 6; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "%c_%s", "pq"[i / 3], axis_name[i % 3]);
    emit_net(m, EMIT_WIRE, true, name, "E_W");
  }
  for (int i = 0; i < 3; i++) {
    const char *j = axis_name[(i + 1) % 3];
    const char *k = axis_name[(i + 2) % 3];
    char name[EMIT_NAME];
    const char *const factor[2][2] = {{j, k}, {k, j}};
    for (int t = 0; t < 2; t++) {
      snprintf(name, sizeof name, "product_%s%s", factor[t][0], factor[t][1]);
      emit_signal(m, EMIT_WIRE, true, name, "P_W", "p_%s q_%s", factor[t][0], factor[t][1]);
      snprintf(name, sizeof name, "product_%s%s_q", factor[t][0], factor[t][1]);
      emit_net(m, EMIT_REG, true, name, "P_W");
    }
    snprintf(name, sizeof name, "exact_%s", axis_name[i]);
    emit_net(m, EMIT_WIRE, true, name, "S_W");
    snprintf(name, sizeof name, "scaled_%s", axis_name[i]);
    emit_net(m, EMIT_WIRE, true, name, "S_W");
    snprintf(name, sizeof name, "axis_%s", axis_name[i]);
    emit_net(m, EMIT_WIRE, true, name, "C_W");
  }
  emit_blank(m);
  for (int i = 0; i < 6; i++) {
    const char *bus = i < 3 ? "p" : "q";
    emit_text(m, "assign %s_%s = %s;", bus, axis_name[i % 3], gen_part(bus, "E_W", i % 3).text);
  }
  emit_blank(m);
  for (int i = 0; i < 3; i++) {
    const char *j = axis_name[(i + 1) % 3];
    const char *k = axis_name[(i + 2) % 3];
    const char *const factor[2][2] = {{j, k}, {k, j}};
    for (int t = 0; t < 2; t++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, "mul_%s%s", factor[t][0], factor[t][1]);
      emit_instance(m, "sepax_mul", name, "A_W=E_W, B_W=E_W, FULL_W=M_W, P_W=P_W",
                    "a=p_%s, b=q_%s, p=product_%s%s", factor[t][0], factor[t][1], factor[t][0],
                    factor[t][1]);
    }
  }
  emit_blank(m);
  for (int i = 0; i < 3; i++) {
    const char *j = axis_name[(i + 1) % 3];
    const char *k = axis_name[(i + 2) % 3];
    emit_text(m,
              "assign exact_%s = {{(S_W-P_W){product_%s%s_q[P_W-1]}}, product_%s%s_q}\n"
              "               - {{(S_W-P_W){product_%s%s_q[P_W-1]}}, product_%s%s_q};",
              axis_name[i], j, k, j, k, k, j, k, j);
  }
  emit_blank(m);
  if (d->config.block_float) {
    emit_net(m, EMIT_WIRE, false, "exact", "3*S_W");
    emit_net(m, EMIT_WIRE, false, "scaled", "3*S_W");
    emit_text(m, "assign exact = {exact_x, exact_y, exact_z};");
    for (int i = 0; i < 3; i++) {
      emit_text(m, "assign scaled_%s = %s;", axis_name[i], gen_part("scaled", "S_W", i).text);
    }
    emit_blank(m);
    emit_instance(m, "sepax_norm", "norm", "S_W=S_W", "exact=exact, shifted=scaled");
  } else {
    emit_text(m, "assign scaled_x = exact_x;\n"
                 "assign scaled_y = exact_y;\n"
                 "assign scaled_z = exact_z;\n\n");
  }
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "trunc_%s", axis_name[i]);
    emit_instance(m, "sepax_trunc", name, "IN_W=S_W, OUT_W=C_W", "value=scaled_%s, kept=axis_%s",
                  axis_name[i], axis_name[i]);
  }
  emit_text(m, "\nalways @(posedge clk) begin\n  if (product_en) begin");
  for (int i = 0; i < 3; i++) {
    const char *j = axis_name[(i + 1) % 3];
    const char *k = axis_name[(i + 2) % 3];
    emit_text(m, "    product_%s%s_q <= product_%s%s;\n    product_%s%s_q <= product_%s%s;", j, k,
              j, k, k, j, k, j);
  }
  emit_text(m, "  end\n  if (axis_en) begin\n    axis <= {axis_x, axis_y, axis_z};\n  end\nend");
  emit_end(m);
}

/* {x, y, z} of a normal in the bits of an edge. */
static void widen_normal(emit_module *m, char body) {
  const sepax_format *f = m->emitter->design->format;
  if (f[SEPAX_F_NORMAL].width == f[SEPAX_F_EDGE].width) {
    emit_text(m, "assign normal_%c = n_%c;", body, body);
    return;
  }
  emit_text(m, "assign normal_%c = {", body);
  char bus[] = {'n', '_', body, '\0'};
  for (int i = 0; i < 3; i++) {
    emit_text(m, "  {(E_W-N_W){%s}}, %s%s", gen_sign(bus, "N_W", i).text,
              gen_part(bus, "N_W", i).text, i < 2 ? "," : "};");
  }
}

static void axes_parameters(emit_module *m, bool normals) {
  const sepax_format *f = m->emitter->design->format;
  emit_parameter(m, EMIT_PARAMETER, "V_W", f[SEPAX_F_VERTEX].width, "bits of a coordinate");
  if (normals) {
    emit_parameter(m, EMIT_PARAMETER, "N_W", f[SEPAX_F_NORMAL].width,
                   "bits of a normal's component");
  }
  emit_parameter(m, EMIT_PARAMETER, "D_W", f[SEPAX_F_EDGE].exact,
                 "bits of a coordinate difference");
  emit_parameter(m, EMIT_PARAMETER, "E_W", f[SEPAX_F_EDGE].width, "bits of an edge's component");
  emit_parameter(m, EMIT_PARAMETER, "M_W", f[SEPAX_F_CROSS_PRODUCT].exact,
                 "bits of an exact product");
  emit_parameter(m, EMIT_PARAMETER, "P_W", f[SEPAX_F_CROSS_PRODUCT].width, "bits kept of it");
  emit_parameter(m, EMIT_PARAMETER, "S_W", f[SEPAX_F_AXIS].exact,
                 "bits of an exact axis component");
  emit_parameter(m, EMIT_PARAMETER, "C_W", f[SEPAX_F_AXIS].width, "bits kept of it");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "load_en", "", "first cycle: take the operands");
  emit_signal(m, EMIT_INPUT, false, "product_en", "", "second cycle: take the products");
  emit_signal(m, EMIT_INPUT, false, "axis_en", "", "third cycle: take the axes");
}

static void axes_ports(emit_module *m, bool normals, int axes) {
  char name[EMIT_NAME];
  for (int i = 0; i < 6; i++) {
    snprintf(name, sizeof name, "%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_signal(m, EMIT_INPUT, false, name, "3*V_W", "vertex %c_%d, {x, y, z}, signed each",
                "AB"[i / 3], i % 3 + 1);
  }
  if (normals) {
    emit_signal(m, EMIT_INPUT, false, "n_a", "3*N_W", "N_A, {x, y, z}, signed each");
    emit_signal(m, EMIT_INPUT, false, "n_b", "3*N_W", "N_B, {x, y, z}, signed each");
  }
  for (int i = 1; i <= axes; i++) {
    snprintf(name, sizeof name, "axis_%d", i);
    emit_signal(m, EMIT_OUTPUT, false, name, "3*C_W", "axis %d, {x, y, z}, signed each", i);
  }
}

static void edge_nets(emit_module *m) {
  char name[EMIT_NAME];
  for (int i = 0; i < 6; i++) {
    snprintf(name, sizeof name, "edge_%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_net(m, EMIT_WIRE, false, name, "3*E_W");
  }
}

static void edge_instances(emit_module *m) {
  char name[EMIT_NAME];
  for (int i = 0; i < 6; i++) {
    char body = "ab"[i / 3];
    snprintf(name, sizeof name, "edge_of_%c_%d", body, i % 3 + 1);
    emit_instance(m, "sepax_edge", name, "V_W=V_W, D_W=D_W, E_W=E_W",
                  "from=%c_%d, to=%c_%d, edge_vector=edge_%c_%d", body, i % 3 + 1, body,
                  (i + 1) % 3 + 1, body, i % 3 + 1);
  }
}

void gen_psa(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_psa",
      "PSA of figure 5: the potential separating axes of a pair, 54 multipliers.\n"
      "  not coplanar (table 1): axis 3(i-1) + j = edge i of A x edge j of B\n"
      "  coplanar (table 2):     axis j = N_A x edge j of A, axis 3 + j = N_B x edge j of B,\n"
      "                          axes 7 ... 9 rest: their operands and products are held\n"
      "Edges are 1: 1->2, 2: 2->3, 3: 3->1. Latency 3: operands by load_en, products by\n"
      "product_en, axes by axis_en; coplanar must stand in all three cycles.");
  axes_parameters(m, true);
  emit_signal(m, EMIT_INPUT, false, "coplanar", "", "1: table 2, 0: table 1");
  axes_ports(m, true, 9);
  char name[EMIT_NAME];
  emit_blank(m);
  edge_nets(m);
  emit_net(m, EMIT_WIRE, false, "normal_a", "3*E_W");
  emit_net(m, EMIT_WIRE, false, "normal_b", "3*E_W");
  emit_signal(m, EMIT_WIRE, false, "row_3", "", "axes 7 ... 9 are wanted");
  emit_net(m, EMIT_WIRE, false, "product_en_3", "");
  emit_net(m, EMIT_WIRE, false, "axis_en_3", "");
  for (int row = 1; row <= 3; row++) {
    snprintf(name, sizeof name, "p_%d", row);
    emit_signal(m, EMIT_REG, false, name, "3*E_W", "left factor of axes %d ... %d", 3 * row - 2,
                3 * row);
    for (int column = 1; column <= 3; column++) {
      snprintf(name, sizeof name, "q_%d", 3 * row - 3 + column);
      emit_signal(m, EMIT_REG, false, name, "3*E_W", "right factor of axis %d",
                  3 * row - 3 + column);
    }
  }
  emit_blank(m);
  widen_normal(m, 'a');
  widen_normal(m, 'b');
  emit_text(m, "assign row_3 = !coplanar;\n"
               "assign product_en_3 = product_en && row_3;\n"
               "assign axis_en_3 = axis_en && row_3;\n\n");
  edge_instances(m);
  emit_text(m, "\nalways @(posedge clk) begin\n"
               "  if (load_en) begin\n"
               "    p_1 <= coplanar ? normal_a : edge_a_1;\n"
               "    q_1 <= coplanar ? edge_a_1 : edge_b_1;\n"
               "    q_2 <= coplanar ? edge_a_2 : edge_b_2;\n"
               "    q_3 <= coplanar ? edge_a_3 : edge_b_3;\n"
               "    p_2 <= coplanar ? normal_b : edge_a_2;\n"
               "    q_4 <= edge_b_1;\n"
               "    q_5 <= edge_b_2;\n"
               "    q_6 <= edge_b_3;\n"
               "    if (row_3) begin\n"
               "      p_3 <= edge_a_3;\n"
               "      q_7 <= edge_b_1;\n"
               "      q_8 <= edge_b_2;\n"
               "      q_9 <= edge_b_3;\n"
               "    end\n"
               "  end\n"
               "end\n\n");
  for (int i = 1; i <= 9; i++) {
    const char *suffix = i > 6 ? "_3" : "";
    snprintf(name, sizeof name, "cross_%d", i);
    emit_instance(m, "sepax_cross", name, "E_W=E_W, M_W=M_W, P_W=P_W, S_W=S_W, C_W=C_W",
                  "clk=clk, product_en=product_en%s, axis_en=axis_en%s, p=p_%d, q=q_%d, "
                  "axis=axis_%d",
                  suffix, suffix, (i + 2) / 3, i, i);
  }
  emit_end(m);
}

static void operand(emit_module *m, char side, int number, const char *what) {
  char name[EMIT_NAME];
  snprintf(name, sizeof name, "%c_%d", side, number);
  emit_signal(m, EMIT_REG, false, name, "3*E_W", "%s", what);
}

static void cross(emit_module *m, int axis, int p, int q) {
  char name[EMIT_NAME];
  snprintf(name, sizeof name, "cross_%d", axis);
  emit_instance(m, "sepax_cross", name, "E_W=E_W, M_W=M_W, P_W=P_W, S_W=S_W, C_W=C_W",
                "clk=clk, product_en=product_en, axis_en=axis_en, p=p_%d, q=q_%d, axis=axis_%d", p,
                q, axis);
}

void gen_psa_9(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_psa_9",
                 "The nine axes of table 1 across edges, 54 multipliers:\n"
                 "  axis 3(i-1) + j = edge i of A x edge j of B\n"
                 "Edges are 1: 1->2, 2: 2->3, 3: 3->1. Latency 3: operands by load_en,\n"
                 "products by product_en, axes by axis_en.");
  axes_parameters(m, false);
  axes_ports(m, false, 9);
  emit_blank(m);
  edge_nets(m);
  static const char *const about[] = {"edge 1->2", "edge 2->3", "edge 3->1"};
  for (int i = 1; i <= 3; i++) {
    operand(m, 'p', i, about[i - 1]);
    operand(m, 'q', i, about[i - 1]);
  }
  emit_blank(m);
  edge_instances(m);
  emit_text(m, "\nalways @(posedge clk) begin\n  if (load_en) begin");
  for (int i = 1; i <= 3; i++) {
    emit_text(m, "    p_%d <= edge_a_%d;\n    q_%d <= edge_b_%d;", i, i, i, i);
  }
  emit_text(m, "  end\nend\n\n");
  for (int i = 1; i <= 9; i++) {
    cross(m, i, (i + 2) / 3, (i - 1) % 3 + 1);
  }
  emit_end(m);
}

void gen_psa_6(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_psa_6",
                 "The six axes of table 2, for coplanar pairs, 36 multipliers:\n"
                 "  axis j = N_A x edge j of A, axis 3 + j = N_B x edge j of B\n"
                 "Edges are 1: 1->2, 2: 2->3, 3: 3->1. Latency 3: operands by load_en,\n"
                 "products by product_en, axes by axis_en.");
  axes_parameters(m, true);
  axes_ports(m, true, 6);
  emit_blank(m);
  edge_nets(m);
  emit_net(m, EMIT_WIRE, false, "normal_a", "3*E_W");
  emit_net(m, EMIT_WIRE, false, "normal_b", "3*E_W");
  operand(m, 'p', 1, "N_A");
  operand(m, 'p', 2, "N_B");
  for (int i = 1; i <= 6; i++) {
    operand(m, 'q', i, i <= 3 ? "an edge of A" : "an edge of B");
  }
  emit_blank(m);
  widen_normal(m, 'a');
  widen_normal(m, 'b');
  emit_blank(m);
  edge_instances(m);
  emit_text(m, "\nalways @(posedge clk) begin\n"
               "  if (load_en) begin\n"
               "    p_1 <= normal_a;\n"
               "    p_2 <= normal_b;");
  for (int i = 1; i <= 6; i++) {
    emit_text(m, "    q_%d <= edge_%c_%d;", i, "ab"[(i - 1) / 3], (i - 1) % 3 + 1);
  }
  emit_text(m, "  end\nend\n\n");
  for (int i = 1; i <= 6; i++) {
    cross(m, i, (i + 2) / 3, i);
  }
  emit_end(m);
}
