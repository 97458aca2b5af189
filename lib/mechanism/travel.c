/* SPDX-License-Identifier: MIT */
/* travel.c - a bound on the motion of bodies while joints move linearly.
 * docs/reference/mechanisms.md#the-bound-on-motion derives the bound. */
#include "mechanism/steps.h"
#include "util/vector.h"

#include <math.h>

/* A factor that covers all rounding of the products and sums here. */
static const double up = 1 + 0x1p-30;

static void corner_of(const double box[2][3], int corner, double v[3]) {
  for (int i = 0; i < 3; i++) {
    v[i] = box[corner >> i & 1][i];
  }
}

/* to = R v, or R^T v if `back`. */
static void turn(const double r[3][3], bool back, const double v[3], double to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = back ? r[0][i] * v[0] + r[1][i] * v[1] + r[2][i] * v[2]
                 : r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2];
  }
}

/* The corners of a box of A, in B's coordinates. */
static void seen_from_b(const sepax_chain *chain, const sepax_mechanism *m, const double *value,
                        const double box[2][3], double at[8][3]) {
  sepax_pose pose[2];
  sepax_chain_poses(chain, m, value, pose);
  for (int n = 0; n < 8; n++) {
    double v[3];
    double in_top[3];
    corner_of(box, n, v);
    turn(pose[0].rotation, false, v, in_top);
    for (int i = 0; i < 3; i++) {
      in_top[i] += pose[0].translation[i] - pose[1].translation[i];
    }
    turn(pose[1].rotation, true, in_top, at[n]);
  }
}

/* The greatest distance of a point of the box from an axis through the origin of a link. It is
 * reached at a corner because the distance is a convex function. */
static double reach_of(const double axis[3], const sepax_pose *link, const double box[2][3]) {
  double most = 0;
  double a[3];
  turn(link->rotation, false, axis, a);
  for (int n = 0; n < 8; n++) {
    double arm[3];
    double cross[3];
    corner_of(box, n, arm);
    for (int i = 0; i < 3; i++) {
      arm[i] -= link->translation[i];
    }
    vector_cross(a, arm, cross);
    most = fmax(most, vector_length(cross));
  }
  return most;
}

/* Go to the next link of the chain: from the child's pose to the parent's, or from the parent's to
 * the child's, both in A's coordinates. */
static sepax_pose next_link(const sepax_pose *link, const sepax_joint *joint, double value,
                            bool rising) {
  sepax_pose step = sepax__step_of(joint, value);
  if (rising) {
    sepax_pose back;
    double t[3];
    turn(step.rotation, true, step.translation, t);
    for (int i = 0; i < 3; i++) {
      for (int j = 0; j < 3; j++) {
        back.rotation[i][j] = step.rotation[j][i];
      }
      back.translation[i] = -t[i];
    }
    step = back;
  }
  return sepax_pose_compose(link, &step);
}

/* What the joints do to the points of a box in the time from 0 to 1. */
typedef struct {
  double scale;     /* sum of all lengths */
  double moved;     /* motion by the joints so far (those nearest to A) from the middle to an end */
  double curvature; /* bound on the second derivative of a point's path in B's coordinates */
  double rounded;   /* rounding of the joint values between the ends */
} motion;

static motion motion_of(const sepax_chain *chain, const sepax_mechanism *m, const double *from,
                        const double *middle, const double *to, const double box[2][3]) {
  sepax_pose link = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  motion sum = {.scale = 2 * (vector_length(box[0]) + vector_length(box[1]))};
  for (size_t n = 0; n < chain->count; n++) {
    const sepax_joint *joint = &m->joint[chain->joint[n]];
    const double *value[3] = {from, middle, to};
    double q[3];
    for (int k = 0; k < 3; k++) {
      q[k] = joint->kind == SEPAX_JOINT_FIXED ? 0 : value[k][chain->joint[n]];
    }
    bool rising = n < chain->up;
    sepax_pose other = next_link(&link, joint, q[1], rising);
    const sepax_pose *child = rising ? &link : &other;
    sum.scale += vector_length(joint->origin.translation);
    double slack = (double)(n + 1) * 0x1p-43 * sum.scale;
    double most = fmax(fabs(q[0]), fabs(q[2]));
    double way = fabs(q[2] - q[0]);
    if (joint->kind == SEPAX_JOINT_PRISMATIC) {
      sum.scale += most;
      sum.rounded += 0x1p-50 * most;
      sum.moved += way / 2 * up;
    } else if (joint->kind != SEPAX_JOINT_FIXED) {
      double arm = (reach_of(joint->axis, child, box) + slack + sum.moved) * up;
      sum.rounded += 0x1p-50 * most * arm;
      sum.curvature += way * (way * arm + 4 * sum.moved) * up;
      sum.moved += way / 2 * arm * up;
    }
    link = other;
  }
  return sum;
}

/* All rounding: of joint values on the way, and of poses. */
static double rounding_of(const motion *sum, const sepax_chain *chain) {
  return 2 * sum->rounded + (double)(chain->count + 1) * 0x1p-42 * sum->scale;
}

double sepax__chain_bend(const sepax_chain *chain, const sepax_mechanism *m, const double *from,
                         const double *middle, const double *to, const double box[2][3]) {
  motion sum = motion_of(chain, m, from, middle, to, box);
  return sum.curvature / 8 * up + rounding_of(&sum, chain);
}

double sepax_chain_travel(const sepax_chain *chain, const sepax_mechanism *m, const double *from,
                          const double *middle, const double *to, const double box[2][3]) {
  motion sum = motion_of(chain, m, from, middle, to, box);
  double at[3][8][3];
  double chord = 0;
  seen_from_b(chain, m, middle, box, at[0]);
  seen_from_b(chain, m, from, box, at[1]);
  seen_from_b(chain, m, to, box, at[2]);
  for (int end = 1; end < 3; end++) {
    for (int n = 0; n < 8; n++) {
      double way[3];
      for (int i = 0; i < 3; i++) {
        way[i] = at[end][n][i] - at[0][n][i];
      }
      chord = fmax(chord, vector_length(way));
    }
  }
  return fmin(chord + sum.curvature / 32, sum.moved) * up + rounding_of(&sum, chain);
}
