/* motion.h - where the bodies of a scene may be, and poses drawn from there (private). */
#ifndef SEPAX_MOTION_H
#define SEPAX_MOTION_H

#include "sepax_design.h"
#include "sepax_vectors.h"

/* Numbers of 0 ... 1 of each body: three for its shift, three for its rotation. */
typedef struct {
  double u[2][6];
} motion_pose;

bool sepax__motion_moves(const sepax_motion *m);

/* True iff the rotation does not change this coordinate. */
bool sepax__motion_keeps(sepax_rotation rotation, int axis);

/* The pose of the files, or the nearest to it in the ranges. */
motion_pose sepax__motion_pose_of_files(const sepax_motion motion[2]);

/* Any pose, or one within a share of the ranges around another pose. */
motion_pose sepax__motion_draw(const motion_pose *centre, double share, sepax_random *random);

/* The numbers u of a pose move a body. */
void sepax__motion_apply(sepax_soup *moved, const sepax_soup *mesh, const sepax_motion *motion,
                         const double u[6]);

#endif
