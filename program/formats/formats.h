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

/* What a motion is for. */
typedef enum { FORMAT_MOVE, FORMAT_RAPID, FORMAT_FEED, FORMAT_PROBE, FORMAT_DWELL } format_kind;
enum { FORMAT_KINDS = FORMAT_DWELL + 1 };
extern const char *const format_kind_names[FORMAT_KINDS]; /* "move", "rapid", ... */

#define FORMAT_NO_NAME SIZE_MAX

/* The motion that ends in a line of the path, and its place in a program. */
typedef struct {
  format_kind kind;
  bool breaks;       /* the path begins anew in this line, so no motion ends here */
  size_t file, tool; /* numbers of names; FORMAT_NO_NAME: none */
  size_t line;       /* line of `file`; 0: not known */
  double deviation;  /* metres. During the motion, two bodies may be nearer by this than if all
                        joints  moved linearly */
} format_step;

typedef struct {
  double *value; /* value[n * joints + j]: joint j in line n, for all joints, also those that follow
                    others */
  double *time;  /* or NULL */
  size_t *line;  /* line[n]: number of line n in its file, counted from 1 */
  size_t lines, joints;
  size_t columns;  /* columns of the file, including the time */
  bool of_program; /* made from an NC program, not read from a file; `line` is that of the file that
                      it would make */
  /* Of a path with a column that says more about its motions: step[n] belongs to line n. Otherwise
   * NULL. */
  format_step *step;
  char **name; /* of files and tools */
  size_t names;
} format_motion;

typedef struct {
  bool hold;          /* keep joints without a column at 0 */
  bool ignore_limits; /* accept values beyond the limits of joints */
} format_motion_rules;

bool format_motion_read(format_motion *motion, const sepax_mechanism *m,
                        const format_motion_rules *rules, const char *path, sepax_error *error);
void format_motion_free(format_motion *motion);

/* Do bodies move from line n to the next? Not if the next line begins anew, nor after the last. */
bool format_motion_goes_on(const format_motion *motion, size_t n);

/* ------------------------------------------------------------------- rules */

/* Two links may meet in motions of a kind. */
typedef struct {
  char *body[2];
  format_kind kind;
  size_t line; /* of the file */
} format_rule;

typedef struct {
  format_rule *rule;
  size_t count;
} format_rules;

/* Read CSV with the first line a,b,kind. */
bool format_rules_read(format_rules *rules, const char *path, sepax_error *error);
void format_rules_free(format_rules *rules);

#endif
