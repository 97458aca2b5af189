/* SPDX-License-Identifier: MIT */
/* locate.c - which points does a convex shape reach that goes straight on?
 *
 * In the frame, the point q is at q - t w after the part t of the way w = (x, 0, z). Each limit is
 * a convex function of that place, at most 0 inside, and changes by no more than a length for each
 * length. So the times at which one limit is kept are an interval, and q is reached if all these
 * intervals and 0 ... 1 have a time in common.
 *
 * Rounding. sweep.c has M, and why a place is within 2^-46 M of the true one. An interval computed
 * for a limit that is larger by 2^-40 M holds the true interval. For a plane the error of z is a
 * shift of the plane by as much. For a circle of radius R that a line passes at the distance y,
 * half the interval is sqrt(R^2 - y^2). With R + g instead of R and y wrong by at most d < g it
 * grows by g - d or more, because (R + g)^2 - (y + d)^2 >= R^2 - y^2 + 2 R (g - d) + (g - d)^2 if
 * y <= R. For limits without a formula, see `advance`. */
#include "stock/sweep.h"

#include <math.h>

/* As fmin and fmax, which compilers call. */
static inline double least(double a, double b) { return a < b ? a : b; }
static inline double most_of(double a, double b) { return a > b ? a : b; }

/* Times at which a limit is kept. If there are none, then the place is always `away` or more beyond
 * the limit; 0 is always true. */
typedef struct {
  double from, to, away;
} span;

static const span never = {INFINITY, -INFINITY, 0};
static const span always = {-INFINITY, INFINITY, 0};

/* How far a place is from the cylinder rho <= ring above z = a; inside, the negative of its
 * distance from the surface. `over` and `below` are its distances from the side and from the end,
 * or below 0.
 */
static inline double from_ring(double over, double below) {
  if (over <= 0 || below <= 0) {
    return most_of(over, below);
  }
  return sqrt(over * over + below * below);
}

/* The limit's function at a place: at most 0 inside, and never more than the distance outside. */
static double beyond(const sweep_limit *k, double c, double x, double y, double z) {
  double rho = k->a > 0 || k->round ? sqrt(x * x + y * y) : 0;
  if (k->round) {
    return from_ring(rho - k->ring, k->b * (k->a - z)) - c;
  }
  return k->a * rho + k->b * z - c;
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
  return step > 0 ? (span){t, INFINITY, 0} : (span){-INFINITY, t, 0};
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
  return (span){(q[0] - half) * s->inverse_x, (q[0] + half) * s->inverse_x, 0};
}

/* The limit's function after the part t of the way, and how fast it grows with t. */
static double follow(const sweep *s, const sweep_limit *k, double c, const double q[3], double t,
                     double *slope) {
  double x = q[0] - t * s->x;
  double z = q[2] - t * s->z;
  double rho = sqrt(x * x + q[1] * q[1]);
  double outward = rho > 0 ? -s->x * x / rho : 0;
  if (!k->round) {
    *slope = k->a * outward - k->b * s->z;
    return k->a * rho + k->b * z - c;
  }
  double over = rho - k->ring;
  double below = k->b * (k->a - z);
  double down = k->b * s->z;
  double from = from_ring(over, below);
  if (over <= 0 || below <= 0) {
    *slope = over > below ? outward : down;
  } else {
    *slope = (over * outward + below * down) / from;
  }
  return from - c;
}

/* Newton's steps from the time `from` in the direction of `sign`, as long as the limit is broken. A
 * convex function lies above its tangents, so it is above 0 before the zero of a tangent: no step
 * passes a time at which the limit is kept by more than 2^-40 M. For the function's values have an
 * error below 2^-45 M, and the slope one of d < 2^-49 times the length of the way; a step from t to
 * t' <= 1 passes no place where the function is less than -d |t' - t|.
 *
 * If there is no such time, the tangents also bound how far the place stays away. A tangent that
 * does not reach 0 on the way: the function is nowhere less than the tangent's end. A tangent that
 * leads up: before it, the function is not below that tangent nor below the last one, which is 0
 * here; so it is not below the value at which the two meet. */
static double advance(const sweep *s, const sweep_limit *k, double c, const double q[3],
                      double from, double sign, double *away) {
  double t = from;
  double before = INFINITY; /* how steeply the last tangent led down */
  for (int n = 0; n < 8; n++) {
    double slope;
    double value = follow(s, k, c, q, t, &slope);
    if (value <= s->close) {
      return t;
    }
    double down = -slope * sign;
    double end = sign > 0 ? 1 - t : t;
    if (!(down > 0)) {
      *away = n == 0 ? value : value * (before / (before - down));
      return sign * INFINITY;
    }
    if (value - down * end > 0) {
      *away = value - down * end;
      return sign * INFINITY;
    }
    before = down;
    t -= value / slope;
  }
  return t;
}

/* Both ends of the times at which a limit without a formula is kept. */
static span between(const sweep *s, const sweep_limit *k, double c, const double q[3]) {
  span in = never;
  in.from = advance(s, k, c, q, 0, 1, &in.away);
  if (in.from <= 1) {
    in.to = advance(s, k, c, q, 1, -1, &in.away);
  }
  return in;
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
  return (span){(along - half) * s->inverse_length, (along + half) * s->inverse_length, 0};
}

/* Within c of a ray, on a way that is not across it: in the ball at its end, or in the cylinder
 * around it. Both parts are convex and so is what they are together: where both are met, the times
 * between are met, too. */
static span in_ray(const sweep *s, const sweep_limit *k, double c, const double q[3]) {
  if (!(fabs(q[1]) <= c)) {
    return never;
  }
  const double at[3] = {q[0], q[1], k->b * (q[2] - k->a)};
  double z = k->b * s->z;
  span ball = in_ball(s, at, z, c);
  span tube = in_cylinder(s, q, c);
  span above = below_plane(-at[2], -z);
  tube = (span){most_of(tube.from, above.from), least(tube.to, above.to), 0};
  if (!(tube.from <= tube.to)) {
    return ball;
  }
  return (span){least(ball.from, tube.from), most_of(ball.to, tube.to), 0};
}

/* Within c of the cylinder rho <= ring above z = a, or, if c is below 0, -c deep in it. */
static span in_round(const sweep *s, const sweep_limit *k, double c, const double q[3]) {
  double apart = fabs(q[1]) - k->ring - c;
  if (!(apart <= 0)) {
    return (span){INFINITY, -INFINITY, apart};
  }
  if (s->z == 0) {
    double below = k->b * (k->a - q[2]);
    if (!(below <= c)) {
      return (span){INFINITY, -INFINITY, below - c};
    }
    return in_cylinder(s, q, k->ring + (below > 0 ? sqrt((c - below) * (c + below)) : c));
  }
  return k->ring == 0 ? in_ray(s, k, c, q) : between(s, k, c, q);
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
  return between(s, k, c, q);
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
  return in.away;
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
