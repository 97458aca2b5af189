/* SPDX-License-Identifier: MIT */
/* polygon.c - ears are cut off until a triangle is left.
 *
 * That the division is right needs no proof of the search: the numbers of turns around a point of
 * all triangles add up to that of the polygon, which is 1 inside and 0 outside. As no triangle is
 * turned the other way, they tile the polygon. */
#include "polygon.h"

#include "report.h"

#include <stdlib.h>
#include <string.h>

enum { CORNERS_MOST = 20000 };

typedef struct {
  long double x, y;
} flat_point;

static long double area(flat_point a, flat_point b, flat_point c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

static long double longest(flat_point a, flat_point b, flat_point c) {
  return fmaxl(hypotl(b.x - a.x, b.y - a.y),
               fmaxl(hypotl(c.x - b.x, c.y - b.y), hypotl(a.x - c.x, a.y - c.y)));
}

/* 0 where rounding may have made the sign; a triangle so thin is a segment here. */
static int side(flat_point a, flat_point b, flat_point c) {
  const long double twice = area(a, b, c);
  const long double length = longest(a, b, c);
  const long double doubt = 0x1p-60L * length * length;
  return twice > doubt ? 1 : twice < -doubt ? -1 : 0;
}

/* Corners that are not in the way of an ear: outside it, or at one of its corners. */
static bool is_free(const flat_point *p, const size_t *left, size_t count, size_t at) {
  const flat_point a = p[left[(at + count - 1) % count]];
  const flat_point b = p[left[at]];
  const flat_point c = p[left[(at + 1) % count]];
  for (size_t n = 2; n + 1 < count; n++) {
    const flat_point q = p[left[(at + n) % count]];
    if ((q.x == a.x && q.y == a.y) || (q.x == b.x && q.y == b.y) || (q.x == c.x && q.y == c.y))
      continue;
    if (side(a, b, q) >= 0 && side(b, c, q) >= 0 && side(c, a, q) >= 0)
      return false;
  }
  return true;
}

/* The polygon runs anticlockwise. false: no ear is left. */
static bool cut_ears(const flat_point *p, size_t count, size_t (*triangle)[3]) {
  size_t *left = memory(NULL, count, sizeof *left);
  for (size_t n = 0; n < count; n++)
    left[n] = n;
  size_t made = 0;
  while (count > 2) {
    size_t found = count;
    for (int least = 1; least >= 0 && found == count; least--) {
      for (size_t n = 0; n < count && found == count; n++) {
        const flat_point a = p[left[(n + count - 1) % count]];
        const flat_point c = p[left[(n + 1) % count]];
        if (side(a, p[left[n]], c) == least && (count == 3 || is_free(p, left, count, n)))
          found = n;
      }
    }
    if (found == count)
      break;
    triangle[made][0] = left[(found + count - 1) % count];
    triangle[made][1] = left[found];
    triangle[made++][2] = left[(found + 1) % count];
    count--;
    memmove(left + found, left + found + 1, (count - found) * sizeof *left);
  }
  free(left);
  return count == 2;
}

/* Of a convex polygon all divisions are right, along whatever axis it is seen. */
static bool is_convex(const flat_point *p, size_t count) {
  for (size_t n = 0; n < count; n++) {
    if (side(p[n], p[(n + 1) % count], p[(n + 2) % count]) <= 0)
      return false;
    if (n + 2 < count && side(p[0], p[n + 1], p[n + 2]) <= 0)
      return false;
  }
  return true;
}

static void fan(size_t count, size_t (*triangle)[3]) {
  for (size_t n = 0; n + 2 < count; n++) {
    triangle[n][0] = 0;
    triangle[n][1] = n + 1;
    triangle[n][2] = n + 2;
  }
}

/* Twice the area, as a vector. */
static point normal_of(const point *corner, size_t count) {
  point sum = {0, 0, 0};
  for (size_t n = 1; n + 1 < count; n++) {
    sum = point_plus(
        sum, point_cross(point_minus(corner[n], corner[0]), point_minus(corner[n + 1], corner[0])));
  }
  return sum;
}

static long double coordinate(point p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

static bool on_a_line(const point *corner, size_t count) {
  size_t far = 0;
  for (size_t n = 1; n < count; n++) {
    if (point_length(point_minus(corner[n], corner[0])) >
        point_length(point_minus(corner[far], corner[0])))
      far = n;
  }
  const point way = point_minus(corner[far], corner[0]);
  for (size_t n = 1; n < count; n++) {
    const point across = point_cross(way, point_minus(corner[n], corner[0]));
    if (point_length(across) > 1e-17L * point_dot(way, way))
      return false;
  }
  return true;
}

/* In the order of the corners. `triangle` is NULL if the polygon crosses itself. */
static division divide(const mesh *m, const point *corner, size_t count) {
  if (count > CORNERS_MOST)
    cannot("%s: a polygon of %zu corners", m->file, count);
  division d = {memory(NULL, count - 2, sizeof *d.triangle), false, {0, 0, 0}};
  fan(count, d.triangle);
  if (count == 3 || on_a_line(corner, count))
    return d;
  const point normal = normal_of(corner, count);
  int axis = 0;
  long double second = 0;
  for (int n = 1; n < 3; n++) {
    if (fabsl(coordinate(normal, n)) > fabsl(coordinate(normal, axis)))
      axis = n;
  }
  for (int n = 0; n < 3; n++)
    second = n == axis ? second : fmaxl(second, fabsl(coordinate(normal, n)));
  const long double along = coordinate(normal, axis);
  long double reach = 0;
  for (size_t n = 1; n < count; n++)
    reach = fmaxl(reach, point_length(point_minus(corner[n], corner[0])));
  /* Without an area it has no side: it crosses itself, or comes back as it went. */
  if (fabsl(along) <= 1e-16L * reach * reach) {
    free(d.triangle);
    d.triangle = NULL;
    return d;
  }
  flat_point *p = memory(NULL, count, sizeof *p);
  long double low = 0;
  long double high = 0;
  long double size = 0;
  for (size_t n = 0; n < count; n++) {
    const point from = point_minus(corner[n], corner[0]);
    const long double height = point_dot(normal, from) / along;
    low = fminl(low, height);
    high = fmaxl(high, height);
    size = fmaxl(size, point_length(corner[n]));
    p[n] = (flat_point){coordinate(from, (axis + 1) % 3), coordinate(from, (axis + 2) % 3)};
    if (along < 0)
      p[n].y = -p[n].y;
  }
  /* Below this the height is of the rounding of the corners, which a proof takes into account. */
  d.bent = high - low > 1e-14L * size;
  const bool convex = is_convex(p, count);
  /* A program that sees it along another axis might divide it otherwise, and not within the hull.
   */
  if (d.bent && !convex && second > (1 - 1e-9L) * fabsl(along))
    cannot("%s: a polygon of %zu corners is bent, concave and at 45 degrees; divide it into "
           "triangles",
           m->file, count);
  if (!convex && !cut_ears(p, count, d.triangle)) {
    free(d.triangle);
    d.triangle = NULL;
  }
  const long double height = (high - low) * (1 + 1e-9L) * (along < 0 ? -1 : 1);
  d.up = (point){axis == 0 ? height : 0, axis == 1 ? height : 0, axis == 2 ? height : 0};
  free(p);
  return d;
}

static bool is_before(point a, point b) {
  return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

/* Both sides of a face are divided alike: from the lowest corner towards its lower neighbour. */
division polygon_divide(mesh *m, const point *corner, size_t count) {
  size_t first = 0;
  for (size_t n = 1; n < count; n++) {
    if (is_before(corner[n], corner[first]))
      first = n;
  }
  const bool back = is_before(corner[(first + count - 1) % count], corner[(first + 1) % count]);
  const size_t step = back ? count - 1 : 1;
  point *turned = memory(NULL, count, sizeof *turned);
  for (size_t n = 0; n < count; n++)
    turned[n] = corner[(first + n * step) % count];
  division d = divide(m, turned, count);
  free(turned);
  if (d.triangle == NULL) {
    if (!m->fans)
      cannot("%s: a polygon of %zu corners crosses itself; divide it into triangles", m->file,
             count);
    d = (division){memory(NULL, count - 2, sizeof *d.triangle), false, {0, 0, 0}};
    fan(count, d.triangle);
    m->fanned++;
    return d;
  }
  for (size_t n = 0; n + 2 < count; n++) {
    const size_t *of = d.triangle[n];
    const size_t made[3] = {of[back ? 2 : 0], of[1], of[back ? 0 : 2]};
    for (int k = 0; k < 3; k++)
      d.triangle[n][k] = (first + made[k] * step) % count;
  }
  d.up = point_times(back ? -1 : 1, d.up);
  return d;
}
