/* SPDX-License-Identifier: MIT */
/* cutter.c - parts of tools as convex solids of revolution. A convex profile becomes one shape; any
 * other becomes a shape for each of its edges and arcs. */
#include "path/cutter.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CORNERS = 4 * TURNED_POINTS_MOST };

typedef sepax__stock_corner corner;

typedef struct {
  corner list[CORNERS];
  size_t count;
} corners;

static void push(corners *c, double r, double z, double round) {
  if (c->count == 0 || c->list[c->count - 1].r != r || c->list[c->count - 1].z != z) {
    c->list[c->count++] = (corner){r, z, round};
  }
}

/* The corner of the tangents of an arc from p to q that bulges away from the axis, if its tangents
 * meet between the heights of its ends. Otherwise the arc is divided where it is widest. */
static void push_arc(corners *c, const turned_point *p, const turned_point *q, double radius) {
  double dr = q->r - p->r;
  double dz = q->z - p->z;
  double length = hypot(dr, dz);
  double height = sqrt(fmax(0, radius * radius - length * length / 4));
  double side[2] = {dz / length, -dr / length}; /* away from the axis */
  double middle[2] = {(p->r + q->r) / 2, (p->z + q->z) / 2};
  double centre[2] = {middle[0] - side[0] * height, middle[1] - side[1] * height};
  double far = height > 0 ? length * length / 4 / height : INFINITY;
  double z = middle[1] + side[1] * far;
  if (z >= p->z - 1e-12 * radius && z <= q->z + 1e-12 * radius) {
    push(c, middle[0] + side[0] * far, fmin(fmax(z, p->z), q->z), radius);
    push(c, q->r, q->z, 0);
    return;
  }
  const turned_point widest = {centre[1], centre[0] + radius, 0};
  push_arc(c, p, &widest, radius);
  push_arc(c, &widest, q, radius);
}

/* The corners of a part of a profile, from point `first` to point `last`, closed by flat faces. */
static void find_corners(corners *c, const turned_profile *profile, size_t first, size_t last) {
  const turned_point *p = profile->point;
  c->count = 0;
  push(c, 0, p[first].z, 0);
  push(c, p[first].r, p[first].z, 0);
  for (size_t n = first + 1; n <= last; n++) {
    if (p[n].bend > 0) {
      push_arc(c, &p[n - 1], &p[n], p[n].bend);
    } else {
      push(c, p[n].r, p[n].z, 0);
    }
  }
  push(c, 0, p[last].z, 0);
}

/* Leave out corners in which the profile goes straight on. */
static void leave_out_straight(corners *c) {
  size_t kept = 1;
  for (size_t n = 1; n + 1 < c->count; n++) {
    const corner *p = &c->list[kept - 1];
    const corner *q = &c->list[n];
    const corner *s = &c->list[n + 1];
    double u[2] = {q->r - p->r, q->z - p->z};
    double v[2] = {s->r - q->r, s->z - q->z};
    double sine = u[0] * v[1] - u[1] * v[0];
    bool straight = fabs(sine) <= 1e-9 * hypot(u[0], u[1]) * hypot(v[0], v[1]) && q->round == 0 &&
                    u[0] * v[0] + u[1] * v[1] > 0;
    if (!straight) {
      c->list[kept++] = *q;
    }
  }
  c->list[kept++] = c->list[c->count - 1];
  c->count = kept;
}

/* From mm above the tip to metres on the link. */
static void place(corners *c, double length) {
  for (size_t n = 0; n < c->count; n++) {
    c->list[n].r *= 1e-3;
    c->list[n].round *= 1e-3;
    c->list[n].z = (c->list[n].z - length) * 1e-3;
  }
}

/* The flat faces at the ends of a shape go on in the next one. */
static void join(sepax__stock_shape *s, bool low, bool high) {
  for (int n = 0; n < s->count; n++) {
    sepax__stock_limit *limit = &s->limit[n];
    bool flat = !limit->round && limit->a == 0;
    limit->joined = flat && (limit->b < 0 ? low : high);
  }
}

static bool add(path_cutter *cutter, corners *c, const nc_turned_tool *tool, double error_most,
                sepax_error *error) {
  leave_out_straight(c);
  place(c, tool->length);
  return sepax__stock_shape_make(c->list, c->count, error_most, &cutter->inside[cutter->count],
                                 &cutter->outside[cutter->count], error) &&
         ++cutter->count > 0;
}

/* A shape for an edge or arc. Of an arc that bulges towards the axis, the chord encloses the solid,
 * and a cylinder with the lesser radius of the ends, less what the arc bulges, lies within. */
static bool add_piece(path_cutter *cutter, corners *c, const nc_turned_tool *tool,
                      const turned_profile *profile, size_t n, double error_most,
                      sepax_error *error) {
  const turned_point *p = &profile->point[n - 1];
  const turned_point *q = &profile->point[n];
  if (p->z == q->z || (p->r == 0 && q->r == 0)) {
    return true;
  }
  find_corners(c, profile, n - 1, n);
  if (!add(cutter, c, tool, error_most, error)) {
    return false;
  }
  if (q->bend < 0) {
    double radius = -q->bend;
    double length = hypot(q->r - p->r, q->z - p->z);
    double bulge = radius - sqrt(fmax(0, radius * radius - length * length / 4));
    double r = fmax(fmin(p->r, q->r) - bulge, 1e-6);
    sepax__stock_shape outside;
    c->count = 0;
    push(c, 0, p->z, 0);
    push(c, r, p->z, 0);
    push(c, r, q->z, 0);
    push(c, 0, q->z, 0);
    place(c, tool->length);
    return sepax__stock_shape_make(c->list, c->count, error_most,
                                   &cutter->inside[cutter->count - 1], &outside, error);
  }
  return true;
}

static bool bulges_inwards(const turned_profile *profile) {
  size_t n = 0;
  while (n < profile->points && !(profile->point[n].bend < 0)) {
    n++;
  }
  return n < profile->points;
}

bool path_cutter_make(path_cutter *cutter, const nc_turned_tool *tool, nc_tool_part part,
                      double error_most, sepax_error *error) {
  const turned_profile *profile = &tool->part[part];
  corners *c = malloc(sizeof *c);
  sepax_error not_convex = {0};
  *cutter = (path_cutter){calloc(profile->points, sizeof *cutter->inside),
                          calloc(profile->points, sizeof *cutter->outside), 0};
  bool ok = (c != NULL && cutter->inside != NULL && cutter->outside != NULL) ||
            sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the shapes of tools");
  if (ok) {
    find_corners(c, profile, 0, profile->points - 1);
    bool convex = !bulges_inwards(profile) && add(cutter, c, tool, error_most, &not_convex);
    for (size_t n = 1; n < profile->points && !convex && ok; n++) {
      ok = add_piece(cutter, c, tool, profile, n, error_most, error);
    }
  }
  for (size_t n = 0; n < cutter->count && ok; n++) {
    bool tip = part == NC_FLUTES && n == 0;
    join(&cutter->inside[n], !tip, true);
    join(&cutter->outside[n], !tip, true);
  }
  free(c);
  if (!ok) {
    path_cutter_free(cutter);
  }
  return ok;
}

void path_cutter_free(path_cutter *cutter) {
  free(cutter->inside);
  free(cutter->outside);
  *cutter = (path_cutter){0};
}
