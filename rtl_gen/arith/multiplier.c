/* gen_arith.c - sepax_fa, sepax_digit, and the multipliers made of them. */
#include "arith.h"

#include <stdlib.h>
#include <string.h>

void gen_fa(emitter *e) {
  emit_module *m = emit_begin(e, "sepax_fa",
                              "N full adders side by side: a + b + c = sum + 2 carry, bit by bit.\n"
                              "Combinational. A library's full-adder cell may stand for it.");
  emit_parameter(m, EMIT_PARAMETER, "N", 8, "bits");
  emit_signal(m, EMIT_INPUT, false, "a", "N", "row");
  emit_signal(m, EMIT_INPUT, false, "b", "N", "row");
  emit_signal(m, EMIT_INPUT, false, "c", "N", "row, may be the last to come");
  emit_signal(m, EMIT_OUTPUT, false, "sum", "N", "sums of the columns");
  emit_signal(m, EMIT_OUTPUT, false, "carry", "N", "carries of the columns");
  emit_net(m, EMIT_WIRE, false, "half", "N");
  emit_text(m, "\nassign half = a ^ b;\n"
               "assign sum = half ^ c;\n"
               "assign carry = (a & b) | (half & c);");
  emit_end(m);
}

static emit_module *begin_row(emitter *e, const char *name, const char *digit, const char *bits,
                              const char *about) {
  char banner[400];
  snprintf(banner, sizeof banner,
           "One row of a multiplier: with %s,\n"
           "  digit * a = row + negative modulo 2^ROW_W.\n"
           "Combinational.",
           digit);
  emit_module *m = emit_begin(e, name, banner);
  emit_parameter(m, EMIT_PARAMETER, "A_W", 8, "bits of a");
  emit_parameter(m, EMIT_PARAMETER, "ROW_W", 9, "bits of the row kept, 1 ... A_W + 1");
  emit_signal(m, EMIT_INPUT, true, "a", "A_W", "the factor that is selected");
  emit_signal(m, EMIT_INPUT, false, "b", bits, "%s", about);
  emit_signal(m, EMIT_OUTPUT, false, "row", "ROW_W",
              "the row, two's complement but for `negative`");
  emit_signal(m, EMIT_OUTPUT, false, "negative", "", "to be added at the row's lowest bit");
  emit_net(m, EMIT_WIRE, false, "one", "");
  emit_net(m, EMIT_WIRE, false, "two", "");
  emit_signal(m, EMIT_WIRE, false, "twice", "A_W+2", "2 a");
  emit_text(m, "\nassign twice = {a[A_W-1], a, 1'b0};");
  return m;
}

static void end_row(emit_module *m) {
  emit_text(m, "\n"
               "generate\n"
               "  if (A_W + 1 > ROW_W) begin : beyond\n"
               "    wire [A_W-ROW_W:0] unused_bits = twice[A_W+1:ROW_W+1];\n"
               "  end\n"
               "endgenerate");
  emit_end(m);
}

void gen_digits(emitter *e, bool two_less) {
  emit_module *m = begin_row(e, "sepax_digit", "digit = b - 1, which is -1, 0, 1 or 2", "2",
                             "two bits of the other factor");
  emit_text(m,
            "assign one = b == 2'd2;\n"
            "assign two = b == 2'd3;\n"
            "assign negative = b == 2'd0;\n"
            "assign row = (twice[ROW_W:1] & {ROW_W{one}}) | (twice[ROW_W-1:0] & {ROW_W{two}}) |\n"
            "             (~twice[ROW_W:1] & {ROW_W{negative}});");
  end_row(m);
  if (two_less) {
    m = begin_row(e, "sepax_digit_2", "digit = b - 2, which is -2, -1, 0 or 1", "2",
                  "two bits of the other factor");
    emit_text(
        m, "assign one = b == 2'd3;\n"
           "assign two = b == 2'd0;\n"
           "assign negative = !b[1];\n"
           "assign row = (twice[ROW_W:1] & {ROW_W{one}}) | (~twice[ROW_W-1:0] & {ROW_W{two}}) |\n"
           "             (~twice[ROW_W:1] & {ROW_W{negative && !two}});");
    end_row(m);
  }
  m = begin_row(e, "sepax_top_digit", "digit = b, two's complement, -2, -1, 0, 1 or 2", "3",
                "the highest bits of the other factor");
  emit_text(m, "assign one = b[0];\n"
               "assign two = b[1] && !b[0];\n"
               "assign negative = b[2];\n"
               "assign row = ((twice[ROW_W:1] ^ {ROW_W{negative}}) & {ROW_W{one}}) |\n"
               "             ((twice[ROW_W-1:0] ^ {ROW_W{negative}}) & {ROW_W{two}});");
  end_row(m);
}

/* ------------------------------------------------------------------- multipliers */

typedef struct {
  emit_module *m;
  const arith_plan *plan;
  int *place;      /* of each bit in each rank */
  int *order;      /* of each adder in its group */
  char offset[48]; /* K */
} writer;

