/* SPDX-License-Identifier: MIT */
/* interval.c - proves that two bodies do not collide in a part of the way between two lines: if
 * they are farther apart than any of their points moves, or if the hulls of the ways of their
 * triangles are apart, then they do not meet. docs/reference/mechanisms.md#between-the-lines. */
#include "path/search/interval.h"
#include "distance/swept.h"
#include "mechanism/steps.h"
#include "util/error.h"
#include "util/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

bool path_asking_begin(path_asking *a, const path_scene *scene, const path_question *q,
                       const path_pair *pair, sepax_error *error) {
  size_t joints = scene->motion.joints;
  *a = (path_asking){.scene = scene,
                     .q = q,
                     .pair = pair,
                     .body = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]}};
  double *values = malloc(3 * (joints + 1) * sizeof *values);
  a->value[0] = values;
  if (values == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu joints", joints);
  }
  for (int k = 0; k < 3; k++) {
    a->value[k] = values + (size_t)k * joints;
    a->extent += fabs(a->body[0]->least[k]) + fabs(a->body[0]->most[k]) +
                 fabs(a->body[1]->least[k]) + fabs(a->body[1]->most[k]);
  }
  return sepax_chain_find(&a->back, &scene->robot.mechanism, a->body[1]->link, a->body[0]->link,
                          error);
}

void path_asking_end(path_asking *a) {
  sepax_chain_free(&a->back);
  free(a->value[0]);
}

static void set_values(path_asking *a) {
  const format_motion *motion = &a->scene->motion;
  const double *from = &motion->value[a->at.segment * motion->joints];
  const double *to = from + motion->joints;
  for (int k = 0; k < 3; k++) {
    double part = ldexp((double)(2 * a->at.index + (uint64_t)k), -(int)a->at.level - 1);
    for (size_t n = 0; n < motion->joints; n++) {
      a->value[k][n] = part == 1 ? to[n] : from[n] + (to[n] - from[n]) * part;
    }
  }
}

/* How far the bodies must be apart in each pose of the segment. */
static double clearance_of(const path_asking *a) {
  const format_step *step = a->scene->motion.step;
  return path_bands(a->q, a->pair).clearance.length +
         (step != NULL ? step[a->at.segment + 1].deviation : 0);
}

static double bound_of(const path_asking *a) {
  const sepax_mechanism *m = &a->scene->robot.mechanism;
  const sepax_chain *const chain[2] = {&a->pair->chain, &a->back};
  double least = INFINITY;
  for (int side = 0; side < 2; side++) {
    double box[2][3];
    memcpy(box[0], a->body[side]->least, sizeof box[0]);
    memcpy(box[1], a->body[side]->most, sizeof box[1]);
    least =
        fmin(least, sepax_chain_travel(chain[side], m, a->value[0], a->value[1], a->value[2], box));
  }
  return least;
}

/* ----------------------------------------------------------------------------- boxes */

typedef struct {
  double side[2][3]
             [3];    /* half the sides of each box, as vectors in the second body's coordinates */
  double between[3]; /* from the centre of the second box to the centre of the first */
} two_boxes;

static two_boxes posed_boxes(const path_asking *a) {
  two_boxes t;
  double way[3];
  for (int i = 0; i < 3; i++) {
    way[i] = a->pose[0].translation[i] - a->pose[1].translation[i];
    for (int k = 0; k < 3; k++) {
      way[i] += a->pose[0].rotation[i][k] * (a->body[0]->least[k] / 2 + a->body[0]->most[k] / 2);
    }
  }
  for (int i = 0; i < 3; i++) {
    const double(*b)[3] = a->pose[1].rotation;
    t.between[i] = b[0][i] * way[0] + b[1][i] * way[1] + b[2][i] * way[2] -
                   (a->body[1]->least[i] / 2 + a->body[1]->most[i] / 2);
    for (int k = 0; k < 3; k++) {
      const double(*r)[3] = a->pose[0].rotation;
      t.side[0][k][i] = (b[0][i] * r[0][k] + b[1][i] * r[1][k] + b[2][i] * r[2][k]) *
                        (a->body[0]->most[k] / 2 - a->body[0]->least[k] / 2);
      t.side[1][k][i] = i == k ? a->body[1]->most[k] / 2 - a->body[1]->least[k] / 2 : 0;
    }
  }
  return t;
}

