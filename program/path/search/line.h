/* SPDX-License-Identifier: MIT */
/* line.h - two bodies in one line of the path: a bound on their distance, their verdict and their
 * distance. search.c decides which lines are asked for what. */
#ifndef SEPAX_PATH_LINE_H
#define SEPAX_PATH_LINE_H

#include "path/common/parts.h"

/* A pair of bodies, posed as in a line. Each thread has its own. */
typedef struct {
  const path_scene *scene;
  const path_question *q;
  const path_pair *pair;
  const path_body *body[2];
  report_bands bands; /* of the pair */
  double outer;       /* the greater of clearance and warning */
  sepax_pose pose[2];
  sepax_distance_result last; /* the last distance above 0 that was found */
  bool has_last;
  size_t measured; /* number of distances that path_line_measure has searched for */
} path_line;

path_line path_line_begin(const path_scene *scene, const path_question *q, const path_pair *pair);

/* Pose the bodies as in a line, counted from 0. */
void path_line_pose(path_line *l, size_t line);

/* A certain lower bound on the distance, found in less than a microsecond from a box about each
 * body. */
bool path_line_bound(const path_line *l, double *least, sepax_error *error);

/* The distance of the surfaces in r->min_distance, or infinite if the distance is above `limit`,
 * which may be infinite. */
bool path_line_measure(path_line *l, double limit, sepax_distance_result *r, sepax_error *error);

/* Like path_line_measure without a limit, but the result depends on the poses alone. Where several
 * pairs of triangles are nearest, another search can choose another pair, and its distance can
 * differ in the last place. */
bool path_line_measure_alone(path_line *l, sepax_distance_result *r, sepax_error *error);

/* Are the surfaces at most `distance` apart? */
bool path_line_is_near(const path_line *l, double distance, bool *near, sepax_error *error);

/* What is known of a distance; the bounds may be rounded. */
typedef struct {
  double least, most;
} path_range;

/* The verdict on the surfaces. What is known of their distance may save searches. */
bool path_line_surfaces(const path_line *l, const path_range *known, report_verdict *verdict,
                        sepax_error *error);

/* May one body be inside the other? Only if their posed boxes overlap, with an allowance for
 * rounding. */
bool path_line_boxes_overlap(const path_line *l);

/* The verdict on solids whose surfaces do not collide: raise the verdict on the surfaces if a part
 * of a body is inside a part of the other, or may be. */
bool path_line_within(const path_line *l, report_verdict *verdict, sepax_error *error);

/* Why is it not known whether a part of body *side is inside a part of the other one? */
bool path_line_why(const path_line *l, int *side, sepax_within_reason *why, sepax_error *error);

#endif
