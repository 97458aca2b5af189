/* gen_cmp.c - sepax_cmp and sepax_nand: from projections to the verdict. */
#include "emit/gen.h"
#include "sepax_design.h"

static void extreme(emit_module *m, const char *bus, const char *kind, const char *relation) {
  char name[EMIT_NAME];
  snprintf(name, sizeof name, "%s_12_%s", kind, bus);
  emit_net(m, EMIT_WIRE, true, name, "D_W");
  snprintf(name, sizeof name, "%s_%s", kind, bus);
  emit_net(m, EMIT_WIRE, true, name, "D_W");
  emit_text(m,
            "assign %s_12_%s = (%s_1 %s %s_2) ? %s_1 : %s_2;\n"
            "assign %s_%s = (%s_12_%s %s %s_3) ? %s_12_%s : %s_3;",
            kind, bus, bus, relation, bus, bus, bus, kind, bus, kind, bus, relation, bus, kind, bus,
            bus);
}

void gen_cmp(emitter *e) {
  const sepax_design *d = e->design;
  bool printed = d->config.inequality == SEPAX_INEQUALITY_PRINTED;
  emit_module *m = emit_begin(
      e, "sepax_cmp",
      printed ? "CMP of figure 5: do the projections of A and B on one axis overlap?\n"
                "  overlap = not (min A > max B or max A > min B): (5) as the paper prints it\n"
                "Latency 1. A resting axis overlaps."
              : "CMP of figure 5: do the projections of A and B on one axis overlap?\n"
                "  overlap = not (min A > max B or max A < min B): touching intervals overlap\n"
                "Latency 1. A resting axis overlaps.");
  emit_parameter(m, EMIT_PARAMETER, "D_W", d->format[SEPAX_F_PROJECTION].width,
                 "bits of a projection");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "en", "", "take the comparison");
  emit_signal(m, EMIT_INPUT, false, "rest", "", "1: the axis is not used");
  emit_signal(m, EMIT_INPUT, false, "on_a", "3*D_W", "projections of A_1, A_2, A_3, signed each");
  emit_signal(m, EMIT_INPUT, false, "on_b", "3*D_W", "projections of B_1, B_2, B_3, signed each");
  emit_signal(m, EMIT_OUTPUT_REG, false, "overlap", "", "0: a separating axis");
  for (int i = 0; i < 6; i++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "%c_%d", "ab"[i / 3], i % 3 + 1);
    emit_net(m, EMIT_WIRE, true, name, "D_W");
  }
  for (int i = 0; i < 6; i++) {
    emit_text(m, "assign %c_%d = %s;", "ab"[i / 3], i % 3 + 1,
              gen_part(i < 3 ? "on_a" : "on_b", "D_W", i % 3).text);
  }
  emit_blank(m);
  extreme(m, "a", "min", "<");
  extreme(m, "a", "max", ">");
  extreme(m, "b", "min", "<");
  extreme(m, "b", "max", ">");
  emit_text(m,
            "\nalways @(posedge clk) begin\n"
            "  if (en) begin\n"
            "    overlap <= rest || !((min_a > max_b) || (max_a %s min_b));\n"
            "  end\n"
            "end",
            printed ? ">" : "<");
  emit_end(m);
}

void gen_nand(emitter *e) {
  emit_module *m =
      emit_begin(e, "sepax_nand",
                 "The last gate of figure 5: a separating axis was found iff not all 11\n"
                 "projections overlap. Combinational.");
  emit_signal(m, EMIT_INPUT, false, "overlap", "11", "bit i-1: projections on axis i overlap");
  emit_signal(m, EMIT_OUTPUT, false, "separated", "", "1: the triangles are separated");
  emit_text(m, "assign separated = ~(&overlap);");
  emit_end(m);
}
