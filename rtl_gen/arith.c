/* arith.c - sepax_fa, sepax_booth and the multipliers made of them. */
#include "arith.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Of a full adder, from its first two inputs and from the third, which may be late. */
static const double sum_delay = 0.135;
static const double late_sum_delay = 0.085;
static const double carry_delay = 0.095;

/* Low columns are ready early, which helps the last addition, but not behind a rank. */
static const double skew_lost = 0.07;

double delay_register(void) { return 0.20; }

double delay_booth(int width) { return 0.27 + 0.03 * log2(width); }

double delay_compressor(void) { return sum_delay; }

double delay_adder(int width) { return 0.10 + 0.055 * log2(width) + 0.0012 * width; }

double delay_test(int width) { return 0.05 + 0.04 * log2(width); }

double delay_mux(int inputs) { return inputs > 1 ? 0.08 + 0.04 * log2(inputs) : 0; }

/* ------------------------------------------------------------------------ planning */

typedef struct {
  int bit[ARITH_WIDTH];
  int count;
} column;

static int add_bit(arith_plan *p, arith_source source, int from, int index, int stage,
                   double time) {
  if (p->bits == ARITH_BITS) {
    abort();
  }
  p->bit[p->bits] = (arith_bit){source, from, index, stage, stage, time};
  return p->bits++;
}

static void put(column *c, int bit) {
  if (c->count == ARITH_WIDTH) {
    abort();
  }
  c->bit[c->count++] = bit;
}

/* Take the earliest bit out of a column. */
static int take_bit(const arith_plan *p, column *c) {
  int best = 0;
  for (int i = 1; i < c->count; i++) {
    const arith_bit *a = &p->bit[c->bit[i]];
    const arith_bit *b = &p->bit[c->bit[best]];
    if (a->stage < b->stage || (a->stage == b->stage && a->time < b->time)) {
      best = i;
    }
  }
  int bit = c->bit[best];
  memmove(c->bit + best, c->bit + best + 1, (size_t)(c->count - best - 1) * sizeof c->bit[0]);
  c->count--;
  return bit;
}

static int row_bits(const arith_plan *p, int row) {
  /* The digit of a sign bit alone is never 2 or -2. */
  bool alone = p->b_w % 2 == 1 && row == p->rows - 1;
  int whole = alone ? p->a_w : p->a_w + 1;
  int room = p->p_w - 2 * row;
  return whole < room ? whole : room;
}

/* Rows and their corrections: each row's highest bit, inverted, stands for -2^n + it. */
static void plan_rows(arith_plan *p, column *columns, bool one[ARITH_WIDTH], double time) {
  int weight[ARITH_WIDTH] = {0};
  for (int row = 0; row < p->rows; row++) {
    bool alone = p->b_w % 2 == 1 && row == p->rows - 1;
    int whole = alone ? p->a_w : p->a_w + 1;
    int bits = row_bits(p, row);
    for (int i = 0; i < bits; i++) {
      put(&columns[2 * row + i], add_bit(p, ARITH_ROW, row, i, 0, time));
    }
    if (bits == whole) {
      weight[2 * row + whole - 1]++;
    }
    put(&columns[2 * row], add_bit(p, ARITH_NEGATIVE, row, 0, 0, time - 0.1));
  }
  int borrow = 0;
  for (int c = 0; c < p->p_w; c++) {
    int digit = -weight[c] - borrow;
    one[c] = (digit & 1) != 0;
    borrow = (one[c] - digit) / 2;
  }
}

/* The stage and time at which something with this delay is ready, given its inputs. */
static void settle(const arith_plan *p, const int *input, int inputs, double delay, double room,
                   int *stage, double *time) {
  *stage = 0;
  *time = 0;
  for (int i = 0; i < inputs; i++) {
    const arith_bit *b = &p->bit[input[i]];
    if (b->stage > *stage) {
      *stage = b->stage;
      *time = 0;
    }
    if (b->stage == *stage && b->time > *time) {
      *time = b->time;
    }
  }
  *time += delay;
  if (*time > room) {
    (*stage)++;
    *time = delay;
  }
}

