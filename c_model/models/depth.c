/* SPDX-License-Identifier: MIT */
/* depth.c - the depth of a collision, or the distance of separated triangles. */
#include "sepax_models.h"
#include "util/wide.h"

#include <math.h>

typedef struct {
  double c[3];
} real;

static real of(sepax_vec v) { return (real){{v.x, v.y, v.z}}; }

static real minus(real p, real q) {
  return (real){{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

static real step(real p, double t, real d) {
  return (real){{p.c[0] + t * d.c[0], p.c[1] + t * d.c[1], p.c[2] + t * d.c[2]}};
}

static double inner(real p, real q) { return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2]; }

static real outer(real p, real q) {
  return (real){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                 p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static double clamp(double t) { return t < 0 ? 0 : t > 1 ? 1 : t; }

static double to_segment(real p, real a, real b) {
  real d = minus(b, a);
  double square = inner(d, d);
  double t = square > 0 ? clamp(inner(minus(p, a), d) / square) : 0;
  real gap = minus(p, step(a, t, d));
  return sqrt(inner(gap, gap));
}

/* The distance of two segments. It lies between an end and the other segment, or between inner
 * points. */
static double between_segments(real a, real b, real c, real d) {
  double least = fmin(fmin(to_segment(a, c, d), to_segment(b, c, d)),
                      fmin(to_segment(c, a, b), to_segment(d, a, b)));
  real u = minus(b, a);
  real v = minus(d, c);
  real w = minus(a, c);
  double uu = inner(u, u);
  double uv = inner(u, v);
  double vv = inner(v, v);
  double area = uu * vv - uv * uv;
  if (area > 0) {
    double s = (uv * inner(v, w) - vv * inner(u, w)) / area;
    double t = (uu * inner(v, w) - uv * inner(u, w)) / area;
    if (s > 0 && s < 1 && t > 0 && t < 1) {
      real gap = minus(step(a, s, u), step(c, t, v));
      least = fmin(least, sqrt(inner(gap, gap)));
    }
  }
  return least;
}

/* The distance from a point to the inside of a triangle; infinite if the foot of the perpendicular
 * is not inside. */
static double to_face(real p, const real t[3]) {
  real n = outer(minus(t[1], t[0]), minus(t[2], t[0]));
  double length = sqrt(inner(n, n));
  if (!(length > 0)) {
    return INFINITY;
  }
  for (int i = 0; i < 3; i++) {
    if (inner(outer(minus(t[(i + 1) % 3], t[i]), minus(p, t[i])), n) < 0) {
      return INFINITY;
    }
  }
  return fabs(inner(minus(p, t[0]), n)) / length;
}

static double distance(const sepax_tri *a, const sepax_tri *b) {
  real p[6];
  double least = INFINITY;
  for (int i = 0; i < 6; i++) {
    p[i] = of(i < 3 ? a->v[i] : b->v[i - 3]);
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      least = fmin(least, between_segments(p[i], p[(i + 1) % 3], p[3 + j], p[3 + (j + 1) % 3]));
    }
    least = fmin(least, fmin(to_face(p[i], p + 3), to_face(p[3 + i], p)));
  }
  return least;
}

/* The length, in LSB, of the shorter of the two translations along an axis that separate the
 * triangles. */
static double overlap(wide_vec n, const wide_vec p[6]) {
  wide low[2] = {0, 0};
  wide high[2] = {0, 0};
  for (int i = 0; i < 6; i++) {
    wide at = wide_dot(n, p[i]);
    int t = i / 3;
    low[t] = i % 3 == 0 || at < low[t] ? at : low[t];
    high[t] = i % 3 == 0 || at > high[t] ? at : high[t];
  }
  wide shorter = high[0] - low[1] < high[1] - low[0] ? high[0] - low[1] : high[1] - low[0];
  double x = (double)n.c[0];
  double y = (double)n.c[1];
  double z = (double)n.c[2];
  return (double)shorter / sqrt(x * x + y * y + z * z);
}

static double penetration(const sepax_tri *a, const sepax_tri *b) {
  wide_vec p[6];
  wide_vec edge[6];
  for (int i = 0; i < 6; i++) {
    p[i] = wide_from(i < 3 ? a->v[i] : b->v[i - 3]);
  }
  for (int i = 0; i < 6; i++) {
    edge[i] = wide_sub(p[i / 3 * 3 + (i + 1) % 3], p[i]);
  }
  double least = INFINITY;
  for (int i = 0; i < 5; i++) {
    for (int j = i + 1; j < 6; j++) {
      wide_vec n = wide_cross(edge[i], edge[j]);
      if (!wide_is_zero(n)) {
        least = fmin(least, overlap(n, p));
      }
    }
  }
  return isinf(least) ? 0 : least;
}

double sepax_depth(const sepax_tri *a, const sepax_tri *b) {
  return sepax_exact(a, b).collision ? penetration(a, b) : -distance(a, b);
}
