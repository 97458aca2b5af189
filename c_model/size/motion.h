/* SPDX-License-Identifier: MIT */
/* motion.h - random poses of the bodies of a scene within their motion (private). */
#ifndef SEPAX_MOTION_H
#define SEPAX_MOTION_H

#include "sepax_design.h"
#include "sepax_vectors.h"

/* A pose of both bodies as numbers of 0 ... 1: for each body three for its shift and three for its
 * rotation. */
typedef struct {
  double u[2][6];
} motion_pose;

bool sepax__motion_moves(const sepax_motion *m);

/* True if the rotation does not change this coordinate. */
bool sepax__motion_keeps(sepax_rotation rotation, int axis);

/* The pose of the files, or the nearest pose within the ranges. */
motion_pose sepax__motion_pose_of_files(const sepax_motion motion[2]);

/* A random pose, or one near another pose, within a share of the ranges. */
motion_pose sepax__motion_draw(const motion_pose *centre, double share, sepax_random *random);

/* Move a body to a pose. */
void sepax__motion_apply(sepax_soup *moved, const sepax_soup *mesh, const sepax_motion *motion,
                         const double u[6]);

#endif
