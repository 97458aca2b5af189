/* SPDX-License-Identifier: MIT */
/* surface.c - triangles of meshes, boxes, cylinders, spheres and capsules. */
#include "surface.h"

#include "polygon.h"
#include "report.h"

#include <stdlib.h>
#include <string.h>

/* Corners of a cylinder's ends; of a sphere's equator, which has half as many rings. */
enum { SEGMENTS = 256, RINGS = SEGMENTS / 2 };

static const long double PI = 3.14159265358979323846264338327950288L;

/* Above the rounding of a polyhedron's corners. */
static const long double OUTWARD = 1 + 1e-12L;

void surface_element(surface *s) {
  GROW(s->element, s->elements);
  s->element[s->elements++] = (surface_part){s->count, false};
}

static void add(surface *s, pose at, point a, point b, point c) {
  GROW(s->triangle, s->count);
  s->triangle[s->count++] =
      (triangle){{point_near(pose_apply(at, a)), point_near(pose_apply(at, b)),
                  point_near(pose_apply(at, c))}};
}

static void stands_out(surface *s, long double length) {
  s->rounded = fmax(s->rounded, (double)length);
}

typedef struct {
  surface *s;
  point scale;
  pose at;
} target;

static point scaled(const target *t, point p) {
  return (point){p.x * t->scale.x, p.y * t->scale.y, p.z * t->scale.z};
}

/* A scale that mirrors turns the triangle round, so that its outer side stays outside. */
static void add_to(const target *t, point a, point b, point c) {
  const bool mirrors = ((t->scale.x < 0) ^ (t->scale.y < 0) ^ (t->scale.z < 0)) != 0;
  add(t->s, t->at, scaled(t, a), scaled(t, mirrors ? c : b), scaled(t, mirrors ? b : c));
}

/* The outer sides of all hulls are outside. */
static void add_hull(const target *t, const point *corner, size_t count, const division *d) {
  const point up = d->up;
  for (size_t n = 0; n + 2 < count; n++) {
    const size_t *of = d->triangle[n];
    add_to(t, point_plus(corner[of[0]], up), point_plus(corner[of[1]], up),
           point_plus(corner[of[2]], up));
    add_to(t, point_minus(corner[of[0]], up), point_minus(corner[of[2]], up),
           point_minus(corner[of[1]], up));
  }
  for (size_t n = 0; n < count; n++) {
    const point a = corner[n];
    const point b = corner[(n + 1) % count];
    add_to(t, point_minus(a, up), point_minus(b, up), point_plus(b, up));
    add_to(t, point_minus(a, up), point_plus(b, up), point_plus(a, up));
  }
}

void surface_mesh(surface *s, mesh *m, point scale, pose at) {
  const target t = {s, scale, at};
  size_t *bent = NULL;
  size_t bents = 0;
  for (size_t n = 0; n < m->polygons; n++) {
    const size_t from = n == 0 ? 0 : m->end[n - 1];
    const point *corner = m->corner + from;
    const division d = polygon_divide(m, corner, m->end[n] - from);
    for (size_t k = 0; k + 2 < m->end[n] - from; k++)
      add_to(&t, corner[d.triangle[k][0]], corner[d.triangle[k][1]], corner[d.triangle[k][2]]);
    if (d.bent) {
      GROW(bent, bents);
      bent[bents++] = n;
    }
    free(d.triangle);
  }
  for (size_t n = 0; n < bents; n++) {
    surface_element(s);
    s->element[s->elements - 1].hull = true;
    const size_t from = bent[n] == 0 ? 0 : m->end[bent[n] - 1];
    const division d = polygon_divide(m, m->corner + from, m->end[bent[n]] - from);
    add_hull(&t, m->corner + from, m->end[bent[n]] - from, &d);
    stands_out(s, point_length(scaled(&t, d.up)));
    free(d.triangle);
  }
  free(bent);
}

static void quad(surface *s, pose at, point a, point b, point c, point d) {
  add(s, at, a, b, c);
  add(s, at, a, c, d);
}

