/* multiplier.c - a planned multiplier as a module of rows (sepax_digit) and adders (sepax_fa). */
#include "arith.h"
#include "emit/template.h"

#include <stdlib.h>
#include <string.h>

void gen_fa(emitter *e) { emit_template(e, "sepax_fa", NULL); }

static void gen_digit(emitter *e, const char *name, const char *top, const char *two_less) {
  const emit_hole holes[] = {{"name", name}, {"top", top}, {"two_less", two_less}, {NULL, NULL}};
  emit_template(e, "sepax_digit", holes);
}

void gen_digits(emitter *e, bool two_less) {
  gen_digit(e, "sepax_digit", "", "");
  if (two_less) {
    gen_digit(e, "sepax_digit_2", "", "1");
  }
  gen_digit(e, "sepax_top_digit", "1", "");
}

/* ------------------------------------------------------------------- multipliers */

typedef struct {
  emit_module *m;
  const arith_plan *plan;
  int *place;    /* of each bit in each pipeline register */
  int *order;    /* of each adder in its group */
  char bias[48]; /* BIAS, decimal */
} writer;

/* "sum_2_0" and the like: adders of one kind, level and stage, the k-th of their columns. */
static void adder_name(const arith_adder *a, const char *what, char text[EMIT_NAME]) {
  static const char *const kind[] = {"", "half_", "ones_", "top_", "top_half_", "top_ones_"};
  int used = a->stage > 0 ? snprintf(text, EMIT_NAME, "%s%s_r%d", kind[a->kind], what, a->stage)
                          : snprintf(text, EMIT_NAME, "%s%s", kind[a->kind], what);
  snprintf(text + used, EMIT_NAME - (size_t)used, "_%d_%d", a->level, a->copy);
}

/* The vector and index in which a bit stands behind `stage` pipeline registers; index -1: it is a
 * bit. */
static int bit_name(const writer *w, int bit, int stage, char text[EMIT_NAME]) {
  const arith_bit *b = &w->plan->bit[bit];
  if (b->source == ARITH_ONE) {
    snprintf(text, EMIT_NAME, "1'b1");
    return -1;
  }
  if (stage > b->stage) {
    snprintf(text, EMIT_NAME, "stage_%d", stage);
    return w->place[bit * ARITH_STAGES + stage];
  }
  switch (b->source) {
  case ARITH_ROW:
    snprintf(text, EMIT_NAME, "row_%d", b->from);
    return b->index;
  case ARITH_NEGATIVE:
    snprintf(text, EMIT_NAME, "negative");
    return b->from;
  default:
    adder_name(&w->plan->adder[b->from], b->source == ARITH_SUM ? "sum" : "carry", text);
    return w->order[b->from];
  }
}

/* bit[at] and what follows below it in the same vector, as one range; -1: zero. Returns
 * how many bits that is. */
static int print_run(const writer *w, const int bit[], int at, int stage, char *text, size_t size) {
  char name[EMIT_NAME];
  int run = 1;
  if (bit[at] < 0) {
    while (at - run >= 0 && bit[at - run] < 0) {
      run++;
    }
    snprintf(text, size, "%d'd0", run);
    return run;
  }
  int index = bit_name(w, bit[at], stage, name);
  char next[EMIT_NAME];
  while (index >= 0 && at - run >= 0 && bit[at - run] >= 0 &&
         bit_name(w, bit[at - run], stage, next) == index - run && strcmp(name, next) == 0) {
    run++;
  }
  if (index < 0) {
    snprintf(text, size, "%s", name);
  } else if (run == 1) {
    snprintf(text, size, "%s[%d]", name, index);
  } else {
    snprintf(text, size, "%s[%d:%d]", name, index, index - run + 1);
  }
  return run;
}

/* {highest ... lowest} of these bits, runs of one vector as ranges; -1: zero. */
static void print_bits(const writer *w, const int bit[], int count, int stage, FILE *out) {
  fputc('{', out);
  int column_at = 0;
  for (int i = count - 1; i >= 0;) {
    char text[3 * EMIT_NAME];
    int run = print_run(w, bit, i, stage, text, sizeof text);
    i -= run;
    column_at += (int)strlen(text) + 2;
    fprintf(out, "%s%s", text, i >= 0 ? column_at > 80 ? ",\n                     " : ", " : "}");
    column_at = column_at > 80 ? 0 : column_at;
  }
}

static char *bits_text(const writer *w, const int bit[], int count, int stage) {
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  if (out == NULL) {
    abort();
  }
  print_bits(w, bit, count, stage, out);
  fclose(out);
  return text;
}

