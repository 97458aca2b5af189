/* SPDX-License-Identifier: MIT */
/* sheets.h - which triangles belong together in every closed surface that they form.
 *
 * A closed surface is a sum of triangles, each times a whole number (0: left out, negative: turned
 * round), without a boundary: at nearly every point of each line the factors of the triangle edges
 * there cancel, each with the direction of its edge. Along a line the sum of these factors changes
 * only at vertices. So at each vertex, for each line through it, the edges on that line bring as
 * much to the vertex as they take away. That is a current in a net: its nodes are pairs of a vertex
 * and a line through it, its wires are edges. Whatever the factors are:
 *
 *   1. A wire that is alone at a node carries nothing, and may be taken out of the net.
 *   2. Two wires that are alone at a node carry the same current.
 *
 * If a wire carries nothing and exactly two triangles have it, in opposite directions, then both
 * have the same factor. If law 2 holds of two wires, and each of them belongs to one triangle, then
 * both triangles have the same factor if one edge ends at the node and one begins there. So it is
 * where a vertex is in the middle of another triangle's edge (a T-junction). A sheet is what hangs
 * together in these two ways: all of its triangles have the same factor.
 *
 * Corners are rounded. If two lines through a vertex may be the same, then they are one node. Such
 * a node is a law less, so whatever the net proves is true. Whether a part is closed is another
 * question: there lines are the same only if no corner is farther from one than it is rounded. */
#ifndef CERTIFICATE_SHEETS_H
#define CERTIFICATE_SHEETS_H

#include "surface.h"

#include <stdbool.h>
#include <stddef.h>

#define FLAT ((size_t)-2)

/* What hangs together by wires, and by nodes of wires that carry something: of each closed surface,
 * the triangles that are in a part are closed by themselves. */
typedef struct {
  size_t element;
  bool open;    /* at some place of a line there is an odd number of its triangles */
  bool twisted; /* its triangles, each with the factor 1, are not closed */
  vec at[7];    /* a vertex; then those that are farthest out: low x, high x, low y ... */
} part;

typedef struct {
  size_t *sheet_of; /* of each triangle: one that stands for its sheet; FLAT: on one line, but for
                       rounding; NONE: two of its corners are equal, so no ray meets it */
  size_t *part_of;  /* of each triangle */
  part *part;
  size_t parts;
} sheets;

/* Triangles of different elements are in different sheets and parts. Takes n log n. */
sheets sheets_of(const surface *s);

#endif
