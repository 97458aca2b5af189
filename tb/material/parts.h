/* SPDX-License-Identifier: MIT */
/* parts.h - the parts of a soup by the definition in sepax.h, and whether a point is in a cavity.
 */
#ifndef MATERIAL_PARTS_H
#define MATERIAL_PARTS_H

#include "surfaces.h"

/* part[i] is the number of the part of triangle i. Return how many parts there are. Triangles
 * without area count. */
size_t find_parts(const soup *s, size_t *part);

/* True if the parts that enclose the point do not touch each other, directions cancel in each of
 * them, and they are wound outwards, inwards, ... from the outermost one on, an even number of
 * them; and if no closed surface encloses the point by the other parts. */
bool is_cavity(const surfaces *f, point p, generator *g);

#endif
