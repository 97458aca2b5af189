/* aabb.c - the AABB test before architecture exact: sepax_aabb_axis on each axis. */
#include "aabb.h"

#include "emit/emit.h"

#include <stdlib.h>

static void gen_once(emitter *e, const char *name) {
  if (emit_find(e, name) == NULL) {
    const gen_line word = gen_format("%d", e->design->config.word);
    emit_template(e, name, (emit_hole[]){{"word", word.text}, {NULL, NULL}});
  }
}

void gen_bounds(emitter *e) { gen_once(e, "sepax_bounds"); }

void gen_disjoint(emitter *e) { gen_once(e, "sepax_disjoint"); }

int gen_aabb_test(emitter *e) {
  const sepax_design *design = e->design;
  const sepax_config *c = &design->config;
  if (!design->aabb_test) {
    return 0;
  }
  bool extents = c->extent_a > 0;
  bool a_is_larger = c->extent_a > c->extent_b;
  int64_t smaller = a_is_larger ? c->extent_b : c->extent_a;
  int64_t margin = design->margin[1];
  int64_t modulus = INT64_C(1) << design->core_word;
  emit_holes h = {NULL, 0};
  emit_hole_numbers(&h,
                    (emit_number[]){{"word", c->word},
                                    {"extents", extents},
                                    {"core_word", design->core_word},
                                    {"extent_a", c->extent_a},
                                    {"extent_b", c->extent_b},
                                    {"origin", (smaller + margin + modulus / 2) & (modulus - 1)},
                                    {"limits", design->limits},
                                    {"margin", margin},
                                    {"margin_w", c->word + 1},
                                    {NULL, 0}});
  emit_hole_set(&h, "stage", extents ? "_q" : "");
  emit_hole_set(&h, "larger", a_is_larger ? "a" : "b");
  emit_hole_set(&h, "margin_about", design->limits > 0 ? " by more than %lld LSB" : "",
                (long long)margin);
  gen_bounds(e);
  gen_disjoint(e);
  emit_template(e, "sepax_aabb_axis", h.hole);
  emit_holes_free(&h);
  return extents ? 2 : 1;
}
