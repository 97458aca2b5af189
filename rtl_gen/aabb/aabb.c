/* SPDX-License-Identifier: MIT */
/* aabb.c - the AABB test before architecture exact, sepax_aabb_test, and all that other files have
 * to know of it. */
#include "aabb.h"

#include "datapath/delay.h"
#include "emit/emit.h"

#include <math.h>

/* An emitter without a design has these modules, or has refused one. */
static void gen_once(emitter *e, const char *name) {
  if (emit_works(e) && emit_find(e, name) == NULL) {
    const gen_line word = gen_format("%d", e->design->config.word);
    emit_template(e, name, (emit_hole[]){{"word", word.text}, {NULL, NULL}});
  }
}

void gen_bounds(emitter *e) { gen_once(e, "sepax_bounds"); }

void gen_disjoint(emitter *e) { gen_once(e, "sepax_disjoint"); }

void gen_thinnest(emitter *e) {
  gen_once(e, "sepax_thinnest");
  gen_once(e, "sepax_swap_axes");
}

void aabb_holes(emit_holes *h, const sepax_design *design) {
  const sepax_config *c = &design->config;
  bool extents = c->extent_a > 0;
  bool a_is_larger = c->extent_a > c->extent_b;
  int64_t smaller = a_is_larger ? c->extent_b : c->extent_a;
  int64_t margin = design->margin[1];
  int64_t modulus = INT64_C(1) << design->core_word;
  emit_hole_numbers(h, (emit_number[]){{"aabb_test", design->aabb_test},
                                       {"extents", extents},
                                       {"extent_a", c->extent_a},
                                       {"extent_b", c->extent_b},
                                       {"aabb_axis", SEPAX_AXIS_AABB},
                                       {"limit_axis", SEPAX_AXIS_EXTENT},
                                       {"test_latency", extents ? 2 : 1},
                                       {"note", extents ? 2 : design->aabb_test},
                                       {"origin", (smaller + margin + modulus / 2) & (modulus - 1)},
                                       {"margin", margin},
                                       {"margin_w", c->word + 1},
                                       {NULL, 0}});
  emit_hole_set(h, "stage", extents ? "_q" : "");
  emit_hole_set(h, "larger", a_is_larger ? "a" : "b");
  const gen_line about = gen_format(" by more than %lld LSB", (long long)margin);
  emit_hole_set(h, "margin_about", "%s", design->limits > 0 ? about.text : "");
  emit_hole_set(h, "aabb_decided",
                design->limits > 0 ? "with AABBs at a distance above %lld LSB are free"
                                   : "with disjoint AABBs are separated",
                (long long)margin);
  emit_hole_set(h, "axis_aabb",
                extents                                   ? ", 13 AABBs, 14 undecided"
                : design->aabb_test || design->limits > 0 ? ", 13 AABBs"
                                                          : "");
  emit_hole_set(h, "decided", extents ? "(in_disjoint || in_exceeds)" : "in_disjoint");
  emit_hole_set(h, "note_in", extents ? "{in_disjoint, in_exceeds}" : "in_disjoint");
  emit_hole_set(h, "exceeded", extents ? "note[0]" : "1'b0");
  emit_hole_set(h, "exceeds_about", extents ? ", in_exceeds" : "");
}

double aabb_delay(const sepax_design *design) {
  const delay_model *m = delay_model_of(design->config.target);
  int word = design->config.word;
  if (!design->aabb_test) {
    return 0;
  }
  double bounds = delay_adder(m, word) + delay_mux(m, 3);
  if (design->config.extent_a > 0) {
    double length = delay_adder(m, word + 1) + delay_test(m, word + 1);
    return fmax(fmax(bounds, length), m->aabb);
  }
  double compare = delay_adder(m, word) + (design->limits > 0 ? delay_adder(m, word + 1) : 0);
  return bounds + compare + m->aabb;
}

void gen_aabb_test(emitter *e, const emit_holes *h) {
  if (e->design->aabb_test) {
    gen_bounds(e);
    gen_disjoint(e);
    emit_template(e, "sepax_aabb_test", h->hole);
  }
}

int aabb_latency(const sepax_design *design) {
  return !design->aabb_test ? 0 : design->config.extent_a > 0 ? 2 : 1;
}