/* The gap between the boxes along an axis, or a negative number if there is none. `axis` becomes a
 * unit vector that points from the second box to the first. */
static double gap_along(const two_boxes *t, double axis[3]) {
  double length = vector_length(axis);
  if (!(length > 0x1p-500)) {
    return -1;
  }
  double way = vector_dot(t->between, axis);
  double reach = 0;
  for (int k = 0; k < 6; k++) {
    reach += fabs(vector_dot(t->side[k / 3][k % 3], axis));
  }
  for (int i = 0; i < 3; i++) {
    axis[i] /= way < 0 ? -length : length;
  }
  return (fabs(way) - reach) / length;
}

/* True if the boxes are more than `need` apart. Then a->at.axis is an axis that proves it. */
static bool boxes_disjoint(path_asking *a, double need) {
  two_boxes t = posed_boxes(a);
  double most = -1;
  for (int n = 0; n < 15; n++) {
    double axis[3];
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      const double *u = t.side[0][n % 3];
      const double *v = t.side[1][n / 3 % 3];
      axis[i] = n < 9 ? u[j] * v[k] - u[k] * v[j] : t.side[(n - 9) / 3][n % 3][i];
    }
    double gap = gap_along(&t, axis);
    if (gap > most) {
      most = gap;
      memcpy(a->at.axis, axis, sizeof axis);
    }
  }
  return most > need + 0x1p-40 * (a->extent + sqrt(vector_dot(t.between, t.between)));
}

/* -------------------------------------------------------------------------- intervals */

/* A proof needs "farther apart than", not how far. How far decides only how often an interval is
 * halved, so a coarse distance does in most cases. The last tolerance is that of the exact
 * distance. */
static const double tolerances[] = {0x1p-4, 0x1p-10, 0};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };

/* Measure the distance at the middle with the next tolerance. */
static bool narrow(path_asking *a, sepax_error *error) {
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                          .relative = tolerances[a->step],
                                          .last = a->has_last ? &a->last : NULL};
  sepax_distance_result r;
  if (!sepax_bodies_distance(a->body[0]->body, &a->pose[0], a->body[1]->body, &a->pose[1], &request,
                             &r, error)) {
    return false;
  }
  a->step++;
  a->least = a->step == TOLERANCES ? r.min_distance : r.least;
  a->most = a->step == TOLERANCES ? r.min_distance : r.most;
  if (r.min_distance > 0) {
    a->last = r;
    a->has_last = true;
  }
  return true;
}

/* ----------------------------------------------------------------------------- sweeps */

/* Comparisons of a sweep, and how many parts go by after sweeps that failed. A sweep takes as long
 * as some tens of queries, so it is for bodies that slide along each other. */
enum { SWEEP_WORK = 4096, PAUSE_MOST = 63, SWEEP_FROM = 4 };

/* The pose of one body as seen from the other. */
static sepax_pose seen(const path_asking *a, int moving, const double *value) {
  sepax_pose pose[2];
  sepax_chain_poses(&a->pair->chain, &a->scene->robot.mechanism, value, pose);
  return sepax__pose_seen(&pose[!moving], &pose[moving]);
}

static double size_of(const path_body *b) {
  double size = 0;
  for (int i = 0; i < 3; i++) {
    size = fmax(size, b->most[i] - b->least[i]);
  }
  return size;
}

/* Do the bodies slide along each other far enough apart? The way of each point is straight but for
 * its bend, so what counts is how near the hulls of the ways come (lib/distance/swept.c). The
 * smaller body is taken as the one that moves, because the hulls of triangles that turn are wide.
 */
