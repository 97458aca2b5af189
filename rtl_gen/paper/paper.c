/* paper.c - architecture paper: the widths of its templates. */
#include "paper.h"
#include "emit/template.h"

#include <string.h>

enum { HOLES = 2 * SEPAX_F_COUNT + 10 };

typedef struct {
  emit_hole hole[HOLES];
  gen_line name[HOLES], text[HOLES];
  int count;
} hole_list;

static void add(hole_list *list, gen_line name, gen_line text) {
  int i = list->count++;
  list->name[i] = name;
  list->text[i] = text;
  list->hole[i] = (emit_hole){list->name[i].text, list->text[i].text};
}

static void add_number(hole_list *list, const char *name, long long value) {
  add(list, gen_format("%s", name), gen_format("%lld", value));
}

bool paper_emit(emitter *e, const char *const *file) {
  const sepax_design *d = e->design;
  const sepax_config *c = &d->config;
  hole_list w = {.count = 0};
  for (int i = 0; i < d->formats; i++) {
    add_number(&w, d->format[i].name, d->format[i].width);
    add_number(&w, gen_format("%s_exact", d->format[i].name).text, d->format[i].exact);
  }
  add_number(&w, "msb", c->word - 1);
  add_number(&w, "min", sepax_word_min(c->word));
  add_number(&w, "max", sepax_word_max(c->word));
  add_number(&w, "latency", d->latency);
  add_number(&w, "epsilon", c->epsilon);
  add_number(&w, "plane", c->coplanarity == SEPAX_COPLANAR_PLANE);
  add_number(&w, "printed", c->inequality == SEPAX_INEQUALITY_PRINTED);
  add_number(&w, "block_float", c->block_float);
  int bits = d->format[SEPAX_F_NORMAL_PROJECTION].width + 1;
  add(&w, gen_format("coplanar_limit"),
      gen_format("%d'sd%lld", bits, (long long)d->coplanar_limit));
  bool ok = true;
  for (; *file != NULL && ok; file++) {
    ok = (!c->block_float && strcmp(*file, "sepax_norm") == 0) || emit_template(e, *file, w.hole);
  }
  return ok;
}

bool gen_paper(emitter *e) {
  static const char *const file[] = {
      "sepax_trunc", "sepax_mul",   "sepax_edge",        "sepax_dot", "sepax_proj",
      "sepax_cop",   "sepax_norm",  "paper/sepax_cross", "sepax_psa", "sepax_cmp",
      "sepax_nand",  "sepax_input", "paper/sepax_top",   NULL};
  return paper_emit(e, file);
}
