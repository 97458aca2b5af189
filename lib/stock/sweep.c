/* SPDX-License-Identifier: MIT */
/* sweep.c - a convex shape that goes straight on: which points does it reach?
 *
 * In the frame, the point q is at q - t w after the part t of the way w = (x, 0, z). Each limit is
 * a convex function of that place, at most 0 inside, and changes by no more than a length for each
 * length. So the times at which one limit is kept are an interval, and q is reached if all these
 * intervals and 0 ... 1 have a time in common.
 *
 * Rounding. Let M be the sum of the greatest coordinates of points and poses, the length of the way
 * and the reach of the shape. A computed place q - t w is within 2^-46 M of the true one: the
 * difference and the three products of sweep_point have an error below 16 * 2^-53 M, the entries of
 * the frame are true within 2^-50. sepax__sweep_make adds 2^-40 M to every limit, the parts of the
 * way that the frame drops, and 8 n reach for a matrix R whose R^T R differs from the identity by
 * n: R = Q S with a rotation Q and |S - 1| <= 3 n, so that R and the rotation Q put a point no
 * farther than 3 n |q| apart, and their axes differ by less than 3.5 n.
 *
 * An interval computed for a limit that is larger by 2^-40 M holds the true interval. For a plane
 * the error of z is a shift of the plane by as much. For a circle of radius R that a line passes at
 * the distance y, half the interval is sqrt(R^2 - y^2). With R + g instead of R and y wrong by at
 * most d < g it grows by g - d or more, because (R + g)^2 - (y + d)^2 >= R^2 - y^2 + 2 R (g - d) +
 * (g - d)^2 if y <= R. For a cone, see `advance`. */
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
    s->limit[n] = (sweep_limit){k->round, k->a, k->b, k->c + grow, cube};
  }
  enclose(s, shape, piece, grow);
  return true;
}

/* ------------------------------------------------------------------ asking */

/* As fmin and fmax, which compilers call. */
static inline double least(double a, double b) { return a < b ? a : b; }
static inline double most_of(double a, double b) { return a > b ? a : b; }

typedef struct {
  double from, to; /* times at which a limit is kept */
} span;

static const span never = {INFINITY, -INFINITY};
static const span always = {-INFINITY, INFINITY};

/* The limit's function at a place: at most 0 inside, and never more than the distance outside. */
static double beyond(const sweep_limit *k, double c, double x, double y, double z) {
  if (k->round) {
    double below = least(0, k->b * (z - k->a));
    return sqrt(x * x + y * y + below * below) - c;
  }
  return (k->a > 0 ? k->a * sqrt(x * x + y * y) : 0) + k->b * z - c;
}

static double beyond_at(const sweep *s, const sweep_limit *k, double c, const double q[3],
                        double t) {
  return beyond(k, c, q[0] - t * s->x, q[1], q[2] - t * s->z);
}

/* Times at which z - t step <= 0. */
static span below_plane(double z, double step) {
  if (step == 0) {
    return z <= 0 ? always : never;
  }
  double t = z / step;
  return step > 0 ? (span){t, INFINITY} : (span){-INFINITY, t};
}

/* Times at which the place is in the cylinder of the radius. */
static span in_cylinder(const sweep *s, const double q[3], double radius) {
  double y = fabs(q[1]);
  if (!(y <= radius)) {
    return never;
  }
  double half = sqrt((radius - y) * (radius + y));
  if (s->x == 0) {
    return fabs(q[0]) <= half ? always : never;
  }
  return (span){(q[0] - half) * s->inverse_x, (q[0] + half) * s->inverse_x};
}

/* Newton's steps from the time `from` in the direction of `sign`, as long as the limit of a cone is
 * broken. A convex function lies above its tangents, so it is above 0 before the zero of a tangent:
 * no step passes a time at which the limit is kept by more than the error of the function's values,
 * which the limit's 2^-40 M covers. */
