/* SPDX-License-Identifier: MIT */
/* robot.h - what the parts of the reader of robots share (private). */
#ifndef SEPAX_ROBOT_PRIVATE_H
#define SEPAX_ROBOT_PRIVATE_H

#include "sepax_robot.h"

/* Pose the mesh. Equal vertices stay equal. */
void sepax__place_mesh(sepax_soup *mesh, const sepax_pose *pose);

/* Of triangles with the same corners keep the first, in order. The surface has the same points but
 * is no longer the same solid. Otherwise a search would compare each copy with each triangle of
 * another body. False without memory; then all stay. */
bool sepax__distinct(sepax_soup *mesh);

/* sepax_robot_pairs_choose as if the link `also` had geometry, too; SIZE_MAX: none. */
bool sepax__robot_pairs(sepax_robot_pairs *pairs, const sepax_robot *robot, const char *srdf,
                        size_t also, sepax_error *error);

#endif
