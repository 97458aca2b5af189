/* SPDX-License-Identifier: MIT */
/* binding.h - which unit computes an operation, and in which slot of the II window.
 *
 * Operations of a kind fill their units in order: operation n goes to unit n / II, slot n % II. An
 * operation that is beside another takes that one's slot in the unit of the same number.
 *
 * Why this order needs few multiplexers where 3 divides II. Rotation of both triangles by one
 * vertex (A_i to A_i+1, B_j to B_j+1) maps each operation on another of its kind; three in a row
 * are a cyclic symmetry class. The graph lists them together, so 3 | II keeps a class in one unit,
 * in slots k, k + 1, k + 2.
 *   - Coordinates. The registers of each triangle rotate by one place a cycle. Member m reads in
 *     cycle start + k + m what member 0 reads in cycle start + k, rotated m times: that is the same
 *     register. No multiplexer.
 *   - Results. The operand of member m is the rotation by m of the operand of member 0, and comes
 *     from the same unit, m slots later, read m cycles later. Its age is the same, and so is its
 *     place in the delay line, but where the slots of the operand's class wrap around (member 2 is
 *     followed by member 0): such an operand is read 3 cycles later or earlier than its neighbours,
 *     from a second place. So a class has at most one multiplexer of two inputs an operand. */
#ifndef SEPAX_BINDING_H
#define SEPAX_BINDING_H

#include "graph.h"

/* Bind all operations of the graph for this II. */
void binding_make(graph *g, int ii);

#endif
