/* SPDX-License-Identifier: MIT */
/* parts.h - the parts of a soup by the definition in sepax.h, and whether a point is in a cavity.
 */
#ifndef MATERIAL_PARTS_H
#define MATERIAL_PARTS_H

#include "surfaces.h"

typedef struct {
  size_t part[MOST]; /* of a triangle: the number of its part */
  size_t count;
  bool open[MOST]; /* of a part: an odd number of its triangles runs along some segment */
  point low, high; /* the box of all open parts; low is above high if there is none */
} division;

void find_parts(division *d, const soup *s);

/* True if the parts that enclose the point do not touch each other, directions cancel in each of
 * them, and they are wound outwards, inwards, ... from the outermost one on, an even number of
 * them; and if no closed surface encloses the point by the other parts. */
bool is_cavity(const surfaces *f, const division *d, point p, generator *g);

#endif
