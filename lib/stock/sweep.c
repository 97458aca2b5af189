/* SPDX-License-Identifier: MIT */
/* sweep.c - a convex shape that goes straight on, ready to be asked which points it reaches.
 *
 * Rounding. Let M be the sum of the greatest coordinates of points and poses, the length of the way
 * and the reach of the shape. A computed place q - t w is within 2^-46 M of the true one: the
 * difference and the three products of sweep_point have an error below 16 * 2^-53 M, the entries of
 * the frame are true within 2^-50. sepax__sweep_make adds 2^-40 M to every limit, the parts of the
 * way that the frame drops, and 8 n reach for a matrix R whose R^T R differs from the identity by
 * n: R = Q S with a rotation Q and |S - 1| <= 3 n, so that R and the rotation Q put a point no
 * farther than 3 n |q| apart, and their axes differ by less than 3.5 n. */
#include "stock/sweep.h"

#include "util/error.h"
#include "util/vector.h"

#include <math.h>

/* ------------------------------------------------------------------ making */

static void scaled(double v[3], double by) {
  for (int i = 0; i < 3; i++) {
    v[i] *= by;
  }
}

/* v loses its part along the unit vector w. */
static void straighten(double v[3], const double w[3]) {
  double part = vector_dot(v, w);
  for (int i = 0; i < 3; i++) {
    v[i] -= part * w[i];
  }
}

/* Any unit vector across w. */
static void across(const double w[3], double v[3]) {
  int axis = 0;
  for (int i = 1; i < 3; i++) {
    axis = fabs(w[i]) < fabs(w[axis]) ? i : axis;
  }
  v[0] = v[1] = v[2] = 0;
  v[axis] = 1;
  straighten(v, w);
  scaled(v, 1 / vector_length(v));
  straighten(v, w);
  scaled(v, 1 / vector_length(v));
}

/* The frame and the way in it; returns a bound on what it drops of the way. */
static double turn_frame(sweep *s, const sepax__stock_piece *piece) {
  double *u = s->frame[0];
  double *w = s->frame[2];
  for (int i = 0; i < 3; i++) {
    w[i] = piece->at.rotation[i][2];
    u[i] = piece->way[i];
  }
  scaled(w, 1 / vector_length(w));
  straighten(u, w);
  double length = vector_length(piece->way);
  double wide = vector_length(u);
  bool along = wide <= fmax(0x1p-30 * length, 0x1p-500); /* or no way at all */
  if (along) {
    across(w, u);
  } else {
    scaled(u, 1 / wide);
    straighten(u, w);
    scaled(u, 1 / vector_length(u));
  }
  vector_cross(w, u, s->frame[1]);
  s->x = along ? 0 : vector_dot(piece->way, u);
  s->z = vector_dot(piece->way, w);
  s->inverse_x = 1 / s->x;
  s->inverse_length = 1 / hypot(s->x, s->z);
  return along ? 2 * wide : 2 * fabs(vector_dot(piece->way, s->frame[1]));
}

/* The greatest difference of an entry of R^T R from the identity. */
static double skew_of(const sepax_pose *pose) {
  double most = 0;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j <= i; j++) {
      double sum = i == j ? -1 : 0;
      for (int k = 0; k < 3; k++) {
        sum += pose->rotation[k][i] * pose->rotation[k][j];
      }
      most = fmax(most, fabs(sum));
    }
  }
  return most + 0x1p-50;
}

/* How far a cube of half side 1 reaches along the axis, and around it. */
static void measure_cube(const sweep *s, double *axial, double *radial) {
  const double *w = s->frame[2];
  double around = 0;
  for (int n = 0; n < 4; n++) {
    const double corner[3] = {1, n & 1 ? 1 : -1, n & 2 ? 1 : -1};
    double u = vector_dot(corner, s->frame[0]);
    double v = vector_dot(corner, s->frame[1]);
    around = fmax(around, u * u + v * v);
  }
  *axial = (fabs(w[0]) + fabs(w[1]) + fabs(w[2])) * (1 + 0x1p-40);
  *radial = sqrt(around) * (1 + 0x1p-40);
}

static void enclose(sweep *s, const sepax__stock_shape *shape, const sepax__stock_piece *piece,
                    double grow) {
  double radius = shape->radius + fmax(grow, 0);
  for (int i = 0; i < 3; i++) {
    double w = s->frame[2][i];
    double wide = radius * sqrt(fmax(0, 1 - w * w)) + 0x1p-20 * radius;
    double low = w * (shape->low - fmax(grow, 0));
    double high = w * (shape->high + fmax(grow, 0));
    s->box[0][i] = s->origin[i] + fmin(low, high) - wide + fmin(0, piece->way[i]);
    s->box[1][i] = s->origin[i] + fmax(low, high) + wide + fmax(0, piece->way[i]);
  }
}

bool sepax__sweep_make(sweep *s, const sepax__stock_shape *shape, const sepax__stock_piece *piece,
                       double grow, int sure, double extent, double close, sepax_error *error) {
  if (!sepax_pose_valid(&piece->at, error)) {
    return false;
  }
  double dropped = turn_frame(s, piece);
  double reach = shape->radius + fmax(fabs(shape->low), fabs(shape->high)) + fabs(grow);
  double size = extent + reach;
  for (int i = 0; i < 3; i++) {
    s->origin[i] = piece->at.translation[i];
    size += fabs(s->origin[i]) + fabs(piece->way[i]);
  }
  grow += sure * (0x1p-40 * size + dropped + 8 * skew_of(&piece->at) * reach);
  if (!isfinite(grow)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a way of the tool has a number not finite");
  }
  double axial;
  double radial;
  measure_cube(s, &axial, &radial);
  s->close = close;
  s->count = shape->count;
  for (int n = 0; n < s->count; n++) {
    const sepax__stock_limit *k = &shape->limit[n];
    /* the cube lies in a ball, and in a cylinder around the axis */
    double ball = sqrt(3) * (1 + 0x1p-40);
    double cube = k->round ? ball : fmin(ball, k->a * radial + fabs(k->b) * axial);
    s->limit[n] = (sweep_limit){k->round, k->a, k->b, k->c + grow, k->ring, cube};
  }
  enclose(s, shape, piece, grow);
  return true;
}
