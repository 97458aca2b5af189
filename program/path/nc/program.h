/* SPDX-License-Identifier: MIT */
/* program.h - NC programs: the path of an NC program, by the interpreter of its control. */
#ifndef SEPAX_PATH_PROGRAM_H
#define SEPAX_PATH_PROGRAM_H

#include "path/common/parts.h"

/* Run the interpreter, and make the path of scene->robot from what the program does. */
bool path_program_read(path_scene *scene, const path_question *q, sepax_error *error);

/* Refuse a URDF that does not move as the kinematics of the control say, as far as a tool's link is
 * known. Fills in scene->agreement. */
bool path_program_agrees(path_scene *scene, const path_question *q, sepax_error *error);

/* Replace each rapid in which the axes take their own time by motions that cover all ways between
 * its ends. All pairs are there. */
bool path_program_doglegs(path_scene *scene, const path_question *q, sepax_error *error);

/* Fill in how far bodies deviate from linear motion of the joints. All pairs are there. `blended`:
 * also by blending without a bound. */
bool path_program_deviations(path_scene *scene, bool blended, sepax_error *error);

/* Write the path as a motion file, and note its number of columns. */
bool path_program_write(path_scene *scene, const char *path, sepax_error *error);

extern const char path_linuxcnc[]; /* the text of program/nc/linuxcnc, embedded by scripts/embed */

#endif
