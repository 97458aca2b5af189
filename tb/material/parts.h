/* SPDX-License-Identifier: MIT */
/* parts.h - the parts of a soup by the definition in sepax.h, and which of them enclose a
 * point.
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

/* piece[i] is the number of the piece of triangle i: parts that touch each other are one. Triangles
 * without area touch nothing. Return how many pieces there are. Cost: each pair of triangles. */
size_t find_pieces(const soup *s, const division *d, size_t *piece);

/* The parts of which closed surfaces enclose a point. */
typedef struct {
  size_t count;
  bool consistent; /* in each of them, directions cancel on every segment */
  int sum;         /* how often a ray leaves less how often it enters, over all of them */
  size_t below;    /* so many of them have a sum below 0 */
  bool alone;      /* no closed surface encloses the point by triangles of other parts */
  bool in_turn;    /* they are in different pieces, and are wound outwards, inwards, ... from the
                      outermost one on, an even number of them */
} walls;

/* Find them by the crossings of a ray from the point with all triangles. */
void find_walls(walls *w, const surfaces *f, const division *d, const int8_t *crossing);

#endif
