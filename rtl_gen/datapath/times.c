/* SPDX-License-Identifier: MIT */
/* times.c - starts of units, and lifetimes of values. */
#include "times.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const graph_node *node_of(const datapath *d, graph_value v) {
  return &d->graph.node[abs(v)];
}

static schedule_value value_of(const datapath *d, graph_value v) {
  const graph_node *n = node_of(d, v);
  return (schedule_value){d->graph.kind[n->kind].producer[n->unit], n->slot};
}

int times_defined(const datapath *d, graph_value v) {
  return schedule_defined(&d->schedule, value_of(d, v));
}

/* The first cycle in which a unit can start: coordinates and constants are there in cycle 0. */
static int earliest_of(const datapath *d, const graph_kind *k, int unit) {
  int start = 0;
  for (int slot = 0; slot < d->schedule.ii; slot++) {
    const graph_node *n = &d->graph.node[k->at[unit][slot]];
    for (int i = 0; i < n->operands; i++) {
      if (node_of(d, n->operand[i])->kind >= 0) {
        int after = times_defined(d, n->operand[i]) - slot;
        start = after > start ? after : start;
      }
    }
  }
  return start;
}

int times_earliest(const datapath *d, int kind) {
  const graph_kind *k = &d->graph.kind[kind];
  int start = 0;
  for (int unit = 0; unit < k->units; unit++) {
    int after = earliest_of(d, k, unit);
    start = after > start ? after : start;
  }
  return start;
}

void times_start(datapath *d, int kind, int cycle) {
  graph_kind *k = &d->graph.kind[kind];
  for (int unit = 0; unit < k->units && !k->started; unit++) {
    if (k->count[unit] > 0) {
      k->start[unit] = cycle < 0 ? earliest_of(d, k, unit) : cycle;
      schedule_producer made = {.width = k->row.width,
                                .is_signed = k->row.is_signed,
                                .first = k->start[unit] + k->latency};
      memcpy(made.symbol, k->symbol, sizeof made.symbol);
      for (int slot = 0; slot < d->schedule.ii; slot++) {
        const char *label = d->graph.node[k->at[unit][slot]].label;
        memcpy(made.label[slot], label, sizeof made.label[slot]);
        if (k->at[unit][slot] != 0) {
          snprintf(made.name, sizeof made.name, "%s_%s", k->symbol, label);
        }
      }
      if (k->count[unit] > 1) {
        snprintf(made.name, sizeof made.name, "%s_%d", k->symbol, unit);
      }
      k->producer[unit] = schedule_add(&d->schedule, &made);
    }
  }
  k->started = true;
}

void times_need(datapath *d, graph_value v, int cycle) {
  const graph_node *n = node_of(d, v);
  if (n->kind >= 0) {
    schedule_need(&d->schedule, value_of(d, v), cycle);
  } else if (n->kind == GRAPH_COORDINATE) {
    coordinates_need(&d->coordinates, n->axis, n->vertex, cycle);
  }
}

void times_need_operands(datapath *d) {
  for (int i = 0; i < d->graph.kinds; i++) {
    const graph_kind *k = &d->graph.kind[i];
    for (int unit = 0; unit < k->units; unit++) {
      for (int slot = 0; slot < d->schedule.ii; slot++) {
        const graph_node *n = &d->graph.node[k->at[unit][slot]];
        for (int j = 0; j < n->operands; j++) {
          times_need(d, n->operand[j], k->start[unit] + slot);
        }
      }
    }
  }
}

gen_line times_source(const datapath *d, graph_value v, int cycle) {
  const graph_node *n = node_of(d, v);
  return n->kind == GRAPH_CONSTANT ? gen_format("%s", n->text)
         : n->kind == GRAPH_COORDINATE
             ? coordinates_source(&d->coordinates, n->axis, n->vertex, cycle)
             : schedule_source(&d->schedule, value_of(d, v), cycle);
}
