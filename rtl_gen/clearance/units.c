/* units.c - the modules that a clearance adds to architecture exact. */
#include "clearance.h"

#include "aabb/aabb.h"
#include "emit/gen.h"
#include "emit/template.h"

#include <stdlib.h>
#include <string.h>

#define NUMBER(value) gen_format("%d", (value)).text

/* One digit of a factor, -1, 0 or 1, and what is left of it, halved. */
static int digit_of(int64_t *factor) {
  int digit = (*factor & 1) == 0 ? 0 : (*factor & 3) == 3 ? -1 : 1;
  *factor = (*factor - digit) / 2;
  return digit;
}

int clearance_digits(int64_t factor) {
  int digits = 0;
  while (factor != 0) {
    digits += digit_of(&factor) != 0;
  }
  return digits;
}

/* `factor` times a value of `width` bits, as a sum of its shifts modulo 2^bits. */
static void print_multiple(FILE *out, const char *value, int width, int64_t factor, int bits) {
  bool first = true;
  for (int shift = 0; factor != 0; shift++) {
    int digit = digit_of(&factor);
    if (digit == 0 || shift >= bits) {
      continue;
    }
    fprintf(out, "%s{", first ? (digit < 0 ? "-" : "") : digit < 0 ? "\n      - " : "\n      + ");
    first = false;
    if (bits > shift + width) {
      fprintf(out, "%d'd0, ", bits - shift - width);
    }
    fputs(value, out);
    if (bits < shift + width) {
      fprintf(out, "[%d:0]", bits - shift - 1);
    }
    if (shift > 0) {
      fprintf(out, ", %d'd0", shift);
    }
    fputc('}', out);
  }
  if (first) {
    fprintf(out, "%d'd0", bits);
  }
}

/* What a limit is made of. */
typedef struct {
  const char *sum, *most;
  int sum_width, most_width, bits;
} limit_terms;

enum { LIMIT_HOLES = 16 };

/* Holes of both kinds of limits, behind those that are there: for each clearance D of_sum, of_most,
 * or their sum. Their texts are to be freed, from `more` on. */
static void limit_holes(const exact_plan *p, const limit_terms *t, emit_hole hole[LIMIT_HOLES],
                        int more) {
  static const char *const name[2][3] = {{"of_sum_1", "of_most_1", "limit_1"},
                                         {"of_sum_2", "of_most_2", "limit_2"}};
  for (int k = 0; k < p->limits; k++) {
    int64_t d = p->design->margin[k] - 1;
    for (int part = p->stages.total ? 0 : 2; part < (p->stages.total ? 2 : 3); part++) {
      char *text = NULL;
      size_t size = 0;
      FILE *out = open_memstream(&text, &size);
      if (out == NULL || more + 1 >= LIMIT_HOLES) {
        abort();
      }
      if (part != 1) {
        print_multiple(out, t->sum, t->sum_width, 2 + d, t->bits);
      }
      if (part == 2 && d > 0) {
        fputs("\n      + ", out);
      }
      if (part == 1 || (part == 2 && d > 0)) {
        print_multiple(out, t->most, t->most_width, d, t->bits);
      }
      fclose(out);
      hole[more++] = (emit_hole){name[k][part], text};
    }
  }
  hole[more] = (emit_hole){NULL, NULL};
}

static void free_texts(emit_hole *hole) {
  for (; hole->name != NULL; hole++) {
    free((char *)hole->text);
  }
}

static const char *flag(bool set) { return set ? "1" : ""; }

static bool most_matters(const exact_plan *p) { return p->design->margin[1] > 1; }

static void gen_limit(emitter *e, const exact_plan *p, const char *name, int format,
                      const char *what) {
  const sepax_format *f = p->design->format;
  const gen_line latency = gen_format("%d", 3 + p->stages.most + p->stages.total);
  const gen_line component = gen_format("%d", f[format].width);
  const gen_line bits = gen_format("%d", f[SEPAX_X_LIMIT].width);
  enum { MORE = 9 };
  emit_hole hole[LIMIT_HOLES] = {{"name", name},
                                 {"what", what},
                                 {"latency", latency.text},
                                 {"c_w", component.text},
                                 {"l_w", bits.text},
                                 {"two", flag(p->limits > 1)},
                                 {"registered", flag(p->stages.most)},
                                 {"most", flag(most_matters(p))},
                                 {"parts", flag(p->stages.total)}};
  const limit_terms terms = {p->stages.most ? "sum_q2" : "sum_q", "most_q", f[format].width + 2,
                             f[format].width, f[SEPAX_X_LIMIT].width};
  limit_holes(p, &terms, hole, MORE);
  emit_template(e, "sepax_limit", hole);
  free_texts(hole + MORE);
}

