/* SPDX-License-Identifier: MIT */
/* revolve.c - meshes around solids of revolution and inside them.
 *
 * The region of the profile is first bounded by two outlines without arcs: P around it, Q within
 * it. Four statements make the meshes bounds. d is a small part of the gap, e = how->shrink.
 *
 * 1. Outline. Without shrinking the outer outline is apart from P by d / 2 and around it. With
 *    shrinking no point of it is deeper than e - d / 2 in P. The inner outline is in Q, and apart
 *    from the boundary of Q by e + d / 2. outline_checks.c proves these statements of the numbers
 *    that are used. So both outlines stay d / 2 away from the boundary of the shrunk solid.
 * 2. Ring. Let C be a regular polygon with N sides. The outer solid has the section R(z) C at the
 *    height z, where C contains the circle of radius 1; the inner one has C inside of that circle.
 *    A point of its surface at a distance q from the axis has q >= R(z) in the outer solid and q <=
 *    R(z) in the inner one. So by 1 it is on the outer, or inner, side of the outline, and d / 2 or
 *    more away from the boundary of the shrunk solid, too. Corners of C are wrong by 2^-48 at most:
 *    the angle, sine, cosine and quotient have a few roundings each, and glibc's sine and cosine
 *    err by less than a unit in the last place. The factor 1 +- 2^-40 is more than that.
 * 3. Rounding. A vertex is wrong by at most 4 * 2^-53 * 2e4 < 1e-11, which is less than d / 2 >=
 *    1e-7 by far; so are 1e-10 in the checks and 1e-9 at the ends of arcs. Move the vertices from
 *    their exact places straight to their rounded ones. Each point of each triangle moves by less
 *    than d / 2, so no triangle ever meets the boundary of the shrunk solid. The number of times
 *    that the surface winds around a point there does not change on the way. So the rounded outer
 *    mesh still winds around each point of the solid once, and the inner mesh around no point
 *    outside of it.
 * 4. Gap. Every point of the outer outline's region is within half of the gap of a region that the
 *    shrunk solid contains: that of Q, or if it is shrunk, that of the inner outline. Likewise
 * every point of P's region, or of the outer outline's, is within half of the gap of the inner
 *    outline's. outline_checks.c proves it. N makes the polygons differ from the circles by less
 *    than the other half. */
#include "outline.h"
#include "util/error.h"
#include "util/memory.h"

#include <math.h>

static const double pi = 0x1.921fb54442d18p1;

/* Parts of the gap. The ring gets `ring`; P, Q, arcs around hollow corners of a shrunk solid, and
 * d share the half that statement 4 leaves to the outlines: 2 (0.18 + 0.03) + 2.9 / 256 < 0.5. */
static const double part_ring = 0.49;
static const double part_arc = 0.18;
static const double part_corner = 0.03;
static const double part_rounding = 1.0 / 256;
static const double margin_least = 2e-7;

/* Least length that may be shrunk by, so that a quarter of it is much above rounding. */
static const double shrink_least = 1e-5;

/* Each try divides the parts of the outlines by 4. */
enum { TRIES = 4, TRIANGLES_MOST = 1 << 23, SIDES_LEAST = 8 };

/* The outlines of the two meshes. */
typedef struct {
  outline outer, inner;
  bool outer_wanted, inner_wanted;
} outlines;

/* d of statement 1, where the parts of the gap that outlines may take are multiplied by `part`. */
static double margin_of(const revolve_how *how, double part) {
  double margin = fmax(part_rounding * how->gap * part, margin_least);
  return how->shrink > 0 ? fmin(margin, how->shrink / 4) : margin;
}

/* Statement 1. */
static bool outer_holds(const outline *o, const outline *p, const revolve_how *how, double margin) {
  double low = p->at[0].z + how->shrink;
  double high = p->at[p->count - 1].z - how->shrink;
  if (o->count == 0) {
    return how->shrink > 0 && low > high - margin;
  }
  bool spans = o->at[0].z <= low - margin / 2 && o->at[o->count - 1].z >= high + margin / 2;
  return spans && (how->shrink > 0 ? sepax__outline_covered(o, p, how->shrink - margin / 2)
                                   : sepax__outline_apart(o, p, margin / 2));
}

