/* emission.h - the units of a datapath as Verilog: their outputs, what selects their operands,
 * their instances. */
#ifndef SEPAX_EMISSION_H
#define SEPAX_EMISSION_H

#include "times.h"

enum { EMISSION_COPIES = 16 * SEPAX_II_MAX };

typedef struct {
  emit_module *m;
  const datapath *d;
  char copy[EMISSION_COPIES][EMIT_NAME]; /* slot register copies that are there */
  int copies;
} emission;

/* All registers, and a wire for each unit's output. */
void emission_declare(emission *e);

/* The units of a kind, with what selects their operands. */
void emission_units(emission *e, int kind);

/* Wire `name`: values as they stand in this cycle, the first in the lowest bits; `value` ends with
 * 0. */
void emission_bus(emission *e, const char *name, const graph_value value[], int cycle);

#endif
