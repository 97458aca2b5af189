/* SPDX-License-Identifier: MIT */
/* clearance.h - what a clearance adds to architecture exact (docs/reference/clearance.md). */
#ifndef SEPAX_CLEARANCE_H
#define SEPAX_CLEARANCE_H

#include "exact.h"

/* Nodes of the graph: two more projections, cross products, limits, comparisons; the verdict's
 * buses. */
void clearance_graph(exact_plan *p);

/* Signed digits -1, 1 of a factor: rows that a number is made of when it is multiplied by it. */
int clearance_digits(int64_t factor);

/* Its modules. */
void gen_clearance_units(emitter *e, const exact_plan *p, emit_holes *h);

#endif
