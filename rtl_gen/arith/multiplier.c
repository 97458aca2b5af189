/* SPDX-License-Identifier: MIT */
/* multiplier.c - a planned multiplier, or sum of products, as a module of rows (sepax_digit) and
 * adders (sepax_fa). */
#include "arith.h"
#include "emit/template.h"

#include <string.h>

/* `kind`: one of the holes "top", "one_less", "two_less"; the first of a name counts. */
static void gen_digit(emitter *e, const char *name, const char *kind) {
  const emit_hole holes[] = {{"name", name},   {kind, "1"},      {"top", ""},
                             {"one_less", ""}, {"two_less", ""}, {NULL, NULL}};
  emit_template(e, "sepax_digit", holes);
}

void gen_multiplier_parts(emitter *e, bool two_less) {
  emit_template(e, "sepax_fa", NULL);
  gen_digit(e, "sepax_digit", "one_less");
  if (two_less) {
    gen_digit(e, "sepax_digit_2", "two_less");
  }
  gen_digit(e, "sepax_top_digit", "top");
}

gen_line arith_name(const arith_plan *plan) {
  if (plan->terms > 0) {
    return gen_format("sepax_products%d_%dx%d%s", plan->terms, plan->a_w, plan->b_w,
                      plan->open ? "_open" : "");
  }
  const char *kind = plan->plain ? "" : plan->less == 2 ? "_biased_2" : "_biased";
  return gen_format("sepax_mul_%dx%d%s", plan->a_w, plan->b_w, kind);
}

gen_line arith_bias(const arith_plan *plan) {
  unsigned __int128 bias = 0;
  if (plan->delay->family) {
    return gen_format("0");
  }
  for (int i = 1; i < plan->rows; i++) {
    bias = 4 * bias + (unsigned)plan->less;
  }
  char digits[48] = "";
  char *at = digits + sizeof digits - 1;
  do {
    *--at = (char)('0' + (int)(bias % 10));
    bias /= 10;
  } while (bias > 0);
  return gen_format("%s", at);
}

/* ------------------------------------------------------------------------ lists of bits */

/* What adders compute: sums of three, of two, of two and a one. */
static const struct {
  const char *name;
  int inputs;
  const char *carry, *sum;                        /* operators; "~" inverts */
} adders[] = {[ARITH_FULL] = {"", 3, NULL, NULL}, /* sepax_fa does */
              [ARITH_HALF] = {"half_", 2, "&", "^"},
              [ARITH_PLUS_ONE] = {"ones_", 2, "|", "~^"},
              [ARITH_TOP_FULL] = {"top_", 3, NULL, "^"},
              [ARITH_TOP_HALF] = {"top_half_", 2, NULL, "^"},
              [ARITH_TOP_PLUS_ONE] = {"top_ones_", 2, NULL, "~^"}};

/* "sum_2_0" and the like: adders of one kind, level and stage, the k-th of their columns. */
static gen_line adder_name(const arith_adder *a, const char *what) {
  const gen_line group = a->stage > 0 ? gen_format("_r%d_%d_%d", a->stage, a->level, a->copy)
                                      : gen_format("_%d_%d", a->level, a->copy);
  return gen_format("%s%s%s", adders[a->kind].name, what, group.text);
}

/* The vector and index in which a bit stands behind `stage` pipeline registers; index -1: it is a
 * bit. */
static gen_line bit_name(const arith_plan *p, int bit, int stage, int *index) {
  const arith_bit *b = &p->bit[bit];
  bool passed = stage > b->made.stage && b->source != ARITH_ONE;
  *index = passed ? b->place[stage] : b->index;
  return passed                        ? gen_format("stage_%d", stage)
         : b->source == ARITH_ONE      ? gen_format("1'b1")
         : b->source == ARITH_ROW      ? gen_format("row_%d", b->from)
         : b->source == ARITH_NEGATIVE ? gen_format("negative")
         : b->source == ARITH_ADDEND   ? gen_format("addend_%d", b->from)
         : b->source == ARITH_SUM      ? adder_name(&p->adder[b->from], "sum")
                                       : adder_name(&p->adder[b->from], "carry");
}

/* bit[at] and what follows below it in the same vector, as one range; -1: zero. Returns
 * how many bits that is. */
static int run_text(const arith_plan *p, const int bit[], int at, int stage, gen_line *text) {
  int run = 1;
  if (bit[at] < 0) {
    while (at - run >= 0 && bit[at - run] < 0) {
      run++;
    }
    *text = gen_format("%d'd0", run);
    return run;
  }
  int index;
  const gen_line name = bit_name(p, bit[at], stage, &index);
  for (; index >= 0 && at - run >= 0 && bit[at - run] >= 0; run++) {
    int below;
    const gen_line next = bit_name(p, bit[at - run], stage, &below);
    if (below != index - run || strcmp(name.text, next.text) != 0) {
      break;
    }
  }
  *text = index < 0  ? name
          : run == 1 ? gen_format("%s[%d]", name.text, index)
                     : gen_format("%s[%d:%d]", name.text, index, index - run + 1);
  return run;
}

