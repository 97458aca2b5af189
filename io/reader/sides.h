/* SPDX-License-Identifier: MIT */
/* sides.h - finds polygons that a file has twice, such as both sides of a face (private).
 *
 * A polygon with four or more corners can be divided into triangles in several ways. If the two
 * sides of a face were divided in different ways, and a vertex was in the middle of an edge, then
 * nothing could tell that the two enclose a solid. So a polygon with the same corners as an earlier
 * one is divided in the order of the corners of the earlier one. */
#ifndef SEPAX_SIDES_H
#define SEPAX_SIDES_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* Hashes of a polygon: of all its corners, whatever their order; of its first two corners. */
typedef struct {
  uint64_t all; /* 0: the slot is free */
  uint32_t corner[2];
} polygon_side;

/* A hash table; all zero at the beginning. The caller releases `slot`. */
typedef struct {
  polygon_side *slot;
  size_t slots, used;
} polygon_sides;

/* At which corner, and in which direction (`back`: the other one), the earlier polygon began.
 * Without an earlier one, *first is 0 and *back is false, and the polygon is kept. Polygons of
 * equal hashes may be taken for each other; any corner and direction is right. False without
 * memory. */
bool sepax__sides_find(polygon_sides *sides, const double (*corner)[3], size_t count, size_t *first,
                       bool *back);

#endif
