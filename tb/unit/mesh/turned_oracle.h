/* SPDX-License-Identifier: MIT */
/* turned_oracle.h - a solid of revolution in long double, written from its definition: how deep is
 * a point in it? */
#ifndef TURNED_ORACLE_H
#define TURNED_ORACLE_H

#include "mesh/revolve.h"

#include <math.h>

typedef long double real;

/* An edge of the region from (z[0], r[0]) to (z[1], r[1]); if radius is not 0, then an arc about
 * the centre (cz, cr). */
typedef struct {
  real z[2], r[2], radius, cz, cr;
} oracle_edge;

typedef struct {
  oracle_edge edge[TURNED_POINTS_MOST + 1];
  size_t edges; /* with the faces at both ends, which come first and last */
} oracle;

static inline oracle_edge oracle_between(turned_point a, turned_point b) {
  oracle_edge e = {{a.z, b.z}, {a.r, b.r}, fabsl(b.bend), 0, 0};
  if (b.bend != 0) {
    real z = e.z[1] - e.z[0];
    real r = e.r[1] - e.r[0];
    real square = z * z + r * r;
    real rest = e.radius * e.radius / square - 0.25L;
    real k = (rest > 0 ? sqrtl(rest) : 0) * (b.bend > 0 ? 1 : -1);
    e.cz = (e.z[0] + e.z[1]) / 2 + k * r;
    e.cr = (e.r[0] + e.r[1]) / 2 - k * z;
  }
  return e;
}

static inline oracle oracle_of(const turned_profile *p, real above) {
  oracle o = {.edges = p->points + 1};
  turned_point low = p->point[0];
  turned_point high = p->point[p->points - 1];
  o.edge[0] = (oracle_edge){{low.z, low.z}, {0, low.r}, 0, 0, 0};
  for (size_t n = 1; n < p->points; n++) {
    o.edge[n] = oracle_between(p->point[n - 1], p->point[n]);
  }
  o.edge[p->points] = (oracle_edge){{high.z + above, high.z + above}, {high.r, 0}, 0, 0, 0};
  if (above > 0) {
    o.edge[o.edges] = o.edge[p->points];
    o.edge[p->points] = (oracle_edge){{high.z, high.z + above}, {high.r, high.r}, 0, 0, 0};
    o.edges++;
  }
  return o;
}

/* The distance of a point of the half plane from an edge. An arc spans half a circle at most, so a
 * point of the circle is on it if it is on the far side of the chord. */
static inline real oracle_distance(const oracle_edge *e, real z, real r) {
  real dz = e->z[1] - e->z[0];
  real dr = e->r[1] - e->r[0];
  if (e->radius > 0) {
    real away = hypotl(z - e->cz, r - e->cr);
    real mz = (e->z[0] + e->z[1]) / 2 - e->cz;
    real mr = (e->r[0] + e->r[1]) / 2 - e->cr;
    real chord = hypotl(mz, mr);
    real along = chord > 1e-12L
                     ? ((z - e->cz) * mz + (r - e->cr) * mr) / chord
                     : ((z - e->cz) * dr - (r - e->cr) * dz) * (e->cr < e->r[0] ? -1 : 1);
    if (away > 0 && along * e->radius >= chord * away) {
      return fabsl(away - e->radius);
    }
    return fminl(hypotl(z - e->z[0], r - e->r[0]), hypotl(z - e->z[1], r - e->r[1]));
  }
  real square = dz * dz + dr * dr;
  real t = square > 0 ? ((z - e->z[0]) * dz + (r - e->r[0]) * dr) / square : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  return hypotl(z - (e->z[0] + t * dz), r - (e->r[0] + t * dr));
}

/* R(z) on one edge. */
static inline real oracle_radius(const oracle_edge *e, real z) {
  if (e->radius > 0) {
    real square = e->radius * e->radius - (z - e->cz) * (z - e->cz);
    real half = square > 0 ? sqrtl(square) : 0;
    bool hollow = e->cr > e->r[0] || e->cr > e->r[1];
    return hollow ? e->cr - half : e->cr + half;
  }
  return e->r[0] + (e->r[1] - e->r[0]) * (z - e->z[0]) / (e->z[1] - e->z[0]);
}

/* The depth of a point: its distance from the boundary, negative outside. */
static inline real oracle_depth(const oracle *o, real z, real r) {
  real least = INFINITY;
  bool inside = false;
  for (size_t n = 0; n < o->edges; n++) {
    const oracle_edge *e = &o->edge[n];
    least = fminl(least, oracle_distance(e, z, r));
    inside =
        inside || (e->z[0] < e->z[1] && z >= e->z[0] && z <= e->z[1] && r <= oracle_radius(e, z));
  }
  return inside ? least : -least;
}

#endif
