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
#include "path/nc/deviation.h"
#include "path/nc/program.h"
#include "util/error.h"
#include "util/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Covers all rounding of the sums and products. */
static const double up = 1 + 0x1p-30;

bool path_motion_decided(const path_scene *scene, const path_pair *pair, size_t line) {
  return pair->by_cells ? format_motion_goes_on(&scene->motion, line) &&
                              pair->tool == scene->motion.step[line + 1].tool
                        : path_motion_asked(scene, pair, line);
}

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

double *path_levers(const path_scene *scene, sepax_error *error) {
  size_t joints = scene->robot.mechanism.joints;
  double *lever = calloc(2 * scene->pairs * joints + 1, sizeof *lever);
  double *size = calloc(joints + 1, sizeof *size);
  bool ok = lever != NULL && size != NULL;
  if (ok) {
    find_sizes(scene, size);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for deviations");
  }
  for (size_t n = 0; n < scene->pairs && ok; n++) {
    const path_pair *pair = &scene->pair[n];
    const path_body *body[2] = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]};
    sepax_chain back;
    ok = sepax_chain_find(&back, &scene->robot.mechanism, body[1]->link, body[0]->link, error);
    if (ok) {
      double *of = &lever[2 * n * joints];
      find_levers(scene, &pair->chain, radius_of(body[0]), size, of);
      find_levers(scene, &back, radius_of(body[1]), size, of + joints);
      sepax_chain_free(&back);
    }
  }
  free(size);
  if (!ok) {
    free(lever);
  }
  return ok ? lever : NULL;
}

static double sum_of(size_t joints, const double *lever, const double *off) {
  double sum = 0;
  for (size_t j = 0; j < joints; j++) {
    sum += lever[j] * off[j];
  }
  return sum * up;
}

double path_nearer(const path_scene *scene, const double *levers, size_t pair, const double *off) {
  size_t joints = scene->robot.mechanism.joints;
  const double *lever = &levers[2 * pair * joints];
  return fmin(sum_of(joints, lever, off), sum_of(joints, lever + joints, off));
}

void path_followers_off(const sepax_mechanism *m, double *off) {
  for (size_t j = 0; j < m->joints; j++) {
    if (m->joint[j].mimic != SEPAX_NO_JOINT) {
      off[j] = fabs(m->joint[j].factor) * off[m->joint[j].mimic] * up;
    }
  }
}

void path_joints_off(const path_scene *scene, bool blended, size_t line, double *off) {
  const nc_motion *nc = &scene->nc;
  const sepax_mechanism *m = &scene->robot.mechanism;
  size_t row = scene->row_of[line];
  bool counts = blended || nc->row[row].blend != NC_UNBOUNDED;
  for (size_t j = 0; j < m->joints; j++) {
    off[j] = scene->slack + (scene->spread != NULL ? scene->spread[line * m->joints + j] : 0);
  }
  for (size_t k = 0; k < nc->joints; k++) {
    size_t to = scene->joint_of[k];
    if (to != SEPAX_NO_JOINT) {
      off[to] += nc->deviation[row * nc->joints + k] +
                 (counts ? nc->blending[row * nc->joints + k] : nc->smoothing[k]);
    }
  }
  path_followers_off(m, off);
}

bool path_program_deviations(path_scene *scene, bool blended, sepax_error *error) {
  double *off = calloc(scene->robot.mechanism.joints + 1, sizeof *off);
  double *levers = path_levers(scene, error);
  bool ok = levers != NULL &&
            (off != NULL || sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for deviations"));
  for (size_t n = 1; n < scene->motion.lines && ok; n++) {
    path_joints_off(scene, blended, n, off);
    for (size_t k = 0; k < scene->pairs; k++) {
      if (path_motion_decided(scene, &scene->pair[k], n - 1)) {
        format_step *step = &scene->motion.step[n];
        step->deviation = fmax(step->deviation, path_nearer(scene, levers, k, off));
      }
    }
  }
  free(off);
  free(levers);
  return ok;
}
