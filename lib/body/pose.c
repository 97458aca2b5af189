/* SPDX-License-Identifier: MIT */
/* pose.c - poses: validity, nearest rotation, application, composition, inverse. */
#include "placement.h"
#include "util/error.h"

#include <math.h>
#include <string.h>

bool sepax_pose_valid(const sepax_pose *pose, sepax_error *error) {
  const double(*r)[3] = pose->rotation;
  for (int i = 0; i < 3; i++) {
    if (!isfinite(pose->translation[i]) || !isfinite(r[i][0]) || !isfinite(r[i][1]) ||
        !isfinite(r[i][2])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "a pose has a number that is not finite; mend it");
    }
    for (int j = 0; j < 3; j++) {
      double product = r[i][0] * r[j][0] + r[i][1] * r[j][1] + r[i][2] * r[j][2];
      if (!(fabs(product - (i == j)) <= 1e-6)) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "the matrix is no rotation: rows %d and %d have the product %.9g; "
                          "mend it to within 1e-6",
                          i + 1, j + 1, product);
      }
    }
  }
  double determinant = r[0][0] * (r[1][1] * r[2][2] - r[1][2] * r[2][1]) -
                       r[0][1] * (r[1][0] * r[2][2] - r[1][2] * r[2][0]) +
                       r[0][2] * (r[1][0] * r[2][1] - r[1][1] * r[2][0]);
  return determinant > 0 ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "the matrix is a reflection, not a rotation; mirror the mesh instead");
}

static bool has_numbers(const sepax_pose *pose) {
  for (int i = 0; i < 3; i++) {
    const double *r = pose->rotation[i];
    if (!isfinite(r[0]) || !isfinite(r[1]) || !isfinite(r[2]) || !isfinite(pose->translation[i])) {
      return false;
    }
  }
  return true;
}

/* Compute wrong = I - R^T R and return its greatest entry. */
static double deviation(const double r[3][3], double wrong[3][3]) {
  double most = 0;
  for (int p = 0; p < 3; p++) {
    for (int q = 0; q < 3; q++) {
      wrong[p][q] = (p == q) - (r[0][p] * r[0][q] + r[1][p] * r[1][q] + r[2][p] * r[2][q]);
      most = fmax(most, fabs(wrong[p][q]));
    }
  }
  return most;
}

/* Repeating R = R (3 I - R^T R) / 2 leads to the nearest rotation: each singular value goes to 1,
 * and its distance from 1 is squared in each step. An orthonormal matrix stays as it is. */
static void make_orthonormal(double r[3][3]) {
  double wrong[3][3];
  for (int round = 0; round < 6 && deviation((const double(*)[3])r, wrong) > 0; round++) {
    double next[3][3];
    for (int i = 0; i < 9; i++) {
      int p = i / 3;
      int q = i % 3;
      next[p][q] =
          r[p][q] + (r[p][0] * wrong[0][q] + r[p][1] * wrong[1][q] + r[p][2] * wrong[2][q]) / 2;
    }
    memcpy(r, next, sizeof next);
  }
}

bool sepax_pose_nearest(sepax_pose *pose, double *moved, sepax_error *error) {
  static const double most = 1e-2; /* largest allowed change of an entry */
  double wrong[3][3];
  sepax_pose nearest = *pose;
  if (!has_numbers(pose)) {
    return sepax_pose_valid(pose, error);
  }
  double way = 0;
  if (deviation(pose->rotation, wrong) <= 0.1) {
    make_orthonormal(nearest.rotation);
    for (int i = 0; i < 9; i++) {
      way = fmax(way, fabs(nearest.rotation[i / 3][i % 3] - pose->rotation[i / 3][i % 3]));
    }
  } else {
    way = INFINITY;
  }
  if (!(way <= most)) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "the matrix is no rotation, and even the nearest rotation differs by more than %g in an "
        "entry; mend it",
        most);
  }
  if (!sepax_pose_valid(&nearest, error)) {
    return false;
  }
  *pose = nearest;
  if (moved != NULL) {
    *moved = way;
  }
  return true;
}

bool sepax__poses_valid(const sepax_pose *pose_a, const sepax_pose *pose_b, sepax_error *error) {
  return (pose_a == NULL || sepax_pose_valid(pose_a, error)) &&
         (pose_b == NULL || sepax_pose_valid(pose_b, error));
}

/* Coordinate i of the turned point: row i of the rotation times v. */
static double turned(const sepax_pose *pose, int i, const double v[3]) {
  const double *r = pose->rotation[i];
  return r[0] * v[0] + r[1] * v[1] + r[2] * v[2];
}

void sepax_pose_apply(const sepax_pose *pose, const double v[3], double to[3]) {
  const double at[3] = {turned(pose, 0, v) + pose->translation[0],
                        turned(pose, 1, v) + pose->translation[1],
                        turned(pose, 2, v) + pose->translation[2]};
  for (int i = 0; i < 3; i++) {
    to[i] = at[i];
  }
}

sepax_pose sepax_pose_compose(const sepax_pose *outer, const sepax_pose *inner) {
  const double(*q)[3] = inner->rotation;
  sepax_pose r;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      const double column[3] = {q[0][j], q[1][j], q[2][j]};
      r.rotation[i][j] = turned(outer, i, column);
    }
  }
  sepax_pose_apply(outer, inner->translation, r.translation);
  return r;
}

sepax_pose sepax_pose_inverse(const sepax_pose *pose) {
  sepax_pose r;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      r.rotation[i][j] = pose->rotation[j][i];
    }
  }
  for (int i = 0; i < 3; i++) {
    r.translation[i] = -turned(&r, i, pose->translation);
  }
  return r;
}
