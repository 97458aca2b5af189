/* product.c - products of an FPGA: planned for the signed factors of its multipliers, as a module.
 */
#include "arith.h"
#include "emit/template.h"

/* Bits that logic may take of the factor that is cut, and of the other. */
enum { LOW_A = 2, LOW_B = 3 };

/* a on a port of `a` bits, b on one of `b`: false if b is too long for that. */
static bool cut_for(const arith_form *form, int a, int b, int low_a, arith_cut *cut) {
  int beyond = form->a_w - low_a - a;
  cut->low_a = low_a;
  cut->low_b = form->b_w > b ? form->b_w - b : 0;
  cut->part = a - 1;
  cut->parts = 1 + (beyond > 0 ? (beyond + a - 2) / (a - 1) : 0);
  return cut->low_b <= LOW_B;
}

static int cost_of(const arith_cut *cut) { return 8 * cut->parts + cut->low_a + cut->low_b; }

void arith_product_make(arith_plan *p, const arith_form *form) {
  const int *port = form->delay->dsp;
  *p = (arith_plan){
      .delay = form->delay, .a_w = form->a_w, .b_w = form->b_w, .p_w = form->p_w, .plain = true};
  for (int turned = 0; turned < 2; turned++) {
    for (int low = 0; low <= LOW_A; low++) {
      arith_cut cut;
      if (port[0] > 0 && cut_for(form, port[!turned], port[turned], low, &cut) &&
          (p->cut.parts == 0 || cost_of(&cut) < cost_of(&p->cut))) {
        p->cut = cut;
      }
    }
  }
  p->cut.held = form->held;
  p->latency = (p->cut.parts > 0 ? p->cut.parts : 2) + !form->held;
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
static int last_part(const arith_plan *p) { return p->cut.parts > 0 ? p->cut.parts - 1 : 0; }

/* Bits of the sum of part k and of all before it, from the lowest of part k on. */
static int rest(const arith_plan *p, int k) { return p->p_w - low_bits(p) - k * p->cut.part; }

/* The bits of a factor that wait for part k begin here. */
static int begin(const arith_plan *p, char factor, int k) {
  return k == 0 ? 0 : factor == 'b' ? p->cut.low_b : p->cut.low_a + k * p->cut.part;
}

static int factor_msb(const arith_plan *p, char factor, int k) {
  return (factor == 'a' ? p->a_w : p->b_w) - 1 - begin(p, factor, k);
}

/* A factor as part k reads it, in registers that begin with its bit begin(): "a", "a_q", "a_q2". */
static gen_line factor_name(const arith_plan *p, char factor, int k) {
  int registers = k + !p->cut.held;
  return registers == 0   ? gen_format("%c", factor)
         : registers == 1 ? gen_format("%c_q", factor)
                          : gen_format("%c_q%d", factor, registers);
}

static int product_width(const arith_plan *p, int k) {
  int whole = p->b_w - p->cut.low_b;
  whole += k < last_part(p) ? p->cut.part + 1 : p->a_w - p->cut.low_a - k * p->cut.part;
  return whole < rest(p, k) ? whole : rest(p, k);
}

/* A sum in the midst; the last has the rest. */
static int sum_width(const arith_plan *p, int k) {
  int width = product_width(p, k) + 1;
  return k == last_part(p) || width > rest(p, k) ? rest(p, k) : width;
}

/* Of what logic makes of the low bits. */
static int low_width(const arith_plan *p) {
  int of_b = p->a_w + p->cut.low_b;
  int of_a = p->b_w + p->cut.low_a;
  int width = 1 + (of_a > of_b ? of_a : of_b);
  return width < p->p_w ? width : p->p_w;
}

static void print_registers(FILE *out, const arith_plan *p) {
  for (int k = p->cut.held; k <= last_part(p); k++) {
    fprintf(out, "  reg signed [%d:0] %s;\n  reg signed [%d:0] %s;\n", factor_msb(p, 'a', k),
            factor_name(p, 'a', k).text, factor_msb(p, 'b', k), factor_name(p, 'b', k).text);
  }
}

static void clock_registers(FILE *out, const arith_plan *p) {
  for (int k = p->cut.held; k <= last_part(p); k++) {
    for (int i = 0; i < 2; i++) {
      char factor = "ab"[i];
      const gen_line before = k == 0 ? gen_format("%c", factor) : factor_name(p, factor, k - 1);
      int msb = k == 0 ? factor_msb(p, factor, 0) : factor_msb(p, factor, k - 1);
      int lsb = k == 0 ? 0 : begin(p, factor, k) - begin(p, factor, k - 1);
      fprintf(out, "    %s <= %s;\n", factor_name(p, factor, k).text,
              bits(before.text, msb, lsb, msb - lsb + 1).text);
    }
  }
}

/* What logic makes of the low bits: each times the other factor. */
static void print_low(FILE *out, const arith_plan *p) {
  int width = low_width(p);
  const gen_line a = factor_name(p, 'a', 0);
  const gen_line b = factor_name(p, 'b', 0);
  if (low_bits(p) == 0) {
    return;
  }
  fprintf(out, "  wire [%d:0] low =", width - 1);
  const char *plus = "";
  for (int i = 0; i < p->cut.low_b; i++, plus = " +") {
    fprintf(out, "%s\n    ({%d{%s[%d]}} & {%s%s})", plus, width, b.text, i,
            bits(a.text, p->a_w - 1, 0, width - i).text,
            i > 0 ? gen_format(", %d'd0", i).text : "");
  }
  for (int i = 0; i < p->cut.low_a; i++, plus = " +") {
    int shift = p->cut.low_b + i;
    fprintf(out, "%s\n    ({%d{%s[%d]}} & {%s%s})", plus, width, a.text, i,
            bits(b.text, p->b_w - 1, p->cut.low_b, width - shift).text,
            shift > 0 ? gen_format(", %d'd0", shift).text : "");
  }
  fprintf(out, ";\n  reg signed [%d:0] low_q;\n", width - 1);
  for (int n = 2; n <= last_part(p) + 1; n++) {
    fprintf(out, "  reg [%d:0] low_q%d;\n", low_bits(p) - 1, n);
  }
}

static void clock_low(FILE *out, const arith_plan *p) {
  if (low_bits(p) > 0) {
    fprintf(out, "    low_q <= low;\n");
    for (int n = 2; n <= last_part(p) + 1; n++) {
      fprintf(out, n == 2 ? "    low_q%d <= low_q[%d:0];\n" : "    low_q%d <= low_q%d;\n", n,
              n == 2 ? low_bits(p) - 1 : n - 1);
    }
  }
}

static void print_part(FILE *out, const arith_plan *p, int k) {
  int width = product_width(p, k);
  int a_lsb = k == 0 ? p->cut.low_a : 0;
  int b_lsb = k == 0 ? p->cut.low_b : 0;
  const gen_line a = factor_name(p, 'a', k);
  const gen_line b = factor_name(p, 'b', k);
  const gen_line part = k < last_part(p) ? gen_format("{%d'd0, %s[%d:%d]}", width - p->cut.part,
                                                      a.text, a_lsb + p->cut.part - 1, a_lsb)
                                         : bits(a.text, factor_msb(p, 'a', k), a_lsb, width);
  fprintf(out,
          "  wire signed [%d:0] left_%d = %s;\n  wire signed [%d:0] right_%d = %s;\n"
          "  reg signed [%d:0] product_%d;\n",
          width - 1, k, part.text, width - 1, k,
          bits(b.text, factor_msb(p, 'b', k), b_lsb, width).text, width - 1, k);
  int sum = sum_width(p, k);
  gen_line before = {""};
  if (k > 0) {
    before = gen_format(
        " +\n    %s",
        bits(gen_format("sum_%d_q", k - 1).text, sum_width(p, k - 1) - 1, p->cut.part, sum).text);
  } else if (low_bits(p) > 0) {
    before = gen_format(" +\n    %s", bits("low_q", low_width(p) - 1, low_bits(p), sum).text);
  }
  fprintf(out, "  wire [%d:0] sum_%d = %s%s;\n", sum - 1, k,
          bits(gen_format("product_%d", k).text, width - 1, 0, sum).text, before.text);
  if (k < last_part(p)) {
    fprintf(out, "  reg signed [%d:0] sum_%d_q;\n", sum - 1, k);
    for (int n = 2; n < last_part(p) - k + 1; n++) {
      fprintf(out, "  reg [%d:0] sum_%d_q%d;\n", p->cut.part - 1, k, n);
    }
  }
}

static void clock_part(FILE *out, const arith_plan *p, int k) {
  fprintf(out, "    product_%d <= left_%d * right_%d;\n", k, k, k);
  if (k < last_part(p)) {
    fprintf(out, "    sum_%d_q <= sum_%d;\n", k, k);
    for (int n = 2; n < last_part(p) - k + 1; n++) {
      const gen_line before =
          n == 2 ? gen_format("q[%d:0]", p->cut.part - 1) : gen_format("q%d", n - 1);
      fprintf(out, "    sum_%d_q%d <= sum_%d_%s;\n", k, n, k, before.text);
    }
  }
}

/* The product's bits: the last sum, low bits of the others, those that logic made. */
static void print_result(FILE *out, const arith_plan *p) {
  int last = last_part(p);
  fprintf(out, "{sum_%d", last);
  for (int k = last - 1; k >= 0; k--) {
    int n = last - k;
    fprintf(out, n == 1 ? ", sum_%d_q[%d:0]" : ", sum_%d_q%d", k, n == 1 ? p->cut.part - 1 : n);
  }
  if (low_bits(p) > 0) {
    fprintf(out, last == 0 ? ", low_q[%d:0]" : ", low_q%d", last == 0 ? low_bits(p) - 1 : last + 1);
  }
  fputc('}', out);
}

void gen_product(emitter *e, const arith_plan *p) {
  emit_holes h = {0};
  bool parts = p->cut.parts > 0;
  emit_hole_set(&h, "name", "%s", arith_name(p).text);
  emit_hole_set(&h, "family", "%s", p->delay->library);
  emit_hole_numbers(&h, (emit_number[]){{"a_msb", p->a_w - 1},
                                        {"b_msb", p->b_w - 1},
                                        {"p_msb", p->p_w - 1},
                                        {"p_w", p->p_w},
                                        {"latency", p->latency},
                                        {"parts", p->cut.parts},
                                        {"whole", !parts},
                                        {"held", p->cut.held},
                                        {"port_a", p->delay->dsp[0]},
                                        {"port_b", p->delay->dsp[1]},
                                        {"low", low_bits(p)},
                                        {NULL, 0}});
  FILE *out = emit_hole_open(&h, "body");
  print_registers(out, p);
  print_low(out, p);
  for (int k = 0; k <= last_part(p); k++) {
    print_part(out, p, k);
  }
  out = emit_hole_open(&h, "clocked");
  clock_registers(out, p);
  clock_low(out, p);
  for (int k = 0; k <= last_part(p); k++) {
    clock_part(out, p, k);
  }
  print_result(emit_hole_open(&h, "result"), p);
  emit_hole_close(&h);
  emit_template(e, "sepax_product", h.hole);
  emit_holes_free(&h);
}