static void gen_edge_limit(emitter *e, const exact_plan *p) {
  int word = p->design->core_word;
  int bits = p->design->format[SEPAX_X_EDGE_LIMIT].width;
  const gen_line latency = gen_format("%d", 3 + p->stages.total);
  const gen_line coordinate = gen_format("%d", word);
  const gen_line each = gen_format("%d", bits);
  const gen_line all = gen_format("%d", p->limits * bits);
  enum { MORE = 7 };
  emit_hole hole[LIMIT_HOLES] = {{"latency", latency.text},
                                 {"w", coordinate.text},
                                 {"l_w", each.text},
                                 {"m_w", all.text},
                                 {"two", flag(p->limits > 1)},
                                 {"most", flag(most_matters(p))},
                                 {"parts", flag(p->stages.total)}};
  const limit_terms terms = {"sum_q", "most_q", word + 1, word, bits};
  limit_holes(p, &terms, hole, MORE);
  emit_template(e, "sepax_edge_limit", hole);
  free_texts(hole + MORE);
}

static void gen_exceeds(emitter *e, const exact_plan *p, const char *name, int value, int limit) {
  int v_w = p->design->format[value].width;
  int l_w = p->design->format[limit].width;
  int n = (v_w > l_w ? v_w : l_w) + 2;
  bool of_3d = value == SEPAX_X_ORIENT3D;
  emit_template(e, "sepax_exceeds",
                (emit_hole[]){{"name", name},
                              {"value", of_3d ? "v" : "g"},
                              {"zero", flag(of_3d)},
                              {"v_w", NUMBER(v_w)},
                              {"l_w", NUMBER(l_w)},
                              {"n", NUMBER(n)},
                              {"pad_v", n > v_w + 2 ? gen_format("%d'd0, ", n - v_w - 2).text : ""},
                              {"limits", NUMBER(p->limits)},
                              {NULL, NULL}});
}

static void gen_aabb_outside(emitter *e, const exact_plan *p) {
  int word = p->design->core_word;
  long long inner = (long long)p->design->margin[0];
  long long outer = (long long)p->design->margin[1];
  const gen_line margins = p->limits > 1
                               ? gen_format("%d'd%lld, %d'd%lld", word, outer, word, inner)
                               : gen_format("%d'd%lld", word, inner);
  gen_bounds(e);
  emit_template(e, "sepax_aabb_outside",
                (emit_hole[]){{"w", NUMBER(word)},
                              {"limits", NUMBER(p->limits)},
                              {"margins", margins.text},
                              {NULL, NULL}});
}

static void gen_decide_band(emitter *e, const exact_plan *p) {
  emit_template(e, "sepax_decide_band",
                (emit_hole[]){{"limits", NUMBER(p->limits)},
                              {"two", flag(p->limits > 1)},
                              {"axis_none", NUMBER(SEPAX_AXIS_NONE)},
                              {"axis_edges", NUMBER(SEPAX_AXIS_EDGES)},
                              {"axis_normal_a", NUMBER(SEPAX_AXIS_NORMAL_A)},
                              {"axis_normal_b", NUMBER(SEPAX_AXIS_NORMAL_B)},
                              {"axis_plane", NUMBER(SEPAX_AXIS_PLANE)},
                              {"axis_aabb", NUMBER(SEPAX_AXIS_AABB)},
                              {NULL, NULL}});
}

void gen_clearance_units(emitter *e, const exact_plan *p) {
  const sepax_format *f = p->design->format;
  if (p->design->config.ii > 1) {
    emit_template(e, "sepax_slot_copy", NULL);
  }
  emit_template(e, "clearance/sepax_cross",
                (emit_hole[]){{"g_w", NUMBER(f[SEPAX_X_ORIENT2D].width)},
                              {"c_w", NUMBER(f[SEPAX_X_CROSS].width)},
                              {NULL, NULL}});
  emit_template(e, "sepax_slope",
                (emit_hole[]){{"v_w", NUMBER(f[SEPAX_X_ORIENT3D].width)}, {NULL, NULL}});
  emit_template(e, "sepax_edge_outside",
                (emit_hole[]){{"g_w", NUMBER(f[SEPAX_X_ORIENT2D].width)},
                              {"limits", NUMBER(p->limits)},
                              {NULL, NULL}});
  gen_limit(e, p, "sepax_limit", SEPAX_X_CROSS, "e x f");
  gen_limit(e, p, "sepax_own_limit", SEPAX_X_ORIENT2D, "N_A or N_B");
  gen_edge_limit(e, p);
  gen_exceeds(e, p, "sepax_exceeds", SEPAX_X_ORIENT3D, SEPAX_X_LIMIT);
  gen_exceeds(e, p, "sepax_exceeds_edge", SEPAX_X_ORIENT2D, SEPAX_X_EDGE_LIMIT);
  gen_aabb_outside(e, p);
  gen_decide_band(e, p);
}

void clearance_widths(emit_module *m, const exact_plan *p) {
  const sepax_format *f = p->design->format;
  emit_parameter(m, EMIT_LOCALPARAM, "LIMITS", p->limits, "clearances");
  emit_parameter(m, EMIT_LOCALPARAM, "C_W", f[SEPAX_X_CROSS].width, "bits of a component of e x f");
  emit_parameter(m, EMIT_LOCALPARAM, "L_W", f[SEPAX_X_LIMIT].width, "of a limit");
  emit_parameter(m, EMIT_LOCALPARAM, "M_W", p->limits * f[SEPAX_X_EDGE_LIMIT].width,
                 "of an edge's limits in one projection");
}