static void emit_vector(emit_module *m, emit_kind kind, const char *name, int bits) {
  char width[16];
  snprintf(width, sizeof width, "%d", bits);
  emit_net(m, kind, false, name, width);
}

/* BIAS: what the digits count less, all together. */
static void emit_bias(const writer *w, int bits, const char *about) {
  emit_text(w->m, "localparam [%d:0] BIAS = %d'd%s; // %s", bits - 1, bits, w->bias, about);
}

static void recode(writer *w) {
  const arith_plan *p = w->plan;
  char name[EMIT_NAME];
  char digit[EMIT_NAME];
  char parameters[48];
  const char *b = p->plain ? "sum" : "b";
  int top = p->sum_w - 2 * (p->rows - 1);
  emit_text(w->m, "// Rows: digit k selects row k, worth 4^k; its sign bit counts negative.");
  if (p->plain) {
    emit_vector(w->m, EMIT_WIRE, "sum", p->sum_w);
    emit_bias(w, p->sum_w, "added to b, so that its digits may be one less");
    emit_text(w->m, "assign sum = {b[%d], b} + BIAS;", p->b_w - 1);
  }
  emit_vector(w->m, EMIT_WIRE, "top", 3);
  if (top == 3) {
    emit_text(w->m, "assign top = %s[%d:%d];", b, p->sum_w - 1, p->sum_w - 3);
  } else {
    const gen_line high = gen_format("%s[%d:%d]", b, p->sum_w - 1, p->sum_w - top);
    emit_text(w->m, "assign top = {{%d{%s[%d]}}, %s};", 3 - top, b, p->sum_w - 1, high.text);
  }
  emit_vector(w->m, EMIT_WIRE, "negative", p->rows);
  for (int row = 0; row < p->rows; row++) {
    snprintf(name, sizeof name, "plain_%d", row);
    emit_vector(w->m, EMIT_WIRE, name, arith_row_bits(p, row));
    snprintf(name, sizeof name, "row_%d", row);
    emit_vector(w->m, EMIT_WIRE, name, arith_row_bits(p, row));
  }
  for (int row = 0; row < p->rows; row++) {
    int bits = arith_row_bits(p, row);
    snprintf(parameters, sizeof parameters, "A_W=%d, ROW_W=%d", p->a_w, bits);
    snprintf(name, sizeof name, "digit_%d", row);
    bool is_top = row == p->rows - 1;
    snprintf(digit, sizeof digit, is_top ? "top" : "%s[%d:%d]", b, 2 * row + 1, 2 * row);
    const char *low = p->less == 2 ? "sepax_digit_2" : "sepax_digit";
    emit_instance(w->m, is_top ? "sepax_top_digit" : low, name, parameters,
                  "a=a, b=%s, row=plain_%d, negative=negative[%d]", digit, row, row);
    if (!arith_row_whole(p, row)) {
      emit_text(w->m, "assign row_%d = plain_%d;", row, row);
    } else {
      const gen_line sign = gen_format("~plain_%d[%d]", row, bits - 1);
      emit_text(w->m, "assign row_%d = {%s, plain_%d[%d:0]};", row, sign.text, row, bits - 2);
    }
  }
}

static bool same_group(const arith_adder *a, const arith_adder *b) {
  return a->kind == b->kind && a->level == b->level && a->stage == b->stage && a->copy == b->copy;
}

/* The adders of one kind, level, stage and copy stand side by side in one instance, in the
 * order of their columns. */
static void group_adders(writer *w) {
  const arith_plan *p = w->plan;
  for (int i = 0; i < p->adders; i++) {
    for (int j = 0; j < i; j++) {
      if (same_group(&p->adder[i], &p->adder[j])) {
        w->order[i]++;
      }
    }
  }
}

