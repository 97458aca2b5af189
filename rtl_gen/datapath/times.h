/* SPDX-License-Identifier: MIT */
/* times.h - when the units of each kind start, and what that asks of the storage. */
#ifndef SEPAX_TIMES_H
#define SEPAX_TIMES_H

#include "advance.h"
#include "coordinates.h"
#include "graph.h"
#include "schedule.h"

typedef struct {
  graph graph;
  bool chains; /* sums on carry chains: what is selected is not the first operand: the logic in
                  front of a chain can select the others */
  schedule schedule;
  coordinates coordinates;
  advance advance;
} datapath;

/* The definition cycle of an operation's value; its kind has started. */
int times_defined(const datapath *d, graph_value v);

/* The first cycle in which all units of a kind can start together. */
int times_earliest(const datapath *d, int kind);

/* All units of a kind start in this cycle, or, -1, each as soon as it can; unless they have started
 * already. */
void times_start(datapath *d, int kind, int cycle);

/* A value is read in this cycle. */
void times_need(datapath *d, graph_value v, int cycle);

/* All kinds have started: all operands are read when their units read them. */
void times_need_operands(datapath *d);

/* Where a value stands in this cycle. */
gen_line times_source(const datapath *d, graph_value v, int cycle);

#endif
