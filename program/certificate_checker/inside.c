/* SPDX-License-Identifier: MIT */
/* inside.c - finds the parts of surfaces, and tests by rays whether one is inside another. */
#include "inside.h"

#include "pieces.h"
#include "report.h"
#include "sheets.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  vec at;
  size_t place; /* 3 triangle + corner */
} corner;

static int compare_numbers(double a, double b) { return (a > b) - (a < b); }
static int compare_sizes(size_t a, size_t b) { return (a > b) - (a < b); }

static int compare_corners(const void *x, const void *y) {
  const corner *a = x;
  const corner *b = y;
  int order = compare_numbers(a->at.x, b->at.x);
  if (order == 0)
    order = compare_numbers(a->at.y, b->at.y);
  return order != 0 ? order : compare_numbers(a->at.z, b->at.z);
}

static int compare_edges(const void *x, const void *y) {
  const edge *a = x;
  const edge *b = y;
  const int order = compare_sizes(a->low, b->low);
  return order != 0 ? order : compare_sizes(a->high, b->high);
}

static size_t root_of(size_t *parent, size_t n) {
  while (parent[n] != n)
    n = parent[n] = parent[parent[n]];
  return n;
}

/* Numbers of equal vertices are equal. */
static size_t *welded(const triangle *t, size_t count) {
  corner *all = memory(NULL, 3 * count, sizeof *all);
  size_t *vertex = memory(NULL, 3 * count, sizeof *vertex);
  for (size_t n = 0; n < 3 * count; n++)
    all[n] = (corner){t[n / 3].at[n % 3], n};
  qsort(all, 3 * count, sizeof *all, compare_corners);
  size_t number = 0;
  for (size_t n = 0; n < 3 * count; n++) {
    if (n > 0 && compare_corners(&all[n - 1], &all[n]) != 0)
      number++;
    vertex[all[n].place] = number;
  }
  free(all);
  return vertex;
}

