/* SPDX-License-Identifier: MIT */
/* paper.c - architecture paper: the widths of its templates. */
#include "paper.h"
#include "emit/template.h"

#include <string.h>

/* sepax_psa and its kinds sepax_psa_9, sepax_psa_6 are one file. */
static const char *set_psa(emit_holes *h, const char *module) {
  bool nine = strcmp(module, "sepax_psa_9") == 0;
  bool six = strcmp(module, "sepax_psa_6") == 0;
  emit_hole_set(h, "name", "%s", module);
  emit_hole_numbers(
      h,
      (emit_number[]){
          {"nine", nine}, {"six", six}, {"both", !nine && !six}, {"axes", six ? 6 : 9}, {NULL, 0}});
  return nine || six ? "sepax_psa" : module;
}

bool paper_emit(emitter *e, const char *const *module) {
  const sepax_design *d = e->design;
  const sepax_config *c = &d->config;
  emit_holes h = {0};
  gen_line exact[SEPAX_F_COUNT];
  for (int i = 0; i < d->formats; i++) {
    exact[i] = gen_format("%s_exact", d->format[i].name);
    emit_hole_set(&h, d->format[i].name, "%d", d->format[i].width);
    emit_hole_set(&h, exact[i].text, "%d", d->format[i].exact);
  }
  emit_hole_numbers(&h, (emit_number[]){{"msb", c->word - 1},
                                        {"min", sepax_word_min(c->word)},
                                        {"max", sepax_word_max(c->word)},
                                        {"latency", d->latency},
                                        {"epsilon", c->epsilon},
                                        {"plane", c->coplanarity == SEPAX_COPLANAR_PLANE},
                                        {"printed", c->inequality == SEPAX_INEQUALITY_PRINTED},
                                        {"block_float", c->block_float},
                                        {NULL, 0}});
  emit_hole_set(&h, "coplanar_limit", "%d'sd%lld", d->format[SEPAX_F_NORMAL_PROJECTION].width + 1,
                (long long)d->coplanar_limit);
  bool ok = true;
  for (; *module != NULL && ok; module++) {
    ok = (!c->block_float && strcmp(*module, "sepax_norm") == 0) ||
         emit_template(e, set_psa(&h, *module), h.hole);
  }
  emit_holes_free(&h);
  return ok;
}

bool gen_paper(emitter *e) {
  static const char *const module[] = {
      "sepax_trunc", "sepax_mul",   "sepax_edges",       "sepax_dot", "sepax_proj",
      "sepax_cop",   "sepax_norm",  "paper/sepax_cross", "sepax_psa", "sepax_cmp",
      "sepax_nand",  "sepax_input", "paper/sepax_top",   NULL};
  return paper_emit(e, module);
}
