/* SPDX-License-Identifier: MIT */
/* bounds.h - bounds of the distance of boxes and of triangles of two posed bodies (private). */
#ifndef SEPAX_DISTANCE_BOUNDS_H
#define SEPAX_DISTANCE_BOUNDS_H

#include "search.h"
#include "util/vector.h"

/* The distance of a pair of triangles is within least ... most. */
typedef struct {
  double least, most, way[3];
} pair_enclosure;

/* Directions on which many pairs of triangles have a gap: that of the nearest pair and that of the
 * last one. Pairs whose gap on one of them is above `enough` need no more. */
typedef struct {
  double way[2][3];
  double enough;
} short_cut;

enum { ENCLOSED_MOST = 4 }; /* pairs of triangles that are enclosed at once; 2 without AVX2 */

/* Make a vector's length 1, or 0 if it is too short or long. */
static inline void set_unit(double to[3], const double v[3]) {
  double length = vector_length(v);
  double scale = length > 0x1p-400 && length < 0x1p400 ? 1 / length : 0;
  for (int i = 0; i < 3; i++) {
    to[i] = v[i] * scale;
  }
}

/* Take the way between the bodies, in the coordinates of the search, as an axis for boxes. */
void sepax__set_way(search *s, const double way[3]);

/* Find the squares of the limit in the units of the boxes. */
void sepax__find_most(search *s);

/* Bound the distances of the children of a node of the body `open` from the box `other`. Bit k:
 * child k may be within the limit; square[k]: the square of its distance at least. */
uint32_t sepax__bound_children(const search *s, int open, uint32_t node, uint32_t other,
                               float square[BODY_WIDE]);

/* A bound of the distance of two children in doubles, in the unit of the search; at least one of
 * them is a node. */
double sepax__exact_bound(const search *s, const uint32_t child[2]);

/* Enclose the distances of `used` waiting pairs of triangles, from number `first` on. */
void sepax__enclose_waiting(const search *s, int first, int used, const short_cut *cut,
                            pair_enclosure e[ENCLOSED_MOST]);

#endif
