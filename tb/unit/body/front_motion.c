/* SPDX-License-Identifier: MIT */
/* front_motion.c - how much the bounds of a front fall (distance/front.c): MOTION_ERROR, and 2^-50
 * of `skew`. */
#define sepax_front_bytes front_bytes_of_test
#define sepax_front_begin front_begin_of_test
#define sepax__front_clear front_clear_of_test
#define sepax__front_move front_move_of_test
#define sepax__front_least front_least_of_test
#define sepax__front_beyond front_beyond_of_test
#define sepax__front_worth front_worth_of_test
#define sepax__front_next front_next_of_test
#define sepax__front_add front_add_of_test
#define sepax__front_note_near front_note_near_of_test
#define sepax__front_end front_end_of_test
#include "distance/front.c" /* NOLINT(bugprone-suspicious-include): its functions are static */

#include "wide.h"

enum { POSE = 16 };

/* A pose of 16 inputs; the later ones differ from it by a little. */
static void pose_of(const double *x, const double *change, sepax_pose *pose) {
  double q[4];
  for (int k = 0; k < 4; k++) {
    q[k] = x[k] + 0x1p-20 * change[k];
  }
  skewed_rotation(q, x + 4, 0, pose->rotation);
  for (int i = 0; i < 3; i++) {
    pose->translation[i] = x[13 + i] + 0x1p-20 * change[4 + i];
  }
}

/* M = R_b^T R_a and m = R_b^T (t_a - t_b). */
static void exact_relation(const sepax_pose pose[2], wide rotation[3][3], wide translation[3]) {
  for (int i = 0; i < 3; i++) {
    translation[i] = 0;
    for (int k = 0; k < 3; k++) {
      wide way = (wide)pose[0].translation[k] - pose[1].translation[k];
      translation[i] += pose[1].rotation[k][i] * way;
      rotation[i][k] = 0;
      for (int n = 0; n < 3; n++) {
        rotation[i][k] += (wide)pose[1].rotation[n][i] * pose[0].rotation[n][k];
      }
    }
  }
}

/* A body A of a centre and a radius, a body B of size 0 and no distance: the motion of A alone. */
static double motion_error(const double *x) {
  sepax_body body[2] = {{.scale = 1}, {.scale = 1}};
  sepax_front f = {.body = {&body[0], &body[1]}, .scale = 1};
  relation at[2];
  wide turn[2][3][3];
  wide shift[2][3];
  wide_point centre;
  wide_point way;
  wide square = 0;
  body[0].radius = fabs(x[2 * POSE + 17]);
  for (int i = 0; i < 3; i++) {
    body[0].centre[i] = x[2 * POSE + 14 + i];
  }
  wide_of(body[0].centre, centre);
  for (int time = 0; time < 2; time++) {
    static const double none[7];
    sepax_pose pose[2];
    for (int n = 0; n < 2; n++) {
      pose_of(x + n * POSE, time == 0 ? none : x + 2 * POSE + 7 * n, &pose[n]);
    }
    relate(&at[time], &pose[0], &pose[1]);
    exact_relation(pose, turn[time], shift[time]);
  }
  memcpy(f.rotation, at[0].rotation, sizeof f.rotation);
  memcpy(f.translation, at[0].translation, sizeof f.translation);
  f.reach = at[0].reach;
  f.skew = at[0].skew;
  for (int i = 0; i < 3; i++) {
    way[i] = shift[1][i] - shift[0][i];
    for (int k = 0; k < 3; k++) {
      wide d = turn[1][i][k] - turn[0][i][k];
      way[i] += d * centre[k];
      square += d * d;
    }
  }
  double size = vector_length(body[0].centre) + body[0].radius;
  double error = MOTION_ERROR * (size + at[0].reach + at[1].reach);
  wide exact = wide_length(way) + body[0].radius * wide_root(square);
  return (double)((exact - motion(&f, &at[1])) / error) + 1;
}

CASE(motions_of_bodies) {
  assert_part("MOTION_ERROR", most_of_bound(motion_error, 2 * POSE + 18, 12, 20000), 0.005);
}

/* An entry of R R^T - 1 in doubles. */
static double skew_error(const double *x) {
  sepax_pose pose;
  relation r;
  skewed_rotation(x, x + 4, x[13] > 0 ? 1e-6 : 0, pose.rotation);
  memcpy(pose.translation, x + 13, sizeof pose.translation);
  if (!sepax_pose_valid(&pose, NULL)) {
    return -1;
  }
  relate(&r, NULL, &pose);
  wide most = 0;
  for (int k = 0; k < 9; k++) {
    wide_point row[2];
    wide_of(pose.rotation[k / 3], row[0]);
    wide_of(pose.rotation[k % 3], row[1]);
    most = wide_most(most, wide_size(wide_dot(row[0], row[1]) - (k / 3 == k % 3)));
  }
  return (double)((most - r.skew) / 0x1p-50) + 1;
}

CASE(skews_of_poses) { assert_part("2^-50", most_of_bound(skew_error, POSE, 8, 10000), 0.15); }
