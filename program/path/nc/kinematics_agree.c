/* SPDX-License-Identifier: MIT */
/* kinematics_agree.c - whether the URDF moves as the kinematics of the control say. With the tool
 * center point in force, the nose of the spindle, without a tool, is where the axes are, as seen
 * from the table, however the rotary axes are turned. So the difference of both must be the same
 * everywhere. A pivot, an offset or a direction of the URDF that is not that of the control shows
 * here.
 *
 * If a program never applies the length of a tool, then the control may have been set up for the
 * tip instead: a point some way below the nose does as well. The output names it. */
#include "mechanism/steps.h"
#include "nc/kinematics.h"
#include "path/nc/program.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>

enum { PLACES = 24 };

/* No link may be off by more, in metres. Numbers of a URDF are often rounded to micrometres. */
static const double off_most = 5e-5;

/* Some positions of the axes, in mm and degrees; the first is at 0. */
static void choose(size_t n, nc_jet axis[NC_AXES]) {
  static const double step[NC_AXES] = {37, 53, 71, 23, 29, 101, 0, 0, 0};
  static const double most[NC_AXES] = {100, 100, 100, 40, 40, 180, 0, 0, 0};
  for (int i = 0; i < NC_AXES; i++) {
    double x = most[i] > 0 ? fmod((double)n * step[i], 2 * most[i]) : 0;
    x = x > most[i] ? x - 2 * most[i] : x;
    axis[i] = (nc_jet){nc_point(x), nc_point(0), nc_point(0)};
  }
}

/* The values of all joints of the URDF at a position of the axes. */
static void find_values(const path_scene *scene, const nc_kinematics *k, const nc_jet axis[NC_AXES],
                        double *value) {
  nc_jet joint[NC_JOINTS_MOST];
  nc_kinematics_joints(k, axis, joint);
  for (size_t n = 0; n < scene->robot.mechanism.joints; n++) {
    value[n] = 0;
  }
  for (size_t n = 0; n < k->joints; n++) {
    if (scene->joint_of[n] != SEPAX_NO_JOINT) {
      value[scene->joint_of[n]] = joint[n].v.lo / 2 + joint[n].v.hi / 2;
    }
  }
  sepax_mechanism_follow(&scene->robot.mechanism, value);
}

/* The nose and the direction of the tool at each place, as seen from a link; the nose is counted
 * from where the axes are. */
typedef struct {
  double nose[PLACES][3], along[PLACES][3];
} views;

static bool look(const path_scene *scene, const nc_kinematics *k, size_t link, double *value,
                 views *v, sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  sepax_chain chain;
  if (!sepax_chain_find(&chain, m, scene->tool_link, link, error)) {
    return false;
  }
  for (size_t n = 0; n < PLACES; n++) {
    nc_jet axis[NC_AXES];
    sepax_pose pose[2];
    choose(n, axis);
    find_values(scene, k, axis, value);
    sepax_chain_poses(&chain, m, value, pose);
    const sepax_pose tool = sepax__pose_seen(&pose[1], &pose[0]);
    for (int i = 0; i < 3; i++) {
      v->nose[n][i] = tool.translation[i] - axis[i].v.lo * 1e-3;
      v->along[n][i] = -tool.rotation[i][2];
    }
  }
  sepax_chain_free(&chain);
  return true;
}

/* How far the point at `length` below the nose leaves its first place. */
static double off_at(const views *v, double length) {
  double most = 0;
  for (size_t n = 1; n < PLACES; n++) {
    double sum = 0;
    for (int i = 0; i < 3; i++) {
      double x = v->nose[n][i] - v->nose[0][i] + length * (v->along[n][i] - v->along[0][i]);
      sum += x * x;
    }
    most = fmax(most, sqrt(sum));
  }
  return most;
}

/* The length for which the point leaves its first place least, in the sum of squares. */
static double best_length(const views *v) {
  double over = 0;
  double under = 0;
  for (size_t n = 1; n < PLACES; n++) {
    for (int i = 0; i < 3; i++) {
      double e = v->along[n][i] - v->along[0][i];
      over -= e * (v->nose[n][i] - v->nose[0][i]);
      under += e * e;
    }
  }
  return under > 1e-6 ? over / under : 0;
}

/* Does the program ever apply the length of a tool? */
static bool applies_lengths(const nc_program *p) {
  for (size_t n = 0; n < p->records; n++) {
    if (p->record[n].action == NC_DO_LENGTH && p->record[n].axis[NC_Z] != 0) {
      return true;
    }
  }
  return false;
}

static bool refuse(const path_scene *scene, const path_question *q, sepax_error *error) {
  const path_agreement *best = &scene->agreement;
  return sepax_fail(
      error, SEPAX_ERROR_ARGUMENT,
      "%.200s: does not move as %.60s says: the nose of the spindle leaves the place of the axes "
      "by %.3g mm, as seen from link %.60s; mend pivots, offsets or directions in one of the two",
      q->urdf, scene->nc.program.machine[0], best->off * 1e3,
      scene->robot.mechanism.link[best->link].name);
}

bool path_program_agrees(path_scene *scene, const path_question *q, sepax_error *error) {
  nc_kinematics k;
  const sepax_mechanism *m = &scene->robot.mechanism;
  path_agreement *best = &scene->agreement;
  if (scene->tool_link == SIZE_MAX) {
    return true;
  }
  if (!nc_kinematics_of(&k, &scene->nc.program, q->motion, error)) {
    return false;
  }
  if (k.module == NC_TRIVIAL) {
    return true;
  }
  nc_kinematics_switch(&k, k.identity_first ? 1 : 0);
  double *value = calloc(m->joints + 1, sizeof *value);
  if (value == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu joints", m->joints);
  }
  bool nose_only = applies_lengths(&scene->nc.program);
  bool ok = true;
  best->off = INFINITY;
  for (size_t n = 0; n < m->links && ok; n++) {
    views v;
    ok = look(scene, &k, n, value, &v, error);
    double length = !ok || nose_only ? 0 : best_length(&v);
    double off = ok ? off_at(&v, length) : INFINITY;
    if (off < best->off) {
      *best = (path_agreement){n, off, length};
    }
  }
  free(value);
  return ok && (best->off <= off_most || refuse(scene, q, error));
}
