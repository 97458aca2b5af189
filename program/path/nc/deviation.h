/* SPDX-License-Identifier: MIT */
/* deviation.h - how much nearer two bodies come if joints are off their linear motion. */
#ifndef SEPAX_PATH_DEVIATION_H
#define SEPAX_PATH_DEVIATION_H

#include "path/common/parts.h"

/* Is the pair decided in the motion from a line to the next, by its bodies or by the stock as it is
 * cut? */
bool path_motion_decided(const path_scene *scene, const path_pair *pair, size_t line);

/* For both bodies of each pair and each joint: how far a point of the body, seen from the other
 * body, moves if the joint is off by 1. lever[(2 * pair + side) * joints + joint], in metres for
 * each radian or metre. NULL without memory; the caller frees it. */
double *path_levers(const path_scene *scene, sepax_error *error);

/* How far each joint of the URDF may be off in the motion that ends in a line, in rad or m, by the
 * numbers of the NC program. `blended`: also by blending without a bound. */
void path_joints_off(const path_scene *scene, bool blended, size_t line, double *off);

/* The same of joints that follow others. */
void path_followers_off(const sepax_mechanism *m, double *off);

/* How much nearer the bodies of a pair come, in metres, if each joint is off by off[joint]. */
double path_nearer(const path_scene *scene, const double *levers, size_t pair, const double *off);

#endif
