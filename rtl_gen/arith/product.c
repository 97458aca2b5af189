/* SPDX-License-Identifier: MIT */
/* product.c - products of an FPGA: cut for the signed factors of its multipliers, as a module. */
#include "arith.h"
#include "emit/template.h"

#include <math.h>
#include <stdlib.h>

/* Bits that logic may take of the factor that is cut, and of the other. */
enum { LOW_A = 2, LOW_B = 3 };

/* Is a multiplier a stage of logic, which takes any factor? */
static bool is_logic(const arith_form *form) { return form->delay->dsp[0] > 32; }

/* a on a port of `a` bits, b on one of `b`: false if b is too long for that. */
static bool cut_for(const arith_form *form, int a, int b, int low_a, arith_cut *cut) {
  int beyond = form->a_w - low_a - a;
  cut->low_a = low_a;
  cut->low_b = form->b_w > b ? form->b_w - b : 0;
  cut->part = a - 1;
  cut->parts = 1 + (beyond > 0 ? (beyond + a - 2) / (a - 1) : 0);
  if (is_logic(form) && cut->parts > 1) { /* even parts */
    cut->part = (beyond + cut->parts - 2) / (cut->parts - 1);
    if (form->a_w - (cut->parts - 1) * cut->part < 3) { /* a product longer than b needs 3 bits */
      return cut_for(form, a - 1, b, low_a, cut);
    }
  }
  return cut->low_b <= LOW_B;
}

static int cost_of(const arith_cut *cut) { return 8 * cut->parts + cut->low_a + cut->low_b; }

/* Until what logic makes of the low bits has settled: the sum of two of their products, or behind
 * registers the sum of up to three such sums. */
static double settled(const arith_form *form, const arith_cut *cut) {
  const delay_model *m = form->delay;
  int terms = cut->low_a + cut->low_b;
  double sum = terms > 1 ? delay_adder(m, form->a_w + cut->low_b + 1) : 0;
  double of_sums = terms > 4 ? sum + delay_compressor(m) : 0;
  return delay_register(m) + fmax(delay_mux(m, 2) + sum, of_sums);
}

void arith_product_make(arith_plan *p, const arith_form *form, double period) {
  const int *port = form->delay->dsp;
  bool logic = is_logic(form);
  *p = (arith_plan){
      .delay = form->delay, .a_w = form->a_w, .b_w = form->b_w, .p_w = form->p_w, .plain = true};
  for (int turned = 0; turned < 2 - logic; turned++) {
    for (int low = 0; low <= (logic ? 0 : LOW_A); low++) {
      arith_cut cut;
      if (cut_for(form, port[!turned], port[turned], low, &cut) &&
          (p->cut.parts == 0 ||
           (settled(form, &cut) <= period && cost_of(&cut) < cost_of(&p->cut)))) {
        p->cut = cut;
        p->cut.settled = settled(form, &cut);
      }
    }
  }
  if (p->cut.parts == 0) { /* both factors are too long: synthesis cuts them */
    p->cut.parts = 1;
    p->cut.settled = delay_register(form->delay) + form->delay->product +
                     2 * delay_adder(form->delay, form->p_w);
  }
  p->latency = p->cut.parts + 1;
}

/* -------------------------------------------------------------------- the module */

/* Bits lsb ... of a vector whose highest is msb, as a number of `width` bits: with its sign. */
static gen_line bits(const char *name, int msb, int lsb, int width) {
  int top = lsb + width - 1 < msb ? lsb + width - 1 : msb;
  int more = width - (top - lsb + 1);
  const gen_line range =
      top == lsb ? gen_format("%s[%d]", name, top) : gen_format("%s[%d:%d]", name, top, lsb);
  return more > 0 ? gen_format("{{%d{%s[%d]}}, %s}", more, name, top, range.text) : range;
}

static int low_bits(const arith_plan *p) { return p->cut.low_a + p->cut.low_b; }
static int last_part(const arith_plan *p) { return p->cut.parts - 1; }

/* Bits of the sum of part k and of all before it, from the lowest of part k on. */
static int rest(const arith_plan *p, int k) { return p->p_w - low_bits(p) - k * p->cut.part; }

