/* SPDX-License-Identifier: MIT */
/* motion.c - random poses of the bodies of a scene within their motion. docs/reference/size.md. */
#include "size/motion.h"

#include <math.h>

static const double full_angle = 6.283185307179586;

bool sepax__motion_moves(const sepax_motion *m) {
  bool shifted = false;
  for (int axis = 0; axis < 3; axis++) {
    shifted = shifted || m->low[axis] != 0 || m->high[axis] != 0;
  }
  return shifted || m->rotation != SEPAX_ROTATION_NONE;
}

bool sepax__motion_keeps(sepax_rotation rotation, int axis) {
  return rotation == SEPAX_ROTATION_NONE || (int)rotation - SEPAX_ROTATION_X == axis;
}

static double unit(sepax_random *random) {
  return (double)(sepax_random_next(random) >> 11) * 0x1p-53;
}

motion_pose sepax__motion_pose_of_files(const sepax_motion motion[2]) {
  static const double no_rotation[3] = {0, 0.25, 0};
  motion_pose p;
  for (int k = 0; k < 12; k++) {
    int axis = k % 6;
    double low = motion[k / 6].low[axis % 3];
    double way = motion[k / 6].high[axis % 3] - low;
    double u = way > 0 ? fmin(fmax(-low / way, 0), 1) : 0;
    p.u[k / 6][axis] = axis < 3 ? u : no_rotation[axis - 3];
  }
  return p;
}

motion_pose sepax__motion_draw(const motion_pose *centre, double share, sepax_random *random) {
  motion_pose p;
  for (int k = 0; k < 12; k++) {
    double u = unit(random);
    if (centre != NULL) {
      double moved = centre->u[k / 6][k % 6] + share * (u - 0.5);
      u = k % 6 < 3 ? fmin(fmax(moved, 0), 1) : moved - floor(moved);
    }
    p.u[k / 6][k % 6] = u;
  }
  return p;
}

/* A rotation about one axis, or any rotation (Shoemake: uniform). */
static void rotation_matrix(double m[3][3], sepax_rotation rotation, const double u[3]) {
  double q[4] = {1, 0, 0, 0};
  if (rotation == SEPAX_ROTATION_ANY) {
    double p = sqrt(1 - u[0]);
    double r = sqrt(u[0]);
    q[0] = p * sin(full_angle * u[1]);
    q[1] = p * cos(full_angle * u[1]);
    q[2] = r * sin(full_angle * u[2]);
    q[3] = r * cos(full_angle * u[2]);
  } else if (rotation != SEPAX_ROTATION_NONE) {
    q[0] = cos(full_angle / 2 * u[0]);
    q[1 + (int)rotation - SEPAX_ROTATION_X] = sin(full_angle / 2 * u[0]);
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    m[i][i] = 1 - 2 * (q[1 + j] * q[1 + j] + q[1 + k] * q[1 + k]);
    m[i][j] = 2 * (q[1 + i] * q[1 + j] - q[0] * q[1 + k]);
    m[i][k] = 2 * (q[1 + i] * q[1 + k] + q[0] * q[1 + j]);
  }
}

void sepax__motion_apply(sepax_soup *moved, const sepax_soup *mesh, const sepax_motion *motion,
                         const double u[6]) {
  double m[3][3];
  rotation_matrix(m, motion->rotation, &u[3]);
  for (size_t n = 0; n < 3 * mesh->count; n++) {
    const double *v = mesh->facet[n / 3].v[n % 3];
    for (int i = 0; i < 3; i++) {
      double x = v[i];
      if (!sepax__motion_keeps(motion->rotation, i)) {
        x = motion->centre[i];
        for (int k = 0; k < 3; k++) {
          x += m[i][k] * (v[k] - motion->centre[k]);
        }
      }
      double shift = motion->low[i] + u[i] * (motion->high[i] - motion->low[i]);
      moved->facet[n / 3].v[n % 3][i] = x + shift;
    }
  }
}
