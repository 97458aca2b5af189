/* SPDX-License-Identifier: MIT */
/* wide.h - tests of bounds on rounding errors: numbers that are wide enough to be exact beside
 * doubles, a search for inputs whose error is large, and geometry in these numbers.
 *
 * A test computes how much of a bound an error takes: 1 is all of it. The search changes inputs so
 * that the part grows. The test fails if the part is more than 1, because the bound is wrong then,
 * and if it stays small, because the test would not see a bound that is wrong. */
#ifndef WIDE_H
#define WIDE_H

#include "harness.h"
#include "sepax.h"

#include <math.h>
#include <string.h>

/* 113 bits: 60 more than a double has. cppcheck does not know the size of __float128. */
#if defined __SIZEOF_FLOAT128__ && !defined __cppcheck__
typedef __float128 wide;
#else
typedef long double wide;
#endif

typedef wide wide_point[3];

/* ----------------------------------------------------------------------- numbers */

static inline wide wide_size(wide x) { return x < 0 ? -x : x; }
static inline wide wide_least(wide p, wide q) { return q < p ? q : p; }
static inline wide wide_most(wide p, wide q) { return q > p ? q : p; }

static inline wide wide_root(wide x) {
  if (!(x > 0)) {
    return 0;
  }
  wide r = (wide)sqrt((double)x);
  r = (r + x / r) / 2;
  return (r + x / r) / 2;
}

static inline wide wide_dot(const wide p[3], const wide q[3]) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

static inline wide wide_length(const wide p[3]) { return wide_root(wide_dot(p, p)); }

static inline void wide_cross(const wide p[3], const wide q[3], wide r[3]) {
  r[0] = p[1] * q[2] - p[2] * q[1];
  r[1] = p[2] * q[0] - p[0] * q[2];
  r[2] = p[0] * q[1] - p[1] * q[0];
}

static inline void wide_minus(const wide p[3], const wide q[3], wide r[3]) {
  for (int i = 0; i < 3; i++) {
    r[i] = p[i] - q[i];
  }
}

static inline wide wide_gap(const wide p[3], const wide q[3]) {
  wide_point way;
  wide_minus(q, p, way);
  return wide_length(way);
}

/* to = R v + t; t may be NULL */
static inline void wide_move(const double r[3][3], const wide v[3], const double t[3], wide to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = r[i][0] * v[0] + r[i][1] * v[1] + r[i][2] * v[2] + (t != NULL ? (wide)t[i] : 0);
  }
}

static inline void wide_of(const double v[3], wide to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = v[i];
  }
}

/* The numbers u with sum of u[k] axis[k] = v. */
static inline void wide_solve(const wide axis[3][3], const wide v[3], wide u[3]) {
  for (int k = 0; k < 3; k++) {
    wide_point normal;
    wide_cross(axis[(k + 1) % 3], axis[(k + 2) % 3], normal);
    u[k] = wide_dot(normal, v) / wide_dot(normal, axis[k]);
  }
}

/* ---------------------------------------------------------------------- geometry */

/* A box: centre + sum of u[i] axis[i], |u[i]| <= half[i]. */
typedef struct {
  wide centre[3], axis[3][3], half[3];
} wide_box;

/* The distance of a point from a point of the box, the nearest one if the axes are at right
 * angles. */
static inline wide wide_box_reach(const wide_box *b, const wide p[3]) {
  wide_point d;
  wide_point u;
  wide_point at;
  wide_minus(p, b->centre, d);
  wide_solve((const wide(*)[3])b->axis, d, u);
  memcpy(at, b->centre, sizeof at);
  for (int k = 0; k < 3; k++) {
    wide t = wide_most(-b->half[k], wide_least(b->half[k], u[k]));
    for (int i = 0; i < 3; i++) {
      at[i] += t * b->axis[k][i];
    }
  }
  return wide_gap(at, p);
}

static inline void wide_corner(const wide_box *b, int number, wide to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = b->centre[i];
    for (int k = 0; k < 3; k++) {
      to[i] += (number >> k & 1) != 0 ? b->half[k] * b->axis[k][i] : -b->half[k] * b->axis[k][i];
    }
  }
}

/* The distance of two points of two boxes, the nearest ones where one of them is a corner and axes
 * are at right angles. */
static inline wide wide_boxes_reach(const wide_box *p, const wide_box *q) {
  wide least = INFINITY;
  for (int number = 0; number < 8; number++) {
    wide_point at;
    wide_corner(p, number, at);
    least = wide_least(least, wide_box_reach(q, at));
    wide_corner(q, number, at);
    least = wide_least(least, wide_box_reach(p, at));
  }
  return least;
}

static inline wide wide_within(wide t) { return t > 0 ? (t < 1 ? t : 1) : 0; }

/* The distance of a point from an edge. */
static inline wide wide_edge_reach(const wide p[3], const wide a[3], const wide b[3]) {
  wide_point e;
  wide_point d;
  wide_point at;
  wide_minus(b, a, e);
  wide_minus(p, a, d);
  wide square = wide_dot(e, e);
  wide t = square > 0 ? wide_within(wide_dot(d, e) / square) : 0;
  for (int i = 0; i < 3; i++) {
    at[i] = a[i] + t * e[i];
  }
  return wide_gap(at, p);
}

