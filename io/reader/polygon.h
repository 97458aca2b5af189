/* SPDX-License-Identifier: MIT */
/* polygon.h - a polygon as triangles (private).
 *
 * The rule. A polygon is seen along one of the axes x, y, z: along which its area vector, the sum
 * of the cross products of its edges as seen from the first corner, is longest as computed in
 * doubles; of equal ones along the first. In this view all signs are exact.
 *   1. If every triangle (first corner, corner k, corner k + 1) has an area, all turn the same way,
 *      and they do not go round the first corner more than once, these are the triangles. So a
 *      convex polygon becomes a fan of its first corner.
 *   2. Else ears are cut off. Corners are looked at in their order from the first corner on. A
 *      corner is cut off where it is the tip of a spike or a repetition; where the triangle of it
 *      and its two neighbours has an area inside the polygon and no edge of the polygon runs
 *      through it; and, if no corner is either, where it lies straight between its neighbours. The
 *      search goes on behind the next corner.
 * Where the view shows edges that cross, and the corners are in no common plane, the other two axes
 * are tried, in the order of the lengths along them. Of four corners that cross in all three views
 * the triangles are a fan, whose two triangles do not cross in space. A polygon may touch itself,
 * in corners or along edges, as one with a bridge to a hole does. If all corners are on one line,
 * the triangles are a fan without area, which holds each edge.
 *
 * So every corner is one of a triangle, and every edge of the polygon is one of exactly one
 * triangle; each other edge of a triangle belongs to two of them. */
#ifndef SEPAX_POLYGON_H
#define SEPAX_POLYGON_H

#include <stdbool.h>
#include <stddef.h>

typedef enum {
  POLYGON_DIVIDED,
  POLYGON_CROSSES, /* it crosses itself in every view */
  POLYGON_LONG,    /* more than POLYGON_CORNERS_MOST corners, and the first does not see them all */
  POLYGON_MEMORY
} polygon_result;

/* Ears are searched in a time that grows as the square of the number of corners: a second. */
enum { POLYGON_CORNERS_MOST = 20000 };

/* A polygon of `count` (3 or more) corners, finite and within 2^1000, as count - 2 triangles, three
 * numbers of corners each, that run the same way as the polygon. *bent tells, exactly, whether its
 * corners are in no common plane. */
polygon_result sepax__polygon_divide(const double (*corner)[3], size_t count, size_t (*triangle)[3],
                                     bool *bent);

/* Of the same polygon, the fan of corner `first`: the triangles (first, k, k + 1). A corner beyond
 * the last is the first one. */
void sepax__polygon_fan(size_t count, size_t first, size_t (*triangle)[3]);

#endif