static bool slides_apart(path_asking *a) {
  double left = a->least - clearance_of(a);
  double box[2][3];
  if (!(a->at.bound > SWEEP_FROM * left) || !(left > 0)) {
    return false;
  }
  if (a->waits > 0) {
    a->waits--;
    return false;
  }
  int moving = size_of(a->body[1]) < size_of(a->body[0]);
  memcpy(box[0], a->body[moving]->least, sizeof box[0]);
  memcpy(box[1], a->body[moving]->most, sizeof box[1]);
  double bend =
      sepax__chain_bend(moving == 0 ? &a->pair->chain : &a->back, &a->scene->robot.mechanism,
                        a->value[0], a->value[1], a->value[2], box);
  if (!(bend < left / 2)) {
    return false;
  }
  sepax_pose from = seen(a, moving, a->value[0]);
  sepax_pose to = seen(a, moving, a->value[2]);
  double need = (clearance_of(a) + bend) * (1 + 0x1p-40);
  bool yes = sepax__swept_apart(a->body[moving]->body, &from, &to, a->body[!moving]->body, need,
                                SWEEP_WORK);
  a->pause = yes ? 0 : a->pause < PAUSE_MOST ? 2 * a->pause + 1 : PAUSE_MOST;
  a->waits = a->pause;
  return yes;
}

bool path_interval_ask(path_asking *a, bool *certified, sepax_error *error) {
  static const sepax_apart_request request = {.size = sizeof(sepax_apart_request)};
  sepax_apart_result r;
  set_values(a);
  sepax_chain_poses(&a->pair->chain, &a->scene->robot.mechanism, a->value[1], a->pose);
  a->at.bound = bound_of(a);
  double need = (a->at.bound + clearance_of(a)) * (1 + 0x1p-48);
  a->at.by_axis = boxes_disjoint(a, need);
  *certified = a->at.by_axis;
  if (*certified) {
    return true;
  }
  if (!sepax_bodies_apart(a->body[0]->body, &a->pose[0], a->body[1]->body, &a->pose[1], need,
                          &request, &r, error)) {
    return false;
  }
  a->step = 0;
  *certified = r.verdict == SEPAX_APART;
  if (*certified) {
    return true;
  }
  if (!narrow(a, error)) {
    return false;
  }
  *certified = slides_apart(a);
  return true;
}

/* How often a part is halved if this is its distance; at least once. */
static int halvings(const path_asking *a, double distance) {
  const path_question *q = a->q;
  double left = fmax(distance - clearance_of(a), q->resolution.length);
  int times = (int)floor(log2(a->at.bound / left));
  return times < 1 ? 1 : times > 8 ? 8 : times;
}

bool path_interval_divide(path_asking *a, bool *possible, sepax_error *error) {
  *possible = a->at.bound > a->q->resolution.length;
  if (!*possible) {
    return true;
  }
  int times = halvings(a, a->least);
  while (times != halvings(a, a->most)) {
    if (!narrow(a, error)) {
      return false;
    }
    times = halvings(a, a->least);
  }
  *possible = (int)a->at.level + times <= PATH_LEVELS_MOST;
  if (*possible) {
    a->at.level += (unsigned)times;
    a->at.index <<= times;
  }
  return true;
}

bool path_interval_collides(path_asking *a, bool *yes, sepax_error *error) {
  double limit = path_bands(a->q, a->pair).clearance.length * (1 - 0x1p-50);
  while (a->least <= limit && limit < a->most) {
    if (!narrow(a, error)) {
      return false;
    }
  }
  *yes = a->most <= limit;
  return true;
}

bool path_interval_measure(path_asking *a, double *distance, sepax_error *error) {
  while (a->step < TOLERANCES) {
    if (!narrow(a, error)) {
      return false;
    }
  }
  *distance = a->least;
  return true;
}
