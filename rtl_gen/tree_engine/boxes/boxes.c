/* SPDX-License-Identifier: MIT */
/* boxes.c - see boxes.h. */
#include "tree_engine/boxes/boxes.h"

#include "arith/arith.h"
#include "emit/template.h"

#include <stdlib.h>

/* Emit a sum of products for a period of 2 ns. The holes `dot` and `bias` get the name of its
 * module and its BIAS. On an ASIC its latency must be *latency, because the modules around it are
 * written for this latency; on an FPGA *latency becomes what the multipliers need. False on
 * failure. */
static bool gen_dot(emitter *e, const arith_form *form, int *latency, emit_holes *h) {
  arith_plan *plan = malloc(sizeof *plan);
  if (plan == NULL) {
    return emit_no_memory(e);
  }
  arith_plan_make(plan, form, 2);
  if (!plan->delay->family && plan->latency != *latency) {
    emit_fail(e, SEPAX_ERROR_LIMIT, "%s: its latency is %d, not %d", arith_name(plan).text,
              plan->latency, *latency);
  }
  *latency = plan->latency;
  gen_multiplier(e, plan);
  emit_hole_set(h, "dot", "%s", arith_name(plan).text);
  emit_hole_set(h, "bias", "%s", arith_bias(plan).text);
  free(plan);
  return emit_works(e);
}

int gen_turn_vertex(emitter *e, const delay_model *m, int word) {
  const arith_form form = {.delay = m,
                           .a_w = 22,
                           .b_w = m->family ? word : word + 1,
                           .p_w = 45,
                           .digits = (word + 1) / 2,
                           .less = 1,
                           .used = 0.2,
                           .terms = 3,
                           .addend = {{44, 0, false}, {word, 20, true}}};
  emit_holes h = {0};
  int latency = 1;
  if (gen_dot(e, &form, &latency, &h)) {
    emit_hole_numbers(&h, (emit_number[]){{"w", word},
                                          {"b_w", form.b_w},
                                          {"fpga", m->family},
                                          {"latency", latency + 2},
                                          {NULL, 0}});
    emit_template(e, "sepax_turn_vertex", h.hole);
  }
  emit_holes_free(&h);
  return latency + 2;
}

void gen_tree_compare(emitter *e, const delay_model *m) {
  const arith_form form = {.delay = m,
                           .a_w = 12,
                           .b_w = 9,
                           .p_w = 22,
                           .digits = 4,
                           .less = 1,
                           .used = 0.2,
                           .terms = 3,
                           .addend = {{21, 0, false}}};
  static const char *const modules[] = {"sepax_tree_setup", "sepax_turn_box", "sepax_lanes",
                                        "sepax_hits", "sepax_tree_compare"};
  emit_holes h = {0};
  int latency = 0;
  if (gen_dot(e, &form, &latency, &h)) {
    emit_hole_set(&h, "load", m->family ? "turn_q && turn_first_q" : "first");
    emit_hole_numbers(&h, (emit_number[]){{"fpga", m->family},
                                          {"sums", latency + 1},
                                          {"turn", latency + 5},
                                          {"cells", latency + 3},
                                          {"rows", latency + 11 > 14 ? 5 : 4},
                                          {NULL, 0}});
    if (m->family) {
      emit_template(e, "sepax_several", NULL);
    }
    for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
      emit_template(e, modules[i], h.hole);
    }
  }
  emit_holes_free(&h);
}
