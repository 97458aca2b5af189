/* gen_leaf.c - the arithmetic below the paper's modules: sepax_trunc, sepax_mul,
 * sepax_edge. */
#include "emit/gen.h"
#include "sepax_design.h"

gen_text gen_part(const char *bus, const char *width, int i) {
  static const char *const range[] = {"[3*%s-1:2*%s]", "[2*%s-1:%s]", "[%s-1:0]"};
  gen_text t;
  int used = snprintf(t.text, sizeof t.text, "%s", bus);
  snprintf(t.text + used, sizeof t.text - (size_t)used, range[i], width, width);
  return t;
}

gen_text gen_sign(const char *bus, const char *width, int i) {
  static const char *const bit[] = {"[3*%s-1]", "[2*%s-1]", "[%s-1]"};
  gen_text t;
  int used = snprintf(t.text, sizeof t.text, "%s", bus);
  snprintf(t.text + used, sizeof t.text - (size_t)used, bit[i], width);
  return t;
}

void gen_trunc(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_trunc",
                 "Drop the low bits of a number: kept = floor(value / 2^(IN_W - OUT_W)).\n"
                 "Combinational; no gates. The only place where the datapath loses bits.");
  emit_parameter(m, EMIT_PARAMETER, "IN_W", 8, "bits of the exact value");
  emit_parameter(m, EMIT_PARAMETER, "OUT_W", 8, "bits kept, 1 ... IN_W");
  emit_signal(m, EMIT_INPUT, true, "value", "IN_W", "exact value");
  emit_signal(m, EMIT_OUTPUT, true, "kept", "OUT_W", "its OUT_W most significant bits");
  emit_text(m, "assign kept = value[IN_W-1:IN_W-OUT_W];\n"
               "\n"
               "generate\n"
               "  if (IN_W > OUT_W) begin : dropped\n"
               "    wire [IN_W-OUT_W-1:0] unused_bits = value[IN_W-OUT_W-1:0];\n"
               "  end\n"
               "endgenerate");
  emit_end(m);
}

void gen_mul(emitter *e) {
  const sepax_design *d = e->design;
  emit_module *m =
      emit_begin(e, "sepax_mul",
                 "Signed product: p = floor(a * b / 2^(FULL_W - P_W)).\n"
                 "Combinational. FULL_W bits hold every product of the operands' proven\n"
                 "ranges, so it may be less than A_W + B_W.");
  const sepax_format *product = &d->format[SEPAX_F_PRODUCT];
  emit_parameter(m, EMIT_PARAMETER, "A_W", d->format[SEPAX_F_VERTEX].width, "bits of a");
  emit_parameter(m, EMIT_PARAMETER, "B_W", d->format[SEPAX_F_AXIS].width, "bits of b");
  emit_parameter(m, EMIT_PARAMETER, "FULL_W", product->exact,
                 "bits of the exact product, > A_W, > B_W");
  emit_parameter(m, EMIT_PARAMETER, "P_W", product->width, "bits kept, 1 ... FULL_W");
  emit_signal(m, EMIT_INPUT, true, "a", "A_W", "first factor");
  emit_signal(m, EMIT_INPUT, true, "b", "B_W", "second factor");
  emit_signal(m, EMIT_OUTPUT, true, "p", "P_W", "product, its P_W most significant bits");
  emit_net(m, EMIT_WIRE, true, "a_wide", "FULL_W");
  emit_net(m, EMIT_WIRE, true, "b_wide", "FULL_W");
  emit_net(m, EMIT_WIRE, true, "full", "FULL_W");
  emit_text(m, "\n"
               "assign a_wide = {{(FULL_W-A_W){a[A_W-1]}}, a};\n"
               "assign b_wide = {{(FULL_W-B_W){b[B_W-1]}}, b};\n"
               "assign full = a_wide * b_wide;\n");
  emit_instance(m, "sepax_trunc", "trunc_p", "IN_W=FULL_W, OUT_W=P_W", "value=full, kept=p");
  emit_end(m);
}

void gen_edge(emitter *e) {
  const sepax_design *d = e->design;
  const sepax_format *edge = &d->format[SEPAX_F_EDGE];
  emit_module *m =
      emit_begin(e, "sepax_edge",
                 "Edge vector of two vertices: edge = floor((to - from) / 2^(D_W - E_W)).\n"
                 "Combinational. Vectors are packed {x, y, z}.");
  emit_parameter(m, EMIT_PARAMETER, "V_W", d->format[SEPAX_F_VERTEX].width, "bits of a coordinate");
  emit_parameter(m, EMIT_PARAMETER, "D_W", edge->exact, "bits of a difference, V_W + 1");
  emit_parameter(m, EMIT_PARAMETER, "E_W", edge->width, "bits kept, 1 ... D_W");
  emit_signal(m, EMIT_INPUT, false, "from", "3*V_W", "vertex {x, y, z}, signed each");
  emit_signal(m, EMIT_INPUT, false, "to", "3*V_W", "vertex {x, y, z}, signed each");
  emit_signal(m, EMIT_OUTPUT, false, "edge_vector", "3*E_W", "edge {x, y, z}, signed each");
  static const char *const axis[] = {"x", "y", "z"};
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "difference_%s", axis[i]);
    emit_net(m, EMIT_WIRE, true, name, "D_W");
  }
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "edge_%s", axis[i]);
    emit_net(m, EMIT_WIRE, true, name, "E_W");
  }
  emit_blank(m);
  for (int i = 0; i < 3; i++) {
    emit_text(m, "assign difference_%s = {%s, %s} - {%s, %s};", axis[i],
              gen_sign("to", "V_W", i).text, gen_part("to", "V_W", i).text,
              gen_sign("from", "V_W", i).text, gen_part("from", "V_W", i).text);
  }
  emit_text(m, "assign edge_vector = {edge_x, edge_y, edge_z};\n\n");
  for (int i = 0; i < 3; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "trunc_%s", axis[i]);
    emit_instance(m, "sepax_trunc", name, "IN_W=D_W, OUT_W=E_W",
                  "value=difference_%s, kept=edge_%s", axis[i], axis[i]);
  }
  emit_end(m);
}