static void use(arith_plan *p, int bit, int stage) {
  p->bit[bit].last = stage > p->bit[bit].last ? stage : p->bit[bit].last;
}

static int level_of(const arith_plan *p, int bit, int stage) {
  const arith_bit *b = &p->bit[bit];
  return b->source < ARITH_SUM || b->source == ARITH_ONE || b->stage < stage
             ? 0
             : p->adder[b->from].level;
}

/* Three bits of a column, or two, or two and a one, become one and a carry. */
static void add_adder(arith_plan *p, column *columns, int at, arith_kind kind, double room) {
  arith_adder *a = &p->adder[p->adders];
  if (p->adders == ARITH_ADDERS) {
    abort();
  }
  int inputs = kind == ARITH_FULL ? 3 : 2;
  bool top = at == p->p_w - 1;
  kind = top ? kind + (ARITH_TOP_FULL - ARITH_FULL) : kind;
  *a = (arith_adder){.kind = kind, .column = at};
  for (int i = 0; i < inputs; i++) {
    a->input[i] = take_bit(p, &columns[at]);
  }
  int stage[3];
  double time[3];
  settle(p, a->input, 2, sum_delay, room, &stage[0], &time[0]);
  settle(p, a->input, 2, carry_delay, room, &stage[1], &time[1]);
  double sum = time[0];
  double carry = time[1];
  a->stage = stage[0];
  if (inputs == 3) {
    settle(p, a->input + 2, 1, late_sum_delay, room, &stage[2], &time[2]);
    if (stage[2] > a->stage) {
      a->stage = stage[2];
      sum = carry = time[2] > carry_delay ? time[2] : carry_delay;
    } else if (stage[2] == a->stage && time[2] > sum) {
      sum = time[2];
    }
    if (stage[2] == a->stage && time[2] + carry_delay - late_sum_delay > carry) {
      carry = time[2] + carry_delay - late_sum_delay;
    }
  }
  if (stage[1] < a->stage && carry > sum) {
    carry = sum;
  }
  for (int i = 0; i < inputs; i++) {
    use(p, a->input[i], a->stage);
    int level = level_of(p, a->input[i], a->stage) + 1;
    a->level = level > a->level ? level : a->level;
  }
  p->levels = a->level > p->levels ? a->level : p->levels;
  for (int i = 0; i < p->adders; i++) {
    const arith_adder *b = &p->adder[i];
    if (b->column == at && b->level == a->level && b->stage == a->stage &&
        b->kind == kind && b->copy >= a->copy) {
      a->copy = b->copy + 1;
    }
  }
  int number = p->adders++;
  put(&columns[at], add_bit(p, ARITH_SUM, number, 0, a->stage, sum));
  if (!top) {
    put(&columns[at + 1], add_bit(p, ARITH_CARRY, number, 0, a->stage, carry));
  }
}

/* Columns below this are early enough to ripple. */
enum { RIPPLE = 8 };

static void plan_in(arith_plan *p, int a_w, int b_w, int p_w, double used, double room) {
  *p = (arith_plan){.a_w = a_w, .b_w = b_w, .p_w = p_w, .rows = (b_w + 1) / 2};
  column *columns = calloc(ARITH_WIDTH, sizeof *columns);
  if (columns == NULL) {
    abort();
  }
  bool one[ARITH_WIDTH] = {false};
  plan_rows(p, columns, one, used + delay_booth(a_w));
  int stage = 0;
  double time = 0;
  for (int c = 0; c < p_w; c++) {
    if (one[c] && columns[c].count >= 2) {
      add_adder(p, columns, c, ARITH_PLUS_ONE, room);
    } else if (one[c]) {
      put(&columns[c], add_bit(p, ARITH_ONE, 0, 0, 0, 0));
    }
    if (c >= RIPPLE && columns[c].count > 2 && columns[c].count % 2 == 1) {
      add_adder(p, columns, c, ARITH_HALF, room);
    }
    while (columns[c].count > 2) {
      add_adder(p, columns, c, ARITH_FULL, room);
    }
    for (int i = 0; i < 2; i++) {
      p->final[i][c] = i < columns[c].count ? columns[c].bit[i] : -1;
      if (p->final[i][c] >= 0) {
        const arith_bit *b = &p->bit[p->final[i][c]];
        time = b->stage > stage || (b->stage == stage && b->time > time) ? b->time : time;
        stage = b->stage > stage ? b->stage : stage;
      }
    }
  }
  free(columns);
  double skew = stage > 0 ? skew_lost : 0;
  p->ranks = time + delay_adder(p_w) + skew > room ? stage + 1 : stage;
  for (int c = 0; c < p_w; c++) {
    for (int i = 0; i < 2; i++) {
      if (p->final[i][c] >= 0) {
        use(p, p->final[i][c], p->ranks);
      }
    }
  }
  for (int i = 0; i < p->bits; i++) {
    p->registers += p->bit[i].source == ARITH_ONE ? 0 : p->bit[i].last - p->bit[i].stage;
  }
}