/* The bits of a factor that wait for part k begin here. */
static int begin(const arith_plan *p, char factor, int k) {
  return k == 0 ? 0 : factor == 'b' ? p->cut.low_b : p->cut.low_a + k * p->cut.part;
}

static int factor_msb(const arith_plan *p, char factor, int k) {
  return (factor == 'a' ? p->a_w : p->b_w) - 1 - begin(p, factor, k);
}

/* A factor as it waits for part k, which has registers of its own: the port, then registers that
 * begin with its bit begin(): "a", "a_q", "a_q2". */
static gen_line factor_name(char factor, int k) {
  return k == 0   ? gen_format("%c", factor)
         : k == 1 ? gen_format("%c_q", factor)
                  : gen_format("%c_q%d", factor, k);
}

static int product_width(const arith_plan *p, int k) {
  int whole = p->b_w - p->cut.low_b;
  whole += k < last_part(p) ? p->cut.part + 1 : p->a_w - p->cut.low_a - k * p->cut.part;
  return whole < rest(p, k) ? whole : rest(p, k);
}

/* Of what logic makes of the low bits. */
static int low_width(const arith_plan *p) {
  int of_b = p->a_w + p->cut.low_b;
  int of_a = p->b_w + p->cut.low_a;
  int width = 1 + (of_a > of_b ? of_a : of_b);
  return width < p->p_w ? width : p->p_w;
}

/* A sum in the midst: one bit more than its longer addend; the last has the rest. */
static int sum_width(const arith_plan *p, int k) {
  int before = k > 0             ? sum_width(p, k - 1) - p->cut.part
               : low_bits(p) > 0 ? low_width(p) - low_bits(p)
                                 : 0;
  int width = 1 + (before > product_width(p, k) ? before : product_width(p, k));
  return k == last_part(p) || width > rest(p, k) ? rest(p, k) : width;
}

static void print_registers(emit_text *out, const arith_plan *p) {
  for (int k = 1; k <= last_part(p); k++) {
    text_printf(out, "  reg signed [%d:0] %s;\n  reg signed [%d:0] %s;\n", factor_msb(p, 'a', k),
                factor_name('a', k).text, factor_msb(p, 'b', k), factor_name('b', k).text);
  }
}

static void clock_registers(emit_text *out, const arith_plan *p) {
  for (int k = 1; k <= last_part(p); k++) {
    for (int i = 0; i < 2; i++) {
      char factor = "ab"[i];
      int msb = factor_msb(p, factor, k - 1);
      int lsb = begin(p, factor, k) - begin(p, factor, k - 1);
      text_printf(out, "    %s <= %s;\n", factor_name(factor, k).text,
                  bits(factor_name(factor, k - 1).text, msb, lsb, msb - lsb + 1).text);
    }
  }
}

/* Term n of what logic makes of the low bits: one of them times the other factor. */
static gen_line low_term(const arith_plan *p, int n) {
  int width = low_width(p);
  bool of_b = n < p->cut.low_b;
  int bit = of_b ? n : n - p->cut.low_b;
  const gen_line factor =
      of_b ? bits("a", p->a_w - 1, 0, width - n) : bits("b", p->b_w - 1, p->cut.low_b, width - n);
  return gen_format("({%d{%c[%d]}} & {%s%s})", width, of_b ? 'b' : 'a', bit, factor.text,
                    n > 0 ? gen_format(", %d'd0", n).text : "");
}

/* Pairs of terms, then, behind a register each, their sum. */
static void print_low(emit_text *out, const arith_plan *p) {
  for (int n = 0; n < low_bits(p); n += 2) {
    text_printf(out, "  reg [%d:0] low_%d;\n", low_width(p) - 1, n / 2);
  }
  if (low_bits(p) > 0) {
    text_printf(out, "  reg signed [%d:0] low_q;\n", low_width(p) - 1);
    for (int n = 2; n <= last_part(p) + 1; n++) {
      text_printf(out, "  reg [%d:0] low_q%d;\n", low_bits(p) - 1, n);
    }
  }
}

