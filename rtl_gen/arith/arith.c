/* SPDX-License-Identifier: MIT */
/* arith.c - multipliers planned: rows, full adders, pipeline registers. */
#include "arith.h"

#include <string.h>

/* ------------------------------------------------------------------------ planning */

typedef struct {
  int bit[ARITH_WIDTH];
  int count;
} column;

static int add_bit(arith_plan *p, arith_source source, int from, int index, arith_moment made) {
  if (p->bits == ARITH_BITS) {
    p->fault = "more bits than ARITH_BITS";
    return 0;
  }
  p->bit[p->bits] = (arith_bit){source, from, index, made, made.stage, {0}};
  return p->bits++;
}

static arith_moment later(arith_moment a, arith_moment b) {
  return a.stage > b.stage || (a.stage == b.stage && a.time >= b.time) ? a : b;
}

static void put(arith_plan *p, column *c, int bit) {
  if (c->count == ARITH_WIDTH) {
    p->fault = "more bits in a column than ARITH_WIDTH";
    return;
  }
  c->bit[c->count++] = bit;
}

/* Take the earliest bit out of a column. */
static int take_bit(const arith_plan *p, column *c) {
  int best = 0;
  for (int i = 1; i < c->count; i++) {
    arith_moment made = p->bit[c->bit[i]].made;
    arith_moment earliest = p->bit[c->bit[best]].made;
    if (made.stage < earliest.stage ||
        (made.stage == earliest.stage && made.time < earliest.time)) {
      best = i;
    }
  }
  int bit = c->bit[best];
  memmove(c->bit + best, c->bit + best + 1, (size_t)(c->count - best - 1) * sizeof c->bit[0]);
  c->count--;
  return bit;
}

/* A digit of one bit, which is a sign, is never 2 or -2. */
static int whole_row(const arith_plan *p, int row) {
  return p->sum_w - 2 * row == 1 ? p->a_w : p->a_w + 1;
}

int arith_row_bits(const arith_plan *p, int row) {
  int whole = whole_row(p, row);
  int most = p->p_w - 2 * row;
  return whole < most ? whole : most;
}

bool arith_row_whole(const arith_plan *p, int row) {
  return arith_row_bits(p, row) == whole_row(p, row);
}

/* Rows of one product; each row's highest bit, inverted, stands for -2^n + it. */
static void plan_rows(arith_plan *p, column *columns, int weight[ARITH_WIDTH], int term,
                      double time) {
  for (int row = 0; row < p->rows; row++) {
    int bits = arith_row_bits(p, row);
    int from = term * p->rows + row;
    for (int i = 0; i < bits; i++) {
      put(p, &columns[2 * row + i], add_bit(p, ARITH_ROW, from, i, (arith_moment){0, time}));
    }
    if (arith_row_whole(p, row)) {
      weight[2 * row + bits - 1]++;
    }
    put(p, &columns[2 * row],
        add_bit(p, ARITH_NEGATIVE, from, from,
                (arith_moment){0, time - p->delay->early_correction}));
  }
}

/* What is subtracted is inverted, and 1 more. Its highest bit is as that of a row, unless it is the
 * sum's. */
static void plan_addend(arith_plan *p, column *columns, int weight[ARITH_WIDTH], int number) {
  const arith_addend *a = &p->addend[number];
  for (int i = 0; i < a->width && a->place + i < p->p_w; i++) {
    put(p, &columns[a->place + i], add_bit(p, ARITH_ADDEND, number, i, (arith_moment){0, 0}));
  }
  if (a->width > 0) {
    weight[a->place + a->width - 1] += a->place + a->width < p->p_w;
    weight[a->place] -= a->minus;
  }
}

/* What is added, and the sum of all corrections as bits that are 1. */
static void plan_columns(arith_plan *p, column *columns, bool one[ARITH_WIDTH], double time) {
  int weight[ARITH_WIDTH] = {0};
  for (int term = 0; term < p->terms || term == 0; term++) {
    plan_rows(p, columns, weight, term, time);
  }
  for (int k = 0; k < ARITH_ADDENDS; k++) {
    plan_addend(p, columns, weight, k);
  }
  int borrow = 0;
  for (int c = 0; c < p->p_w; c++) {
    int digit = -weight[c] - borrow;
    one[c] = (digit & 1) != 0;
    borrow = (one[c] - digit) / 2;
  }
}

