/* SPDX-License-Identifier: MIT */
/* turned.c - convex shapes that make up a turned profile.
 *
 * Going up, the profile is a list of elements: lines, chords and tangents of arcs, quarters of
 * circles around the axis. An element is a limit that holds between two heights. Elements whose
 * normals turn to the same side, up and inward, bound one convex shape together. Where they turn
 * back, the solid is cut at that height, and a new shape begins.
 *
 * An arc that bulges outward lies outside its chords and inside its tangents. One that bulges
 * inward lies outside its tangents and inside its chords, and each of its chords or tangents has a
 * shape of its own. The centre of an arc of radius R is s = sqrt(R^2 - h^2) from its chord of
 * length 2h. The radicand is wrong by less than 2^-50 R^2, so s, at least 0, by less than 2^-25 R;
 * the limits have 2^-23 R to spare.
 *
 * A quarter of a circle is one round limit: no point is farther than R from the cylinder of the
 * radius r of its centre, above its height z. The solid keeps this limit near the arc. It does so
 * elsewhere, too, if it is no wider than r + R and begins no lower than z - R. For a quarter that
 * is one but for 2^-20, make_shape sees to both. */
#include "stock/stock.h"

#include "util/error.h"
#include "util/list.h"

#include <math.h>
#include <string.h>

typedef struct {
  sepax__stock_limit limit;
  double low, high;   /* heights between which it holds */
  double first, last; /* angles of its normals, -pi/2 (down) ... pi/2 (up) */
  double r[2];        /* of the profile at its ends */
} element;

typedef struct {
  element *item;
  size_t count, capacity;
} elements;

static bool add(elements *list, element e) {
  element *grown = list_grow(list->item, &list->capacity, list->count, sizeof e);
  if (grown == NULL) {
    return false;
  }
  list->item = grown;
  list->item[list->count++] = e;
  return true;
}

/* -------------------------------------------------------------------- arcs */

static const double spared = 0x1p-23;

typedef struct {
  const turned_point *from, *to;
  double r, z, radius; /* centre */
  double first, last;  /* angles of the normals of the solid, at both ends */
  bool inward;
} arc;

static arc arc_of(const turned_point *from, const turned_point *to) {
  double dr = to->r - from->r;
  double dz = to->z - from->z;
  double chord = hypot(dr, dz);
  arc k = {.from = from, .to = to, .radius = fabs(to->bend), .inward = to->bend < 0};
  double off = sqrt(fmax(0, (k.radius - chord / 2) * (k.radius + chord / 2)));
  off = k.inward ? -off : off;
  k.r = from->r / 2 + to->r / 2 - dz / chord * off;
  k.z = from->z / 2 + to->z / 2 + dr / chord * off;
  double turn = asin(fmin(1, chord / 2 / k.radius)); /* half of the arc's angle */
  double middle = atan2(-dr, dz);
  k.first = middle - (k.inward ? -turn : turn);
  k.last = middle + (k.inward ? -turn : turn);
  return k;
}

/* A limit of an arc: the tangent with its normal at the angle, moved inward by `in`. */
static sepax__stock_limit tangent(const arc *k, double angle, double in) {
  sepax__stock_limit limit = {.a = cos(angle), .b = sin(angle)};
  limit.a = limit.a < 0x1p-50 ? 0 : limit.a;
  double out = k->inward ? -k->radius : k->radius;
  limit.c = limit.a * k->r + limit.b * k->z + out - in;
  return limit;
}

/* A quarter of a circle between a flat face and a cylinder, up to rounding; its centre is on the
 * axis (a ball) or beside it (the corner of a bull nose). */
static bool is_quarter(const arc *k) {
  const double near = 0x1p-20;
  const double right = 0x1.921fb54442d18p0;
  bool low = fabs(k->first + right) <= near && fabs(k->last) <= near;
  bool high = fabs(k->first) <= near && fabs(k->last - right) <= near;
  return !k->inward && k->r >= -near * k->radius && (low || high);
}

/* One round limit. Outside, make_shape makes it larger by what it is no quarter. */
static bool add_quarter(elements *list, const arc *k, double spare) {
  double ring = k->r > 0x1p-20 * k->radius ? k->r : 0;
  double off = fabs(k->r - ring);
  element e = {.limit = {true, false, k->z, k->first + k->last < 0 ? 1 : -1, 0, ring},
               .low = k->from->z,
               .high = k->to->z,
               .first = k->first,
               .last = k->last,
               .r = {k->from->r, k->to->r}};
  e.limit.c = k->radius + spare + (spare < 0 ? -off : off);
  return add(list, e);
}