/* With as many ranks as the period needs, their places are those for the shortest period
 * that needs no more. */
void arith_plan_make(arith_plan *p, int a_w, int b_w, int p_w, double used, double period) {
  double enough = period - delay_register();
  plan_in(p, a_w, b_w, p_w, used, enough);
  int ranks = p->ranks;
  double little = enough / 2;
  for (int i = 0; i < 4 && ranks > 0; i++) {
    double room = (enough + little) / 2;
    plan_in(p, a_w, b_w, p_w, used, room);
    if (p->ranks == ranks) {
      enough = room;
    } else {
      little = room;
    }
  }
  if (p->ranks != ranks) {
    plan_in(p, a_w, b_w, p_w, used, enough);
  }
}

/* -------------------------------------------------------------------------- leaves */

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

void gen_booth(emitter *e) {
  emit_module *m = emit_begin(
      e, "sepax_booth",
      "One row of a radix-4 Booth multiplier: with digit = -2 b2 + b1 + b0 of three\n"
      "neighbouring bits {b2, b1, b0} of b,\n"
      "  digit * a = row + negative modulo 2^ROW_W.\n"
      "Combinational.");
  emit_parameter(m, EMIT_PARAMETER, "A_W", 8, "bits of a");
  emit_parameter(m, EMIT_PARAMETER, "ROW_W", 9, "bits of the row kept, 1 ... A_W + 1");
  emit_signal(m, EMIT_INPUT, true, "a", "A_W", "the factor that is selected");
  emit_signal(m, EMIT_INPUT, false, "b", "3", "bits of the factor that is recoded");
  emit_signal(m, EMIT_OUTPUT, false, "row", "ROW_W", "the row, two's complement but for `negative`");
  emit_signal(m, EMIT_OUTPUT, false, "negative", "", "to be added at the row's lowest bit");
  emit_net(m, EMIT_WIRE, false, "one", "");
  emit_net(m, EMIT_WIRE, false, "two", "");
  emit_signal(m, EMIT_WIRE, false, "signed_a", "A_W+2", "a or its complement, and one more bit");
  emit_text(m, "\n"
               "assign one = b[1] ^ b[0];\n"
               "assign two = (b == 3'b011) || (b == 3'b100);\n"
               "assign negative = b[2] && !(b[1] && b[0]);\n"
               "assign signed_a = {a[A_W-1], a, 1'b0} ^ {(A_W+2){b[2]}};\n"
               "assign row = (signed_a[ROW_W:1] & {ROW_W{one}}) | (signed_a[ROW_W-1:0] & {ROW_W{two}});\n"
               "\n"
               "generate\n"
               "  if (A_W + 1 > ROW_W) begin : beyond\n"
               "    wire [A_W-ROW_W:0] unused_bits = signed_a[A_W+1:ROW_W+1];\n"
               "  end\n"
               "endgenerate");
  emit_end(m);
}

/* ------------------------------------------------------------------- multipliers */