void surface_box(surface *s, point size, pose at) {
  point corner[8];
  for (int n = 0; n < 8; n++) {
    corner[n] = (point){n & 1 ? size.x / 2 : -size.x / 2, n & 2 ? size.y / 2 : -size.y / 2,
                        n & 4 ? size.z / 2 : -size.z / 2};
  }
  static const int SIDE[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  for (int n = 0; n < 6; n++) {
    quad(s, at, corner[SIDE[n][0]], corner[SIDE[n][1]], corner[SIDE[n][2]], corner[SIDE[n][3]]);
  }
}

/* n of SEGMENTS on a circle; the same numbers for the last as for the first. */
static point on_circle(int n, long double radius, long double z) {
  const long double angle = 2 * PI * (n % SEGMENTS) / SEGMENTS;
  return (point){radius * cosl(angle), radius * sinl(angle), z};
}

/* The middles of the sides are as far from the axis as the corners times cos(pi / SEGMENTS). */
void surface_cylinder(surface *s, long double radius, long double length, pose at) {
  const long double outer = radius / cosl(PI / SEGMENTS) * OUTWARD;
  const long double half = length / 2 * OUTWARD;
  const point bottom = {0, 0, -half};
  const point top = {0, 0, half};
  for (int n = 0; n < SEGMENTS; n++) {
    const point low = on_circle(n, outer, -half);
    const point next = on_circle(n + 1, outer, -half);
    const point over = on_circle(n, outer, half);
    const point next_over = on_circle(n + 1, outer, half);
    quad(s, at, low, next, next_over, over);
    add(s, at, bottom, next, low);
    add(s, at, top, over, next_over);
  }
  stands_out(s, outer - radius + half - length / 2);
}

/* A face's distance from the centre: the chord of a meridian, pi / RINGS long, is cos(pi / 2 RINGS)
 * radii away, and a face between two meridians is this chord, squeezed towards the sphere's axis by
 * cos(pi / SEGMENTS), which brings no line nearer by more than that factor. */
static void add_ball(surface *s, long double radius, long double length, pose at) {
  const long double outer = radius / cosl(PI / SEGMENTS) / cosl(PI / (2 * RINGS)) * OUTWARD;
  for (int ring = 0; ring < RINGS; ring++) {
    const long double below = PI * ring / RINGS;
    const long double above = PI * (ring + 1) / RINGS;
    /* At the poles sine is 0, so that the faces close. */
    const long double r0 = ring == 0 ? 0 : outer * sinl(below);
    const long double r1 = ring == RINGS - 1 ? 0 : outer * sinl(above);
    /* The upper half is `length` above the lower one; the ring between both is at the equator. */
    const long double apart = ring < RINGS / 2 ? -length / 2 : length / 2;
    const long double z0 = apart - outer * cosl(below);
    const long double z1 = apart - outer * cosl(above);
    for (int n = 0; n < SEGMENTS; n++) {
      const point a = on_circle(n, r0, z0);
      const point b = on_circle(n + 1, r0, z0);
      const point c = on_circle(n + 1, r1, z1);
      const point d = on_circle(n, r1, z1);
      if (ring > 0)
        add(s, at, a, b, c);
      if (ring < RINGS - 1)
        add(s, at, a, c, d);
    }
  }
  for (int n = 0; n < SEGMENTS && length > 0; n++) {
    const long double low = -length / 2 - outer * cosl(PI / 2);
    const long double high = length / 2 - outer * cosl(PI / 2);
    quad(s, at, on_circle(n, outer, low), on_circle(n + 1, outer, low),
         on_circle(n + 1, outer, high), on_circle(n, outer, high));
  }
  stands_out(s, outer - radius);
}

void surface_sphere(surface *s, long double radius, pose at) { add_ball(s, radius, 0, at); }

/* A cylinder of this length along z with half a sphere at each end. */
void surface_capsule(surface *s, long double radius, long double length, pose at) {
  add_ball(s, radius, length, at);
}

void surface_finish(surface *s) {
  s->low = s->high = s->triangle[0].at[0];
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 0; k < 3; k++) {
      const vec p = s->triangle[n].at[k];
      s->low = (vec){fmin(s->low.x, p.x), fmin(s->low.y, p.y), fmin(s->low.z, p.z)};
      s->high = (vec){fmax(s->high.x, p.x), fmax(s->high.y, p.y), fmax(s->high.z, p.z)};
      s->radius = fmax(s->radius, vec_length(p) * (1 + 1e-12));
    }
  }
}