static double coordinate(vec p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

/* Of those that are farthest out, two an axis, the low one first. */
static void part_add(shell_part *part, vec p) {
  for (int n = 0; n < 6; n++) {
    const double by = coordinate(p, n / 2) - coordinate(part->at[n + 1], n / 2);
    if (n % 2 == 0 ? by < 0 : by > 0)
      part->at[n + 1] = p;
  }
}

/* The parts of count triangles, whose roots are in `parent`. */
static void add_parts(shell *s, const triangle *t, size_t count, size_t *parent) {
  size_t *number = memory(NULL, count, sizeof *number);
  for (size_t n = 0; n < count; n++) {
    if (root_of(parent, n) != n)
      continue;
    GROW(s->part, s->parts);
    for (int k = 0; k < 7; k++)
      s->part[s->parts].at[k] = t[n].at[0];
    number[n] = s->parts++;
  }
  for (size_t n = 0; n < 3 * count; n++)
    part_add(&s->part[number[root_of(parent, n / 3)]], t[n / 3].at[n % 3]);
  free(number);
}

static void open_add(open_box *box, const triangle *t) {
  if (!box->any)
    *box = (open_box){true, t->at[0], t->at[0]};
  for (int k = 0; k < 3; k++) {
    const vec p = t->at[k];
    box->low = (vec){fmin(box->low.x, p.x), fmin(box->low.y, p.y), fmin(box->low.z, p.z)};
    box->high = (vec){fmax(box->high.x, p.x), fmax(box->high.y, p.y), fmax(box->high.z, p.z)};
  }
}

/* Two of its corners are one. */
static bool is_line(const size_t v[3]) { return v[0] == v[1] || v[1] == v[2] || v[2] == v[0]; }

/* One collision element: count triangles from `first`. */
static void element_parts(shell *s, size_t element, size_t first, size_t count) {
  const triangle *t = s->body->triangle + first;
  size_t *vertex = welded(t, count);
  edge *edges = memory(NULL, 3 * count, sizeof *edges);
  size_t *parent = memory(NULL, count, sizeof *parent);
  bool *odd = memory(NULL, count, sizeof *odd);
  size_t used = 0;
  for (size_t n = 0; n < count; n++) {
    parent[n] = n;
    odd[n] = false;
    for (size_t k = 0; k < 3; k++) {
      const size_t from = vertex[3 * n + k];
      const size_t to = vertex[3 * n + (k + 1) % 3];
      if (from == to)
        continue; /* a side without length */
      edges[used++] = (edge){from < to ? from : to, from < to ? to : from, n, from < to};
    }
  }
  qsort(edges, used, sizeof *edges, compare_edges);
  for (size_t n = 1; n < used; n++) {
    if (compare_edges(&edges[n - 1], &edges[n]) == 0) {
      parent[root_of(parent, edges[n].triangle)] = root_of(parent, edges[n - 1].triangle);
    }
  }
  size_t *before = memory(NULL, count, sizeof *before);
  size_t *copies = memory(NULL, count, sizeof *copies);
  sheets_find(before, copies, edges, used, vertex, count);
  bool *twisted = s->turned + first;
  memset(twisted, 0, count * sizeof *twisted);
  bool *split = memory(NULL, count, sizeof *split); /* of a part: open with one of each */
  memset(split, 0, count * sizeof *split);
  for (size_t n = 0; n < count; n++) {
    s->out[first + n][0] = false;
    s->out[first + n][1] = before[n] > 0;
    s->out[first + n][2] = before[n] % 2 != 0;
  }
  size_t *times = memory(NULL, count, sizeof *times); /* of a part: 0: not known yet */
  memset(times, 0, count * sizeof *times);
  for (size_t n = 0; n < used;) {
    size_t end = n;
    long ways = 0;
    size_t kept = 0; /* of those with one copy of each sheet */
    size_t one = 0;  /* the same without triangles that are lines */
    for (; end < used && compare_edges(&edges[n], &edges[end]) == 0; end++) {
      ways += edges[end].forward ? 1 : -1;
      kept += before[edges[end].triangle] == 0;
      one += before[edges[end].triangle] == 0 && !is_line(&vertex[3 * edges[end].triangle]);
    }
    const size_t of = root_of(parent, edges[n].triangle);
    if ((end - n) % 2 != 0)
      odd[of] = true;
    if (ways != 0)
      twisted[of] = true;
    if (one > 2)
      times[of] = SIZE_MAX;
    if (kept % 2 != 0)
      split[of] = true;
    n = end;
  }
  /* A part with copies is closed if it is copies of one surface: each sheet has as many copies, and
   * one of each are closed, with two triangles at each edge. Other copies may hide what they
   * enclose. */
  for (size_t n = 0; n < count; n++) {
    const size_t of = root_of(parent, n);
    odd[of] = odd[of] || (copies[n] > 1 && (split[of] || times[of] == SIZE_MAX));
  }
  for (size_t n = 0; n < count; n++) {
    const size_t of = root_of(parent, n);
    if (!is_line(&vertex[3 * n]) && times[of] != SIZE_MAX) {
      odd[of] = odd[of] || (times[of] != 0 && times[of] != copies[n]);
      times[of] = copies[n];
    }
  }
  s->consistent[element] = true;
  s->open[element].any = false;
  bool open = false;
  for (size_t n = 0; n < count; n++) {
    const size_t of = root_of(parent, n);
    s->closed[first + n] = !odd[of];
    s->part_of[first + n] = first + of;
    s->piece[first + n] = SIZE_MAX;
    open = open || odd[of];
    if (!odd[of] && twisted[of])
      s->consistent[element] = false;
  }
  for (size_t n = 0; n < count && open; n++)
    open_add(&s->open[element], &t[n]);
  if (!s->body->element[element].hulls) /* their polygons are parts */
    add_parts(s, t, count, parent);
  free(times);
  free(split);
  free(copies);
  free(before);
  free(odd);
  free(parent);
  free(edges);
  free(vertex);
}

static size_t element_end(const surface *s, size_t element) {
  return element + 1 < s->elements ? s->element[element + 1].first : s->count;
}

shell shell_of(const surface *s) {
  shell made = {.body = s,
                .closed = memory(NULL, s->count, sizeof *made.closed),
                .part_of = memory(NULL, s->count, sizeof *made.part_of),
                .out = memory(NULL, s->count, sizeof *made.out),
                .turned = memory(NULL, s->count, sizeof *made.turned),
                .piece = memory(NULL, s->count, sizeof *made.piece),
                .consistent = memory(NULL, s->elements, sizeof *made.consistent),
                .open = memory(NULL, s->elements, sizeof *made.open)};
  for (size_t n = 0; n < s->elements; n++) {
    element_parts(&made, n, s->element[n].first, element_end(s, n) - s->element[n].first);
  }
  return made;
}

/* Of differences of doubles. Edges that several triangles have whole are the same doubles in each;
 * a vertex in the middle of an edge is beside it by as much as doubles are rounded. */
static const long double EXACT = 0x1p-63L;
static const long double ROUNDED = 0x1p-53L;

typedef enum { RAY_MISSES, RAY_ENTERS, RAY_LEAVES, RAY_UNSURE } ray_meets;

static int sign_of(long double value, long double rounding) {
  return value > rounding ? 1 : value < -rounding ? -1 : 0;
}

/* The ray from the origin along d; doubt: above the rounding of three factors' product. */
static ray_meets ray_meet(point a, point b, point c, point d, long double doubt) {
  const point bc = point_cross(b, c);
  const int of_a = sign_of(point_dot(d, bc), doubt);
  const int of_b = sign_of(point_dot(d, point_cross(c, a)), doubt);
  const int of_c = sign_of(point_dot(d, point_cross(a, b)), doubt);
  const bool some_up = of_a > 0 || of_b > 0 || of_c > 0;
  const bool some_down = of_a < 0 || of_b < 0 || of_c < 0;
  if (some_up && some_down)
    return RAY_MISSES;
  if (of_a == 0 || of_b == 0 || of_c == 0) {
    /* All of the triangle behind the origin: missed in any case. */
    const long double slack = doubt;
    if (point_dot(a, d) < -slack && point_dot(b, d) < -slack && point_dot(c, d) < -slack) {
      return RAY_MISSES;
    }
    return RAY_UNSURE;
  }
  const int side = sign_of(point_dot(a, bc), doubt);
  if (side == 0)
    return RAY_UNSURE;
  if (side != of_a)
    return RAY_MISSES; /* behind */
  return of_a > 0 ? RAY_LEAVES : RAY_ENTERS;
}

/* Above the rounding of the products of ray_meet, for rays from p, where coordinates have it. */
static long double doubt_at(const surface *s, point p, long double rounding) {
  /* No corner is farther from p than `size`; differences are as wrong as coordinates of `reach`. */
  const point far = {fmaxl(s->high.x - p.x, p.x - s->low.x), fmaxl(s->high.y - p.y, p.y - s->low.y),
                     fmaxl(s->high.z - p.z, p.z - s->low.z)};
  const long double size = point_length(far);
  const long double reach = (long double)s->radius + point_length(p);
  return 64 * rounding * reach * fmaxl(size * size, size);
}

static ray_meets triangle_meet(const triangle *t, point p, point d, long double doubt) {
  return ray_meet(point_minus(point_of(t->at[0]), p), point_minus(point_of(t->at[1]), p),
                  point_minus(point_of(t->at[2]), p), d, doubt);
}

/* A part that a ray meets. */
typedef struct {
  size_t part; /* what stands for it */
  long crossings[READINGS];
  long winding;
} part_met;

typedef struct {
  part_met *part;
  size_t parts;
} ray_parts;

static void part_cross(ray_parts *r, const shell *b, size_t place, int way) {
  const size_t part = b->part_of[place];
  size_t n = 0;
  while (n < r->parts && r->part[n].part != part)
    n++;
  if (n == r->parts) {
    GROW(r->part, r->parts);
    r->part[r->parts++] = (part_met){.part = part};
  }
  r->part[n].winding += way;
  for (int k = 0; k < READINGS; k++)
    r->part[n].crossings[k] += !b->out[place][k];
}

/* Is the ray's origin inside the part? */
static bool part_holds(const shell *b, const part_met *m, int reading) {
  if (m->crossings[0] % 2 != 0 || (!b->turned[m->part] && m->winding != 0))
    return true;
  return m->crossings[reading] % 2 != 0;
}

static size_t piece_of(const shell *b, size_t element, size_t part) {
  const size_t first = b->body->element[element].first;
  const size_t count = element_end(b->body, element) - first;
  if (b->piece[part] == SIZE_MAX) {
    size_t *own = memory(NULL, count, sizeof *own);
    for (size_t n = 0; n < count; n++)
      own[n] = b->part_of[first + n] - first;
    pieces_find(b->piece + first, b->body->triangle + first, count, b->body->radius, own);
    free(own);
  }
  return b->piece[part];
}

/* Not proved to be inside of no piece, or of an even number of them, in some reading? Two parts of
 * one piece may be two pieces or one. */
static bool pieces_hold(const shell *b, size_t element, const ray_parts *r) {
  for (int reading = 0; reading < READINGS; reading++) {
    bool odd = false;
    for (size_t n = 0; n < r->parts; n++) {
      if (!part_holds(b, &r->part[n], reading))
        continue;
      odd = !odd;
      for (size_t k = 0; k < n; k++) {
        if (part_holds(b, &r->part[k], reading) &&
            piece_of(b, element, r->part[k].part) == piece_of(b, element, r->part[n].part))
          return true;
      }
    }
    if (odd)
      return true;
  }
  return false;
}

/* Inside the element of b? -1: the ray goes too near to an edge. */
static int element_holds(const shell *b, size_t element, point p, point d) {
  const surface *s = b->body;
  const long double doubt = doubt_at(s, p, EXACT);
  long crossings = 0;
  long winding = 0;
  ray_parts met = {NULL, 0};
  ray_meets at = RAY_MISSES;
  for (size_t n = s->element[element].first; n < element_end(s, element) && at != RAY_UNSURE; n++) {
    at = b->closed[n] ? triangle_meet(&s->triangle[n], p, d, doubt) : RAY_MISSES;
    if (at == RAY_ENTERS || at == RAY_LEAVES) {
      const int way = at == RAY_LEAVES ? 1 : -1;
      crossings++;
      winding += way;
      part_cross(&met, b, n, way);
    }
  }
  const bool holds = b->consistent[element] ? winding != 0 : crossings % 2 != 0;
  const bool inside = at != RAY_UNSURE && (holds || pieces_hold(b, element, &met));
  free(met.part);
  return at == RAY_UNSURE ? -1 : inside;
}

static bool within_box(const surface *s, point p) {
  return p.x > s->low.x && p.x < s->high.x && p.y > s->low.y && p.y < s->high.y && p.z > s->low.z &&
         p.z < s->high.z;
}

/* Of length 1, and none of them along an axis, where edges are; the same ones each time. */
enum { RAYS = 100 };
static const point *rays(void) {
  static point ray[RAYS];
  uint32_t seed = 1;
  for (int n = 0; n < RAYS && point_length(ray[RAYS - 1]) == 0;) {
    long double d[3];
    for (int k = 0; k < 3; k++) {
      seed = seed * 1664525U + 1013904223U;
      d[k] = (long double)seed / 0x1p31L - 1;
    }
    const point along = {d[0], d[1], d[2]};
    const long double length = point_length(along);
    if (length >= 0.1L)
      ray[n++] = point_times(1 / length, along);
  }
  return ray;
}

static bool holds(const shell *b, size_t element, point p) {
  for (int n = 0; n < RAYS; n++) {
    const int inside = element_holds(b, element, p, rays()[n]);
    if (inside >= 0)
      return inside;
  }
  cannot("no ray tells whether one body is inside another");
}

bool shell_inside(const shell *a, const shell *b, pose at) {
  for (size_t n = 0; n < a->parts; n++) {
    const point p = pose_apply(at, point_of(a->part[n].at[0]));
    if (!within_box(b->body, p))
      continue;
    for (size_t element = 0; element < b->body->elements; element++) {
      if (holds(b, element, p))
        return true;
    }
  }
  return false;
}

static bool beyond(const open_box *box, point p, long double slack) {
  return p.x < box->low.x - slack || p.x > box->high.x + slack || p.y < box->low.y - slack ||
         p.y > box->high.y + slack || p.z < box->low.z - slack || p.z > box->high.z + slack;
}

static bool ray_is_free(const shell *b, size_t element, point p, point d) {
  const surface *s = b->body;
  const long double doubt = doubt_at(s, p, ROUNDED);
  for (size_t n = s->element[element].first; n < element_end(s, element); n++) {
    if (triangle_meet(&s->triangle[n], p, d, doubt) != RAY_MISSES)
      return false;
  }
  return true;
}

/* Proved to be outside whatever the triangles of an element with open ones enclose? Closed parts
 * count, too: one may be a face with both of its sides, which fills a hole of the others. A part of
 * a that touches none of the triangles is outside where one of its vertices is. An even number of
 * crossings would not do: two solids may overlap. */
static bool outside_open(const shell_part *part, const shell *b, size_t element, pose at) {
  enum { VERTICES = sizeof part->at / sizeof *part->at };
  point p[VERTICES];
  for (int n = 0; n < VERTICES; n++) {
    p[n] = pose_apply(at, point_of(part->at[n]));
    const long double reach = (long double)b->body->radius + point_length(p[n]);
    if (beyond(&b->open[element], p[n], 64 * ROUNDED * reach))
      return true;
  }
  for (int n = 0; n < VERTICES * RAYS; n++) {
    if (ray_is_free(b, element, p[n / RAYS], rays()[n % RAYS]))
      return true;
  }
  return false;
}

bool shell_may_be_inside(const shell *a, const shell *b, pose at) {
  for (size_t element = 0; element < b->body->elements; element++) {
    for (size_t n = 0; n < a->parts && b->open[element].any; n++) {
      if (!outside_open(&a->part[n], b, element, at))
        return true;
    }
  }
  return false;
}
