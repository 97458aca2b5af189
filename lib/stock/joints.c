/* SPDX-License-Identifier: MIT */
/* joints.c - the way of a tool while joints move linearly, in pieces that do not turn.
 *
 * Let R_0, R_1 and R_m be the tool's turns at the beginning, at the end and in the middle, t_0 and
 * t_1 its translations, and c any point. The piece turns by R_m. It goes from o_0 to o_1 with
 *
 *     o_k = t_k + (R_k - R_m) c
 *
 * so that c is where it belongs at both ends. At the part s of the time a point p is truly at x(s).
 * On its chord it would be at
 *
 *     (1 - s) (R_0 p + t_0) + s (R_1 p + t_1)
 *
 * which is no farther away than sepax__chain_bend. In the piece it is at
 *
 *     (1 - s) (R_m p + o_0) + s (R_m p + o_1)
 *
 * The last two differ by (1 - s) (R_0 - R_m) (p - c) + s (R_1 - R_m) (p - c), which is no longer
 * than the longer of the two vectors (R_k - R_m) (p - c). Each is an affine function of p, so it is
 * longest in a corner of the box. The poses at the three times are rounded by less than the part of
 * 2^-42 of all lengths that sepax__chain_bend has for each joint. */
#include "mechanism/steps.h"
#include "stock/stock.h"
#include "util/vector.h"

#include <math.h>
#include <string.h>

/* The tool's link in the coordinates of the stock's. */
static sepax_pose seen(const sepax__stock_joints *w, const double *value) {
  sepax_pose pose[2];
  sepax_chain_poses(w->chain, w->mechanism, value, pose);
  sepax_pose back = sepax_pose_inverse(&pose[1]);
  return sepax_pose_compose(&back, &pose[0]);
}

/* The vector (R_k - R_m) v. */
static void turn_off(const sepax_pose *end, const sepax_pose *middle, const double v[3],
                     double to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = 0;
    for (int j = 0; j < 3; j++) {
      to[i] += (end->rotation[i][j] - middle->rotation[i][j]) * v[j];
    }
  }
}

/* The length of the longest (R_k - R_m) (p - c), where c is the middle of the box. */
static double longest(const sepax__stock_joints *w, const sepax_pose *end,
                      const sepax_pose *middle) {
  double most = 0;
  for (int n = 0; n < 8; n++) {
    double v[3];
    double off[3];
    for (int i = 0; i < 3; i++) {
      double half = w->box[1][i] / 2 - w->box[0][i] / 2;
      v[i] = n >> i & 1 ? half : -half;
    }
    turn_off(end, middle, v, off);
    most = fmax(most, vector_length(off));
  }
  return most;
}

void sepax__stock_joint_piece(const void *context, double from, double to,
                              sepax__stock_piece *piece) {
  const sepax__stock_joints *w = context;
  const double at[3] = {from, from / 2 + to / 2, to};
  sepax_pose pose[3];
  double pivot[3];
  double start[3];
  double end[3];
  for (int k = 0; k < 3; k++) {
    for (size_t n = 0; n < w->mechanism->joints; n++) {
      /* in this form the ends of the way are exact */
      w->value[k][n] = (1 - at[k]) * w->from[n] + at[k] * w->to[n];
    }
    pose[k] = seen(w, w->value[k]);
  }
  for (int i = 0; i < 3; i++) {
    pivot[i] = w->box[0][i] / 2 + w->box[1][i] / 2;
  }
  turn_off(&pose[0], &pose[1], pivot, start);
  turn_off(&pose[2], &pose[1], pivot, end);
  for (int i = 0; i < 3; i++) {
    start[i] += pose[0].translation[i];
    end[i] += pose[2].translation[i];
    piece->way[i] = end[i] - start[i];
    pose[1].translation[i] = start[i];
  }
  piece->at = sepax_pose_compose(&pose[1], &w->mount);
  double turned = fmax(longest(w, &pose[0], &pose[1]), longest(w, &pose[2], &pose[1]));
  piece->deviation = turned * (1 + 0x1p-30) + sepax__chain_bend(w->chain, w->mechanism, w->value[0],
                                                                w->value[1], w->value[2], w->box);
}

void sepax__stock_mounted_box(const sepax__stock_shape *shape, const sepax_pose *mount,
                              double box[2][3]) {
  for (int i = 0; i < 3; i++) {
    double low = mount->rotation[i][2] * shape->low;
    double high = mount->rotation[i][2] * shape->high;
    double wide = shape->radius * hypot(mount->rotation[i][0], mount->rotation[i][1]);
    wide += 0x1p-40 * (wide + fabs(low) + fabs(high) + fabs(mount->translation[i]));
    box[0][i] = mount->translation[i] + fmin(low, high) - wide;
    box[1][i] = mount->translation[i] + fmax(low, high) + wide;
  }
}
