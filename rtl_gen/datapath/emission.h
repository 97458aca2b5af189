/* SPDX-License-Identifier: MIT */
/* emission.h - a datapath as Verilog: its registers, what selects the operands of its units, their
 * instances. */
#ifndef SEPAX_EMISSION_H
#define SEPAX_EMISSION_H

#include "emit/template.h"
#include "times.h"

/* Holes of the module that the datapath is: `coordinates` and `outputs` (declarations of registers
 * and wires), `coordinate_moves` and `output_moves` (clocked assignments), `units` (instances). */
void emission_holes(datapath *d, emit_holes *h);

/* Wire `name`: values as they stand in this cycle, the first in the lowest bits; `value` ends with
 * 0. */
void emission_bus(const datapath *d, emit_text *out, const char *name, const graph_value value[],
                  int cycle);

#endif