/* {highest ... lowest} of these bits on lines of their own, runs of one vector as ranges. */
static void print_bits(emit_text *out, const arith_plan *p, const int bit[], int count, int stage) {
  int column = text_printf(out, "\n    {");
  const char *separator = "";
  for (int i = count - 1; i >= 0; separator = ", ") {
    gen_line text;
    i -= run_text(p, bit, i, stage, &text);
    if (column + (int)strlen(text.text) > 92) {
      column = 5;
      separator = ",\n     ";
    }
    column += text_printf(out, "%s%s", separator, text.text);
  }
  text_putc(out, '}');
}

/* The operator between lists of `count` bits. */
static void print_terms(emit_text *out, const arith_plan *p, const char *op,
                        const int input[][ARITH_WIDTH], int inputs, int count, int stage) {
  bool inverted = op[0] == '~';
  text_puts(out, inverted ? " ~(" : "");
  for (int k = 0; k < inputs; k++) {
    text_printf(out, "%s%s", k > 0 ? " " : "", k > 0 ? op + inverted : "");
    print_bits(out, p, input[k], count, stage);
  }
  text_puts(out, inverted ? ")" : "");
}

/* --------------------------------------------------------------------------- structure */

/* Bits msb ... lsb of a factor: of the only one, or of the one of that term. */
static gen_line factor_bits(const arith_plan *p, char factor, int term, int msb, int lsb) {
  int below = term * (factor == 'a' ? p->a_w : p->b_w);
  return factor == 'a' && p->terms == 0
             ? gen_format("a")
             : gen_format("%s[%d:%d]",
                          factor == 'b' && p->plain ? "sum" : gen_format("%c", factor).text,
                          below + msb, below + lsb);
}

/* The highest digit, three bits. */
static gen_line top_digit(const arith_plan *p, int term) {
  int msb = p->sum_w - 1;
  int lsb = 2 * (p->rows - 1);
  const gen_line high = factor_bits(p, 'b', term, msb, lsb);
  if (msb - lsb == 2) {
    return high;
  }
  const char *name = p->plain ? "sum" : "b";
  return gen_format("{{%d{%s[%d]}}, %s}", 2 - msb + lsb, name, term * p->b_w + msb, high.text);
}

static void print_row(emit_text *out, const arith_plan *p, int term, int row) {
  int bits = arith_row_bits(p, row);
  int number = term * p->rows + row;
  bool top = row == p->rows - 1;
  const gen_line digit = !top            ? factor_bits(p, 'b', term, 2 * row + 1, 2 * row)
                         : p->terms == 0 ? gen_format("top")
                                         : top_digit(p, term);
  text_printf(out, "  %s #(.A_W(%d), .ROW_W(%d)) digit_%d (\n",
              top            ? "sepax_top_digit"
              : p->less == 2 ? "sepax_digit_2"
                             : "sepax_digit",
              p->a_w, bits, number);
  text_printf(out,
              "    .a(%s),\n    .b(%s),\n    .row(plain_%d),\n    .negative(negative[%d])\n  );\n",
              factor_bits(p, 'a', term, p->a_w - 1, 0).text, digit.text, number, number);
  if (arith_row_whole(p, row)) {
    text_printf(out, "  assign row_%d = {~plain_%d[%d], plain_%d[%d:0]};\n", number, number,
                bits - 1, number, bits - 2);
  } else {
    text_printf(out, "  assign row_%d = plain_%d;\n", number, number);
  }
}

static void print_digits(emit_text *out, const arith_plan *p) {
  int terms = p->terms > 0 ? p->terms : 1;
  for (int row = 0; row < terms * p->rows; row++) {
    int msb = arith_row_bits(p, row % p->rows) - 1;
    text_printf(out, "  wire [%d:0] plain_%d;\n  wire [%d:0] row_%d;\n", msb, row, msb, row);
  }
  for (int row = 0; row < terms * p->rows; row++) {
    print_row(out, p, row / p->rows, row % p->rows);
  }
}

/* What is subtracted is inverted; so is the highest bit of what is narrower than the sum. */
static void print_addends(emit_text *out, const arith_plan *p) {
  for (int k = 0; k < ARITH_ADDENDS; k++) {
    const arith_addend *a = &p->addend[k];
    int msb = a->width - 1;
    bool whole = a->place + a->width >= p->p_w;
    if (a->width > 0) {
      text_printf(out, "  wire [%d:0] addend_%d;\n  assign addend_%d = {%s%c[%d], %s%c[%d:0]};\n",
                  msb, k, k, a->minus == whole ? "~" : "", 'c' + k, msb, a->minus ? "~" : "",
                  'c' + k, msb - 1);
    }
  }
}

