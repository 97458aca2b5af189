/* SPDX-License-Identifier: MIT */
/* bounds_fit.c - the margins of the boxes of body/fit.c, and the axes of body_frame. */
#define sepax__body_fit body_fit_of_test
#include "body/fit.c" /* NOLINT(bugprone-suspicious-include): its functions are static */

#include "wide.h"

enum { TRIANGLES = 4, FIT_INPUTS = 9 * TRIANGLES + 6 };

/* ------------------------------------------------------------------------ frames */

/* Triangles of a body with a centre and scale 1. Some are small, flat, or slivers. */
static uint32_t body_of(const double *x, sepax_body *b, facet_points v[TRIANGLES]) {
  uint32_t count = 1 + (uint32_t)(fabs(x[0]) * (TRIANGLES - 0.1));
  *b = (sepax_body){.count = count, .scale = 1, .triangle = v};
  double size = x[1] > 0 ? ldexp(1, (int)(-40 * x[1])) : 1;
  for (int i = 0; i < 3; i++) {
    b->centre[i] = x[3 + i];
  }
  for (uint32_t k = 0; k < 9 * count; k++) {
    double at = size < 1 ? copysign(1 - size, x[6 + k % 3]) + size * x[6 + k] : x[6 + k];
    at = fmax(-1, fmin(1, x[2] > 0.5 && k % 3 == 2 ? 0x1p-52 * at : at));
    v[k / 9][k / 3 % 3][k % 3] = b->centre[k % 3] + at; /* rounded */
    if (!(fabs(v[k / 9][k / 3 % 3][k % 3] - b->centre[k % 3]) <= 1)) {
      v[k / 9][k / 3 % 3][k % 3] = b->centre[k % 3];
    }
  }
  return count;
}

/* Fit the box of a node around them. */
static bool fit_body(const double *x, sepax_body *b, facet_points v[TRIANGLES], body_frame *f) {
  uint32_t count = body_of(x, b, v);
  facet_points *local = local_triangles(b);
  moments all = {0};
  if (local == NULL) {
    return false;
  }
  for (uint32_t n = 0; n < count; n++) {
    add_triangle(&all, local[n]);
  }
  fit(local, count, &all, x[FIT_INPUTS - 1] > 0 ? INFINITY : 0.5, f);
  sepax_release(local);
  return true;
}

/* Vertices are in the box without LEAST, but for errors. */
static double box_error(const double *x) {
  sepax_body b;
  facet_points v[TRIANGLES] = {{{0}}};
  body_frame f;
  wide axis[3][3];
  wide most = -INFINITY;
  if (!fit_body(x, &b, v, &f)) {
    return -1;
  }
  for (int k = 0; k < 3; k++) {
    wide_of(f.axis[k], axis[k]);
  }
  for (size_t n = 0; n < 3 * b.count; n++) {
    wide_point d;
    wide_point u;
    for (int i = 0; i < 3; i++) {
      d[i] = v[n / 3][n % 3][i] - (wide)b.centre[i] - f.centre[i];
    }
    wide_solve((const wide(*)[3])axis, d, u);
    for (int i = 0; i < 3; i++) {
      most = wide_most(most, wide_size(u[i]) - f.half[i]);
    }
  }
  return (double)(most / 0x1p-46) + 1;
}

static double off_axes(const double axis[3][3]) {
  wide most = 0;
  for (int k = 0; k < 9; k++) {
    wide_point p;
    wide_point q;
    wide_of(axis[k / 3], p);
    wide_of(axis[k % 3], q);
    most = wide_most(most, wide_size(wide_dot(p, q) - (k / 3 == k % 3)));
  }
  return (double)most;
}

static double axes_error(const double *x) {
  sepax_body b;
  facet_points v[TRIANGLES] = {{{0}}};
  body_frame f;
  return fit_body(x, &b, v, &f) ? off_axes((const double(*)[3])f.axis) / 0x1p-48 : -1;
}

CASE(boxes_in_doubles) {
  assert_part("LEAST of a box", most_of_bound(box_error, FIT_INPUTS, 8, 10000), 0.08);
  assert_part("2^-48 of axes", most_of_bound(axes_error, FIT_INPUTS, 8, 10000), 0.2);
}

/* ------------------------------------------------- boxes in single precision */

static void exact_axes(const oriented *r, double axis[3][3]) {
  for (int k = 0; k < 9; k++) {
    axis[k / 3][k % 3] = (double)r->axis[k / 3][k % 3];
  }
}

/* How far a point is out of a rounded box, at most of three axes. */
static wide out_of(const oriented *r, const wide p[3]) {
  double axis[3][3];
  wide exact[3][3];
  wide_point d;
  wide_point u;
  wide most = -INFINITY;
  exact_axes(r, axis);
  for (int k = 0; k < 3; k++) {
    wide_of(axis[k], exact[k]);
    d[k] = p[k] - (double)r->centre[k];
  }
  wide_solve((const wide(*)[3])exact, d, u);
  for (int k = 0; k < 3; k++) {
    most = wide_most(most, wide_size(u[k]) - (double)r->half[k]);
  }
  return most;
}

/* A box in doubles is in the rounded one, even if all but 2^-20 of MORE is taken off. */
static double rounded_error(const double *x) {
  body_frame f;
  oriented r;
  wide_box box = {{0}, {{0}}, {0}};
  skewed_rotation(x, x, 0, f.axis);
  for (int i = 0; i < 3; i++) {
    f.centre[i] = x[4 + i];
    f.half[i] = fabs(x[7 + i]) * ldexp(1, -(int)(20 * fabs(x[10 + i]))) + 0x1p-48;
  }
  round_box(&f, &r);
  wide sum = 0;
  for (int i = 0; i < 3; i++) {
    wide_of(f.axis[i], box.axis[i]);
    box.centre[i] = f.centre[i];
    box.half[i] = f.half[i];
    sum += (double)r.half[i];
  }
  sum /= 1 + 3 * 0x1p-15;
  wide most = -INFINITY;
  for (int number = 0; number < 8; number++) {
    wide_point at;
    wide_corner(&box, number, at);
    most = wide_most(most, out_of(&r, at));
  }
  return (double)((most + 0x1p-15 * sum) / (0x1p-20 * sum));
}

CASE(boxes_in_single_precision) {
  assert_part("2^-20 of a rounded box", most_of_bound(rounded_error, 13, 8, 6000), 0.03);
}

/* ----------------------------------------------------------------------- slivers */

/* Three points on a line, but for rounding, so that the normal of the triangle is all error. */
static double sliver_error(const double *x) {
  facet_points v;
  oriented r;
  axes a;
  for (int i = 0; i < 3; i++) {
    double from = x[i];
    double step = x[3 + i];
    from = x[6] > 0 ? 0 : from;
    step = x[7] > 0 ? round(16 * step) / 16 : step;
    v[0][i] = from;
    v[1][i] = from + step;
    v[2][i] = from + step * x[8];
  }
  fit_triangle(&v, &r);
  axes_of_triangle(v, a);
  wide sum = (wide)0 + (double)r.half[0] + (double)r.half[1] + (double)r.half[2];
  wide out = -INFINITY;
  for (int k = 0; k < 3; k++) {
    wide_point at;
    wide_of(v[k], at);
    out = wide_most(out, out_of(&r, at));
  }
  return fmax(off_axes((const double(*)[3])a) / 0x1p-22,
              (double)((out + 0x1p-15 * sum) / (0x1p-20 * sum)));
}

CASE(axes_of_slivers) {
  double most = most_of_bound(sliver_error, 9, 200, 1000);
  assert_part("2^-22 of the axes of a sliver", most, 0);
}
