/* boxes.h - the tree engine's test of entries: set-up, turned boxes, lanes, hits; and the turner of
 * vertices. */
#ifndef SEPAX_TREE_BOXES_H
#define SEPAX_TREE_BOXES_H

#include "datapath/delay.h"
#include "emit/emit.h"

/* sepax_turn_vertex for coordinates of `word` bits, 4 ... 21, and what it is made of; the parts of
 * multipliers must be there (arith/arith.h). Returns its latency in cycles. */
int gen_turn_vertex(emitter *e, const delay_model *m, int word);

/* sepax_tree_compare and what it is made of; sepax_fifo and the parts of multipliers must be there.
 */
void gen_tree_compare(emitter *e, const delay_model *m);

#endif
