/* schedule.h - where values stand between the unit that makes them and the units that read
 * them, when a unit serves II operations in turn.
 *
 * Time is counted in cycles from the one in which a pair stands in the first registers.
 * Every II cycles a new pair follows, so a unit's slot is its cycle modulo II. A stream
 * is the output register of one unit: the value of slot k stands there in cycle
 * first + k. A value read later is kept in a line of registers behind the output, or in
 * registers that hold it; schedule_store chooses what is smaller. With II = 1 all are
 * lines, and the datapath is a plain pipeline. */
#ifndef SEPAX_SCHEDULE_H
#define SEPAX_SCHEDULE_H

#include "emit/emit.h"
#include "sepax_design.h"

enum { SCHEDULE_STREAMS = 400 };

typedef struct {
  int stream, slot;
} schedule_value;

typedef struct {
  char name[EMIT_NAME]; /* of the output: t_a1b2, or t_3 where it is shared */
  char kind[8];         /* t, g, h ... */
  const char *width;    /* text for declarations; bits: its value */
  int bits;
  bool is_signed;
  int first;                           /* cycle in which slot 0 stands in the output */
  char label[SEPAX_II_MAX][EMIT_NAME]; /* what each slot brings: a1b2 */
  int last[SEPAX_II_MAX];              /* the last cycle in which it is read, -1: never */
  int line;                            /* registers behind the output */
} schedule_stream;

typedef struct {
  int ii;
  schedule_stream stream[SCHEDULE_STREAMS];
  int streams;
} schedule;

/* A new stream; slots get their labels as they are filled. */
int schedule_add(schedule *s, const char *kind, const char *width, int bits, bool is_signed,
                 const char *name);

/* The cycle in which a value stands in its unit's output. */
int schedule_born(const schedule *s, schedule_value v);

/* Value v is read in this cycle, not before it is born. */
void schedule_need(schedule *s, schedule_value v, int cycle);

/* All needs are known: choose the storage. */
void schedule_store(schedule *s);

/* The register in which v stands in this cycle. */
void schedule_source(const schedule *s, schedule_value v, int cycle, char text[EMIT_NAME]);

/* Registers behind the outputs: declarations, then their clocked assignments. at[k] is
 * high in cycle k modulo II. */
void schedule_declare(const schedule *s, emit_module *m);
void schedule_clock(const schedule *s, emit_module *m);

#endif
