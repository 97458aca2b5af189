/* SPDX-License-Identifier: MIT */
/* deviation.c - how much nearer two bodies may be than in linear motion of the joints, if each
 * joint may be off by a given amount.
 *
 * Let a point of body A be seen from body B, and let joint j be off by d_j. Replace the values of
 * the joints by the true ones, one after the other, beginning with the joint that is farthest from
 * A. Each step moves the point by at most d_j (prismatic) or R_j d_j (revolute). R_j bounds the
 * distance of the point from the joint's axis while all joints between A and j have the values of
 * the linear motion: it is the radius of A around the origin of its link, plus the lengths of all
 * translations between A and j, each at its greatest on the path. Later steps do not change this
 * way's length, because they only pose what is behind. So the distance of A and B changes by at
 * most the sum; the sum for B seen from A is as good, and the lesser one counts. */
#include "path/program.h"
#include "util/error.h"
#include "util/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Covers all rounding of the sums and products. */
static const double up = 1 + 0x1p-30;

/* The greatest size of each joint's value on the path. */
static void find_sizes(const path_scene *scene, double *size) {
  const format_motion *motion = &scene->motion;
  for (size_t n = 0; n < motion->lines; n++) {
    for (size_t j = 0; j < motion->joints; j++) {
      size[j] = fmax(size[j], fabs(motion->value[n * motion->joints + j]));
    }
  }
}

static double radius_of(const path_body *b) {
  double v[3];
  for (int i = 0; i < 3; i++) {
    v[i] = fmax(fabs(b->least[i]), fabs(b->most[i]));
  }
  return vector_length(v);
}

/* For each joint of the chain, how far a point of a body with this radius moves if the joint is off
 * by 1: lever[j]. The chain begins at the body. */
static void find_levers(const path_scene *scene, const sepax_chain *chain, double radius,
                        const double *size, double *lever) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  double reach = radius;
  memset(lever, 0, m->joints * sizeof *lever);
  for (size_t n = 0; n < chain->count; n++) {
    const sepax_joint *joint = &m->joint[chain->joint[n]];
    double origin = vector_length(joint->origin.translation);
    bool down = n >= chain->up;
    reach += down ? origin : 0;
    if (joint->kind == SEPAX_JOINT_PRISMATIC) {
      lever[chain->joint[n]] = 1;
      reach += size[chain->joint[n]];
    } else if (joint->kind != SEPAX_JOINT_FIXED) {
      lever[chain->joint[n]] = reach;
    }
    reach += down ? 0 : origin;
  }
}

static double sum_of(size_t joints, const double *lever, const double *off) {
  double sum = 0;
  for (size_t j = 0; j < joints; j++) {
    sum += lever[j] * off[j];
  }
  return sum * up;
}

/* How far each joint may be off in the motion that ends in a line, in m or rad. */
static void find_off(const path_scene *scene, bool blended, size_t line, double *off) {
  const nc_motion *nc = &scene->nc;
  const sepax_mechanism *m = &scene->robot.mechanism;
  const format_motion *motion = &scene->motion;
  size_t row = scene->row_of[line];
  memset(off, 0, m->joints * sizeof *off);
  for (size_t k = 0; k < nc->joints; k++) {
    size_t to = scene->joint_of[k];
    bool counts = blended || nc->row[row].blend != NC_UNBOUNDED;
    if (to != SEPAX_NO_JOINT) {
      off[to] = nc->deviation[row * nc->joints + k] +
                (counts ? nc->blending[row * nc->joints + k] : nc->smoothing[k]);
    }
  }
  if (nc->row[row].dogleg &&
      line > 0) { /* anywhere in the box of both ends: seen from its middle */
    const double *now = &motion->value[line * motion->joints];
    for (size_t j = 0; j < m->joints; j++) {
      off[j] += fabs(now[j] - now[j - motion->joints]) / 2 * up;
    }
  }
  for (size_t j = 0; j < m->joints; j++) {
    if (m->joint[j].mimic != SEPAX_NO_JOINT) {
      off[j] = fabs(m->joint[j].factor) * off[m->joint[j].mimic] * up;
    }
  }
}

/* Add what a pair needs to the deviations of all lines. */
static bool add_pair(path_scene *scene, const path_pair *pair, bool blended, const double *size,
                     double *lever[2], double *off, sepax_error *error) {
  size_t joints = scene->robot.mechanism.joints;
  const path_body *body[2] = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]};
  sepax_chain back;
  if (!sepax_chain_find(&back, &scene->robot.mechanism, body[1]->link, body[0]->link, error)) {
    return false;
  }
  find_levers(scene, &pair->chain, radius_of(body[0]), size, lever[0]);
  find_levers(scene, &back, radius_of(body[1]), size, lever[1]);
  sepax_chain_free(&back);
  for (size_t n = 1; n < scene->motion.lines; n++) {
    if (path_motion_asked(scene, pair, n - 1)) {
      find_off(scene, blended, n, off);
      double most = fmin(sum_of(joints, lever[0], off), sum_of(joints, lever[1], off));
      format_step *step = &scene->motion.step[n];
      step->deviation = fmax(step->deviation, most);
    }
  }
  return true;
}

bool path_program_deviations(path_scene *scene, bool blended, sepax_error *error) {
  size_t joints = scene->robot.mechanism.joints;
  double *memory = calloc(4 * joints + 1, sizeof *memory);
  if (memory == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for deviations");
  }
  double *size = memory;
  double *lever[2] = {memory + joints, memory + 2 * joints};
  bool ok = true;
  find_sizes(scene, size);
  for (size_t n = 0; n < scene->pairs && ok; n++) {
    ok = add_pair(scene, &scene->pair[n], blended, size, lever, memory + 3 * joints, error);
  }
  free(memory);
  return ok;
}