static void clock_low(emit_text *out, const arith_plan *p) {
  int terms = low_bits(p);
  for (int n = 0; n < terms; n += 2) {
    text_printf(out, "    low_%d <=\n      %s", n / 2, low_term(p, n).text);
    if (n + 1 < terms) {
      text_printf(out, " +\n      %s", low_term(p, n + 1).text);
    }
    text_puts(out, ";\n");
  }
  if (terms > 0) {
    text_puts(out, "    low_q <= low_0");
    for (int n = 2; n < terms; n += 2) {
      text_printf(out, " + low_%d", n / 2);
    }
    text_puts(out, ";\n");
    for (int n = 2; n <= last_part(p) + 1; n++) {
      text_printf(out, n == 2 ? "    low_q%d <= low_q[%d:0];\n" : "    low_q%d <= low_q%d;\n", n,
                  n == 2 ? low_bits(p) - 1 : n - 1);
    }
  }
}

/* The factors of part k, as numbers with a sign. */
static void print_part(emit_text *out, const arith_plan *p, int k) {
  int width = product_width(p, k);
  int a_lsb = k == 0 ? p->cut.low_a : 0;
  int b_lsb = k == 0 ? p->cut.low_b : 0;
  int a_msb = factor_msb(p, 'a', k);
  int b_msb = factor_msb(p, 'b', k);
  const gen_line a = factor_name('a', k);
  const gen_line part =
      k < last_part(p) ? gen_format("{1'b0, %s[%d:%d]}", a.text, a_lsb + p->cut.part - 1, a_lsb)
                       : bits(a.text, a_msb, a_lsb, a_msb - a_lsb + 1);
  text_printf(out,
              "  wire [%d:0] product_%d;\n"
              "  sepax_dsp #(.A_W(%d), .B_W(%d), .P_W(%d)) part_%d (\n"
              "    .clk(clk), .a(%s), .b(%s), .p(product_%d)\n  );\n",
              width - 1, k, k < last_part(p) ? p->cut.part + 1 : a_msb - a_lsb + 1,
              b_msb - b_lsb + 1, width, k, part.text,
              bits(factor_name('b', k).text, b_msb, b_lsb, b_msb - b_lsb + 1).text, k);
  int sum = sum_width(p, k);
  gen_line before = {""};
  if (k > 0) {
    before = gen_format(
        " +\n    %s",
        bits(gen_format("sum_%d_q", k - 1).text, sum_width(p, k - 1) - 1, p->cut.part, sum).text);
  } else if (low_bits(p) > 0) {
    before = gen_format(" +\n    %s", bits("low_q", low_width(p) - 1, low_bits(p), sum).text);
  }
  text_printf(out, "  wire [%d:0] sum_%d = %s%s;\n", sum - 1, k,
              bits(gen_format("product_%d", k).text, width - 1, 0, sum).text, before.text);
  if (k < last_part(p)) {
    text_printf(out, "  reg signed [%d:0] sum_%d_q;\n", sum - 1, k);
    for (int n = 2; n < last_part(p) - k + 1; n++) {
      text_printf(out, "  reg [%d:0] sum_%d_q%d;\n", p->cut.part - 1, k, n);
    }
  }
}

static void clock_part(emit_text *out, const arith_plan *p, int k) {
  text_printf(out, "    sum_%d_q <= sum_%d;\n", k, k);
  for (int n = 2; n < last_part(p) - k + 1; n++) {
    const gen_line before =
        n == 2 ? gen_format("q[%d:0]", p->cut.part - 1) : gen_format("q%d", n - 1);
    text_printf(out, "    sum_%d_q%d <= sum_%d_%s;\n", k, n, k, before.text);
  }
}

/* The product's bits: the last sum, low bits of the others, those that logic made. */
static void print_result(emit_text *out, const arith_plan *p) {
  int last = last_part(p);
  text_printf(out, "{sum_%d", last);
  for (int k = last - 1; k >= 0; k--) {
    int n = last - k;
    text_printf(out, n % 4 == 0 ? ",\n    " : ", ");
    text_printf(out, n == 1 ? "sum_%d_q[%d:0]" : "sum_%d_q%d", k, n == 1 ? p->cut.part - 1 : n);
  }
  if (low_bits(p) > 0) {
    text_printf(out, last == 0 ? ", low_q[%d:0]" : ", low_q%d",
                last == 0 ? low_bits(p) - 1 : last + 1);
  }
  text_putc(out, '}');
}

