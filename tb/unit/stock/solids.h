/* SPDX-License-Identifier: MIT */
/* solids.h - profiles of the tests of the stock, and how deep a point is in their solid, in long
 * double and without limits, cells or pieces. */
#ifndef SOLIDS_H
#define SOLIDS_H

#include "harness.h"
#include "stock/stock.h"
#include "unit/body/draws.h"

typedef struct {
  sepax__stock_corner corner[8];
  size_t count;
} profile;

/* Ball, bull nose, flat, drill, ball on a cone, cutter of slots, whole ball, frustum. */
static inline profile draw_profile(int kind) {
  double r = 1 + fabs(random_unit());
  double l = 4 * r;
  double c = 0.2 + 0.3 * fabs(random_unit());
  const profile all[8] = {
      {{{0, 0, 0}, {r, 0, r}, {r, l, 0}, {0, l, 0}}, 4},
      {{{0, 0, 0}, {r, 0, c}, {r, l, 0}, {0, l, 0}}, 4},
      {{{0, 0, 0}, {r, 0, 0}, {r, l, 0}, {0, l, 0}}, 4},
      {{{0, 0, 0}, {r, 0.6 * r, 0}, {r, l, 0}, {0, l, 0}}, 4},
      {{{0, 0, 0}, {0.5 * r, 0, c}, {r, l, 0}, {0, l, 0}}, 4},
      {{{0, 0, 0}, {r, 0, c}, {r, 1, 0.2}, {0, 1, 0}}, 4},
      {{{0, 0, 0}, {r, 0, r}, {r, 2 * r, r}, {0, 2 * r, 0}}, 4},
      {{{0, -1, 0}, {2 * r, -1, 0}, {r, 1, 0}, {0, 1, 0}}, 4},
  };
  return all[kind % 8];
}

/* How far the place (rho, z) is beyond the solid's surface along the worst normal; at most 0
 * inside, where its negative is the depth. A convex function. */
static inline long double beyond_solid(const profile *p, long double rho, long double z) {
  long double most = -INFINITY;
  long double a[2] = {0, 0};
  long double b[2] = {0, 0};
  for (size_t n = 0; n + 1 < p->count; n++) {
    const sepax__stock_corner *k = &p->corner[n];
    long double dr = (long double)k[1].r - k->r;
    long double dz = (long double)k[1].z - k->z;
    long double length = sqrtl(dr * dr + dz * dz);
    a[1] = dz / length;
    b[1] = -dr / length;
    most = fmaxl(most, a[1] * (rho - k->r) + b[1] * (z - k->z));
    if (n > 0 && k->round > 0) {
      long double turn = atan2l(a[0] * b[1] - b[0] * a[1], a[0] * a[1] + b[0] * b[1]);
      long double in = k->round / cosl(turn / 2); /* of the centre, along the bisector */
      long double x = rho - (k->r - in * (a[0] + a[1]) / (2 * cosl(turn / 2)));
      long double y = z - (k->z - in * (b[0] + b[1]) / (2 * cosl(turn / 2)));
      /* the normal to the place lies between those of the edges */
      if (a[0] * y - b[0] * x >= 0 && x * b[1] - y * a[1] >= 0) {
        most = fmaxl(most, sqrtl(x * x + y * y) - k->round);
      }
    }
    a[0] = a[1];
    b[0] = b[1];
  }
  return most;
}

/* How far a point of the stock is beyond the solid in a pose with its origin moved by `t` of `way`.
 */
static inline long double beyond_posed(const profile *p, const sepax_pose *pose,
                                       const double way[3], long double t, const double point[3]) {
  long double q[3] = {0, 0, 0};
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      q[i] += pose->rotation[j][i] * (point[j] - (pose->translation[j] + t * way[j]));
    }
  }
  return beyond_solid(p, sqrtl(q[0] * q[0] + q[1] * q[1]), q[2]);
}

/* The least value on the way: of a convex function. */
static inline long double beyond_way(const profile *p, const sepax_pose *pose, const double way[3],
                                     const double point[3]) {
  long double low = 0;
  long double high = 1;
  for (int n = 0; n < 90; n++) {
    long double t[2] = {low + (high - low) * 0.382L, low + (high - low) * 0.618L};
    if (beyond_posed(p, pose, way, t[0], point) < beyond_posed(p, pose, way, t[1], point)) {
      high = t[1];
    } else {
      low = t[0];
    }
  }
  return beyond_posed(p, pose, way, (low + high) / 2, point);
}

#endif
