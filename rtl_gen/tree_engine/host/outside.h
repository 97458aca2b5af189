/* outside.h - what is around the tree engine: registers, jobs, results (docs/tree.md). */
#ifndef SEPAX_OUTSIDE_H
#define SEPAX_OUTSIDE_H

#include "emit/emit.h"

/* Every module of a design with a tree engine behind those of the core, of which each holds
 * `entries` pairs. */
void gen_tree(emitter *e, int entries);

#endif
