/* SPDX-License-Identifier: MIT */
/* shape.c - convex solids of revolution from profiles.
 *
 * A limit a rho + b z <= c with a >= 0 is the intersection of the half-spaces with the unit normals
 * (a cos t, a sin t, b) for all t. A point whose ball of radius e lies in a half-space is one that
 * lies in the half-space moved inward by e. The same holds for a round limit, c - e instead of c:
 * if the result is below 0, what is left lies that deep in its cylinder. A
 * ball lies in an intersection if it lies in each part. So shrinking by e subtracts e from every c,
 * and is exact. Adding e to every c moves each part outward by e, so the result holds all points
 * within e of the shape. */
#include "stock/stock.h"

#include "util/error.h"

#include <math.h>
#include <string.h>

void sepax__stock_shape_shrink(sepax__stock_shape *shape, double by) {
  for (int n = 0; n < shape->count; n++) {
    shape->limit[n].c -= shape->limit[n].joined ? 0 : by;
  }
  if (by < 0) { /* a smaller shape keeps its bounds */
    shape->radius -= by;
    shape->low += by;
    shape->high -= by;
  }
}

/* ---------------------------------------------------------------- profiles */

typedef struct {
  double a, b, c, length; /* of an edge: normal, c, length */
} edge;

static edge edge_of(const sepax__stock_corner *from, const sepax__stock_corner *to) {
  double dr = to->r - from->r;
  double dz = to->z - from->z;
  double length = hypot(dr, dz);
  edge e = {dz / length, -dr / length, 0, length};
  e.c = e.a * from->r + e.b * from->z;
  return e;
}

static bool fail_profile(size_t n, const char *what, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "corner %zu of the profile: %s", n, what);
}

static bool corners_are_valid(const sepax__stock_corner *corner, size_t count, sepax_error *error) {
  if (count < 3) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a profile needs 3 corners or more, not %zu",
                      count);
  }
  for (size_t n = 0; n < count; n++) {
    const sepax__stock_corner *k = &corner[n];
    if (!isfinite(k->r) || !isfinite(k->z) || !isfinite(k->round) || k->round < 0) {
      return fail_profile(n, "a number is not finite, or the arc's radius is below 0", error);
    }
    bool end = n == 0 || n == count - 1;
    if (end ? k->r != 0 || k->round != 0 : !(k->r > 0)) {
      return fail_profile(n, "the first and the last are on the axis, without an arc, no others",
                          error);
    }
    if (n > 0 && (k->z < k[-1].z || (k->z == k[-1].z && k->r == k[-1].r))) {
      return fail_profile(n, "z falls, or it is the corner before", error);
    }
  }
  return true;
}

/* The turn from one normal to the next, 0 ... pi where the profile is convex. */
static double turn_of(const edge *e, const edge *f) {
  return atan2(e->a * f->b - e->b * f->a, e->a * f->a + e->b * f->b);
}

/* How much of each edge an arc takes. */
static double taken(const sepax__stock_corner *k, double turn) {
  return k->round > 0 ? k->round * tan(turn / 2) : 0;
}

static bool edges_are_valid(const sepax__stock_corner *corner, size_t count, sepax_error *error) {
  double before = 0;
  edge e = edge_of(&corner[0], &corner[1]);
  for (size_t n = 1; n + 1 < count; n++) {
    edge f = edge_of(&corner[n], &corner[n + 1]);
    double turn = turn_of(&e, &f);
    if (!(turn >= 0)) {
      return fail_profile(n, "not convex; give the parts as shapes of their own", error);
    }
    double arc = taken(&corner[n], turn);
    if (!(before + arc <= e.length * (1 + 0x1p-40)) || !(arc <= f.length * (1 + 0x1p-40))) {
      return fail_profile(n, "the arc is longer than its edges", error);
    }
    before = arc;
    e = f;
  }
  return true;
}

/* False if the shape is full. */
static bool add_limit(sepax__stock_shape *s, sepax__stock_limit limit) {
  if (s->count == SEPAX__STOCK_LIMITS) {
    return false;
  }
  s->limit[s->count++] = limit;
  return true;
}

/* A quarter of a circle between a plane and a cylinder, its centre at r: round. */
static bool is_round(const edge *e, const edge *f, double r) {
  return r >= 0 && ((e->a == 0 && f->b == 0) || (e->b == 0 && f->a == 0));
}

