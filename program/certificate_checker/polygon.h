/* SPDX-License-Identifier: MIT */
/* polygon.h - polygons as triangles.
 *
 * A polygon whose corners are in a plane is the same surface however it is divided. Of a bent one
 * each division is another surface. All of them are within its hull: the division that is found
 * here, moved along the coordinate axis onto which the polygon is projected by the height of its
 * corners over a plane, forwards and backwards, and walls between both. So what is outside the hull
 * and farther from it than a distance is on the same side of each division, and as far from it. */
#ifndef CERTIFICATE_POLYGON_H
#define CERTIFICATE_POLYGON_H

#include "mesh.h"

typedef struct {
  size_t (*triangle)[3]; /* corners; count - 2 of them */
  bool bent;
  point up; /* along which the hull goes, as far as it goes; points to the side from which the
               corners run anticlockwise */
} division;

/* `count` corners from `corner`. One that crosses itself is refused; or, with m->fans, it is a fan
 * of its first corner and counted in m->fanned. Such a polygon is divided in this way alone, so it
 * is not bent. The caller frees `triangle`. */
division polygon_divide(mesh *m, const point *corner, size_t count);

#endif