static double advance(const sweep *s, const sweep_limit *k, double c, const double q[3],
                      double from, double sign) {
  double t = from;
  for (int n = 0; n < 8; n++) {
    double x = q[0] - t * s->x;
    double rho = sqrt(x * x + q[1] * q[1]);
    double value = k->a * rho + k->b * (q[2] - t * s->z) - c;
    if (value <= s->close) {
      return t;
    }
    double slope = (rho > 0 ? -k->a * s->x * x / rho : 0) - k->b * s->z;
    if (!(slope * sign < 0)) {
      return sign * INFINITY; /* it only grows */
    }
    t -= value / slope;
    if (!(t >= 0 && t <= 1)) {
      return sign * INFINITY;
    }
  }
  return t;
}

/* Times at which the place is in a ball around (0, 0, 0); q is counted from there, and the way has
 * the part z along the axis. */
static span in_ball(const sweep *s, const double q[3], double z, double radius) {
  double m = (q[0] * z - q[2] * s->x) * s->inverse_length;
  double off = sqrt(q[1] * q[1] + m * m);
  if (!(off <= radius)) {
    return never;
  }
  double half = sqrt((radius - off) * (radius + off));
  double along = (q[0] * s->x + q[2] * z) * s->inverse_length;
  return (span){(along - half) * s->inverse_length, (along + half) * s->inverse_length};
}

/* Within c of a ray: in the ball at its end, or in the cylinder around it. Both parts are convex
 * and so is what they are together: where both are met, the times between are met, too. */
static span in_round(const sweep *s, const sweep_limit *k, double c, const double q[3]) {
  if (!(fabs(q[1]) <= c)) {
    return never;
  }
  const double at[3] = {q[0], q[1], k->b * (q[2] - k->a)};
  double z = k->b * s->z;
  if (z == 0) {
    double below = least(0, at[2]);
    return -below <= c ? in_cylinder(s, q, sqrt((c - below) * (c + below))) : never;
  }
  span ball = in_ball(s, at, z, c);
  span tube = in_cylinder(s, q, c);
  span above = below_plane(-at[2], -z);
  tube = (span){most_of(tube.from, above.from), least(tube.to, above.to)};
  if (!(tube.from <= tube.to)) {
    return ball;
  }
  return (span){least(ball.from, tube.from), most_of(ball.to, tube.to)};
}

static span kept(const sweep *s, const sweep_limit *k, double c, const double q[3]) {
  if (k->round) {
    return in_round(s, k, c, q);
  }
  if (k->a == 0) {
    return below_plane(k->b * q[2] - c, k->b * s->z);
  }
  if (k->b == 0 || s->z == 0) {
    return in_cylinder(s, q, (c - k->b * q[2]) / k->a);
  }
  return (span){advance(s, k, c, q, 0, 1), advance(s, k, c, q, 1, -1)};
}

/* A distance from the sweep, or 0, by a limit that is not kept in 0 ... 1. A convex function is
 * least at the end of the way that is nearer to its span. Where it has no span, the place nearest
 * to the axis is the best one if z does not matter. */
static double distance_of(const sweep *s, const sweep_limit *k, double c, const double q[3],
                          span in) {
  if (in.from <= in.to) {
    return in.from > 1 ? beyond_at(s, k, c, q, 1) : in.to < 0 ? beyond_at(s, k, c, q, 0) : 0;
  }
  if (s->z == 0 || (k->b == 0 && !k->round)) {
    double t = s->x == 0 ? 0 : least(1, most_of(0, q[0] * s->inverse_x));
    return beyond_at(s, k, c, q, t);
  }
  return k->round ? fabs(q[1]) - c : 0;
}

sweep_side sepax__sweep_locate(const sweep *s, const double q[3], double half, double *reach) {
  double from = 0;
  double to = 1;
  for (int n = 0; n < s->count; n++) {
    const sweep_limit *k = &s->limit[n];
    span in = kept(s, k, k->c + half * k->cube, q);
    from = most_of(from, in.from);
    to = least(to, in.to);
    if (!(from <= to)) {
      *reach = most_of(0, distance_of(s, k, k->c + half * k->cube, q, in));
      return SWEEP_OUTSIDE;
    }
  }
  double t = from / 2 + to / 2;
  double depth = INFINITY;
  for (int n = 0; n < s->count; n++) {
    const sweep_limit *k = &s->limit[n];
    depth = least(depth, -beyond_at(s, k, k->c + half * k->cube, q, t));
  }
  *reach = most_of(depth, 0);
  return depth >= 0 ? SWEEP_INSIDE : SWEEP_BORDER;
}
