/* SPDX-License-Identifier: MIT */
/* geometry.h - vectors of 128-bit integers and of doubles. Oracles and tests have their own, so
 * that they share no arithmetic with what they check. */
#ifndef GEOMETRY_H
#define GEOMETRY_H

#include "sepax_models.h"

/* Coordinate 0 ... 2 of a vector. */
static inline int32_t *coordinate(sepax_vec *v, int axis) {
  return axis == 0 ? &v->x : axis == 1 ? &v->y : &v->z;
}

/* --------------------------------------------------- exact: sums and products fit */

typedef __int128 wide;

typedef struct {
  wide c[3];
} wide_vec;

static inline wide_vec wide_of(sepax_vec v) { return (wide_vec){{v.x, v.y, v.z}}; }

static inline wide_vec wide_minus(wide_vec p, wide_vec q) {
  return (wide_vec){{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

static inline wide_vec between(sepax_vec from, sepax_vec to) {
  return wide_minus(wide_of(to), wide_of(from));
}

/* From vertex k to the next. */
static inline wide_vec edge(const sepax_tri *t, int k) {
  return between(t->v[k], t->v[(k + 1) % 3]);
}

static inline wide_vec cross(wide_vec p, wide_vec q) {
  return (wide_vec){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                     p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static inline wide dot(wide_vec p, wide_vec q) {
  return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2];
}

/* True iff all of B is strictly on one side of all of A along c: the signs of nine differences. */
static inline bool separates(wide_vec c, const sepax_tri *a, const sepax_tri *b) {
  int above = 0;
  int below = 0;
  for (int i = 0; i < 9; i++) {
    wide d = dot(c, between(a->v[i / 3], b->v[i % 3]));
    above += d > 0;
    below += d < 0;
  }
  return above == 9 || below == 9;
}

/* --------------------------------------------------------------------- in doubles */

typedef struct {
  double c[3];
} point;

static inline point along(point p, double t, point u) {
  return (point){{p.c[0] + t * u.c[0], p.c[1] + t * u.c[1], p.c[2] + t * u.c[2]}};
}

static inline point minus(point p, point q) { return along(p, -1, q); }

static inline point point_of(sepax_vec v) { return (point){{v.x, v.y, v.z}}; }

static inline point outer(point p, point q) {
  return (point){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                  p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static inline double inner(point p, point q) {
  return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2];
}

#endif
