/* SPDX-License-Identifier: MIT */
/* outline.c - profiles of solids of revolution: their checks, and polylines around and within. */
#include "outline.h"
#include "util/error.h"
#include "util/list.h"

#include <math.h>

/* How far the ends of an arc may lie off its circle, by rounding. */
static const double rounding = 1e-9;

void sepax__outline_free(outline *o) {
  sepax_release(o->at);
  *o = (outline){0};
}

bool sepax__outline_add(outline *o, double z, double r) {
  spot *grown = list_grow(o->at, &o->capacity, o->count, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  o->at = grown;
  o->at[o->count++] = (spot){z, r};
  return true;
}

/* ------------------------------------------------------------------ distances */

double sepax__spot_distance(spot p, spot a, spot b) {
  double z = b.z - a.z;
  double r = b.r - a.r;
  double square = z * z + r * r;
  double part = square > 0 ? ((p.z - a.z) * z + (p.r - a.r) * r) / square : 0;
  part = fmin(fmax(part, 0), 1);
  return hypot(p.z - (a.z + part * z), p.r - (a.r + part * r));
}

static double turn(spot a, spot b, spot p) {
  return (b.r - a.r) * (p.z - a.z) - (b.z - a.z) * (p.r - a.r);
}

double sepax__segment_distance(spot a, spot b, spot c, spot d) {
  if (turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0) {
    return 0;
  }
  return fmin(fmin(sepax__spot_distance(a, c, d), sepax__spot_distance(b, c, d)),
              fmin(sepax__spot_distance(c, a, b), sepax__spot_distance(d, a, b)));
}

/* ----------------------------------------------------------------------- arcs */

typedef struct {
  spot centre;
  double radius;
  double from, to; /* angles: the point at an angle is z = centre.z + radius sin, r = centre.r +
                      radius cos. `from` < `to` for an arc that bulges away from the axis */
} arc;

/* The arc from a to b. The centre is at the side of the axis if bend > 0. Half a circle at most: a
 * chord that is longer than the diameter by rounding counts as the diameter. */
static arc arc_between(spot a, spot b, double bend) {
  double z = b.z - a.z;
  double r = b.r - a.r;
  double chord = hypot(z, r);
  double radius = fabs(bend);
  double half = chord / 2;
  double height = sqrt(fmax((radius - half) * (radius + half), 0)) * (bend > 0 ? 1 : -1);
  arc c = {.radius = radius};
  c.centre.z = a.z + z / 2 + height * (r / chord);
  c.centre.r = a.r + r / 2 - height * (z / chord);
  c.from = atan2(a.z - c.centre.z, a.r - c.centre.r);
  c.to = atan2(b.z - c.centre.z, b.r - c.centre.r);
  if (bend < 0) { /* from -pi/2 down to -3 pi/2 */
    c.from -= c.from > 0 ? 2 * 0x1.921fb54442d18p1 : 0;
    c.to -= c.to > 0 ? 2 * 0x1.921fb54442d18p1 : 0;
  }
  return c;
}

static bool check_arc(size_t n, spot a, spot b, double bend, sepax_error *error) {
  double chord = hypot(b.z - a.z, b.r - a.r);
  if (!(chord > 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "point %zu: an arc without length; leave the point out", n);
  }
  if (chord > 2 * fabs(bend) + rounding) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "point %zu: an arc of radius %g cannot span %g; give a radius of %g or more",
                      n, fabs(bend), chord, chord / 2);
  }
  arc c = arc_between(a, b, bend);
  bool rises =
      bend > 0 ? c.centre.r <= fmin(a.r, b.r) + rounding : c.centre.r >= fmax(a.r, b.r) - rounding;
  if (!rises) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "point %zu: its arc of radius %g goes back down; give a larger radius, or "
                      "divide the arc",
                      n, fabs(bend));
  }
  if (bend < 0 && c.centre.z > a.z && c.centre.z < b.z && c.centre.r < c.radius) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "point %zu: its hollow arc of radius %g crosses the axis; give a larger "
                      "radius",
                      n, fabs(bend));
  }
  return true;
}

