/* SPDX-License-Identifier: MIT */
/* poses.c - where the links of a mechanism are. */
#include "mechanism/steps.h"

#include <math.h>
#include <string.h>

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

/* About a unit axis by an angle: cos I + sin [axis]x + (1 - cos) axis axis^T. 1 - cos is taken from
 * half the angle, where nothing cancels. */
static sepax_pose turn_about(const double axis[3], double angle) {
  double c = cos(angle);
  double s = sin(angle);
  double half = sin(angle / 2);
  double v = 2 * half * half;
  sepax_pose r = at_origin;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    r.rotation[i][i] = v * axis[i] * axis[i] + c;
    r.rotation[i][j] = v * axis[i] * axis[j] - s * axis[k];
    r.rotation[i][k] = v * axis[i] * axis[k] + s * axis[j];
  }
  return r;
}

static sepax_pose move_along(const double axis[3], double way) {
  sepax_pose r = at_origin;
  for (int i = 0; i < 3; i++) {
    r.translation[i] = axis[i] * way;
  }
  return r;
}

sepax_pose sepax__step_of(const sepax_joint *joint, double value) {
  if (joint->kind == SEPAX_JOINT_FIXED) {
    return joint->origin;
  }
  sepax_pose moved = joint->kind == SEPAX_JOINT_PRISMATIC ? move_along(joint->axis, value)
                                                          : turn_about(joint->axis, value);
  return sepax_pose_compose(&joint->origin, &moved);
}

sepax_pose sepax__pose_seen(const sepax_pose *from, const sepax_pose *pose) {
  sepax_pose r = {.translation = {0}};
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      double turned = from->rotation[k][i];
      r.translation[i] += turned * (pose->translation[k] - from->translation[k]);
      for (int j = 0; j < 3; j++) {
        r.rotation[i][j] += turned * pose->rotation[k][j];
      }
    }
  }
  return r;
}

bool sepax_joint_driven(const sepax_joint *joint) {
  return joint->kind != SEPAX_JOINT_FIXED && joint->mimic == SEPAX_NO_JOINT;
}

void sepax_mechanism_follow(const sepax_mechanism *m, double *value) {
  for (size_t n = 0; n < m->joints; n++) {
    const sepax_joint *joint = &m->joint[n];
    if (joint->mimic != SEPAX_NO_JOINT) {
      value[n] = joint->factor * value[joint->mimic] + joint->offset;
    }
  }
}

void sepax_mechanism_poses(const sepax_mechanism *m, const double *value, sepax_pose *pose) {
  pose[m->root] = at_origin;
  for (size_t n = 0; n < m->joints; n++) {
    const sepax_joint *joint = &m->joint[m->order[n]];
    sepax_pose step = sepax__step_of(joint, value[m->order[n]]);
    pose[joint->child] = sepax_pose_compose(&pose[joint->parent], &step);
  }
}

void sepax_chain_poses(const sepax_chain *chain, const sepax_mechanism *m, const double *value,
                       sepax_pose pose[2]) {
  pose[0] = at_origin;
  pose[1] = at_origin;
  for (size_t n = 0; n < chain->count; n++) {
    bool rising = n < chain->up;
    size_t j = chain->joint[rising ? chain->up - 1 - n : n];
    sepax_pose step = sepax__step_of(&m->joint[j], value[j]);
    pose[rising ? 0 : 1] = sepax_pose_compose(&pose[rising ? 0 : 1], &step);
  }
}