/* When something with this delay is ready whose inputs are there at m. */
static arith_moment settle(arith_moment m, double delay, double available) {
  return m.time + delay > available ? (arith_moment){m.stage + 1, delay}
                                    : (arith_moment){m.stage, m.time + delay};
}

/* When the sum and the carry of these inputs are ready, in the stage of the adder; the third input
 * may be late. */
static void settle_adder(const arith_plan *p, const int *input, int inputs, double available,
                         arith_moment *sum, arith_moment *carry) {
  const delay_model *m = p->delay;
  arith_moment early = later(p->bit[input[0]].made, p->bit[input[1]].made);
  double carry_delay = m->carry;
  *sum = settle(early, m->sum, available);
  *carry = settle(early, carry_delay, available);
  bool carry_waits = carry->stage < sum->stage;
  if (inputs == 3) {
    arith_moment late = settle(p->bit[input[2]].made, m->late_sum, available);
    double late_carry = late.time + carry_delay - m->late_sum;
    if (late.stage > sum->stage) {
      carry_waits = carry->stage < late.stage;
      sum->stage = late.stage;
      sum->time = carry->time = late.time > carry_delay ? late.time : carry_delay;
    } else if (late.stage == sum->stage && late.time > sum->time) {
      sum->time = late.time;
    }
    if (late.stage == sum->stage && late_carry > carry->time) {
      carry->time = late_carry;
    }
  }
  if (carry_waits && carry->time > sum->time) {
    carry->time = sum->time;
  }
  carry->stage = sum->stage;
}

static void use(arith_plan *p, int bit, int stage) {
  p->bit[bit].last = stage > p->bit[bit].last ? stage : p->bit[bit].last;
}

static int level_of(const arith_plan *p, int bit, int stage) {
  const arith_bit *b = &p->bit[bit];
  return b->source < ARITH_SUM || b->source == ARITH_ONE || b->made.stage < stage
             ? 0
             : p->adder[b->from].level;
}

/* Its copy and order among the adders before it. */
static void place_adder(const arith_plan *p, arith_adder *a) {
  for (int pass = 0; pass < 2; pass++) {
    for (const arith_adder *b = p->adder; b < a; b++) {
      bool same = b->kind == a->kind && b->level == a->level && b->stage == a->stage;
      if (pass == 0) {
        a->copy += same && b->column == a->column;
      } else {
        a->order += same && b->copy == a->copy;
      }
    }
  }
}

/* Three bits of a column, or two, or two and a one, become one and a carry. */
static void add_adder(arith_plan *p, column *columns, int at, arith_kind kind, double available) {
  if (p->adders == ARITH_ADDERS) {
    p->fault = "more adders than ARITH_ADDERS";
    return;
  }
  arith_adder *a = &p->adder[p->adders];
  int inputs = kind == ARITH_FULL ? 3 : 2;
  bool top = at == p->p_w - 1;
  kind = top ? kind + (ARITH_TOP_FULL - ARITH_FULL) : kind;
  *a = (arith_adder){.kind = kind, .column = at};
  for (int i = 0; i < inputs; i++) {
    a->input[i] = take_bit(p, &columns[at]);
  }
  arith_moment sum;
  arith_moment carry;
  settle_adder(p, a->input, inputs, available, &sum, &carry);
  a->stage = sum.stage;
  for (int i = 0; i < inputs; i++) {
    use(p, a->input[i], a->stage);
    int level = level_of(p, a->input[i], a->stage) + 1;
    a->level = level > a->level ? level : a->level;
  }
  p->levels = a->level > p->levels ? a->level : p->levels;
  place_adder(p, a);
  int number = p->adders++;
  put(p, &columns[at], add_bit(p, ARITH_SUM, number, a->order, sum));
  if (!top) {
    put(p, &columns[at + 1], add_bit(p, ARITH_CARRY, number, a->order, carry));
  }
}

static const delay_model *model_of(const arith_form *form) {
  return form->delay != NULL ? form->delay : delay_model_of(SEPAX_TARGET_ASIC);
}

/* Columns below this are early enough to ripple. */
enum { RIPPLE = 8 };