static void emit_group(writer *w, int first) {
  const arith_plan *p = w->plan;
  const arith_adder *a = &p->adder[first];
  int input[3][ARITH_WIDTH];
  int count = 0;
  for (int j = first; j < p->adders; j++) {
    if (same_group(a, &p->adder[j])) {
      for (int k = 0; k < 3; k++) {
        input[k][count] = p->adder[j].input[k];
      }
      count++;
    }
  }
  char sum[EMIT_NAME];
  char carry[EMIT_NAME];
  char name[EMIT_NAME];
  char parameters[24];
  adder_name(a, "sum", sum);
  adder_name(a, "carry", carry);
  adder_name(a, "fa", name);
  snprintf(parameters, sizeof parameters, "N=%d", count);
  int inputs = a->kind == ARITH_FULL || a->kind == ARITH_TOP_FULL ? 3 : 2;
  char *text[3] = {NULL, NULL, NULL};
  for (int k = 0; k < inputs; k++) {
    text[k] = bits_text(w, input[k], count, a->stage);
  }
  emit_vector(w->m, EMIT_WIRE, sum, count);
  if (a->kind < ARITH_TOP_FULL) {
    emit_vector(w->m, EMIT_WIRE, carry, count);
  }
  switch (a->kind) {
  case ARITH_FULL:
    for (int k = 0; k < 3; k++) {
      char wire[EMIT_NAME];
      snprintf(wire, sizeof wire, "%.40s_%c", name, "abc"[k]);
      emit_vector(w->m, EMIT_WIRE, wire, count);
      emit_text(w->m, "assign %s = %s;", wire, text[k]);
    }
    emit_instance(w->m, "sepax_fa", name, parameters, "%s, sum=%s, carry=%s",
                  gen_format("a=%s_a, b=%s_b, c=%s_c", name, name, name).text, sum, carry);
    break;
  case ARITH_HALF:
    emit_text(w->m, "assign %s = %s & %s;", carry, text[0], text[1]);
    break;
  case ARITH_PLUS_ONE:
    emit_text(w->m, "assign %s = %s | %s;", carry, text[0], text[1]);
    break;
  case ARITH_TOP_FULL:
    emit_text(w->m, "assign %s = %s ^ %s ^ %s;", sum, text[0], text[1], text[2]);
    break;
  default:
    break;
  }
  if (a->kind == ARITH_HALF || a->kind == ARITH_TOP_HALF) {
    emit_text(w->m, "assign %s = %s ^ %s;", sum, text[0], text[1]);
  } else if (a->kind == ARITH_PLUS_ONE || a->kind == ARITH_TOP_PLUS_ONE) {
    emit_text(w->m, "assign %s = ~(%s ^ %s);", sum, text[0], text[1]);
  }
  for (int k = 0; k < 3; k++) {
    free(text[k]);
  }
}

/* Every bit that is used behind a pipeline register and made before it passes the register. */
static void emit_register(writer *w, int stage) {
  const arith_plan *p = w->plan;
  int *crossing = calloc(ARITH_BITS, sizeof *crossing);
  int count = 0;
  if (crossing == NULL) {
    abort();
  }
  for (int i = 0; i < p->bits; i++) {
    if (p->bit[i].source != ARITH_ONE && p->bit[i].stage < stage && p->bit[i].last >= stage) {
      w->place[i * ARITH_STAGES + stage] = count;
      crossing[count++] = i;
    }
  }
  char name[EMIT_NAME];
  snprintf(name, sizeof name, "stage_%d", stage);
  emit_text(w->m, "\n// Pipeline register %d.", stage);
  emit_vector(w->m, EMIT_REG, name, count);
  char *text = bits_text(w, crossing, count, stage - 1);
  emit_text(w->m, "always @(posedge clk) begin\n  %s <= %s;\nend", name, text);
  free(text);
  free(crossing);
}

static void compress(writer *w, int stage) {
  const arith_plan *p = w->plan;
  for (int level = 1; level <= p->levels; level++) {
    bool headed = false;
    for (int i = 0; i < p->adders; i++) {
      const arith_adder *a = &p->adder[i];
      bool first = a->level == level && a->stage == stage;
      for (int j = 0; j < i && first; j++) {
        first = !same_group(a, &p->adder[j]);
      }
      if (first) {
        if (!headed) {
          emit_text(w->m, "\n// Full adders, level %d%s.", level,
                    stage > 0 ? " behind the register" : "");
          headed = true;
        }
        emit_group(w, i);
      }
    }
  }
}

static void add_behaviour(const writer *w) {
  const arith_plan *p = w->plan;
  emit_view(w->m, EMIT_BEHAVIOURAL);
  emit_vector(w->m, EMIT_WIRE, "wide_a", p->p_w);
  emit_vector(w->m, EMIT_WIRE, "wide_b", p->p_w);
  emit_text(w->m, "assign wide_a = {{%d{a[%d]}}, a};", p->p_w - p->a_w, p->a_w - 1);
  if (p->plain) {
    emit_text(w->m, "assign wide_b = {{%d{b[%d]}}, b};", p->p_w - p->b_w, p->b_w - 1);
  } else {
    emit_bias(w, p->p_w, "the module multiplies by b - BIAS");
    emit_text(w->m, "assign wide_b = {{%d{b[%d]}}, b} - BIAS;", p->p_w - p->b_w, p->b_w - 1);
  }
  if (p->latency == 0) {
    emit_text(w->m, "assign p = wide_a * wide_b;");
  } else {
    for (int i = 1; i <= p->latency; i++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, "product_%d", i);
      emit_vector(w->m, EMIT_REG, name, p->p_w);
    }
    emit_text(w->m, "always @(posedge clk) begin\n  product_1 <= wide_a * wide_b;");
    for (int i = 2; i <= p->latency; i++) {
      emit_text(w->m, "  product_%d <= product_%d;", i, i - 1);
    }
    emit_text(w->m, "end\nassign p = product_%d;", p->latency);
  }
  emit_view(w->m, EMIT_STRUCTURAL);
}

