/* aabb.c - the AABB test before architecture exact: sepax_aabb_axis on each axis. */
#include "aabb.h"

#include "emit/emit.h"

#include <stdlib.h>

void gen_bounds(emitter *e) {
  if (emit_find(e, "sepax_bounds") == NULL) {
    char word[8];
    snprintf(word, sizeof word, "%d", e->design->config.word);
    emit_template(e, "sepax_bounds", (emit_hole[]){{"word", word}, {NULL, NULL}});
  }
}

void gen_disjoint(emitter *e) {
  if (emit_find(e, "sepax_disjoint") == NULL) {
    char word[8];
    snprintf(word, sizeof word, "%d", e->design->config.word);
    emit_template(e, "sepax_disjoint", (emit_hole[]){{"word", word}, {NULL, NULL}});
  }
}

int gen_aabb_test(emitter *e) {
  const sepax_design *design = e->design;
  const sepax_config *c = &design->config;
  if (!design->aabb_test) {
    return 0;
  }
  bool extents = c->extent_a > 0;
  bool a_is_larger = c->extent_a > c->extent_b;
  int64_t smaller = a_is_larger ? c->extent_b : c->extent_a;
  int64_t modulus = INT64_C(1) << design->core_word;
  emit_holes h = {NULL, 0};
  emit_hole_set(&h, "word", "%d", c->word);
  emit_hole_set(&h, "extents", "%d", extents);
  emit_hole_set(&h, "core_word", "%d", design->core_word);
  emit_hole_set(&h, "extent_a", "%d", c->extent_a);
  emit_hole_set(&h, "extent_b", "%d", c->extent_b);
  emit_hole_set(&h, "stage", extents ? "_q" : "");
  emit_hole_set(&h, "larger", a_is_larger ? "a" : "b");
  emit_hole_set(&h, "origin", "%lld",
                (long long)((smaller + design->margin[1] + modulus / 2) & (modulus - 1)));
  emit_hole_set(&h, "limits", "%d", design->limits);
  emit_hole_set(&h, "margin", "%lld", (long long)design->margin[1]);
  emit_hole_set(&h, "margin_w", "%d", c->word + 1);
  emit_hole_set(&h, "margin_about", "%s",
                design->limits > 0
                    ? gen_format(" by more than %lld LSB", (long long)design->margin[1]).text
                    : "");
  gen_bounds(e);
  gen_disjoint(e);
  emit_template(e, "sepax_aabb_axis", h.hole);
  emit_holes_free(&h);
  return extents ? 2 : 1;
}
