/* gen_cop.c - sepax_cop: are the two triangles coplanar? */
#include "emit/gen.h"
#include "sepax_design.h"

void gen_cop(emitter *e) {
  const sepax_design *d = e->design;
  bool plane = d->config.coplanarity == SEPAX_COPLANAR_PLANE;
  emit_module *m = emit_begin(
      e, "sepax_cop",
      plane ? "COP of figure 5: coplanar iff |p_k - q_k| < limit for k = 1, 2, 3, with\n"
              "p_k = s_k = B_k.N_A and q_k = t_k = A_k.N_A (all of B in A's plane).\n"
              "Latency 1; en registers the three comparisons."
            : "COP of figure 5: coplanar iff |p_k - q_k| < limit for k = 1, 2, 3, with\n"
              "p_k = t_k = A_k.N_A and q_k = v_k = B_k.N_B, as line 12 of Algorithm 1 is printed\n"
              "(it compares plane offsets). Latency 1; en registers the three comparisons.");
  emit_parameter(m, EMIT_PARAMETER, "D_W", d->format[SEPAX_F_NORMAL_PROJECTION].width,
                 "bits of a projection on a normal");
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  emit_signal(m, EMIT_INPUT, false, "en", "", "take the comparisons");
  emit_signal(m, EMIT_INPUT, true, "limit", "D_W", "1 ... 2^(D_W-1) - 1");
  emit_signal(m, EMIT_INPUT, false, "p", "3*D_W", "{p_1, p_2, p_3}, signed each");
  emit_signal(m, EMIT_INPUT, false, "q", "3*D_W", "{q_1, q_2, q_3}, signed each");
  emit_signal(m, EMIT_OUTPUT, false, "coplanar", "", "1: treat the pair as coplanar");
  emit_net(m, EMIT_WIRE, true, "limit_wide", "D_W+1");
  for (int k = 1; k <= 3; k++) {
    char name[EMIT_NAME];
    snprintf(name, sizeof name, "difference_%d", k);
    emit_net(m, EMIT_WIRE, true, name, "D_W+1");
    snprintf(name, sizeof name, "near_%d", k);
    emit_net(m, EMIT_REG, false, name, "");
  }
  emit_text(m, "\nassign limit_wide = {limit[D_W-1], limit};");
  for (int k = 1; k <= 3; k++) {
    emit_text(m, "assign difference_%d = {%s, %s} - {%s, %s};", k, gen_sign("p", "D_W", k - 1).text,
              gen_part("p", "D_W", k - 1).text, gen_sign("q", "D_W", k - 1).text,
              gen_part("q", "D_W", k - 1).text);
  }
  emit_text(m, "assign coplanar = near_1 && near_2 && near_3;\n"
               "\n"
               "always @(posedge clk) begin\n"
               "  if (en) begin");
  for (int k = 1; k <= 3; k++) {
    emit_text(m, "    near_%d <= (difference_%d < limit_wide) && (difference_%d > -limit_wide);", k,
              k, k);
  }
  emit_text(m, "  end\nend");
  emit_end(m);
}