static void print_full_adders(emit_text *out, const arith_plan *p, const arith_adder *a,
                              const int input[3][ARITH_WIDTH], int count) {
  const gen_line name = adder_name(a, "fa");
  for (int k = 0; k < 3; k++) {
    const gen_line wire = gen_format("%s_%c", name.text, 'a' + k);
    text_printf(out, "  wire [%d:0] %s;\n  assign %s =", count - 1, wire.text, wire.text);
    print_bits(out, p, input[k], count, a->stage);
    text_puts(out, ";\n");
  }
  text_printf(out, "  sepax_fa #(.N(%d)) %s (\n", count, name.text);
  for (int k = 'a'; k <= 'c'; k++) {
    text_printf(out, "    .%c(%s_%c),\n", k, name.text, k);
  }
  text_printf(out, "    .sum(%s),\n    .carry(%s)\n  );\n", adder_name(a, "sum").text,
              adder_name(a, "carry").text);
}

/* The adders of one kind, level, stage and copy side by side, in the order of their columns. */
static void print_group(emit_text *out, const arith_plan *p, const arith_adder *first) {
  int input[3][ARITH_WIDTH];
  int count = 0;
  for (const arith_adder *a = first; a < p->adder + p->adders; a++) {
    if (a->kind == first->kind && a->level == first->level && a->stage == first->stage &&
        a->copy == first->copy) {
      for (int k = 0; k < 3; k++) {
        input[k][count] = a->input[k];
      }
      count++;
    }
  }
  const char *op[] = {adders[first->kind].sum, adders[first->kind].carry};
  const gen_line name[] = {adder_name(first, "sum"), adder_name(first, "carry")};
  for (int k = 0; k < (first->kind < ARITH_TOP_FULL ? 2 : 1); k++) {
    text_printf(out, "  wire [%d:0] %s;\n", count - 1, name[k].text);
  }
  if (first->kind == ARITH_FULL) {
    print_full_adders(out, p, first, input, count);
  }
  for (int k = 1; k >= 0; k--) {
    if (op[k] != NULL) {
      text_printf(out, "  assign %s =", name[k].text);
      print_terms(out, p, op[k], input, adders[first->kind].inputs, count, first->stage);
      text_puts(out, ";\n");
    }
  }
}

/* Every bit that is used behind a pipeline register and made before it passes the register. */
static void print_register(emit_text *out, const arith_plan *p, int stage) {
  int crossing[ARITH_BITS];
  int count = 0;
  for (int i = 0; i < p->bits; i++) {
    const arith_bit *b = &p->bit[i];
    if (b->source != ARITH_ONE && b->made.stage < stage && b->last >= stage) {
      crossing[count++] = i;
    }
  }
  text_printf(out, "\n  // Pipeline register %d.\n  reg [%d:0] stage_%d;\n", stage, count - 1,
              stage);
  text_printf(out, "  always @(posedge clk) begin\n    stage_%d <=", stage);
  print_bits(out, p, crossing, count, stage - 1);
  text_puts(out, ";\n  end\n");
}

static void print_adders(emit_text *out, const arith_plan *p) {
  for (int stage = 0; stage <= p->latency; stage++) {
    if (stage > 0) {
      print_register(out, p, stage);
    }
    for (int level = 1; level <= p->levels; level++) {
      const char *behind = stage > 0 ? " behind the register" : "";
      bool headed = false;
      for (const arith_adder *a = p->adder; a < p->adder + p->adders; a++) {
        if (a->level == level && a->stage == stage && a->order == 0) {
          if (!headed) {
            text_printf(out, "\n  // Full adders, level %d%s.\n", level, behind);
            headed = true;
          }
          print_group(out, p, a);
        }
      }
    }
  }
}

/* -------------------------------------------------------------------------- the module */

