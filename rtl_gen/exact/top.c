/* SPDX-License-Identifier: MIT */
/* top.c - architecture exact around its core: sepax_narrow with the handshake, and sepax_top. */
#include "aabb/aabb.h"
#include "engine/engine.h"
#include "exact.h"

#include <stdlib.h>

/* Log2 of the entries of the queue: enough for a full stream never to wait. Cores side by
 * side take pairs in bursts, of which the verdicts wait for each other. */
static int entries_log2(const exact_plan *p) {
  int burst = p->design->config.cores > 1 ? 2 : 0;
  int needed = (exact_narrow_latency(p) - 1) / p->design->config.ii + 1 + burst;
  int log2 = 1;
  while (1 << log2 < needed) {
    log2++;
  }
  return log2;
}

int exact_control_count(const exact_plan *p) {
  const sepax_config *c = &p->design->config;
  int verdict = exact_axis_latency(p) + p->verdict_cycle;
  int tag = entries_log2(p);
  int result = (p->limits > 0 ? 7 : 5) + aabb_latency(p->design);
  int narrow = (verdict / c->ii + 1) * (1 + aabb_latency(p->design));
  narrow += exact_waits(p) + (c->clock_gating ? verdict : 0);
  return narrow + 3 * (tag + 1) + (result << tag);
}

/* What the verdict 1 means, by whether pairs are left open: coplanar ones, and those out of range.
 */
static const char *collision_about(const sepax_config *c, bool limits) {
  static const char *const about[2][2] = {
      {"the triangles share a point", "a point is shared, or out of range"},
      {"a point is shared, or coplanar: undecided",
       "a point is shared, or coplanar, or out of range"}};
  const bool extents = c->extent_a > 0;
  return limits ? "not proved to be outside the clearance"
                : about[c->flag ? 1 : 0][extents ? 1 : 0];
}

/* What sepax_narrow and sepax_top ask for: the pair and its verdict. */
static void set_words(emit_holes *h, const exact_plan *p) {
  const sepax_design *design = p->design;
  const sepax_config *c = &design->config;
  emit_hole_numbers(h, (emit_number[]){{"word", c->word},
                                       {"core_word", design->core_word},
                                       {"msb", c->word - 1},
                                       {"least", sepax_word_min(c->word)},
                                       {"most", sepax_word_max(c->word)},
                                       {"limits", p->limits},
                                       {"flag", c->flag},
                                       {"registered_ready", engine_registers_ready(c)},
                                       {NULL, 0}});
  emit_hole_set(h, "collision_about", "%s", collision_about(c, p->limits > 0));
  emit_hole_set(h, "collision_to", "%lld", (long long)design->margin[0] - 1);
  emit_hole_set(h, "free_from", "%lld", (long long)design->margin[1] - 1);
  emit_hole_set(h, "between", p->limits > 1 ? " 1: in between." : "");
  emit_hole_set(h, "axis_about", p->limits > 0 ? "proves the band" : "separates");
  emit_hole_set(h, "axis_12",
                p->limits > 0 ? "normal to an edge"
                : c->flag     ? "never"
                              : "in the common plane");
}

/* The II windows that a pair passes. Its cycle 0 is the first behind the one that takes it; the
 * core counts from its own, which comes later, so that its slot is another bit. */
static void set_control(emit_holes *h, const exact_plan *p) {
  const sepax_config *c = &p->design->config;
  bool shared = c->ii > 1;
  int verdict = exact_axis_latency(p) + p->verdict_cycle;
  int turn = exact_axis_latency(p) % c->ii;
  bool noted = p->design->aabb_test;
  emit_hole_numbers(h, (emit_number[]){{"ii", c->ii},
                                       {"shared", shared},
                                       {"fpga", p->delay->family},
                                       {"last_window", verdict / c->ii},
                                       {"tag", entries_log2(p)},
                                       {NULL, 0}});
  emit_hole_set(h, "window_ends", shared ? "last_slot" : "1'b1");
  emit_hole_set(h, "at_last_slot", shared ? "last_slot && " : "");
  const gen_line slot = gen_format(" && slot_q[%d]", verdict % c->ii);
  emit_hole_set(h, "at_verdict_slot", "%s", shared ? slot.text : "");
  const char *slots = c->clock_gating ? "core_slot_q" : "slot_q";
  const gen_line turned =
      gen_format("{%s[%d:0], %s[%d:%d]}", slots, turn - 1, slots, c->ii - 1, turn);
  emit_hole_set(h, "core_slot", "%s", turn > 0 ? turned.text : slots);
  emit_hole_set(h, "result", "%s%d", noted ? "NOTE + " : "", p->limits > 0 ? 7 : 5);
  emit_hole_set(h, "band_out", p->limits > 0 ? "band, " : "");
  emit_hole_set(h, "note_out",
                !noted             ? ""
                : p->delay->family ? "noted_q, "
                                   : "note_q[LAST*NOTE +: NOTE], ");
}

static void generate(emitter *e, exact_plan *plan) {
  const sepax_config *c = &e->design->config;
  emit_holes h = {0};
  bool skid = engine_registers_ready(c);
  e->design->latency = exact_latency(plan);
  e->design->wait = (c->ii - 1) * (aabb_latency(e->design) + skid);
  e->design->ripple = plan->ripple;
  gen_exact_units(e, plan, &h);
  set_words(&h, plan);
  gen_exact_core(e, plan, &h);
  set_control(&h, plan);
  aabb_holes(&h, e->design);
  emit_template(e, "sepax_queue", h.hole);
  emit_template(e, "sepax_narrow", h.hole);
  gen_aabb_test(e, &h);
  emit_hole_set(&h, "latency", "%d cycles", e->design->latency);
  emit_hole_numbers(&h, (emit_number[]){{"wait", e->design->wait}, {NULL, 0}});
  if (skid) {
    emit_template(e, "sepax_skid", NULL);
  }
  emit_template(e, "exact/sepax_top", h.hole);
  const engine_generator *around = engine_generator_of(c);
  if (around->generate != NULL) {
    around->generate(e, &h, (1 << entries_log2(plan)) + aabb_latency(e->design) + skid);
  }
  emit_holes_free(&h);
}

bool gen_exact(emitter *e) {
  exact_plan *plan = malloc(sizeof *plan);
  if (plan == NULL) {
    return emit_no_memory(e);
  }
  if (exact_plan_make(plan, e->design, &e->error)) {
    generate(e, plan);
  }
  free(plan);
  return emit_works(e);
}