/* Chords or tangents of an arc, `parts` of them; tangents of an outward arc also at its ends, where
 * the next element may meet it at an angle. */
static bool add_arc(elements *list, const arc *k, double error_most, bool inside) {
  double spare = (inside ? -1 : 1) * spared * k->radius;
  if (is_quarter(k)) {
    return add_quarter(list, k, spare);
  }
  double step_most = 2 * acos(fmax(0, 1 - error_most / k->radius));
  double parts = fmin(4096, fmax(1, ceil(fabs(k->last - k->first) / step_most)));
  double step = (k->last - k->first) / parts;
  bool ends = !inside && !k->inward;
  for (int n = ends ? -1 : 0; n < (int)parts + ends; n++) {
    double angle = k->first + fmin(parts, fmax(0, n + 0.5)) * step;
    bool chord = inside != k->inward;
    double in = chord ? (k->inward ? -1 : 1) * k->radius * (1 - cos(step / 2)) : 0;
    element e = {.limit = tangent(k, angle, in - spare), .first = angle, .last = angle};
    const double part[2] = {fmin(parts, fmax(0, n)), fmin(parts, fmax(0, n + 1))};
    for (int i = 0; i < 2; i++) {
      double at = k->first + part[i] * step;
      double out = k->inward ? -k->radius : k->radius;
      double z = part[i] == 0 ? k->from->z : part[i] == parts ? k->to->z : k->z + out * sin(at);
      *(i == 0 ? &e.low : &e.high) = z;
      e.r[i] = part[i] == 0 ? k->from->r : part[i] == parts ? k->to->r : k->r + out * cos(at);
    }
    if (!add(list, e)) {
      return false;
    }
  }
  return true;
}

/* An arc that goes out and in again is two: one up to its widest place, one from there. */
static bool add_bend(elements *list, const turned_point *from, const turned_point *to,
                     double error_most, bool inside) {
  arc k = arc_of(from, to);
  if (k.inward || !(k.first < -0x1p-20) || !(k.last > 0x1p-20)) {
    return add_arc(list, &k, error_most, inside);
  }
  const turned_point widest = {k.z, k.r + k.radius, 0};
  arc low = k;
  arc high = k;
  low.to = &widest;
  low.last = 0;
  high.from = &widest;
  high.first = 0;
  return add_arc(list, &low, error_most, inside) && add_arc(list, &high, error_most, inside);
}

static bool add_line(elements *list, const turned_point *from, const turned_point *to) {
  double dr = to->r - from->r;
  double dz = to->z - from->z;
  double length = hypot(dr, dz);
  if (length == 0) {
    return true;
  }
  element e = {.limit = {.a = dz / length, .b = -dr / length},
               .low = from->z,
               .high = to->z,
               .r = {from->r, to->r}};
  e.limit.c = e.limit.a * from->r + e.limit.b * from->z;
  e.first = e.last = atan2(-dr, dz);
  return add(list, e);
}

static bool add_elements(elements *list, const turned_profile *profile, double error_most,
                         bool inside) {
  for (size_t n = 1; n < profile->points; n++) {
    const turned_point *to = &profile->point[n];
    if (to->bend != 0 ? !add_bend(list, to - 1, to, error_most, inside)
                      : !add_line(list, to - 1, to)) {
      return false;
    }
  }
  return true;
}

/* ------------------------------------------------------------------ shapes */

/* A face that closes the shape: z >= at or z <= at. */
static bool add_face(sepax__stock_shape *s, double sign, double at, bool joined) {
  if (s->count == SEPAX__STOCK_LIMITS) {
    return false;
  }
  s->limit[s->count++] = (sepax__stock_limit){.joined = joined, .b = sign, .c = sign * at};
  return true;
}

/* Normals that turn back by less than this are taken for a tangent, such as that of an arc and a
 * line whose ends are rounded. The limits of a shape outside move outward by as much of the
 * profile's size for each element. */
static const double straight = 0x1p-30;

