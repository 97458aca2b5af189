/* SPDX-License-Identifier: MIT */
/* memory.h - emits the tree engine's access to external memory: caches, leaf buffers, AXI4 port. */
#ifndef SEPAX_TREE_MEMORY_H
#define SEPAX_TREE_MEMORY_H

#include "emit/emit.h"

/* Emit sepax_ram for a tree engine. */
void gen_tree_ram(emitter *e, bool fpga);

/* Emit sepax_tree_memory and its modules. sepax_ram must have been emitted. */
void gen_tree_memory(emitter *e, bool fpga);

#endif