static bool inner_holds(const outline *o, const outline *q, const revolve_how *how, double margin) {
  bool within =
      o->count == 0 || (o->at[0].z > q->at[0].z && o->at[o->count - 1].z < q->at[q->count - 1].z);
  return within && sepax__outline_apart(o, q, how->shrink + margin / 2);
}

/* Statement 4, of the meshes that are wanted. */
static bool is_near(const outlines *o, const outline *p, const outline *q, const revolve_how *how) {
  double half = how->gap / 2;
  if (how->shrink > 0) {
    return sepax__outline_reaches(&o->outer, false, &o->inner, false, half);
  }
  return (!o->outer_wanted || sepax__outline_reaches(&o->outer, false, q, true, half)) &&
         (!o->inner_wanted || sepax__outline_reaches(p, true, &o->inner, false, half));
}

/* Make both outlines; *near becomes statement 4. */
static bool find_with(outlines *o, bool *near, const outline *p, const outline *q,
                      const revolve_how *how, double part, sepax_error *error) {
  double margin = margin_of(how, part);
  double corner = part * part_corner * how->gap;
  bool needs_inner = o->inner_wanted || how->shrink > 0;
  if (!sepax__outline_offset(&o->outer, p, how->shrink - margin, AROUND, corner, error) ||
      (needs_inner &&
       !sepax__outline_offset(&o->inner, q, how->shrink + margin, WITHIN, corner, error))) {
    return false;
  }
  *near = is_near(o, p, q, how);
  return (outer_holds(&o->outer, p, how, margin) && inner_holds(&o->inner, q, how, margin)) ||
         sepax_fail(error, SEPAX_ERROR_LIMIT,
                    "no mesh with a gap of %g was proved; give another gap", how->gap);
}

static bool find_part(outlines *o, bool *near, const turned_profile *profile,
                      const revolve_how *how, double part, sepax_error *error) {
  outline p;
  outline q = {0};
  double above = how->keep_top ? how->shrink : 0;
  double sagitta = part * part_arc * how->gap;
  bool made = sepax__outline_of(&p, profile, AROUND, sagitta, above) &&
              sepax__outline_of(&q, profile, WITHIN, sagitta, above);
  if (!made) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a profile");
  }
  bool ok = made && find_with(o, near, &p, &q, how, part, error);
  sepax__outline_free(&p);
  sepax__outline_free(&q);
  return ok;
}

static void free_outlines(outlines *o) {
  sepax__outline_free(&o->outer);
  sepax__outline_free(&o->inner);
}

/* Sharp edges multiply the differences of P and Q. So if statement 4 does not hold, then P, Q and d
 * become finer. */
static bool find_outlines(outlines *o, const turned_profile *profile, const revolve_how *how,
                          sepax_error *error) {
  for (int n = 0; n < TRIES; n++) {
    bool near = false;
    if (!find_part(o, &near, profile, how, ldexp(1, -2 * n), error)) {
      return false;
    }
    if (near) {
      return true;
    }
    free_outlines(o);
  }
  return sepax_fail(error, SEPAX_ERROR_LIMIT,
                    "a gap of %g cannot be kept, because a part or an edge%s is too thin; give a "
                    "larger gap",
                    how->gap, how->shrink > 0 ? " that is left" : "");
}

/* ------------------------------------------------------------------------ meshes */

/* A polygon around the unit circle or in it. */
typedef struct {
  double (*corner)[2];
  size_t sides;
} ring;

static double widest(const outline *o) {
  double r = 0;
  for (size_t n = 0; n < o->count; n++) {
    r = fmax(r, o->at[n].r);
  }
  return r;
}

/* A polygon around a circle of radius r is r (1 / cos(pi / N) - 1) farther out; in a circle, its
 * sides are less than that nearer to the axis. A multiple of 4 is symmetric to x and y. */
static size_t sides_for(double r, double gap) {
  double sides = ceil(pi / acos(r / (r + gap)));
  size_t count = sides > SIDES_LEAST ? (size_t)sides : SIDES_LEAST;
  return (count + 3) / 4 * 4;
}

static bool make_ring(ring *c, size_t sides, outline_side side) {
  double radius = side == AROUND ? (1 + 0x1p-40) / cos(pi / (double)sides) : 1 - 0x1p-40;
  *c = (ring){sepax__zeroed(sides, sizeof *c->corner), sides};
  for (size_t k = 0; c->corner != NULL && k < sides; k++) {
    double angle = 2 * pi * (double)k / (double)sides;
    c->corner[k][0] = radius * cos(angle);
    c->corner[k][1] = radius * sin(angle);
  }
  return c->corner != NULL;
}

