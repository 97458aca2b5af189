/* walk.h - the tree engine's walk, the pairs of its rows, its runs. */
#ifndef SEPAX_TREE_WALK_H
#define SEPAX_TREE_WALK_H

#include "emit/emit.h"

/* sepax_tree_walk_options, sepax_tree_pairs, sepax_tree_run and what they are made of; sepax_ram
 * and sepax_ram_fifo must be there. `turn` is the latency of sepax_turn_vertex. */
void gen_tree_walk(emitter *e, bool fpga, int turn);

#endif