static void plan_in(arith_plan *p, const arith_form *form, double available) {
  const delay_model *m = model_of(form);
  *p = (arith_plan){.delay = m, .a_w = form->a_w, .b_w = form->b_w, .p_w = form->p_w};
  p->rows = form->digits > 0 ? form->digits : (form->b_w + 1) / 2;
  p->plain = form->digits == 0;
  p->less = form->less;
  p->sum_w = form->b_w + p->plain;
  p->terms = form->terms;
  p->open = form->open;
  memcpy(p->addend, form->addend, sizeof p->addend);
  double used = form->used + (p->plain ? delay_adder(m, p->sum_w) : 0);
  int p_w = p->p_w;
  column columns[ARITH_WIDTH];
  memset(columns, 0, sizeof columns);
  bool one[ARITH_WIDTH] = {false};
  plan_columns(p, columns, one, used + delay_row(m, p->a_w));
  arith_moment last = {0, 0};
  for (int c = 0; c < p_w; c++) {
    if (one[c] && columns[c].count >= 2) {
      add_adder(p, columns, c, ARITH_PLUS_ONE, available);
    } else if (one[c]) {
      put(p, &columns[c], add_bit(p, ARITH_ONE, 0, -1, (arith_moment){0, 0}));
    }
    if (c >= RIPPLE && columns[c].count > 2 && columns[c].count % 2 == 1) {
      add_adder(p, columns, c, ARITH_HALF, available);
    }
    while (columns[c].count > 2 && p->fault == NULL) {
      add_adder(p, columns, c, ARITH_FULL, available);
    }
    for (int i = 0; i < 2; i++) {
      p->final[i][c] = i < columns[c].count ? columns[c].bit[i] : -1;
      if (p->final[i][c] >= 0) {
        last = later(last, p->bit[p->final[i][c]].made);
      }
    }
  }
  double skew = last.stage > 0 ? m->skew_lost : 0;
  double rest = p->open ? form->behind : delay_adder(m, p_w) + skew;
  arith_moment end = settle(last, rest, available);
  p->latency = end.stage;
  p->settled = end.time;
  if (p->latency >= ARITH_STAGES) {
    p->fault = "more pipeline registers than ARITH_STAGES";
    return;
  }
  for (int c = 0; c < p_w; c++) {
    for (int i = 0; i < 2; i++) {
      if (p->final[i][c] >= 0) {
        use(p, p->final[i][c], p->latency);
      }
    }
  }
  for (arith_bit *b = p->bit; b < p->bit + p->bits; b++) {
    for (int s = b->made.stage + 1; s <= b->last && b->source != ARITH_ONE; s++) {
      b->place[s] = p->crossing[s]++;
      p->registers++;
    }
  }
}

/* With as many pipeline registers as the period needs, their places are those for the shortest
 * period that needs no more. */
void arith_plan_make(arith_plan *p, const arith_form *form, double period) {
  if (model_of(form)->family) {
    arith_product_make(p, form, period);
    p->terms = form->terms;
    p->latency += arith_two_sums(p);
    memcpy(p->addend, form->addend, sizeof p->addend);
    return;
  }
  double enough = period - delay_register(model_of(form));
  plan_in(p, form, enough);
  int latency = p->latency;
  double little = enough / 2;
  for (int i = 0; i < 4 && latency > 0; i++) {
    double available = (enough + little) / 2;
    plan_in(p, form, available);
    if (p->latency == latency) {
      enough = available;
    } else {
      little = available;
    }
  }
  if (p->latency != latency) {
    plan_in(p, form, enough);
  }
}

bool arith_same(const arith_plan *plan, const arith_plan *other) {
  return plan->a_w == other->a_w && plan->b_w == other->b_w && plan->p_w == other->p_w &&
         plan->terms == other->terms && plan->open == other->open && plan->rows == other->rows &&
         plan->plain == other->plain && plan->less == other->less &&
         plan->latency == other->latency;
}

double arith_shortest(const arith_form *form) {
  const delay_model *m = model_of(form);
  double row = delay_row(m, form->a_w) + m->sum;
  if (form->digits == 0) {
    row += delay_adder(m, form->b_w + 1);
  }
  double addition = delay_adder(m, form->p_w);
  return delay_register(m) + (row > addition ? row : addition);
}
