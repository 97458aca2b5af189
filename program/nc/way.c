/* SPDX-License-Identifier: MIT */
/* way.c - the way of the axes during one motion of a program. */
#include "nc/way.h"

#include <string.h>

/* LinuxCNC takes an arc of less than this angle for a whole turn, in radians. */
static const double angle_least = 1e-6;
static const double radius_least = 1e-6; /* mm */

/* 2 pi to the nearest double. */
#define TURN 0x1.921fb54442d18p2

typedef struct {
  nc_interval x[3];
} vector;

static nc_interval dot(const vector *a, const vector *b) {
  nc_interval sum = nc_times(a->x[0], b->x[0]);
  for (int i = 1; i < 3; i++) {
    sum = nc_add(sum, nc_times(a->x[i], b->x[i]));
  }
  return sum;
}

static vector scaled(const vector *a, nc_interval by) {
  vector v;
  for (int i = 0; i < 3; i++) {
    v.x[i] = nc_times(a->x[i], by);
  }
  return v;
}

static vector difference(const vector *a, const vector *b) {
  vector v;
  for (int i = 0; i < 3; i++) {
    v.x[i] = nc_subtract(a->x[i], b->x[i]);
  }
  return v;
}

static vector cross(const vector *a, const vector *b) {
  vector v;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3, k = (i + 2) % 3;
    v.x[i] = nc_subtract(nc_times(a->x[j], b->x[k]), nc_times(a->x[k], b->x[j]));
  }
  return v;
}

static vector exact(const double *x) {
  return (vector){{nc_point(x[0]), nc_point(x[1]), nc_point(x[2])}};
}

/* The angle of the point (x, y), in 0 ... 2 pi. The point of the box nearest to 0 is at least
 * `near` away, so the angle differs from that of the middle by at most asin(d / near) for the
 * distance d to the middle, and asin(u) <= 2 u. The library's atan2 errs by less than 2^-50. */
static nc_interval angle_of(nc_interval x, nc_interval y) {
  double mx = nc_middle(x), my = nc_middle(y);
  double d = nc_farthest(x, mx) + nc_farthest(y, my);
  double near = nc_below(sqrt(mx * mx + my * my) * (1 - 0x1p-40) - d);
  double angle = atan2(my, mx);
  double off = nc_above(2 * d / near * (1 + 0x1p-40) + 0x1p-48);
  angle = angle < angle_least ? angle + TURN : angle;
  return (nc_interval){nc_below(angle - off), nc_above(angle + off)};
}

static nc_interval whole_turns(int turns) {
  return nc_times(nc_around(TURN), nc_point((double)turns));
}

/* The normal is axis i, and the arc is no helix. */
static bool stays_in_plane(const nc_way *way, const nc_record *record, int i) {
  return record->normal[(i + 1) % 3] == 0 && record->normal[(i + 2) % 3] == 0 &&
         way->from[i] == way->to[i];
}

static const char *make_arc(nc_way *way, const nc_record *record) {
  vector from = exact(way->from), to = exact(way->to), centre = exact(record->centre);
  vector normal = exact(record->normal);
  normal = scaled(&normal, nc_over(nc_point(1), nc_root(dot(&normal, &normal))));
  /* The parts of both ends along the normal and across it. */
  vector start = difference(&from, &centre), end = difference(&to, &centre);
  vector start_up = scaled(&normal, dot(&start, &normal));
  vector end_up = scaled(&normal, dot(&end, &normal));
  vector across = difference(&start, &start_up), end_across = difference(&end, &end_up);
  vector along = cross(&normal, &across), rise = difference(&end_up, &start_up);
  nc_interval square = dot(&across, &across);
  if (!(square.lo > radius_least * radius_least) ||
      !(dot(&end_across, &end_across).lo > radius_least * radius_least)) {
    return "an end of the arc is its centre";
  }
  nc_interval x = nc_over(dot(&end_across, &across), square);
  nc_interval y = nc_over(dot(&end_across, &along), square);
  nc_interval ratio = nc_root(nc_add(nc_times(x, x), nc_times(y, y)));
  way->grow = nc_subtract(ratio, nc_point(1));
  way->angle = nc_add(angle_of(x, y), whole_turns(record->number));
  way->slip = nc_above(2 * nc_size(way->grow) / nc_least(1, ratio.lo) * (1 + 0x1p-40));
  for (int i = 0; i < 3; i++) {
    way->centre[i] = nc_add(centre.x[i], start_up.x[i]);
    way->across[i] = across.x[i];
    way->along[i] = along.x[i];
    way->rise[i] = rise.x[i];
    if (stays_in_plane(way, record, i)) {
      way->centre[i] = nc_point(way->from[i]);
      way->across[i] = way->along[i] = way->rise[i] = nc_point(0);
    }
  }
  if (!(way->slip < 2)) {
    return "the radii of the arc's ends differ too much";
  }
  return way->angle.hi - way->angle.lo < 1e-6 ? NULL : "the arc is too small to have an angle";
}