static void set_corner(double v[3], const ring *c, spot at, size_t k) {
  const double *corner = c->corner[k % c->sides];
  v[0] = at.r > 0 ? at.r * corner[0] : 0;
  v[1] = at.r > 0 ? at.r * corner[1] : 0;
  v[2] = at.z;
}

/* The triangles between two points of an outline, seen counterclockwise from outside. */
static sepax_facet *add_band(sepax_facet *to, const ring *c, spot low, spot high) {
  for (size_t k = 0; k < c->sides; k++) {
    if (low.r > 0) {
      set_corner(to->v[0], c, low, k);
      set_corner(to->v[1], c, low, k + 1);
      set_corner(to->v[2], c, high, k + 1);
      to++;
    }
    if (high.r > 0) {
      set_corner(to->v[0], c, low, k);
      set_corner(to->v[1], c, high, k + 1);
      set_corner(to->v[2], c, high, k);
      to++;
    }
  }
  return to;
}

/* Point n of an outline with its ends at the axis, n = 0 ... count + 1. */
static spot spot_of(const outline *o, size_t n) {
  return n == 0         ? (spot){o->at[0].z, 0}
         : n > o->count ? (spot){o->at[o->count - 1].z, 0}
                        : o->at[n - 1];
}

static size_t count_triangles(const outline *o, size_t sides) {
  size_t count = 0;
  for (size_t n = 0; n < o->count; n++) {
    count += o->at[n].r > 0 ? 2 * sides : 0;
  }
  return count;
}

/* Each point off the axis is the end of two bands, and has a triangle in either for each side. */
static bool make_mesh(sepax_soup *soup, const outline *o, size_t sides, outline_side side,
                      sepax_error *error) {
  size_t count = count_triangles(o, sides);
  ring c;
  if (count == 0) {
    return true;
  }
  if (count > TRIANGLES_MOST) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "%zu triangles, %d being the most; give a larger gap", count, TRIANGLES_MOST);
  }
  soup->facet = sepax__zeroed(count, sizeof *soup->facet);
  if (!make_ring(&c, sides, side) || soup->facet == NULL) {
    sepax_release(c.corner);
    sepax_soup_free(soup);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu triangles", count);
  }
  soup->count = count;
  sepax_facet *next = soup->facet;
  for (size_t n = 0; n <= o->count; n++) {
    next = add_band(next, &c, spot_of(o, n), spot_of(o, n + 1));
  }
  sepax_release(c.corner);
  return true;
}

static bool check_options(const revolve_how *how, sepax_error *error) {
  if (!(how->gap >= TURNED_GAP_LEAST && how->gap <= TURNED_SIZE_MOST)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a gap of %g; give %g ... %g", how->gap,
                      TURNED_GAP_LEAST, TURNED_SIZE_MOST);
  }
  return how->shrink == 0 || (how->shrink >= shrink_least && how->shrink <= TURNED_SIZE_MOST) ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a solid shrunk by %g; give 0, or %g ... %g",
                    how->shrink, shrink_least, TURNED_SIZE_MOST);
}

bool sepax__revolve(sepax_soup *outer, sepax_soup *inner, const turned_profile *profile,
                    const revolve_how *how, sepax_error *error) {
  sepax_soup none[2] = {{0}, {0}};
  sepax_soup *to[2] = {outer != NULL ? outer : &none[0], inner != NULL ? inner : &none[1]};
  outlines o = {.outer_wanted = outer != NULL, .inner_wanted = inner != NULL};
  *to[0] = *to[1] = (sepax_soup){0};
  if (!check_options(how, error) || !sepax__turned_check(profile, error)) {
    return false;
  }
  bool ok = find_outlines(&o, profile, how, error);
  size_t sides = ok ? sides_for(widest(&o.outer), part_ring * how->gap) : 0;
  ok = ok && (outer == NULL || make_mesh(outer, &o.outer, sides, AROUND, error)) &&
       (inner == NULL || make_mesh(inner, &o.inner, sides, WITHIN, error));
  free_outlines(&o);
  if (!ok) {
    sepax_soup_free(to[0]);
    sepax_soup_free(to[1]);
  }
  return ok;
}
