/* SPDX-License-Identifier: MIT */
/* schedule.h - the modulo schedule: where values stand between the unit that makes them and the
 * units that read them, when a unit serves II operations in turn.
 *
 * Time is counted in cycles from the one in which a pair stands in the first registers.
 * Every II cycles a new pair follows, so a unit's slot is its cycle modulo II. A producer
 * is the output register of one unit: the value of slot k is defined there in cycle
 * first + k. A value with a later last use stays in a delay line (a shift register behind the
 * output: _q, _q2 ...) or in holding registers (loaded once an II window: _hold, _hold2 ...);
 * schedule_store takes what is smaller. With II = 1 all are delay lines, and the datapath is a
 * plain pipeline. */
#ifndef SEPAX_SCHEDULE_H
#define SEPAX_SCHEDULE_H

#include "advance.h"
#include "delay.h"
#include "emit/emit.h"
#include "graph.h"

enum { SCHEDULE_PRODUCERS = 400 };

typedef struct {
  int producer, slot;
} schedule_value;

typedef struct {
  char name[2 * GRAPH_LABEL]; /* of the output: t_a1b2, or t_3 where it is shared */
  char symbol[GRAPH_SYMBOL];  /* t, g, h ... */
  const char *width;          /* text for declarations */
  bool is_signed;
  int first;                             /* cycle in which slot 0 stands in the output */
  char label[SEPAX_II_MAX][GRAPH_LABEL]; /* what each slot brings: a1b2 */
  int age[SEPAX_II_MAX];                 /* at the last use: cycles behind the definition */
  int line;                              /* registers of the delay line */
} schedule_producer;

typedef struct {
  const char *fault; /* NULL, or why there is no schedule */
  int ii;
  schedule_producer producer[SCHEDULE_PRODUCERS];
  int producers;
} schedule;

/* A new producer; returns its number. */
int schedule_add(schedule *s, const schedule_producer *producer);

/* The definition cycle of a value: it stands in its unit's output. */
int schedule_defined(const schedule *s, schedule_value v);

/* Value v is read in this cycle, not before it is defined. */
void schedule_need(schedule *s, schedule_value v, int cycle);

/* All needs are known: choose the storage. */
void schedule_store(schedule *s, const delay_model *m);

/* Holding registers of all slots of a producer. schedule_store has been called. */
int schedule_holds(const schedule *s, const schedule_producer *producer);

/* The register in which v stands in this cycle. */
gen_line schedule_source(const schedule *s, schedule_value v, int cycle);

/* Registers behind the outputs: declarations, then their clocked assignments, with their enables.
 * slot[k] is high in cycle k modulo II. */
void schedule_declare(const schedule *s, emit_text *out);
void schedule_clock(const schedule *s, advance *a, emit_text *out);

#endif
