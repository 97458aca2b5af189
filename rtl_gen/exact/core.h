/* exact_core.h - sepax_core while it is written: its banks of coordinates, and the operands
 * of its units. */
#ifndef SEPAX_EXACT_CORE_H
#define SEPAX_EXACT_CORE_H

#include "exact.h"
#include "sepax_design.h"

/* With a clearance so many units choose that each kind has a copy of its own: less fan-out. */
enum {
  TURN_NONE,
  TURN_STRIPS,
  TURN_AREAS = TURN_STRIPS + 2,
  TURN_LIMITS = TURN_AREAS + 2,
  TURN_EDGES,
  TURN_BOXES,
  TURN_FAR,
  TURNS
};

typedef struct {
  emit_module *m;
  const exact_plan *p;
  int ii;
  int turn; /* choices are made by copy `turn` of the frame's cycle, one cycle later; 0: by `at`
               itself */
  unsigned turned[TURNS]; /* bits of each copy that are there */
} core;

typedef char source[EMIT_NAME]; /* the register in which an operand stands */

/* One unit of a class. */
typedef struct {
  exact_class_id id;
  int start;
  int slots, operation[SEPAX_II_MAX]; /* what it does in each slot */
  const schedule_stream *out;
  char suffix[EMIT_NAME]; /* of the names of its wires and instances */
} unit;

unit core_unit_of(const core *c, exact_class_id id, int number);

/* A comment: the operations of a unit that has several. */
void core_describe(core *c, const unit *u);

/* "a1" ... "b3". */
const char *core_vertex_name(int v);

/* The banks: declarations, then their clocked assignments. */
void core_declare_banks(core *c);
void core_clock_banks(core *c);

/* Where vertex v stands in a bank in this cycle; the banks turn where 3 divides II. */
void core_coordinate(const core *c, char axis, int v, int bank, int cycle, source text);

/* What a unit that starts in cycle `start` reads: a register, or a wire `name` that
 * chooses one in each cycle. text[k] is where it stands for slot k. */
void core_choose(core *c, const char *name, const char *width, bool is_signed, int start, int slots,
                 source text[], source out);

/* Operand `index` of a unit as its slots read it from other units. */
void core_operand(core *c, const unit *u, int index, const char *width, source out);

/* With a clearance: outputs of its units, the units, the verdict. */
void core_declare_clear(core *c);
void core_clear(core *c);
void core_decide_band(core *c);

/* Operand of coordinates: vertex[k] in slot k. */
void core_point(core *c, const unit *u, const char *name, char axis, const int vertex[],
                source out);

#endif
