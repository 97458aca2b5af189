/* SPDX-License-Identifier: MIT */
/* glitches.c - see glitches.h. */
#include "glitches.h"
#include "liberty/text.h"

#include <stdlib.h>

typedef struct {
  int time; /* ps after the edge */
  uint64_t value;
} change;

/* Of a net, in order of time. */
typedef struct {
  change *at;
  int count, capacity;
} wave;

struct glitches {
  cell_delays *delay;
  wave *wave; /* of each net */
  double share;
};

void glitches_begin(gates *g, cell_delays *delay, double share) {
  g->changes = text_alloc((size_t)g->nets, sizeof *g->changes);
  g->glitches = text_alloc(1, sizeof *g->glitches);
  g->count_all = glitches_count;
  g->glitches->delay = delay;
  g->glitches->share = share;
  g->glitches->wave = text_alloc((size_t)g->nets, sizeof *g->glitches->wave);
}

static void append(wave *w, int time, uint64_t value) {
  if (w->count == w->capacity) {
    w->capacity = 2 * w->capacity + 4;
    change *more = text_alloc((size_t)w->capacity, sizeof *more);
    for (int k = 0; k < w->count; k++) {
      more[k] = w->at[k];
    }
    free(w->at);
    w->at = more;
  }
  w->at[w->count++] = (change){time, value};
}

/* The value from `time` on; lanes that changed after time - shortest and change again were never
 * different. */
static void push(wave *w, uint64_t begin, int time, uint64_t value, int shortest) {
  for (int k = w->count - 1; k >= 0 && w->at[k].time > time - shortest; k--) {
    uint64_t was = k > 0 ? w->at[k - 1].value : begin;
    uint64_t again = (w->at[k].value ^ was) & (w->at[k].value ^ value);
    for (int later = k; later < w->count; later++) {
      w->at[later].value = (w->at[later].value & ~again) | (value & again);
    }
  }
  if (value != (w->count > 0 ? w->at[w->count - 1].value : begin)) {
    append(w, time, value);
  }
}

/* The wave of an output of a combinational cell. */
static void find_wave(gates *g, int c, int to) {
  const gates_cell *cell = &g->cell[c];
  const lib_cell *type = cell->type;
  const wave *in[LIB_PINS];
  uint64_t now[LIB_PINS];
  int next[LIB_PINS];
  int delay[LIB_PINS];
  for (int k = 0; k < type->pins; k++) {
    next[k] = -1;
    now[k] = 0;
    if (!type->pin[k].output && cell->net[k] >= 0) {
      in[k] = &g->glitches->wave[cell->net[k]];
      now[k] = g->before[cell->net[k]];
      next[k] = 0;
      delay[k] = g->glitches->delay[c][k * type->pins + to];
    }
  }
  wave *out = &g->glitches->wave[cell->net[to]];
  for (;;) {
    int time = -1;
    int shortest = 0;
    for (int k = 0; k < type->pins; k++) {
      if (next[k] < 0 || next[k] == in[k]->count) {
        continue;
      }
      int then = in[k]->at[next[k]].time + delay[k];
      if (time < 0 || then < time) {
        time = then;
        shortest = (int)(g->glitches->share * delay[k]);
      }
    }
    if (time < 0) {
      return;
    }
    for (int k = 0; k < type->pins; k++) {
      if (next[k] >= 0 && next[k] < in[k]->count && in[k]->at[next[k]].time + delay[k] == time) {
        now[k] = in[k]->at[next[k]++].value;
      }
    }
    push(out, g->before[cell->net[to]], time, gates_evaluate(type, type->pin[to].rows, now, 0),
         shortest);
  }
}

/* What an edge or an input changes by itself. */
static void step(gates *g, int net, int time) {
  if (g->value[net] != g->before[net]) {
    append(&g->glitches->wave[net], time, g->value[net]);
  }
}

void glitches_count(gates *g) {
  for (int k = 0; k < g->nets; k++) {
    g->glitches->wave[k].count = 0;
  }
  for (int k = 0; k < g->ports; k++) {
    for (int bit = 0; bit < g->port[k].bits && !g->port[k].output; bit++) {
      step(g, g->port[k].net[bit], 0);
    }
  }
  for (int c = 0; c < g->cells; c++) {
    const gates_cell *cell = &g->cell[c];
    const lib_cell *type = cell->type;
    for (int p = 0; p < type->pins; p++) {
      if (!type->pin[p].output || cell->net[p] < 0) {
        continue;
      }
      if (type->register_ || type->latch) {
        step(g, cell->net[p], g->glitches->delay[c][type->clock * type->pins + p]);
      } else if (cell->phase == 0) {
        find_wave(g, c, p);
      }
    }
  }
  for (int k = 0; k < g->nets; k++) {
    const wave *w = &g->glitches->wave[k];
    uint64_t last = g->before[k];
    for (int n = 0; n < w->count; n++) {
      gates_tally(g->changes[k], w->at[n].value ^ last);
      last = w->at[n].value;
    }
    if (w->count > 0 && w->at[w->count - 1].time > g->latest) {
      g->latest = w->at[w->count - 1].time;
    }
    if (w->count > 0 && last != g->value[k]) {
      text_fail("does not settle as without delays", "a net");
    }
  }
}
