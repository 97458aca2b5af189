/* SPDX-License-Identifier: MIT */
/* points.h - integer geometry of the families of hard pairs (private). */
#ifndef SEPAX_POINTS_H
#define SEPAX_POINTS_H

#include "util/wide.h"

typedef struct {
  int64_t c[3];
} point;

typedef struct {
  point v[3];
} triangle;

/* Two vectors that are not parallel. */
typedef struct {
  point u, v;
} basis;

static inline point sum(point p, point q) {
  return (point){{p.c[0] + q.c[0], p.c[1] + q.c[1], p.c[2] + q.c[2]}};
}

static inline point times(point p, int64_t k) {
  return (point){{p.c[0] * k, p.c[1] * k, p.c[2] * k}};
}

static inline point combine(const basis *b, int64_t i, int64_t j) {
  return sum(times(b->u, i), times(b->v, j));
}

static inline point unit(int64_t axis) { return (point){{axis == 0, axis == 1, axis == 2}}; }

static inline void move(triangle *t, point by) {
  for (int k = 0; k < 3; k++) {
    t->v[k] = sum(t->v[k], by);
  }
}

static inline void exchange(point *p, point *q) {
  point kept = *p;
  *p = *q;
  *q = kept;
}

static inline wide_vec cross(point p, point q) {
  wide_vec n;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    n.c[i] = (wide)p.c[j] * q.c[k] - (wide)p.c[k] * q.c[j];
  }
  return n;
}

static inline wide_vec normal_of(const triangle *t) {
  return cross(sum(t->v[1], times(t->v[0], -1)), sum(t->v[2], times(t->v[0], -1)));
}

static inline wide dot(wide_vec n, point p) {
  return n.c[0] * p.c[0] + n.c[1] * p.c[1] + n.c[2] * p.c[2];
}

static inline bool parallel(point p, point q) { return wide_is_zero(cross(p, q)); }

/* The image of p under symmetry 0 ... 47 of the cube. */
static inline point symmetric(point p, int64_t number) {
  static const int axes[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}};
  point image;
  for (int i = 0; i < 3; i++) {
    int64_t value = p.c[axes[number / 8][i]];
    image.c[i] = (number >> i & 1) != 0 ? -value : value;
  }
  return image;
}

/* p or -p, whichever is on the side of the plane through the origin. */
static inline point on_side(point p, wide_vec n, int side) {
  return dot(n, p) * side < 0 ? times(p, -1) : p;
}

static inline bool in_plane(const triangle *t, wide_vec n, wide level) {
  return dot(n, t->v[0]) == level && dot(n, t->v[1]) == level && dot(n, t->v[2]) == level;
}

static inline sepax_tri to_tri(const triangle *t) {
  sepax_tri tri;
  for (int k = 0; k < 3; k++) {
    const int64_t *c = t->v[k].c;
    tri.v[k] = (sepax_vec){(int32_t)c[0], (int32_t)c[1], (int32_t)c[2]};
  }
  return tri;
}

/* ------------------------------------------------------------ lattice planes */

/* The points i u + j v of a plane, |i|, |j| <= steps. */
typedef struct {
  basis b;
  int64_t steps;
} lattice;

typedef struct {
  int64_t i, j;
} flat;

static inline point lifted(const lattice *l, flat f) { return combine(&l->b, f.i, f.j); }

static inline int64_t lattice_reach(const lattice *l) {
  int64_t most = 0;
  for (int i = 0; i < 3; i++) {
    int64_t u = l->b.u.c[i] < 0 ? -l->b.u.c[i] : l->b.u.c[i];
    int64_t v = l->b.v.c[i] < 0 ? -l->b.v.c[i] : l->b.v.c[i];
    most = u + v > most ? u + v : most;
  }
  return most * l->steps;
}

static inline wide flat_area(flat f, flat g) { return (wide)f.i * g.j - (wide)f.j * g.i; }

#endif
