/* arith.c - multipliers planned: rows, full adders, pipeline registers. */
#include "arith.h"

#include <stdlib.h>
#include <string.h>

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
  p->bit[p->bits] = (arith_bit){source, from, index, stage, stage, time, {0}};
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

/* Rows and their corrections: each row's highest bit, inverted, stands for -2^n + it. */
static void plan_rows(arith_plan *p, column *columns, bool one[ARITH_WIDTH], double time) {
  int weight[ARITH_WIDTH] = {0};
  for (int row = 0; row < p->rows; row++) {
    int bits = arith_row_bits(p, row);
    for (int i = 0; i < bits; i++) {
      put(&columns[2 * row + i], add_bit(p, ARITH_ROW, row, i, 0, time));
    }
    if (arith_row_whole(p, row)) {
      weight[2 * row + bits - 1]++;
    }
    put(&columns[2 * row],
        add_bit(p, ARITH_NEGATIVE, row, row, 0, time - delay_used->early_correction));
  }
  int borrow = 0;
  for (int c = 0; c < p->p_w; c++) {
    int digit = -weight[c] - borrow;
    one[c] = (digit & 1) != 0;
    borrow = (one[c] - digit) / 2;
  }
}

/* The stage and time at which something with this delay is ready, given its inputs. */
static void settle(const arith_plan *p, const int *input, int inputs, double delay,
                   double available, int *stage, double *time) {
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
  if (*time > available) {
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
  settle(p, a->input, 2, delay_used->sum, available, &stage[0], &time[0]);
  settle(p, a->input, 2, delay_used->carry, available, &stage[1], &time[1]);
  double sum = time[0];
  double carry = time[1];
  a->stage = stage[0];
  if (inputs == 3) {
    settle(p, a->input + 2, 1, delay_used->late_sum, available, &stage[2], &time[2]);
    if (stage[2] > a->stage) {
      a->stage = stage[2];
      sum = carry = time[2] > delay_used->carry ? time[2] : delay_used->carry;
    } else if (stage[2] == a->stage && time[2] > sum) {
      sum = time[2];
    }
    if (stage[2] == a->stage && time[2] + delay_used->carry - delay_used->late_sum > carry) {
      carry = time[2] + delay_used->carry - delay_used->late_sum;
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
  place_adder(p, a);
  int number = p->adders++;
  put(&columns[at], add_bit(p, ARITH_SUM, number, a->order, a->stage, sum));
  if (!top) {
    put(&columns[at + 1], add_bit(p, ARITH_CARRY, number, a->order, a->stage, carry));
  }
}

/* Columns below this are early enough to ripple. */
enum { RIPPLE = 8 };

static void plan_in(arith_plan *p, const arith_form *form, double available) {
  *p = (arith_plan){.a_w = form->a_w, .b_w = form->b_w, .p_w = form->p_w};
  p->rows = form->digits > 0 ? form->digits : (form->b_w + 1) / 2;
  p->plain = form->digits == 0;
  p->less = form->less;
  p->sum_w = form->b_w + p->plain;
  double used = form->used + (p->plain ? delay_adder(p->sum_w) : 0);
  int p_w = p->p_w;
  column *columns = calloc(ARITH_WIDTH, sizeof *columns);
  if (columns == NULL) {
    abort();
  }
  bool one[ARITH_WIDTH] = {false};
  plan_rows(p, columns, one, used + delay_row(p->a_w));
  int stage = 0;
  double time = 0;
  for (int c = 0; c < p_w; c++) {
    if (one[c] && columns[c].count >= 2) {
      add_adder(p, columns, c, ARITH_PLUS_ONE, available);
    } else if (one[c]) {
      put(&columns[c], add_bit(p, ARITH_ONE, 0, -1, 0, 0));
    }
    if (c >= RIPPLE && columns[c].count > 2 && columns[c].count % 2 == 1) {
      add_adder(p, columns, c, ARITH_HALF, available);
    }
    while (columns[c].count > 2) {
      add_adder(p, columns, c, ARITH_FULL, available);
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
  double skew = stage > 0 ? delay_used->skew_lost : 0;
  p->latency = time + delay_adder(p_w) + skew > available ? stage + 1 : stage;
  if (p->latency >= ARITH_STAGES) {
    abort(); /* more pipeline registers than ARITH_STAGES */
  }
  for (int c = 0; c < p_w; c++) {
    for (int i = 0; i < 2; i++) {
      if (p->final[i][c] >= 0) {
        use(p, p->final[i][c], p->latency);
      }
    }
  }
  for (arith_bit *b = p->bit; b < p->bit + p->bits; b++) {
    for (int s = b->stage + 1; s <= b->last && b->source != ARITH_ONE; s++) {
      b->place[s] = p->crossing[s]++;
      p->registers++;
    }
  }
}

/* With as many pipeline registers as the period needs, their places are those for the shortest
 * period that needs no more. */
void arith_plan_make(arith_plan *p, const arith_form *form, double period) {
  double enough = period - delay_register();
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
         plan->rows == other->rows && plan->plain == other->plain && plan->less == other->less &&
         plan->latency == other->latency;
}

double arith_shortest(const arith_form *form) {
  double row = delay_row(form->a_w) + delay_used->sum;
  if (form->digits == 0) {
    row += delay_adder(form->b_w + 1);
  }
  double addition = delay_adder(form->p_w);
  return delay_register() + (row > addition ? row : addition);
}
