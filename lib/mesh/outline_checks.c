/* SPDX-License-Identifier: MIT */
/* outline_checks.c - proofs about outlines, by distances alone, without the way they were made. */
#include "outline.h"

#include <math.h>

/* Halvings of a segment at most. */
enum { DEPTH = 24 };

/* Segment n of an outline with its ends at the axis, n = 0 ... count. */
static void segment_of(const outline *o, size_t n, spot ends[2]) {
  ends[0] = n > 0 ? o->at[n - 1] : (spot){o->at[0].z, 0};
  ends[1] = n < o->count ? o->at[n] : (spot){o->at[o->count - 1].z, 0};
}

/* Here the region has no points but those of the axis, and a mesh has no triangles. */
static bool on_axis(const spot ends[2]) { return ends[0].r == 0 && ends[1].r == 0; }

bool sepax__outline_apart(const outline *o, const outline *from, double distance) {
  spot a[2];
  spot b[2];
  for (size_t n = 0; n <= o->count && o->count > 0; n++) {
    segment_of(o, n, a);
    for (size_t k = 0; k <= from->count && !on_axis(a); k++) {
      segment_of(from, k, b);
      if (!(sepax__segment_distance(a[0], a[1], b[0], b[1]) > distance)) {
        return false;
      }
    }
  }
  return true;
}

/* The distance from one segment is a convex function of the point. So it is largest at an end of
 * the segment a b. If no one segment of `to` is near both ends, then the halves are looked at.
 * Segments of `to` on the axis count only if `axis` is true. */
static bool near_all(spot a, spot b, const outline *to, bool axis, double distance, int depth) {
  spot c[2];
  bool near[2] = {false, false};
  for (size_t n = 0; n <= to->count; n++) {
    segment_of(to, n, c);
    if (!axis && on_axis(c)) {
      continue;
    }
    bool first = sepax__spot_distance(a, c[0], c[1]) <= distance;
    bool second = sepax__spot_distance(b, c[0], c[1]) <= distance;
    if (first && second) {
      return true;
    }
    near[0] = near[0] || first;
    near[1] = near[1] || second;
  }
  spot middle = {a.z + (b.z - a.z) / 2, a.r + (b.r - a.r) / 2};
  return near[0] && near[1] && depth > 0 && near_all(a, middle, to, axis, distance, depth - 1) &&
         near_all(middle, b, to, axis, distance, depth - 1);
}

/* What is not `depth` deep at one height stays so farther from the axis, because the shrunk region
 * is 0 <= r <= S(z). So of a step only the point next to the axis is looked at. */
bool sepax__outline_covered(const outline *o, const outline *from, double depth) {
  for (size_t n = 1; n < o->count; n++) {
    spot a = o->at[n - 1];
    spot b = o->at[n];
    if (a.z == b.z) {
      a.r = b.r = fmin(a.r, b.r);
    }
    if (!near_all(a, b, from, true, depth, DEPTH)) {
      return false;
    }
  }
  if (o->count == 0) {
    return true;
  }
  const spot ends[2] = {{o->at[0].z, 0}, {o->at[o->count - 1].z, 0}};
  return near_all(ends[0], ends[0], from, true, depth, 0) &&
         near_all(ends[1], ends[1], from, true, depth, 0);
}

/* It is enough to look at the points of the outline itself. Let q = (z, R) be such a point and w a
 * point of `inner` within `gap` of q. A point (z, r) with r <= R is then within `gap` of the point
 * of `inner` at the height of w and at the distance min(r, r of w) from the axis. */
bool sepax__outline_reaches(const outline *o, bool o_axis, const outline *inner, bool inner_axis,
                            double gap) {
  spot origin = {0, 0};
  const outline nothing = {&origin, 1, 1};
  spot a[2];
  inner = inner->count > 0 ? inner : &nothing;
  for (size_t n = 0; n <= o->count && o->count > 0; n++) {
    segment_of(o, n, a);
    if ((o_axis || !on_axis(a)) && !near_all(a[0], a[1], inner, inner_axis, gap, DEPTH)) {
      return false;
    }
  }
  return true;
}
