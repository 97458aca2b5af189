/* SPDX-License-Identifier: MIT */
/* walk.h - emits the tree engine's walk, the pairs of its rows, and its runs. */
#ifndef SEPAX_TREE_WALK_H
#define SEPAX_TREE_WALK_H

#include "emit/emit.h"

/* Emit sepax_tree_walk, sepax_tree_pairs, sepax_tree_run and their modules. sepax_ram and
 * sepax_ram_fifo must have been emitted. `turn` is the latency of sepax_turn_vertex in cycles. */
void gen_tree_walk(emitter *e, bool fpga, int turn);

#endif
