/* SPDX-License-Identifier: MIT */
/* glitches.h - what nets do between two edges of the clock, where cells have delays.
 *
 * From the values before the edge to those after it each net has a list of changes, in 64 lanes.
 * Registers change by their delay after the edge, the top's inputs at the edge; so do latches,
 * which clock gates alone read. A combinational cell sees each input later by the delay from there
 * to the output; a pulse that is shorter than the delay of what ends it does not come out (as in
 * Verilog with SDF). */
#ifndef SEPAX_GLITCHES_H
#define SEPAX_GLITCHES_H

#include "gates.h"

/* Of each cell, by [input * pins + output], in ps; as many as its pins, squared. */
typedef uint16_t *cell_delays;

/* Counts from here on what gates_rise counts, too. A pulse passes from this share of a delay on (1,
 * as above). The delays belong to the counter. */
void glitches_begin(gates *g, cell_delays *delay, double share);

/* In g->changes: all changes of a cycle, of which g->before is the begin and g->value the end.
 * Exits where a net does not end as it has settled. */
void glitches_count(gates *g);

#endif
