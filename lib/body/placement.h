/* SPDX-License-Identifier: MIT */
/* placement.h - two bodies in their poses (private). */
#ifndef SEPAX_PLACEMENT_H
#define SEPAX_PLACEMENT_H

#include "body.h"

/* A motion from the coordinates of one tree to those of the other. Axis k becomes scaled[k] in
 * units of the other body, and turn[k] has the same direction and length 1. Lengths grow by the
 * factor `ratio`. `lost` bounds the rounding of the doubles. The last of four floats is 0. */
typedef struct {
  double scaled[3][4], shift[4];
  float turn[3][4], ratio, lost;
} motion;

typedef struct {
  const sepax_pose *pose[2]; /* NULL: the body stands as in its file */
  motion to[2];        /* to[0] moves B's boxes to A's coordinates, to[1] moves A's boxes to B's */
  double linear[3][3]; /* moves B's triangles to the coordinates of A's file */
  double offset[3];
  double error; /* bound on the error of such a coordinate; 0 if no pose is given */
  bool whole;   /* the pose turns axes into axes: `linear` has only 0, 1 and -1, and is exact */
} placement;

/* True if both poses are valid; NULL is valid. */
bool sepax__poses_valid(const sepax_pose *pose_a, const sepax_pose *pose_b, sepax_error *error);

/* A bound on all coordinates of the body. */
double sepax__largest_coordinate(const sepax_body *b);

/* Fill in everything except for `to`, for coordinates of B of up to `most`. */
void sepax__place_poses(placement *p, const sepax_pose *pose_a, const sepax_pose *pose_b,
                        double most);

void sepax__place_bodies(placement *p, const sepax_body *a, const sepax_pose *pose_a,
                         const sepax_body *b, const sepax_pose *pose_b);

/* True only if balls around the bodies have no common point. A valid pose stretches lengths by at
 * most 2^-16 of themselves. */
bool sepax__balls_disjoint(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b);

/* The vertices of a triangle of B in the coordinates of A's file, each wrong by at most `error`. */
void sepax__place_triangle_b(const placement *p, const double b[3][3], double placed[3][3]);

#endif
