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

void sepax__robot_others_free(sepax_robot_others *others);

#endif
