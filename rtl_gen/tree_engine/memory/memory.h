/* memory.h - the tree engine's way to external memory: caches, buffers of leaves, the AXI4 port. */
#ifndef SEPAX_TREE_MEMORY_H
#define SEPAX_TREE_MEMORY_H

#include "emit/emit.h"

/* sepax_ram of a tree engine. */
void gen_tree_ram(emitter *e, bool fpga);

/* sepax_tree_memory and what it is made of; sepax_ram must be there. */
void gen_tree_memory(emitter *e, bool fpga);

#endif