static bool check_point(const turned_profile *p, size_t n, sepax_error *error) {
  turned_point at = p->point[n];
  if (!(fabs(at.z) <= TURNED_SIZE_MOST && at.r >= 0 && at.r <= TURNED_SIZE_MOST &&
        fabs(at.bend) <= TURNED_SIZE_MOST)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "point %zu: height %g, radius %g, arc %g; give a radius of 0 or more, and "
                      "numbers up to %g",
                      n, at.z, at.r, at.bend, TURNED_SIZE_MOST);
  }
  if (n == 0) {
    return at.bend == 0 || sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                                      "point 0: an arc needs a point before it; give bend 0");
  }
  if (at.z < p->point[n - 1].z) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "point %zu: its height %g is below the %g of the point before; order the "
                      "points from the tip up",
                      n, at.z, p->point[n - 1].z);
  }
  spot a = {p->point[n - 1].z, p->point[n - 1].r};
  return at.bend == 0 || check_arc(n, a, (spot){at.z, at.r}, at.bend, error);
}

bool sepax__turned_check(const turned_profile *profile, sepax_error *error) {
  size_t count = profile->points;
  if (count < 2 || count > TURNED_POINTS_MOST) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a profile of %zu points; give 2 ... %d", count,
                      TURNED_POINTS_MOST);
  }
  bool solid = false;
  for (size_t n = 0; n < count; n++) {
    if (!check_point(profile, n, error)) {
      return false;
    }
    solid = solid || profile->point[n].r > 0 || profile->point[n].bend != 0;
  }
  return (solid && profile->point[count - 1].z > profile->point[0].z) ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "a profile without a volume; give it a height and a radius above 0");
}

/* -------------------------------------------------------------------- outlines */

/* Add a point of an arc from a to b. Rounding must not let z fall. Tangents of a hollow arc may
 * cross the axis: there the region within is empty. */
static bool add_on_arc(outline *o, const arc *c, spot a, spot b, double angle, double radius) {
  double z = c->centre.z + radius * sin(angle);
  double r = c->centre.r + radius * cos(angle);
  z = fmin(fmax(fmax(z, a.z), o->at[o->count - 1].z), b.z);
  return sepax__outline_add(o, z, r);
}

/* Tangents touch the arc at its ends and at equal angles between, and meet outside of its circle.
 * Chords join the same points. Of a step angle s the tangents are up to R (1 / cos(s / 2) - 1) away
 * from the arc, and the chords are nearer. */
static bool add_arc(outline *o, spot a, spot b, double bend, bool tangents, double sagitta) {
  arc c = arc_between(a, b, bend);
  double step = 2 * acos(c.radius / (c.radius + sagitta));
  int steps = (int)fmin(ceil(fabs(c.to - c.from) / step), 1e6);
  steps = steps < 2 ? 2 : steps;
  step = (c.to - c.from) / steps;
  bool ok = true;
  for (int n = 0; n < steps && ok; n++) {
    if (tangents) {
      ok = add_on_arc(o, &c, a, b, c.from + (n + 0.5) * step, c.radius / cos(step / 2));
    } else if (n > 0) {
      ok = add_on_arc(o, &c, a, b, c.from + n * step, c.radius);
    }
  }
  return ok;
}

bool sepax__outline_of(outline *o, const turned_profile *profile, outline_side side, double sagitta,
                       double above) {
  size_t last = profile->points - 1;
  *o = (outline){0};
  bool ok = true;
  for (size_t n = 0; n <= last && ok; n++) {
    turned_point p = profile->point[n];
    if (p.bend != 0) {
      spot a = {profile->point[n - 1].z, profile->point[n - 1].r};
      ok = add_arc(o, a, (spot){p.z, p.r}, p.bend, (p.bend > 0) == (side == AROUND), sagitta);
    }
    ok = ok && sepax__outline_add(o, p.z, p.r);
  }
  if (ok && above > 0 && o->at[o->count - 1].r == o->at[o->count - 2].r) {
    o->at[o->count - 1].z += above; /* the cylinder below goes on */
  } else if (ok && above > 0) {
    ok = sepax__outline_add(o, o->at[o->count - 1].z + above, o->at[o->count - 1].r);
  }
  if (!ok) {
    sepax__outline_free(o);
  }
  return ok;
}
