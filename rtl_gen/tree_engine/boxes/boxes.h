/* SPDX-License-Identifier: MIT */
/* boxes.h - emits the tree engine's test of entries (set-up, turned boxes, lanes, hits) and the
 * module that turns vertices. */
#ifndef SEPAX_TREE_BOXES_H
#define SEPAX_TREE_BOXES_H

#include "datapath/delay.h"
#include "emit/emit.h"

/* Emit sepax_turn_vertex, for coordinates of `word` bits, 4 ... 21, and its modules. The parts of
 * multipliers must have been emitted (arith/arith.h). Returns its latency in cycles. */
int gen_turn_vertex(emitter *e, const delay_model *m, int word);

/* Emit sepax_tree_compare and its modules. sepax_fifo and the parts of multipliers must have been
 * emitted. */
void gen_tree_compare(emitter *e, const delay_model *m);

#endif