/* "sum_2_0" and the like: adders of one kind, level and stage, the k-th of their columns. */
static void adder_name(const arith_adder *a, const char *what, char text[EMIT_NAME]) {
  static const char *const kind[] = {"", "half_", "ones_", "top_", "top_half_", "top_ones_"};
  int used = a->stage > 0 ? snprintf(text, EMIT_NAME, "%s%s_r%d", kind[a->kind], what, a->stage)
                          : snprintf(text, EMIT_NAME, "%s%s", kind[a->kind], what);
  snprintf(text + used, EMIT_NAME - (size_t)used, "_%d_%d", a->level, a->copy);
}

/* The vector and index in which a bit stands behind `rank` ranks; index -1: it is a bit. */
static int bit_name(const writer *w, int bit, int rank, char text[EMIT_NAME]) {
  const arith_bit *b = &w->plan->bit[bit];
  if (b->source == ARITH_ONE) {
    snprintf(text, EMIT_NAME, "1'b1");
    return -1;
  }
  if (rank > b->stage) {
    snprintf(text, EMIT_NAME, "rank_%d", rank);
    return w->place[bit * ARITH_RANKS + rank];
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
static int print_run(const writer *w, const int bit[], int at, int rank, char *text, size_t size) {
  char name[EMIT_NAME];
  int run = 1;
  if (bit[at] < 0) {
    while (at - run >= 0 && bit[at - run] < 0) {
      run++;
    }
    snprintf(text, size, "%d'd0", run);
    return run;
  }
  int index = bit_name(w, bit[at], rank, name);
  char next[EMIT_NAME];
  while (index >= 0 && at - run >= 0 && bit[at - run] >= 0 &&
         bit_name(w, bit[at - run], rank, next) == index - run && strcmp(name, next) == 0) {
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
static void print_bits(const writer *w, const int bit[], int count, int rank, FILE *out) {
  fputc('{', out);
  int column_at = 0;
  for (int i = count - 1; i >= 0;) {
    char text[3 * EMIT_NAME];
    int run = print_run(w, bit, i, rank, text, sizeof text);
    i -= run;
    column_at += (int)strlen(text) + 2;
    fprintf(out, "%s%s", text, i >= 0 ? column_at > 80 ? ",\n                     " : ", " : "}");
    column_at = column_at > 80 ? 0 : column_at;
  }
}

static char *bits_text(const writer *w, const int bit[], int count, int rank) {
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  if (out == NULL) {
    abort();
  }
  print_bits(w, bit, count, rank, out);
  fclose(out);
  return text;
}

static void emit_vector(emit_module *m, emit_kind kind, const char *name, int bits) {
  char width[16];
  snprintf(width, sizeof width, "%d", bits);
  emit_net(m, kind, false, name, width);
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
    emit_text(w->m, "assign sum = {b[%d], b} + %d'd%s;", p->b_w - 1, p->sum_w, w->offset);
  }
  emit_vector(w->m, EMIT_WIRE, "top", 3);
  if (top == 3) {
    emit_text(w->m, "assign top = %s[%d:%d];", b, p->sum_w - 1, p->sum_w - 3);
  } else {
    emit_text(w->m, "assign top = {{%d{%s[%d]}}, %s[%d:%d]};", 3 - top, b, p->sum_w - 1, b,
              p->sum_w - 1, p->sum_w - top);
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
      emit_text(w->m, "assign row_%d = {~plain_%d[%d], plain_%d[%d:0]};", row, row, bits - 1, row,
                bits - 2);
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
    emit_instance(w->m, "sepax_fa", name, parameters, "a=%s_a, b=%s_b, c=%s_c, sum=%s, carry=%s",
                  name, name, name, sum, carry);
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

/* Every bit that is used behind a rank and made before it passes the rank. */
static void emit_rank(writer *w, int rank) {
  const arith_plan *p = w->plan;
  int *crossing = calloc(ARITH_BITS, sizeof *crossing);
  int count = 0;
  if (crossing == NULL) {
    abort();
  }
  for (int i = 0; i < p->bits; i++) {
    if (p->bit[i].source != ARITH_ONE && p->bit[i].stage < rank && p->bit[i].last >= rank) {
      w->place[i * ARITH_RANKS + rank] = count;
      crossing[count++] = i;
    }
  }
  char name[EMIT_NAME];
  snprintf(name, sizeof name, "rank_%d", rank);
  emit_text(w->m, "\n// Register rank %d.", rank);
  emit_vector(w->m, EMIT_REG, name, count);
  char *text = bits_text(w, crossing, count, rank - 1);
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
                    stage > 0 ? " behind the rank" : "");
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
  emit_vector(w->m, EMIT_WIRE, "above_a", p->p_w);
  emit_vector(w->m, EMIT_WIRE, "above_b", p->p_w);
  emit_text(w->m, "assign above_a = {{%d{a[%d]}}, a};", p->p_w - p->a_w, p->a_w - 1);
  if (p->plain) {
    emit_text(w->m, "assign above_b = {{%d{b[%d]}}, b};", p->p_w - p->b_w, p->b_w - 1);
  } else {
    emit_text(w->m, "assign above_b = {{%d{b[%d]}}, b} - %d'd%s;", p->p_w - p->b_w, p->b_w - 1,
              p->p_w, w->offset);
  }
  if (p->ranks == 0) {
    emit_text(w->m, "assign p = above_a * above_b;");
  } else {
    for (int i = 1; i <= p->ranks; i++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, "product_%d", i);
      emit_vector(w->m, EMIT_REG, name, p->p_w);
    }
    emit_text(w->m, "always @(posedge clk) begin\n  product_1 <= above_a * above_b;");
    for (int i = 2; i <= p->ranks; i++) {
      emit_text(w->m, "  product_%d <= product_%d;", i, i - 1);
    }
    emit_text(w->m, "end\nassign p = product_%d;", p->ranks);
  }
  emit_view(w->m, EMIT_STRUCTURAL);
}

/* What the digits count less, all together. */
static void print_offset(const arith_plan *plan, char text[48]) {
  unsigned __int128 offset = 0;
  for (int i = 1; i < plan->rows; i++) {
    offset = 4 * offset + (unsigned)plan->less;
  }
  char digits[48];
  int count = 0;
  do {
    digits[count++] = (char)('0' + (int)(offset % 10));
    offset /= 10;
  } while (offset > 0);
  for (int i = 0; i < count; i++) {
    text[i] = digits[count - 1 - i];
  }
  text[count] = '\0';
}

void arith_name(const arith_plan *plan, char name[EMIT_NAME]) {
  snprintf(name, EMIT_NAME, "sepax_mul_%dx%d%s", plan->a_w, plan->b_w, plan->less == 2 ? "_2" : "");
}

void gen_multiplier(emitter *e, const arith_plan *plan) {
  char name[EMIT_NAME];
  arith_name(plan, name);
  char banner[512];
  char bits[16];
  char offset[48];
  int full = 0;
  for (int i = 0; i < plan->adders; i++) {
    full += plan->adder[i].kind == ARITH_FULL || plan->adder[i].kind == ARITH_TOP_FULL;
  }
  print_offset(plan, offset);
  if (plan->plain) {
    snprintf(banner, sizeof banner, "Signed product: p = a * b modulo 2^%d.", plan->p_w);
  } else {
    snprintf(banner, sizeof banner,
             "Signed product: p = a * (b - %s) modulo 2^%d, floor(b / 4^%d) in -2 ... 2.", offset,
             plan->p_w, plan->rows - 1);
  }
  size_t used = strlen(banner);
  snprintf(banner + used, sizeof banner - used,
           "\nLatency %d. Structure: %d rows, selected by the radix-4 digits of %s,\n"
           "each but the highest less %d; %d full and %d half adders in columns, the earliest\n"
           "bits first; one addition. Where SEPAX_BEHAVIOURAL is defined, a plain product of the\n"
           "same latency.",
           plan->ranks, plan->rows, plan->plain ? "b + 1 + 4 + 16 ..." : "b", plan->less, full,
           plan->adders - full);
  writer w = {.m = emit_begin(e, name, banner), .plan = plan};
  memcpy(w.offset, offset, sizeof w.offset);
  w.place = calloc((size_t)ARITH_BITS * ARITH_RANKS, sizeof *w.place);
  w.order = calloc(ARITH_ADDERS, sizeof *w.order);
  if (w.place == NULL || w.order == NULL) {
    abort();
  }
  if (plan->ranks > 0) {
    emit_signal(w.m, EMIT_INPUT, false, "clk", "", "clock");
  }
  snprintf(bits, sizeof bits, "%d", plan->a_w);
  emit_signal(w.m, EMIT_INPUT, true, "a", bits, "first factor");
  snprintf(bits, sizeof bits, "%d", plan->b_w);
  emit_signal(w.m, EMIT_INPUT, true, "b", bits, "second factor");
  snprintf(bits, sizeof bits, "%d", plan->p_w);
  emit_signal(w.m, EMIT_OUTPUT, true, "p", bits, "product, %d clocks later", plan->ranks);
  emit_blank(w.m);
  add_behaviour(&w);
  recode(&w);
  group_adders(&w);
  for (int stage = 0; stage <= plan->ranks; stage++) {
    if (stage > 0) {
      emit_rank(&w, stage);
    }
    compress(&w, stage);
  }
  char *row[2];
  for (int i = 0; i < 2; i++) {
    row[i] = bits_text(&w, plan->final[i], plan->p_w, plan->ranks);
  }
  emit_text(w.m, "\n// The last two rows.\nassign p = %s +\n           %s;", row[0], row[1]);
  emit_view(w.m, EMIT_BOTH);
  free(row[0]);
  free(row[1]);
  free(w.place);
  free(w.order);
  emit_end(w.m);
}
