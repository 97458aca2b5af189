/* SPDX-License-Identifier: MIT */
/* corners.c - what blending adds to the deviations of rows, corner by corner. */
#include "nc/blend.h"
#include "nc/rows.h"
#include "util/error.h"

#include <string.h>

static nc_way way_of(const nc_rows *r, const nc_part *part) {
  nc_way way;
  nc_way_of(&way, part->from, &r->motion->program.record[part->record]);
  return way;
}

/* LinuxCNC may merge this motion with others: a feed of X, Y, Z that is straight, or an arc that
 * leaves a straight line by no more than its tolerance. */
static bool may_merge(const nc_rows *r, const nc_part *part, const nc_way *way) {
  for (int i = 3; i < NC_AXES; i++) {
    if (!nc_way_rests(way, i)) {
      return false;
    }
  }
  return part->blend == NC_WITHIN && r->motion->program.record[part->record].kind == NC_FEED &&
         nc_way_bulge(way) <= part->within;
}

/* The corner between two motions may be inside a merged line. If it is, then both their ends and
 * the corner are within E of that line. So the triangle of these three points has a height of 2 E
 * at most, because the strip of all points within E of the line holds it. */
static bool may_vanish(const nc_way *first, const nc_way *second, double within) {
  double a[3], b[3], c[3], n[3], sizes[3] = {0, 0, 0}, twice = 0;
  if (first->arc || second->arc) {
    return true;
  }
  for (int i = 0; i < 3; i++) {
    a[i] = first->to[i] - first->from[i];
    b[i] = second->to[i] - second->from[i];
    c[i] = second->to[i] - first->from[i];
    sizes[0] += a[i] * a[i];
    sizes[1] += b[i] * b[i];
    sizes[2] += c[i] * c[i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    n[i] = a[j] * b[k] - a[k] * b[j];
    twice += n[i] * n[i];
  }
  double longest = nc_most(nc_most(sizes[0], sizes[1]), sizes[2]);
  return sqrt(twice / longest) * (1 - 1e-9) <= 2 * within;
}

/* The motions from `first` on that may be merged into one: at least one. Sets what all do. An arc
 * may be replaced by lines even if it is alone. */
static size_t run_from(const nc_rows *r, size_t first, nc_leg *leg) {
  nc_way before = {0};
  size_t n = first;
  *leg = (nc_leg){0};
  while (n < r->parts) {
    const nc_part *part = &r->part[n];
    nc_way way = way_of(r, part);
    bool merges = may_merge(r, part, &way);
    if (n > first && (!merges || !part->joined ||
                      !may_vanish(&before, &way, nc_most(part[-1].within, part->within)))) {
      break;
    }
    leg->arcs = leg->arcs || way.arc;
    leg->merges = n > first || (merges && way.arc);
    for (int i = 0; i < NC_AXES; i++) {
      leg->moves[i] = leg->moves[i] || !nc_way_rests(&way, i);
    }
    before = way;
    n++;
    if (!merges) {
      break;
    }
  }
  return n;
}

static void raise_rows(nc_rows *r, const nc_part *part, const double joint[NC_JOINTS_MOST]) {
  size_t joints = r->motion->joints;
  for (size_t row = part->first; row < part->end; row++) {
    double *to = &r->motion->blending[row * joints];
    for (size_t n = 0; n < joints; n++) {
      to[n] = nc_most(to[n], joint[n]);
    }
  }
}

/* The corner between motions n - 1 and n. */
static void blend_corner(nc_rows *r, size_t n, nc_leg before, nc_leg after) {
  const nc_part *first = &r->part[n - 1], *second = &r->part[n];
  nc_way way[2] = {way_of(r, first), way_of(r, second)};
  nc_blend blend = first->blend > second->blend ? first->blend : second->blend;
  double off[NC_AXES], joint[NC_JOINTS_MOST];
  before.way = &way[0];
  after.way = &way[1];
  nc_blend_pace(&before, r->motion->program.limits);
  nc_blend_pace(&after, r->motion->program.limits);
  nc_blend_corner(&before, &after, blend, nc_most(first->within, second->within),
                  r->motion->program.servo, off);
  nc_blend_joints(&r->state[second->state], &way[0], &way[1], off, joint);
  raise_rows(r, first, joint);
  raise_rows(r, second, joint);
}

/* The joint moves during the motion, or during a motion that is joined to it. */
static bool joint_moves(const nc_rows *r, size_t n, size_t joint) {
  size_t from = n > 0 && r->part[n].joined ? n - 1 : n;
  size_t to = n + 1 < r->parts && r->part[n + 1].joined ? n + 1 : n;
  const nc_motion *m = r->motion;
  for (size_t row = r->part[from].first; row < r->part[to].end; row++) {
    const double *value = &m->value[row * m->joints + joint];
    if (value[0] != *(value - m->joints) || m->deviation[row * m->joints + joint] > 1e-12) {
      return true;
    }
  }
  return false;
}

static void add_smoothing(nc_rows *r, size_t n) {
  nc_motion *m = r->motion;
  for (size_t joint = 0; joint < m->joints; joint++) {
    if (!joint_moves(r, n, joint)) {
      continue;
    }
    for (size_t row = r->part[n].first; row < r->part[n].end; row++) {
      double *to = &m->blending[row * m->joints + joint];
      *to = nc_above(*to + m->smoothing[joint]);
    }
  }
}

bool nc_rows_blend(nc_rows *r) {
  nc_motion *to = r->motion;
  size_t count = to->rows * to->joints;
  to->blending = sepax_allocate(count * sizeof *to->blending);
  if (to->blending == NULL) {
    return sepax_fail(r->error, SEPAX_ERROR_MEMORY, "%.180s: no memory for %zu rows", r->name,
                      to->rows);
  }
  memset(to->blending, 0, count * sizeof *to->blending);
  nc_leg before = {0};
  for (size_t n = 0; n < r->parts;) {
    nc_leg here;
    size_t end = run_from(r, n, &here);
    if (r->part[n].joined) {
      blend_corner(r, n, before, here);
    }
    for (size_t k = n + 1; k < end; k++) {
      blend_corner(r, k, here, here);
    }
    before = here;
    n = end;
  }
  for (size_t n = 0; n < r->parts; n++) {
    add_smoothing(r, n);
  }
  return true;
}
