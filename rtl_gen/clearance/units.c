/* units.c - the modules that a clearance adds to architecture exact. */
#include "clearance.h"

#include "aabb/aabb.h"
#include "emit/gen.h"

#include <stdlib.h>

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

/* Holes of both kinds of limits: for each clearance D of_sum, of_most, or their sum. Their texts
 * are to be freed, from hole h->count on as it is now. */
static void limit_holes(const exact_plan *p, const limit_terms *t, exact_holes *h) {
  static const char *const name[2][3] = {{"of_sum_1", "of_most_1", "limit_1"},
                                         {"of_sum_2", "of_most_2", "limit_2"}};
  for (int k = 0; k < p->limits; k++) {
    int64_t d = p->design->margin[k] - 1;
    for (int part = 0; part < 3; part++) {
      char *text = NULL;
      size_t size = 0;
      FILE *out = open_memstream(&text, &size);
      if (out == NULL) {
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
      exact_hole(h, name[k][part], text);
    }
  }
}

/* Emit a limit's module of these terms. */
static void gen_limit_of(emitter *e, const exact_plan *p, const char *file, const limit_terms *t,
                         exact_holes *h) {
  exact_hole_number(h, "l_w", t->bits);
  exact_hole_number(h, "m_w", p->limits * t->bits);
  exact_hole_number(h, "registered", p->stages.most);
  exact_hole_number(h, "most", p->design->margin[1] > 1);
  exact_hole_number(h, "parts", p->stages.total);
  int first = h->count;
  limit_holes(p, t, h);
  exact_template(e, file, h);
  for (int i = first; i < h->count; i++) {
    free((char *)h->hole[i].text);
  }
}

static void gen_limit(emitter *e, const exact_plan *p, const char *name, int format,
                      const char *what) {
  const sepax_format *f = p->design->exact_format;
  exact_holes h;
  exact_holes_make(&h, p);
  exact_hole(&h, "name", name);
  exact_hole(&h, "what", what);
  exact_hole_number(&h, "latency", 3 + p->stages.most + p->stages.total);
  exact_hole_number(&h, "c_w", f[format].width);
  const limit_terms terms = {p->stages.most ? "sum_q2" : "sum_q", "most_q", f[format].width + 2,
                             f[format].width, f[SEPAX_X_LIMIT].width};
  gen_limit_of(e, p, "sepax_limit", &terms, &h);
}

static void gen_edge_limit(emitter *e, const exact_plan *p) {
  int word = p->design->core_word;
  exact_holes h;
  exact_holes_make(&h, p);
  exact_hole_number(&h, "latency", 3 + p->stages.total);
  const limit_terms terms = {"sum_q", "most_q", word + 1, word,
                             p->design->exact_format[SEPAX_X_EDGE_LIMIT].width};
  gen_limit_of(e, p, "sepax_edge_limit", &terms, &h);
}

static void gen_exceeds(emitter *e, const exact_plan *p, const char *name, int value, int limit) {
  int v_w = p->design->exact_format[value].width;
  int l_w = p->design->exact_format[limit].width;
  int n = (v_w > l_w ? v_w : l_w) + 2;
  bool of_3d = value == SEPAX_X_ORIENT3D;
  const gen_line pad = gen_format("%d'd0, ", n - v_w - 2);
  exact_holes h;
  exact_holes_make(&h, p);
  exact_hole(&h, "name", name);
  exact_hole(&h, "value", of_3d ? "v" : "g");
  exact_hole_number(&h, "zero", of_3d);
  exact_hole_number(&h, "x_w", v_w);
  exact_hole_number(&h, "l_w", l_w);
  exact_hole_number(&h, "n", n);
  exact_hole(&h, "pad", n > v_w + 2 ? pad.text : "");
  exact_template(e, "sepax_exceeds", &h);
}

void gen_clearance_units(emitter *e, const exact_plan *p) {
  int word = p->design->core_word;
  const int64_t *margin = p->design->margin;
  const gen_line margins = gen_format("%d'd%lld", word, (long long)margin[p->limits - 1]);
  const gen_line both = gen_format("%s, %d'd%lld", margins.text, word, (long long)margin[0]);
  exact_holes h;
  exact_holes_make(&h, p);
  exact_hole_number(&h, "c_w", p->design->exact_format[SEPAX_X_CROSS].width);
  exact_hole(&h, "margins", p->limits > 1 ? both.text : margins.text);
  if (p->design->config.ii > 1) {
    exact_template(e, "sepax_slot_copy", &h);
  }
  gen_bounds(e);
  exact_template(e, "clearance/sepax_cross", &h);
  exact_template(e, "sepax_slope", &h);
  exact_template(e, "sepax_edge_outside", &h);
  exact_template(e, "sepax_aabb_outside", &h);
  gen_limit(e, p, "sepax_limit", SEPAX_X_CROSS, "e x f");
  gen_limit(e, p, "sepax_own_limit", SEPAX_X_ORIENT2D, "N_A or N_B");
  gen_edge_limit(e, p);
  gen_exceeds(e, p, "sepax_exceeds", SEPAX_X_ORIENT3D, SEPAX_X_LIMIT);
  gen_exceeds(e, p, "sepax_exceeds_edge", SEPAX_X_ORIENT2D, SEPAX_X_EDGE_LIMIT);
  exact_template(e, "sepax_decide_band", &h);
}

void clearance_widths(emit_module *m, const exact_plan *p) {
  const sepax_format *f = p->design->exact_format;
  emit_parameter(m, EMIT_LOCALPARAM, "LIMITS", p->limits, "clearances");
  emit_parameter(m, EMIT_LOCALPARAM, "C_W", f[SEPAX_X_CROSS].width, "bits of a component of e x f");
  emit_parameter(m, EMIT_LOCALPARAM, "L_W", f[SEPAX_X_LIMIT].width, "of a limit");
  emit_parameter(m, EMIT_LOCALPARAM, "M_W", p->limits * f[SEPAX_X_EDGE_LIMIT].width,
                 "of an edge's limits in one projection");
}