/* An edge next to the quarter of a ball needs no limit: the arc keeps it. */
static bool is_needless(const sepax__stock_corner *corner, const edge *before, const edge *here,
                        const edge *after) {
  const sepax__stock_corner *k[2] = {&corner[0], &corner[1]};
  const edge *beside[2] = {before, after};
  for (int n = 0; n < 2; n++) {
    double r = beside[n] == NULL ? 0 : (here->b == 0 ? here->c : beside[n]->c) - k[n]->round;
    if (beside[n] != NULL && k[n]->round > 0 && r == 0 && is_round(beside[n], here, r)) {
      return true;
    }
  }
  return false;
}

/* The limits of the arc in a corner between two edges. The polygon of the chords lies in the arc's
 * side of all of them, the tangents enclose it. Chords of the angle 2h are R (1 - cos h) away. */
static bool add_arc(const sepax__stock_corner *k, const edge *e, const edge *f, double error_most,
                    sepax__stock_shape *inside, sepax__stock_shape *outside) {
  double turn = turn_of(e, f);
  double sine = e->a * f->b - e->b * f->a;
  double from = e->c - k->round; /* the centre lies on both edges, moved inward */
  double to = f->c - k->round;
  double r = (from * f->b - to * e->b) / sine;
  double z = (e->a * to - f->a * from) / sine;
  double ring = e->b == 0 ? from : to;
  if (is_round(e, f, ring)) {
    sepax__stock_limit round = {true, false, z, e->a == 0 ? 1 : -1, k->round, ring};
    return add_limit(inside, round) && add_limit(outside, round);
  }
  double half = acos(fmax(0, 1 - error_most / k->round));
  double parts = fmax(1, ceil(turn / (2 * half)));
  if (!(parts < SEPAX__STOCK_LIMITS)) {
    return false;
  }
  double first = atan2(e->b, e->a);
  double step = turn / parts;
  for (int n = 0; n < (int)parts; n++) {
    double at = first + (n + 0.5) * step;
    sepax__stock_limit chord = {.a = fmax(0, cos(at)), .b = sin(at)};
    chord.c = chord.a * r + chord.b * z + k->round;
    bool ok = add_limit(outside, chord);
    chord.c -= k->round * (1 - cos(step / 2));
    if (!ok || !add_limit(inside, chord)) {
      return false;
    }
  }
  return true;
}

static bool add_limits(const sepax__stock_corner *corner, size_t count, double error_most,
                       sepax__stock_shape *inside, sepax__stock_shape *outside) {
  edge e = {0};
  edge f = edge_of(&corner[0], &corner[1]);
  for (size_t n = 0; n + 1 < count; n++) {
    edge g = n + 2 < count ? edge_of(&corner[n + 1], &corner[n + 2]) : f;
    sepax__stock_limit flat = {.a = f.a, .b = f.b, .c = f.c};
    bool ok = is_needless(&corner[n], n > 0 ? &e : NULL, &f, n + 2 < count ? &g : NULL) ||
              (add_limit(inside, flat) && add_limit(outside, flat));
    if (!ok || (n > 0 && corner[n].round > 0 && turn_of(&e, &f) > 0 &&
                !add_arc(&corner[n], &e, &f, error_most, inside, outside))) {
      return false;
    }
    e = f;
    f = g;
  }
  return true;
}

bool sepax__stock_shape_make(const sepax__stock_corner *corner, size_t count, double error_most,
                             sepax__stock_shape *inside, sepax__stock_shape *outside,
                             sepax_error *error) {
  memset(inside, 0, sizeof *inside);
  memset(outside, 0, sizeof *outside);
  if (!isfinite(error_most) || !(error_most > 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "the error of arcs must be above 0");
  }
  if (!corners_are_valid(corner, count, error) || !edges_are_valid(corner, count, error)) {
    return false;
  }
  if (!add_limits(corner, count, error_most, inside, outside)) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "the profile needs more than %d limits; allow its arcs a larger error",
                      SEPAX__STOCK_LIMITS);
  }
  double radius = 0;
  for (size_t n = 0; n < count; n++) {
    radius = fmax(radius, corner[n].r);
  }
  inside->radius = outside->radius = radius;
  inside->low = outside->low = corner[0].z;
  inside->high = outside->high = corner[count - 1].z;
  return true;
}