typedef struct {
  emit_module *m;
  const arith_plan *plan;
  int *place;  /* of each bit in each rank */
  int *order;  /* of each adder in its group */
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
static int print_run(const writer *w, const int bit[], int at, int rank, char *text,
                     size_t size) {
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
  char parameters[48];
  emit_text(w->m, "// Rows: digit k of b selects row k, worth 4^k; its sign bit counts negative.");
  emit_vector(w->m, EMIT_WIRE, "recoded", 2 * p->rows + 1);
  emit_vector(w->m, EMIT_WIRE, "negative", p->rows);
  for (int row = 0; row < p->rows; row++) {
    snprintf(name, sizeof name, "plain_%d", row);
    emit_vector(w->m, EMIT_WIRE, name, row_bits(p, row));
    snprintf(name, sizeof name, "row_%d", row);
    emit_vector(w->m, EMIT_WIRE, name, row_bits(p, row));
  }
  emit_text(w->m, p->b_w % 2 == 1 ? "assign recoded = {b[%d], b, 1'b0};" : "assign recoded = {b, 1'b0};",
            p->b_w - 1);
  for (int row = 0; row < p->rows; row++) {
    int bits = row_bits(p, row);
    bool alone = p->b_w % 2 == 1 && row == p->rows - 1;
    snprintf(parameters, sizeof parameters, "A_W=%d, ROW_W=%d", p->a_w, bits);
    snprintf(name, sizeof name, "booth_%d", row);
    emit_instance(w->m, "sepax_booth", name, parameters,
                  "a=a, b=recoded[%d:%d], row=plain_%d, negative=negative[%d]", 2 * row + 2, 2 * row,
                  row, row);
    if (bits < (alone ? p->a_w : p->a_w + 1)) {
      emit_text(w->m, "assign row_%d = plain_%d;", row, row);
    } else {
      emit_text(w->m, "assign row_%d = {~plain_%d[%d], plain_%d[%d:0]};", row, row, bits - 1, row,
                bits - 2);
    }
  }
}

static bool same_group(const arith_adder *a, const arith_adder *b) {
  return a->kind == b->kind && a->level == b->level && a->stage == b->stage &&
         a->copy == b->copy;
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
          emit_text(w->m, "\n// Full adders, level %d%s.", level, stage > 0 ? " behind the rank" : "");
          headed = true;
        }
        emit_group(w, i);
      }
    }
  }
}

static void add_behaviour(const writer *w) {
  const arith_plan *p = w->plan;
  char above_a[48];
  char above_b[48];
  emit_view(w->m, EMIT_BEHAVIOURAL);
  snprintf(above_a, sizeof above_a, "{{%d{a[%d]}}, a}", p->p_w - p->a_w, p->a_w - 1);
  snprintf(above_b, sizeof above_b, "{{%d{b[%d]}}, b}", p->p_w - p->b_w, p->b_w - 1);
  if (p->ranks == 0) {
    emit_text(w->m, "assign p = %s * %s;", above_a, above_b);
  } else {
    for (int i = 1; i <= p->ranks; i++) {
      char name[EMIT_NAME];
      snprintf(name, sizeof name, "product_%d", i);
      emit_vector(w->m, EMIT_REG, name, p->p_w);
    }
    emit_text(w->m, "always @(posedge clk) begin\n  product_1 <= %s * %s;", above_a, above_b);
    for (int i = 2; i <= p->ranks; i++) {
      emit_text(w->m, "  product_%d <= product_%d;", i, i - 1);
    }
    emit_text(w->m, "end\nassign p = product_%d;", p->ranks);
  }
  emit_view(w->m, EMIT_STRUCTURAL);
}

void gen_multiplier(emitter *e, const char *name, const arith_plan *plan) {
  char banner[512];
  char bits[16];
  snprintf(banner, sizeof banner,
           "Signed product: p = a * b modulo 2^%d.\n"
           "Latency %d. Structure: %d rows by radix-4 Booth recoding of b, %d full adders\n"
           "in columns, the earliest bits first, one addition. Where SEPAX_BEHAVIOURAL is\n"
           "defined, a plain product of the same latency.",
           plan->p_w, plan->ranks, plan->rows, plan->adders);
  writer w = {.m = emit_begin(e, name, banner), .plan = plan};
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
