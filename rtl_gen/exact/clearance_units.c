/* SPDX-License-Identifier: MIT */
/* clearance_units.c - the modules that a clearance adds to architecture exact. */
#include "clearance.h"

#include "aabb/aabb.h"

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
static void print_multiple(emit_text *out, const char *value, int width, int64_t factor, int bits) {
  bool first = true;
  for (int shift = 0; factor != 0; shift++) {
    int digit = digit_of(&factor);
    if (digit == 0 || shift >= bits) {
      continue;
    }
    text_printf(out, "%s{",
                first       ? (digit < 0 ? "-" : "")
                : digit < 0 ? "\n        - "
                            : "\n        + ");
    first = false;
    if (bits > shift + width) {
      text_printf(out, "%d'd0, ", bits - shift - width);
    }
    text_puts(out, value);
    if (bits < shift + width) {
      text_printf(out, "[%d:0]", bits - shift - 1);
    }
    if (shift > 0) {
      text_printf(out, ", %d'd0", shift);
    }
    text_putc(out, '}');
  }
  if (first) {
    text_printf(out, "%d'd0", bits);
  }
}

typedef struct {
  const char *sum; /* the other term is most_q */
  int sum_width, most_width, bits;
} limit_terms;

/* Emit a module of limits: for each clearance D, the inner last, (2 + d) sum + d most, d = D - 1,
 * and its parts. */
static void gen_limit_of(emitter *e, const exact_plan *p, emit_holes *h, const char *file,
                         limit_terms t) {
  static const char *const name[3] = {"of_sum", "of_most", "limit"};
  emit_hole_numbers(h, (emit_number[]){{"l_w", t.bits},
                                       {"registered", p->stages.most},
                                       {"most", p->design->margin[1] > 1},
                                       {"parts", p->stages.total},
                                       {NULL, 0}});
  for (int part = 0; part < 3; part++) {
    emit_text *out = emit_hole_open(h, name[part]);
    for (int k = p->limits - 1; k >= 0; k--) {
      int64_t d = p->design->margin[k] - 1;
      text_puts(out, "\n      ");
      if (part != 1) {
        print_multiple(out, t.sum, t.sum_width, 2 + d, t.bits);
      }
      text_puts(out, part == 2 && d > 0 ? "\n        + " : "");
      if (part == 1 || (part == 2 && d > 0)) {
        print_multiple(out, "most_q", t.most_width, d, t.bits);
      }
      text_puts(out, k > 0 ? "," : "");
    }
  }
  emit_hole_close(h);
  emit_template(e, file, h->hole);
}

static void gen_limit(emitter *e, const exact_plan *p, emit_holes *h, const char *name, int format,
                      const char *what) {
  const sepax_format *f = p->design->exact_format;
  int width = f[format].width;
  emit_hole_set(h, "name", "%s", name);
  emit_hole_set(h, "what", "%s", what);
  emit_hole_set(h, "latency", "%d", 3 + p->stages.most + p->stages.total);
  emit_hole_set(h, "c_w", "%d", width);
  gen_limit_of(
      e, p, h, "sepax_limit",
      (limit_terms){p->stages.most ? "sum_q2" : "sum_q", width + 2, width, f[SEPAX_X_LIMIT].width});
}

static void gen_edge_limit(emitter *e, const exact_plan *p, emit_holes *h) {
  int word = p->design->core_word;
  emit_hole_set(h, "latency", "%d", 3 + p->stages.total);
  gen_limit_of(
      e, p, h, "sepax_edge_limit",
      (limit_terms){"sum_q", word + 1, word, p->design->exact_format[SEPAX_X_EDGE_LIMIT].width});
}

static void gen_exceeds(emitter *e, const exact_plan *p, emit_holes *h, const char *name, int value,
                        int limit) {
  int v_w = p->design->exact_format[value].width;
  int l_w = p->design->exact_format[limit].width;
  int n = (v_w > l_w ? v_w : l_w) + 2;
  bool of_3d = value == SEPAX_X_ORIENT3D;
  emit_hole_set(h, "name", "%s", name);
  emit_hole_set(h, "value", of_3d ? "v" : "g");
  emit_hole_numbers(
      h, (emit_number[]){{"zero", of_3d}, {"x_w", v_w}, {"l_w", l_w}, {"n", n}, {NULL, 0}});
  const gen_line pad = gen_format("%d'd0, ", n - v_w - 2);
  emit_hole_set(h, "pad", "%s", n > v_w + 2 ? pad.text : "");
  emit_template(e, "sepax_exceeds", h->hole);
}

void gen_clearance_units(emitter *e, const exact_plan *p, emit_holes *h) {
  int word = p->design->core_word;
  const long long least = p->design->margin[0];
  const gen_line warning = gen_format("%d'd%lld, ", word, (long long)p->design->margin[1]);
  emit_hole_set(h, "c_w", "%d", p->design->exact_format[SEPAX_X_CROSS].width);
  emit_hole_set(h, "margins", "%s%d'd%lld", p->limits > 1 ? warning.text : "", word, least);
  if (p->design->config.ii > 1 && !p->delay->family) {
    emit_template(e, "sepax_slot_copy", h->hole);
  }
  gen_bounds(e);
  emit_template(e, "clearance/sepax_cross", h->hole);
  emit_template(e, "sepax_slope", h->hole);
  emit_template(e, "sepax_edge_outside", h->hole);
  emit_template(e, "sepax_aabb_outside", h->hole);
  gen_limit(e, p, h, "sepax_limit", SEPAX_X_CROSS, "e x f");
  gen_limit(e, p, h, "sepax_own_limit", SEPAX_X_ORIENT2D, "N_A or N_B");
  gen_edge_limit(e, p, h);
  gen_exceeds(e, p, h, "sepax_exceeds", SEPAX_X_ORIENT3D, SEPAX_X_LIMIT);
  gen_exceeds(e, p, h, "sepax_exceeds_edge", SEPAX_X_ORIENT2D, SEPAX_X_EDGE_LIMIT);
  emit_template(e, "sepax_decide_band", h->hole);
}
