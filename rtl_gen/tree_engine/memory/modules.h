/* modules.h - the tree engine's modules (docs/tree.md). */
#ifndef SEPAX_TREE_MODULES_H
#define SEPAX_TREE_MODULES_H

#include "datapath/delay.h"
#include "emit/emit.h"

/* sepax_ram of a tree engine. */
void gen_tree_ram(emitter *e, bool fpga);

/* sepax_tree_memory and what it is made of; sepax_ram must be there. */
void gen_tree_memory(emitter *e, bool fpga);

/* sepax_tree_walk, sepax_tree_pairs, sepax_tree_run and what they are made of; sepax_ram and
 * sepax_ram_fifo must be there. `turn` is the latency of sepax_turn_vertex. */
void gen_tree_walk(emitter *e, bool fpga, int turn);

/* sepax_turn_vertex for coordinates of `word` bits, 4 ... 21, and what it is made of; the parts of
 * multipliers must be there (arith/arith.h). Its latency. */
int gen_turn_vertex(emitter *e, const delay_model *m, int word);

/* sepax_tree_compare and what it is made of; sepax_fifo and the parts of multipliers must be there.
 */
void gen_tree_compare(emitter *e, const delay_model *m);

#endif
