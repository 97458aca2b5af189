/* SPDX-License-Identifier: MIT */
/* frames.h - bounds of the distance of nodes and triangles in doubles (private).
 *
 * All coordinates are in the unit of a search, in which no coordinate of a body and no translation
 * is above 1. Let u = 2^-53.
 *
 * Errors. A placed vertex is wrong by less than 2^-48 (bounds.c). A placed centre is a sum of
 * R c + t, wrong by as much, and of R times the centre of the frame, wrong by 2^-50 more: less than
 * 2^-47. Two centres are less than 5.6 apart in each coordinate, so their offset along an axis is
 * wrong by 2^-46 for the centres and by 2^-48 for its own rounding. The reach of six half sides,
 * each below 1.8, is wrong by 42 u, less than 2^-47, and axes that are rounded by 2^-50 make
 * 6 * 1.8 * 2^-50 of it. FRAME_ERROR is more than all that. A gap of a triangle's vertices and a
 * frame is wrong by less.
 *
 * Poses and axes are not quite rotations. Let d be what an entry of R R^T may differ from the
 * identity; then R^T R differs from it by at most 3 d as a matrix. Cosines of two axes of one frame
 * are then within 3 d of 0, so a reach of its own half sides is wrong by 3 d times their sum. Three
 * gaps along its axes are at most 1 + 1.5 d times the distance that they stand for, as is a gap
 * along one. `skew` is d of the worse pose and 2^-47, for the axes in the body's tree. */
#ifndef SEPAX_DISTANCE_FRAMES_H
#define SEPAX_DISTANCE_FRAMES_H

#include "body/body.h"

#define FRAME_ERROR 0x1p-44

/* A frame of a node, or a triangle, in the coordinates of a search. */
typedef struct {
  double axis[3][3], centre[3], half[3];
} placed_frame;

typedef double placed_triangle[3][3];

/* Bounds that the distance is not below; 0 or less where nothing is proved. `way` has length 1,
 * within 2^-50, or 0. */
double sepax__frames_apart(const placed_frame *p, const placed_frame *q, const double way[3],
                           double skew);
double sepax__frame_apart(const placed_frame *p, const placed_triangle t, const double way[3],
                          double skew);

#endif