static void set_holes(emit_holes *h, const arith_plan *p) {
  int terms = p->terms > 0 ? p->terms : 1;
  int full = 0;
  for (int i = 0; i < p->adders; i++) {
    full += p->adder[i].kind == ARITH_FULL || p->adder[i].kind == ARITH_TOP_FULL;
  }
  emit_hole_numbers(h, (emit_number[]){{"a_msb", terms * p->a_w - 1},
                                       {"b_msb", terms * p->b_w - 1},
                                       {"p_msb", p->p_w - 1},
                                       {"sum_msb", p->sum_w - 1},
                                       {"p_w", p->p_w},
                                       {"sum_w", p->sum_w},
                                       {"pad_a", p->p_w - p->a_w},
                                       {"pad_b", p->p_w - p->b_w},
                                       {"plain", p->plain},
                                       {"terms", p->terms},
                                       {"open", p->open},
                                       {"latency", p->latency},
                                       {"rows", p->rows},
                                       {"top_row", terms * p->rows - 1},
                                       {"top_digit", p->rows - 1},
                                       {"less", p->less},
                                       {"full", full},
                                       {"half", p->adders - full},
                                       {"c_msb", p->addend[0].width - 1},
                                       {"d_msb", p->addend[1].width - 1},
                                       {"c", p->addend[0].width},
                                       {"d", p->addend[1].width},
                                       {NULL, 0}});
  emit_hole_set(h, "name", "%s", arith_name(p).text);
  emit_hole_set(h, "bias", "%s", arith_bias(p).text);
  emit_hole_set(h, "biased", p->plain ? "" : " + BIAS");
  emit_hole_set(h, "ending", p->open ? "no addition" : "one addition");
  emit_hole_set(h, "plus_q", p->open ? " + q" : "");
  emit_hole_set(h, "recoded", p->plain ? "b + BIAS" : "b");
  emit_hole_set(h, "top", "%s", top_digit(p, 0).text);
}

/* The formula of a sum of products, for its banner and its behavioural view. */
static void set_formula(emit_holes *h, const arith_plan *p) {
  emit_text *out = emit_hole_open(h, "formula");
  text_puts(out, "sum over k of a_k (b_k - BIAS)");
  for (int k = 0; k < ARITH_ADDENDS; k++) {
    const arith_addend *a = &p->addend[k];
    if (a->width > 0) {
      text_printf(out, " %c %c", a->minus ? '-' : '+', 'c' + k);
      text_puts(out, a->place > 0 ? gen_format(" 2^%d", a->place).text : "");
    }
  }
  out = emit_hole_open(h, "sum");
  for (int k = 0; k < p->terms; k++) {
    const gen_line left = gen_format("{{%d{a[%d]}}, %s}", p->p_w - p->a_w, (k + 1) * p->a_w - 1,
                                     factor_bits(p, 'a', k, p->a_w - 1, 0).text);
    const gen_line right = gen_format("{{%d{b[%d]}}, %s}", p->p_w - p->b_w, (k + 1) * p->b_w - 1,
                                      factor_bits(p, 'b', k, p->b_w - 1, 0).text);
    text_printf(out, "  wire [%d:0] product_of_%d =\n    %s *\n    (%s - BIAS);\n", p->p_w - 1, k,
                left.text, right.text);
  }
  text_printf(out, "  wire [%d:0] whole =\n    ", p->p_w - 1);
  for (int k = 0; k < p->terms; k++) {
    text_printf(out, "%sproduct_of_%d", k > 0 ? " + " : "", k);
  }
  for (int k = 0; k < ARITH_ADDENDS; k++) {
    const arith_addend *a = &p->addend[k];
    int above = p->p_w - a->place - a->width;
    if (a->width > 0) {
      text_printf(out, "\n    %c {", a->minus ? '-' : '+');
      text_puts(out,
                above > 0 ? gen_format("{%d{%c[%d]}}, ", above, 'c' + k, a->width - 1).text : "");
      text_printf(out, "%c", 'c' + k);
      text_puts(out, a->place > 0 ? gen_format(", %d'd0}", a->place).text : "}");
    }
  }
  text_puts(out, ";");
}

void gen_multiplier(emitter *e, const arith_plan *plan) {
  if (plan->fault != NULL) {
    emit_fail(e, SEPAX_ERROR_LIMIT, "multiplier of %d x %d bits: %s", plan->a_w, plan->b_w,
              plan->fault);
    return;
  }
  if (plan->delay->family) {
    plan->terms == 0 ? gen_product(e, plan) : gen_products(e, plan);
    return;
  }
  emit_holes h = {0};
  set_holes(&h, plan);
  emit_text *out = emit_hole_open(&h, "products");
  for (int i = 1; i <= plan->latency; i++) {
    text_printf(out, "  reg [%d:0] product_%d;\n", plan->p_w - 1, i);
  }
  out = emit_hole_open(&h, "delays");
  for (int i = 2; i <= plan->latency; i++) {
    text_printf(out, "\n    product_%d <= product_%d;", i, i - 1);
  }
  print_digits(emit_hole_open(&h, "digits"), plan);
  print_addends(emit_hole_open(&h, "addends"), plan);
  print_adders(emit_hole_open(&h, "adders"), plan);
  for (int row = 0; row < 2; row++) {
    out = emit_hole_open(&h, row == 0 ? "first" : "second");
    print_bits(out, plan, plan->final[row], plan->p_w, plan->latency);
  }
  if (plan->terms > 0) {
    set_formula(&h, plan);
  }
  emit_hole_close(&h);
  emit_template(e, plan->terms == 0 ? "sepax_multiplier" : "sepax_products", h.hole);
  emit_holes_free(&h);
}
