/* gen_proj.c - sepax_dot and sepax_proj: six vertices onto one axis; sepax_cop_proj. */
#include "emit/gen.h"
#include "sepax_design.h"

static void projection_parameters(emit_module *m) {
  const sepax_format *f = m->emitter->design->format;
  emit_parameter(m, EMIT_PARAMETER, "V_W", f[SEPAX_F_VERTEX].width, "bits of a coordinate");
  emit_parameter(m, EMIT_PARAMETER, "C_W", f[SEPAX_F_AXIS].width, "bits of an axis component");
  emit_parameter(m, EMIT_PARAMETER, "M_W", f[SEPAX_F_PRODUCT].exact, "bits of an exact product");
  emit_parameter(m, EMIT_PARAMETER, "P_W", f[SEPAX_F_PRODUCT].width, "bits kept of it");
  emit_parameter(m, EMIT_PARAMETER, "S_W", f[SEPAX_F_PROJECTION].exact,
                 "bits of the exact sum of three, > P_W");
  emit_parameter(m, EMIT_PARAMETER, "D_W", f[SEPAX_F_PROJECTION].width, "bits kept of it");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "product_en", "", "first cycle: take the products");
  emit_signal(m, EMIT_INPUT, false, "sum_en", "", "second cycle: take the sum");
}

void gen_dot(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_dot",
                 "Inner product of a vertex and an axis, three multipliers:\n"
                 "  dot = v_x c_x + v_y c_y + v_z c_z\n"
                 "Latency 2: products are registered by product_en, their sum by sum_en.");
  projection_parameters(m);
  emit_signal(m, EMIT_INPUT, false, "vertex", "3*V_W", "{x, y, z}, signed each");
  emit_signal(m, EMIT_INPUT, false, "axis", "3*C_W", "{x, y, z}, signed each");
  emit_signal(m, EMIT_OUTPUT_REG, true, "dot", "D_W", "inner product");
  static const char *const axis[] = {"x", "y", "z"};
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "v_%s", axis[i]);
    emit_net(m, EMIT_WIRE, true, name, "V_W");
    snprintf(name, sizeof name, "c_%s", axis[i]);
    emit_net(m, EMIT_WIRE, true, name, "C_W");
    snprintf(name, sizeof name, "product_%s", axis[i]);
    emit_net(m, EMIT_WIRE, true, name, "P_W");
    snprintf(name, sizeof name, "product_%s_q", axis[i]);
    emit_net(m, EMIT_REG, true, name, "P_W");
  }
  emit_net(m, EMIT_WIRE, true, "sum", "S_W");
  emit_net(m, EMIT_WIRE, true, "sum_kept", "D_W");
  emit_blank(m);
  for (int i = 0; i < 3; i++) {
    emit_text(m, "assign v_%s = %s;\nassign c_%s = %s;", axis[i], gen_part("vertex", "V_W", i).text,
              axis[i], gen_part("axis", "C_W", i).text);
  }
  emit_blank(m);
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "mul_%s", axis[i]);
    emit_instance(m, "sepax_mul", name, "A_W=V_W, B_W=C_W, FULL_W=M_W, P_W=P_W",
                  "a=v_%s, b=c_%s, p=product_%s", axis[i], axis[i], axis[i]);
  }
  emit_text(m, "\n"
               "assign sum = {{(S_W-P_W){product_x_q[P_W-1]}}, product_x_q}\n"
               "           + {{(S_W-P_W){product_y_q[P_W-1]}}, product_y_q}\n"
               "           + {{(S_W-P_W){product_z_q[P_W-1]}}, product_z_q};\n\n");
  emit_instance(m, "sepax_trunc", "trunc_sum", "IN_W=S_W, OUT_W=D_W", "value=sum, kept=sum_kept");
  emit_text(m, "\n"
               "always @(posedge clk) begin\n"
               "  if (product_en) begin\n"
               "    product_x_q <= product_x;\n"
               "    product_y_q <= product_y;\n"
               "    product_z_q <= product_z;\n"
               "  end\n"
               "  if (sum_en) begin\n"
               "    dot <= sum_kept;\n"
               "  end\n"
               "end");
  emit_end(m);
}

/* Six sepax_dot: A's vertices onto one axis, B's onto another, or the same. */
static void project_six(emit_module *m, const char *axis_a, const char *axis_b) {
  for (int i = 0; i < 6; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_signal(m, EMIT_INPUT, false, name, "3*V_W", "vertex %c_%d, {x, y, z}, signed each",
                "AB"[i / 3], i % 3 + 1);
  }
  emit_signal(m, EMIT_OUTPUT, false, "on_a", "3*D_W", "projections of A, signed each");
  emit_signal(m, EMIT_OUTPUT, false, "on_b", "3*D_W", "projections of B, signed each");
  for (int i = 0; i < 6; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "dot_%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_net(m, EMIT_WIRE, true, name, "D_W");
  }
  emit_text(m, "\nassign on_a = {dot_a_1, dot_a_2, dot_a_3};\n"
               "assign on_b = {dot_b_1, dot_b_2, dot_b_3};\n\n");
  for (int i = 0; i < 6; i++) {
    char name[EMIT_NAME];
    char vertex[EMIT_NAME];
    snprintf(vertex, sizeof vertex, "%c_%d", "ab"[i / 3], i % 3 + 1);
    snprintf(name, sizeof name, "inner_%.8s", vertex);
    emit_instance(m, "sepax_dot", name, "V_W=V_W, C_W=C_W, M_W=M_W, P_W=P_W, S_W=S_W, D_W=D_W",
                  "clk=clk, product_en=product_en, sum_en=sum_en, vertex=%s, axis=%s, "
                  "dot=dot_%s",
                  vertex, i < 3 ? axis_a : axis_b, vertex);
  }
}

void gen_proj(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_proj",
                 "PROJ of figure 5: the six vertices of a pair projected onto one axis.\n"
                 "  on_a = {A_1.c, A_2.c, A_3.c}, on_b = {B_1.c, B_2.c, B_3.c}\n"
                 "Latency 2, 18 multipliers.");
  projection_parameters(m);
  emit_signal(m, EMIT_INPUT, false, "axis", "3*C_W", "axis c, {x, y, z}, signed each");
  project_six(m, "axis", "axis");
  emit_end(m);
}

void gen_cop_proj(emitter *e) {
  bool plane = e->design->config.coplanarity == SEPAX_COPLANAR_PLANE;
  emit_module *m = emit_begin(
      e, "sepax_cop_proj",
      plane ? "The six inner products that COP compares, for itself alone:\n"
              "  on_a = {A_1.N_A, A_2.N_A, A_3.N_A}, on_b = {B_1.N_A, B_2.N_A, B_3.N_A}\n"
              "Latency 2, 18 multipliers."
            : "The six inner products that COP compares, for itself alone:\n"
              "  on_a = {A_1.N_A, A_2.N_A, A_3.N_A}, on_b = {B_1.N_B, B_2.N_B, B_3.N_B}\n"
              "Latency 2, 18 multipliers.");
  projection_parameters(m);
  emit_signal(m, EMIT_INPUT, false, "axis_a", "3*C_W", "N_A, {x, y, z}, signed each");
  emit_signal(m, EMIT_INPUT, false, "axis_b", "3*C_W", "N_%c, {x, y, z}, signed each",
              plane ? 'A' : 'B');
  project_six(m, "axis_a", "axis_b");
  emit_end(m);
}
