/* SPDX-License-Identifier: MIT */
/* interval.h - a part of the way between two lines: whether a pair of bodies is proved to stay
 * apart in it. */
#ifndef SEPAX_PATH_INTERVAL_H
#define SEPAX_PATH_INTERVAL_H

#include "path/common/parts.h"

enum { PATH_LEVELS_MOST = 52 }; /* times that the way between two lines is halved */

/* A pair, and a part of its way. The caller sets `at`. */
typedef struct {
  const path_scene *scene;
  const path_question *q;
  const path_pair *pair;
  const path_body *body[2];
  sepax_chain back; /* the chain from the second body to the first */
  double *value[3]; /* values of all joints at the beginning, the middle and the end */
  sepax_pose pose[2];
  double extent; /* larger than every coordinate of both bodies */
  sepax_distance_result last;
  bool has_last;
  path_interval at;
  double least, most;    /* the distance at the middle, if it is not large enough */
  int step;              /* how many tolerances the distance has been measured with */
  unsigned waits, pause; /* sweeps: not before so many more parts; after the next that fails */
} path_asking;

/* Begin with a pair. To be ended, also after a failure. */
bool path_asking_begin(path_asking *a, const path_scene *scene, const path_question *q,
                       const path_pair *pair, sepax_error *error);
void path_asking_end(path_asking *a);

/* Certify the part if possible. If not, the distance at its middle is measured. */
bool path_interval_ask(path_asking *a, bool *certified, sepax_error *error);

/* Of a part that was asked and is not certified: do the bodies collide at the middle? The
 * comparison leaves room for the rounding of the distance. */
bool path_interval_collides(path_asking *a, bool *yes, sepax_error *error);

/* Of the same: halve it as often as its distance requires. *possible: false if its motion is
 * already as short as the resolution. */
bool path_interval_divide(path_asking *a, bool *possible, sepax_error *error);

/* Of the same: the exact distance at its middle. */
bool path_interval_measure(path_asking *a, double *distance, sepax_error *error);

#endif