const char *nc_way_of(nc_way *way, const double from[NC_AXES], const nc_record *record) {
  memset(way, 0, sizeof *way);
  memcpy(way->from, from, sizeof way->from);
  memcpy(way->to, record->axis, sizeof way->to);
  way->arc = record->action == NC_DO_ARC;
  return way->arc ? make_arc(way, record) : NULL;
}

static void turn_at(const nc_way *way, nc_jet t, nc_jet axis[NC_AXES]) {
  nc_jet sine, cosine;
  nc_jet_circle(nc_jet_scale(t, way->angle), &sine, &cosine);
  nc_jet size = nc_jet_add(nc_still(nc_point(1)), nc_jet_scale(t, way->grow));
  sine = nc_jet_times(sine, size);
  cosine = nc_jet_times(cosine, size);
  for (int i = 0; i < 3; i++) {
    nc_jet turned =
        nc_jet_add(nc_jet_scale(cosine, way->across[i]), nc_jet_scale(sine, way->along[i]));
    axis[i] =
        nc_jet_add(nc_jet_add(nc_still(way->centre[i]), nc_jet_scale(t, way->rise[i])), turned);
  }
}

void nc_way_at(const nc_way *way, nc_interval t, nc_jet axis[NC_AXES]) {
  nc_jet parameter = {t, nc_point(1), nc_point(0)};
  for (int i = way->arc ? 3 : 0; i < NC_AXES; i++) {
    nc_interval by = nc_way_rests(way, i)
                         ? nc_point(0)
                         : nc_subtract(nc_point(way->to[i]), nc_point(way->from[i]));
    axis[i] = nc_jet_add(nc_still(nc_point(way->from[i])), nc_jet_scale(parameter, by));
  }
  if (way->arc) {
    turn_at(way, parameter, axis);
  }
  for (int i = 0; i < NC_AXES && (t.hi == 0 || t.lo == 1); i++) {
    axis[i].v = nc_point(t.hi == 0 ? way->from[i] : way->to[i]);
  }
}

double nc_way_slip(const nc_way *way, double t0, double t1) {
  double t = t0 <= 0.5 && t1 >= 0.5 ? 0.5 : t1 < 0.5 ? t1 : t0;
  return nc_above(way->slip * t * (1 - t) * (1 + 0x1p-40));
}

double nc_way_bulge(const nc_way *way) {
  if (!way->arc) {
    return 0;
  }
  vector across = {{way->across[0], way->across[1], way->across[2]}};
  double radius = nc_root(dot(&across, &across)).lo * nc_least(1, 1 + way->grow.lo);
  double half = nc_least(way->angle.lo, TURN / 2) / 2;
  return radius * (1 - cos(half)) * (1 - 1e-9);
}

bool nc_way_rests(const nc_way *way, int axis) {
  return way->from[axis] == way->to[axis] &&
         (!way->arc || axis > NC_Z ||
          nc_size(way->across[axis]) + nc_size(way->along[axis]) + nc_size(way->rise[axis]) == 0);
}
