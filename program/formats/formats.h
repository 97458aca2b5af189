/* SPDX-License-Identifier: MIT */
/* formats.h - what the commands read beyond libsepax-io: paths of joints, and shapes by the options
 * of meshes. Each reader fails with one line that names the file, the line if there is one, and a
 * cure. */
#ifndef SEPAX_FORMATS_H
#define SEPAX_FORMATS_H

#include "cli/meshes.h"
#include "sepax_robot.h"

/* ----------------------------------------------------------------- shapes */

/* The surface of a shape in the link's coordinates (sepax_shape_mesh), by --unit and --weld. The
 * mesh is welded after scaling, before it is placed. `said` describes the file; for a shape without
 * a file it is zero. */
bool format_shape_mesh(sepax_soup *mesh, report_mesh *said, const sepax_shape *shape,
                       const cli_meshes *rules, sepax_error *error);

/* -------------------------------------------------------------------- path */

typedef struct {
  double *value; /* value[n * joints + j]: joint j in line n, for all joints, also those that follow
                    others */
  double *time;  /* or NULL */
  size_t *line;  /* line[n]: number of line n in its file, counted from 1 */
  size_t lines, joints;
  size_t columns; /* columns of the file, including the time */
} format_motion;

typedef struct {
  bool hold;          /* keep joints without a column at 0 */
  bool ignore_limits; /* accept values beyond the limits of joints */
} format_motion_rules;

bool format_motion_read(format_motion *motion, const sepax_mechanism *m,
                        const format_motion_rules *rules, const char *path, sepax_error *error);
void format_motion_free(format_motion *motion);

#endif