static void print_bias(const arith_plan *plan, char text[48]) {
  unsigned __int128 bias = 0;
  for (int i = 1; i < plan->rows; i++) {
    bias = 4 * bias + (unsigned)plan->less;
  }
  char digits[48];
  int count = 0;
  do {
    digits[count++] = (char)('0' + (int)(bias % 10));
    bias /= 10;
  } while (bias > 0);
  for (int i = 0; i < count; i++) {
    text[i] = digits[count - 1 - i];
  }
  text[count] = '\0';
}

void arith_name(const arith_plan *plan, char name[EMIT_NAME]) {
  const char *kind = plan->plain ? "" : plan->less == 2 ? "_biased_2" : "_biased";
  snprintf(name, EMIT_NAME, "sepax_mul_%dx%d%s", plan->a_w, plan->b_w, kind);
}

static gen_line banner_of(const arith_plan *plan, const char *bias) {
  int full = 0;
  for (int i = 0; i < plan->adders; i++) {
    full += plan->adder[i].kind == ARITH_FULL || plan->adder[i].kind == ARITH_TOP_FULL;
  }
  const gen_line product =
      plan->plain
          ? gen_format("Signed product: p = a * b modulo 2^%d.", plan->p_w)
          : gen_format("Biased multiplier: p = a * (b - BIAS) modulo 2^%d, BIAS = %s,\n"
                       "for b with floor(b / 4^%d) in -2 ... 2. Whoever wants a * b adds BIAS to"
                       " b\nbeforehand, or has sums in which a * BIAS cancels.",
                       plan->p_w, bias, plan->rows - 1);
  const gen_line rows =
      gen_format("Latency %d. Structure: %d rows, selected by the radix-4 digits of %s,\n"
                 "each but the highest less %d;",
                 plan->latency, plan->rows, plan->plain ? "b + BIAS" : "b", plan->less);
  return gen_format("%.400s\n%.300s %d full and %d half adders in columns, the earliest\n"
                    "bits first; one addition. Where SEPAX_BEHAVIOURAL is defined, a plain product"
                    " of the\nsame latency.",
                    product.text, rows.text, full, plan->adders - full);
}

static void ports(emit_module *m, const arith_plan *plan) {
  if (plan->latency > 0) {
    emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  }
  emit_signal(m, EMIT_INPUT, true, "a", gen_format("%d", plan->a_w).text, "first factor");
  emit_signal(m, EMIT_INPUT, true, "b", gen_format("%d", plan->b_w).text, "second factor%s",
              plan->plain ? "" : " + BIAS");
  emit_signal(m, EMIT_OUTPUT, true, "p", gen_format("%d", plan->p_w).text,
              "product, %d clocks later", plan->latency);
}

void gen_multiplier(emitter *e, const arith_plan *plan) {
  char name[EMIT_NAME];
  writer w = {.plan = plan};
  arith_name(plan, name);
  print_bias(plan, w.bias);
  w.m = emit_begin(e, name, banner_of(plan, w.bias).text);
  w.place = calloc((size_t)ARITH_BITS * ARITH_STAGES, sizeof *w.place);
  w.order = calloc(ARITH_ADDERS, sizeof *w.order);
  if (w.place == NULL || w.order == NULL) {
    abort();
  }
  ports(w.m, plan);
  add_behaviour(&w);
  recode(&w);
  group_adders(&w);
  for (int stage = 0; stage <= plan->latency; stage++) {
    if (stage > 0) {
      emit_register(&w, stage);
    }
    compress(&w, stage);
  }
  char *row[2];
  for (int i = 0; i < 2; i++) {
    row[i] = bits_text(&w, plan->final[i], plan->p_w, plan->latency);
  }
  emit_text(w.m, "\n// The last two rows.\nassign p = %s +\n           %s;", row[0], row[1]);
  emit_view(w.m, EMIT_BOTH);
  free(row[0]);
  free(row[1]);
  free(w.place);
  free(w.order);
  emit_end(w.m);
}