/* The distance of a point from a triangle. */
static inline wide wide_triangle_reach(const wide p[3], const wide v[3][3]) {
  wide_point e;
  wide_point f;
  wide_point d;
  wide_point n;
  wide_point area;
  wide least = INFINITY;
  wide_minus(v[1], v[0], e);
  wide_minus(v[2], v[0], f);
  wide_minus(p, v[0], d);
  wide_cross(e, f, n);
  wide square = wide_dot(n, n);
  for (int k = 0; k < 3; k++) {
    least = wide_least(least, wide_edge_reach(p, v[k], v[(k + 1) % 3]));
  }
  wide_cross(e, d, area);
  wide t = wide_dot(area, n);
  wide_cross(d, f, area);
  wide s = wide_dot(area, n);
  if (square > 0 && s >= 0 && t >= 0 && s + t <= square) {
    least = wide_least(least, wide_size(wide_dot(d, n)) / wide_root(square));
  }
  return least;
}

/* The distance of two points of two edges, the nearest ones if these are inside both. */
static inline wide wide_edges_reach(const wide a[3], const wide b[3], const wide c[3],
                                    const wide d[3]) {
  wide_point u;
  wide_point v;
  wide_point w;
  wide_minus(b, a, u);
  wide_minus(d, c, v);
  wide_minus(c, a, w);
  wide uu = wide_dot(u, u);
  wide vv = wide_dot(v, v);
  wide uv = wide_dot(u, v);
  wide area = uu * vv - uv * uv;
  if (!(area > 0x1p-80 * uu * vv)) {
    return INFINITY;
  }
  wide s = wide_within((wide_dot(w, u) * vv - uv * wide_dot(w, v)) / area);
  wide t = wide_within((wide_dot(w, u) * uv - uu * wide_dot(w, v)) / area);
  for (int i = 0; i < 3; i++) {
    w[i] += t * v[i] - s * u[i];
  }
  return wide_length(w);
}

/* The distance of two triangles that do not meet. */
static inline wide wide_triangles_reach(const wide a[3][3], const wide b[3][3]) {
  wide least = INFINITY;
  for (int k = 0; k < 3; k++) {
    least = wide_least(least, wide_triangle_reach(a[k], b));
    least = wide_least(least, wide_triangle_reach(b[k], a));
    for (int j = 0; j < 3; j++) {
      least = wide_least(least, wide_edges_reach(a[k], a[(k + 1) % 3], b[j], b[(j + 1) % 3]));
    }
  }
  return least;
}

/* ------------------------------------------------------------------------- poses */

/* The rotation of four numbers, changed by up to `skew` in the entries of R R^T - 1, by the pattern
 * of nine numbers. */
static inline void skewed_rotation(const double q[4], const double change[9], double skew,
                                   double r[3][3]) {
  double n = 2 / (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] + 0x1p-100);
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    r[i][i] = 1 - n * (q[1 + j] * q[1 + j] + q[1 + k] * q[1 + k]);
    r[i][j] = n * (q[1 + i] * q[1 + j] - q[0] * q[1 + k]);
    r[i][k] = n * (q[1 + i] * q[1 + k] + q[0] * q[1 + j]);
  }
  if (skew > 0) { /* (1 + S) R with a symmetric S: R R^T = 1 + 2 S + ... */
    double s[3][3];
    double most = 0;
    for (int k = 0; k < 9; k++) {
      s[k / 3][k % 3] = change[k / 3] + change[k % 3] > 0 ? 1 : change[k / 3 + k % 3 + 3];
      s[k / 3][k % 3] = k / 3 <= k % 3 ? s[k / 3][k % 3] : s[k % 3][k / 3];
      most = fmax(most, fabs(s[k / 3][k % 3]));
    }
    double old[3][3];
    memcpy(old, r, sizeof old);
    for (int k = 0; k < 9; k++) {
      for (int j = 0; j < 3; j++) {
        r[k / 3][k % 3] += 0.4999 * skew * s[k / 3][j] / most * old[j][k % 3];
      }
    }
  }
}

/* ------------------------------------------------------------------------ search */

/* The part of a bound that the error takes for inputs x, within -1 ... 1; below 0 if the inputs are
 * not to be looked at. */
typedef double part_of_bound(const double *x);

enum { INPUTS = 64 };

static inline double changed(double x) {
  switch (random_below(8)) {
  case 0:
    return random_unit();
  case 1:
    return -x;
  case 2:
    return copysign(ldexp(1, -random_below(4)), x) * (1 - random_below(2) * 0x1p-53);
  case 3:
  case 4:
    return fmax(-1, fmin(1, stepped(x, random_below(9) - 4)));
  default:
    return fmax(-1, fmin(1, x + ldexp(random_unit(), -random_below(54))));
  }
}

/* The largest part that is found from so many starts in so many steps each. */
static inline double most_of_bound(part_of_bound *part, int inputs, int starts, int steps) {
  double most = -INFINITY;
  for (int start = 0; start < starts; start++) {
    double x[INPUTS];
    double y[INPUTS];
    for (int k = 0; k < inputs; k++) {
      x[k] = random_unit();
    }
    double now = part(x);
    for (int step = 0; step < FEWER(steps); step++) {
      memcpy(y, x, sizeof y);
      for (int n = 1 + random_below(3); n > 0; n--) {
        double *at = &y[random_below(inputs)];
        *at = changed(*at);
      }
      double then = part(y);
      if (then >= now) {
        now = then;
        memcpy(x, y, sizeof x);
      }
    }
    most = fmax(most, now);
  }
  return most;
}

/* The part is at most 1, and at least what the search is known to reach: a bound that is smaller by
 * 1 / reached is seen. */
static inline void assert_part(const char *bound, double part, double reached) {
  print_message("%s: %.4f of the bound\n", bound, part);
  if (!(part <= 1)) {
    fail_msg("%s is wrong: an error takes %.4f of it", bound, part);
  }
  if (FEWER_BY == 1 && !(part >= reached)) {
    fail_msg("%s: errors of %.4f of it are found, but not of %.4f", bound, part, reached);
  }
}

#endif