void gen_dsp(emitter *e, const delay_model *m) {
  emit_holes h = {0};
  emit_hole_numbers(&h, (emit_number[]){{"port_a", m->dsp[0]},
                                        {"port_b", m->dsp[1]},
                                        {"ports", m->dsp[0] + m->dsp[1]},
                                        {NULL, 0}});
  emit_template(e, "sepax_dsp", h.hole);
  emit_holes_free(&h);
}

void gen_product(emitter *e, const arith_plan *p) {
  emit_holes h = {0};
  emit_hole_set(&h, "name", "%s", arith_name(p).text);
  emit_hole_set(&h, "family", "%s", p->delay->library);
  emit_hole_numbers(&h, (emit_number[]){{"a_msb", p->a_w - 1},
                                        {"b_msb", p->b_w - 1},
                                        {"p_msb", p->p_w - 1},
                                        {"p_w", p->p_w},
                                        {"latency", p->latency},
                                        {"parts", p->cut.parts},
                                        {"several", p->cut.parts > 1},
                                        {"port_a", p->delay->dsp[0]},
                                        {"port_b", p->delay->dsp[1]},
                                        {"low", low_bits(p)},
                                        {"clocked", p->cut.parts > 1 || low_bits(p) > 0},
                                        {NULL, 0}});
  emit_text *out = emit_hole_open(&h, "body");
  print_registers(out, p);
  print_low(out, p);
  for (int k = 0; k <= last_part(p); k++) {
    print_part(out, p, k);
  }
  out = emit_hole_open(&h, "registers");
  clock_registers(out, p);
  clock_low(out, p);
  for (int k = 0; k < last_part(p); k++) {
    clock_part(out, p, k);
  }
  print_result(emit_hole_open(&h, "result"), p);
  emit_hole_close(&h);
  emit_template(e, "sepax_product", h.hole);
  emit_holes_free(&h);
}

bool arith_two_sums(const arith_plan *p) { return p->terms > 0 && p->cut.parts > 1; }

void gen_products(emitter *e, const arith_plan *p) {
  arith_plan *one = malloc(sizeof *one);
  if (one == NULL) {
    emit_no_memory(e);
    return;
  }
  *one = *p;
  one->terms = 0;
  one->p_w = p->a_w + p->b_w;
  one->latency = p->cut.parts + 1;
  if (emit_find(e, arith_name(one).text) == NULL) {
    gen_product(e, one);
  }
  const arith_addend *d = &p->addend[1];
  emit_holes h = {0};
  emit_hole_set(&h, "name", "%s", arith_name(p).text);
  emit_hole_set(&h, "family", "%s", p->delay->library);
  emit_hole_set(&h, "product", "%s", arith_name(one).text);
  emit_hole_set(&h, "minus_d", "%s", d->width > 0 ? gen_format(" - d 2^%d", d->place).text : "");
  emit_hole_numbers(&h, (emit_number[]){{"a_w", p->a_w},
                                        {"b_w", p->b_w},
                                        {"p_w", p->p_w},
                                        {"one_w", one->p_w},
                                        {"a_msb", p->terms * p->a_w - 1},
                                        {"b_msb", p->terms * p->b_w - 1},
                                        {"p_msb", p->p_w - 1},
                                        {"c_msb", p->addend[0].width - 1},
                                        {"d_msb", d->width - 1},
                                        {"d", d->width},
                                        {"c_above", p->p_w - p->addend[0].width},
                                        {"d_above", p->p_w - d->width - d->place},
                                        {"d_place", d->place},
                                        {"terms", p->terms},
                                        {"stages", one->latency},
                                        {"latency", p->latency},
                                        {"two_sums", arith_two_sums(p)},
                                        {NULL, 0}});
  emit_template(e, "sepax_products_dsp", h.hole);
  emit_holes_free(&h);
  free(one);
}