/* Do the elements bound one convex shape, one after the other? */
static bool goes_on(const element *e, const element *next) {
  return next->first >= e->last - straight && e->high >= e->low && next->high >= next->low &&
         e->r[1] == next->r[0];
}

static bool is_face(const element *e) { return e->limit.a == 0 && !e->limit.round; }

/* Round limits around the solid hold its widest place, and its lowest or highest one. */
static void widen(sepax__stock_shape *s, double low, double high) {
  for (int n = 0; n < s->count; n++) {
    sepax__stock_limit *k = &s->limit[n];
    if (k->round) {
      double most = fmax(s->radius - k->ring, k->b > 0 ? k->a - low : high - k->a);
      k->c = fmax(k->c, most * (1 + spared));
    }
  }
}

/* The shape of `count` elements; `spare` is added to its limits. False if it needs too many. */
static bool make_shape(sepax__stock_shape *s, const element *e, size_t count, double spare,
                       const bool joined[2]) {
  const element *last = e + count - 1;
  double size = fmax(fabs(e->low), fabs(last->high));
  memset(s, 0, sizeof *s);
  if (((e->r[0] > 0 || is_face(e)) && !add_face(s, -1, e->low, joined[0])) ||
      ((last->r[1] > 0 || is_face(last)) && !add_face(s, 1, last->high, joined[1]))) {
    return false;
  }
  for (size_t n = 0; n < count; n++) {
    s->radius = fmax(s->radius, fmax(e[n].r[0], e[n].r[1]));
    if (is_face(&e[n])) {
      continue; /* one of both above */
    }
    if (s->count == SEPAX__STOCK_LIMITS) {
      return false;
    }
    s->limit[s->count] = e[n].limit;
    s->limit[s->count++].c += spare * (double)count;
  }
  if (spare > 0) {
    widen(s, e->low, last->high);
  }
  size = (size + s->radius) * 0x1p-16; /* more than all that was spared */
  s->radius += size;
  s->low = e->low - size;
  s->high = last->high + size;
  return true;
}

static bool make_shapes(const elements *list, const bool joined[2], bool inside,
                        sepax__stock_shapes *shapes, sepax_error *error) {
  double size = 0;
  for (size_t n = 0; n < list->count; n++) {
    const element *e = &list->item[n];
    size = fmax(size, fmax(fabs(e->low), fabs(e->high)) + fmax(e->r[0], e->r[1]));
  }
  shapes->shape = sepax_allocate(list->count * sizeof *shapes->shape);
  if (shapes->shape == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the shapes of a tool");
  }
  for (size_t from = 0; from < list->count;) {
    size_t to = from + 1;
    while (to < list->count && goes_on(&list->item[to - 1], &list->item[to])) {
      to++;
    }
    const bool ends[2] = {from > 0 || joined[0], to < list->count || joined[1]};
    if (list->item[to - 1].high > list->item[from].low) { /* no step by itself */
      if (!make_shape(&shapes->shape[shapes->count++], &list->item[from], to - from,
                      inside ? 0 : 2 * straight * size, ends)) {
        return sepax_fail(error, SEPAX_ERROR_LIMIT,
                          "a part of the tool needs more than %d limits; allow its arcs a larger "
                          "error",
                          SEPAX__STOCK_LIMITS);
      }
    }
    from = to;
  }
  return true;
}

void sepax__stock_shapes_free(sepax__stock_shapes *shapes) {
  sepax_release(shapes->shape);
  *shapes = (sepax__stock_shapes){0};
}

bool sepax__stock_shapes_make(const turned_profile *profile, const bool joined[2],
                              double error_most, sepax__stock_shapes *inside,
                              sepax__stock_shapes *outside, sepax_error *error) {
  *inside = *outside = (sepax__stock_shapes){0};
  if (!(error_most > 0) || !isfinite(error_most)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "the error of arcs must be above 0");
  }
  if (!sepax__turned_check(profile, error)) {
    return false;
  }
  for (int side = 0; side < 2; side++) {
    elements list = {0};
    bool ok = add_elements(&list, profile, error_most, side == 0) ||
              sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the shapes of a tool");
    ok = ok && make_shapes(&list, joined, side == 0, side == 0 ? inside : outside, error);
    sepax_release(list.item);
    if (!ok) {
      sepax__stock_shapes_free(inside);
      sepax__stock_shapes_free(outside);
      return false;
    }
  }
  return true;
}
