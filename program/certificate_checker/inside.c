/* SPDX-License-Identifier: MIT */
/* inside.c - proves by rays that no part of one body is inside the other. */
#include "inside.h"

#include "pieces.h"
#include "report.h"
#include "sets.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------ boxes */

static void open_add(open_box *to, const part *p) {
  if (!to->any)
    *to = (open_box){true, p->at[0], p->at[0]};
  to->low.x = fmin(to->low.x, p->at[1].x);
  to->high.x = fmax(to->high.x, p->at[2].x);
  to->low.y = fmin(to->low.y, p->at[3].y);
  to->high.y = fmax(to->high.y, p->at[4].y);
  to->low.z = fmin(to->low.z, p->at[5].z);
  to->high.z = fmax(to->high.z, p->at[6].z);
}

shell shell_of(const surface *s) {
  shell made = {
      .body = s, .of = sheets_of(s), .open = memory(NULL, s->elements, sizeof *made.open)};
  memset(made.open, 0, s->elements * sizeof *made.open);
  for (size_t n = 0; n < made.of.parts; n++) {
    const part *p = &made.of.part[n];
    if (p->open)
      open_add(&made.open[p->element], p);
    made.any_open = made.any_open || p->open;
  }
  return made;
}

static bool beyond(vec low, vec high, point p, long double slack) {
  return p.x < low.x - slack || p.x > high.x + slack || p.y < low.y - slack ||
         p.y > high.y + slack || p.z < low.z - slack || p.z > high.z + slack;
}

static bool beyond_part(const part *of, point p, long double slack) {
  const vec low = {of->at[1].x, of->at[3].y, of->at[5].z};
  const vec high = {of->at[2].x, of->at[4].y, of->at[6].z};
  return beyond(low, high, p, slack);
}

/* ------------------------------------------------------------------------ rays */

/* Above the errors of lengths, and of products of two and of three lengths, at a ray's origin. */
typedef struct {
  long double length, area, volume;
} doubts;

/* Coordinates are rounded to doubles, so a vertex in the middle of an edge is beside it by as much:
 * a ray must pass edges farther away. It passes the same triangles in the surface without rounding,
 * which the bodies' distance is above. On which side of a triangle p is, that is for the doubles
 * themselves: their differences are rounded to long doubles. */
static doubts doubts_at(const surface *s, point p) {
  const long double rounded = 0x1p-53L;
  const long double exact = 0x1p-63L;
  const point far = {fmaxl(s->high.x - p.x, p.x - s->low.x), fmaxl(s->high.y - p.y, p.y - s->low.y),
                     fmaxl(s->high.z - p.z, p.z - s->low.z)};
  const long double size = point_length(far); /* no corner is farther from p */
  const long double reach = (long double)s->radius + point_length(p);
  return (doubts){64 * rounded * reach, 64 * rounded * reach * size,
                  64 * exact * reach * size * size};
}

typedef enum { RAY_MISSES, RAY_ENTERS, RAY_LEAVES, RAY_UNSURE } ray_meets;

static int sign_of(long double value, long double doubt) {
  return value > doubt ? 1 : value < -doubt ? -1 : 0;
}

/* The ray from p along d, of length 1. */
static ray_meets ray_meet(const triangle *t, point p, point d, const doubts *doubt) {
  const point a = point_minus(point_of(t->at[0]), p);
  const point b = point_minus(point_of(t->at[1]), p);
  const point c = point_minus(point_of(t->at[2]), p);
  const point bc = point_cross(b, c);
  const int of_a = sign_of(point_dot(d, bc), doubt->area);
  const int of_b = sign_of(point_dot(d, point_cross(c, a)), doubt->area);
  const int of_c = sign_of(point_dot(d, point_cross(a, b)), doubt->area);
  const bool some_up = of_a > 0 || of_b > 0 || of_c > 0;
  const bool some_down = of_a < 0 || of_b < 0 || of_c < 0;
  if (some_up && some_down)
    return RAY_MISSES;
  if (of_a == 0 || of_b == 0 || of_c == 0) {
    const long double near = -doubt->length;
    const bool behind = point_dot(a, d) < near && point_dot(b, d) < near && point_dot(c, d) < near;
    return behind ? RAY_MISSES : RAY_UNSURE;
  }
  const int side = sign_of(point_dot(a, bc), doubt->volume);
  if (side == 0)
    return RAY_UNSURE;
  if (side != of_a)
    return RAY_MISSES; /* behind */
  return of_a > 0 ? RAY_LEAVES : RAY_ENTERS;
}

/* Of length 1, and none of them along an axis, where edges are; the same ones each time. */
enum { RAYS = 16 };
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

/* ------------------------------------------------------------------------ proofs */

/* What a ray crosses: a triangle, then all of a sheet. */
typedef struct {
  size_t sheet;
  const part *part;
  long sum; /* leaves less entries */
} crossing;

static int compare_sheets(const void *x, const void *y) {
  const crossing *a = x;
  const crossing *b = y;
  return (a->sheet > b->sheet) - (a->sheet < b->sheet);
}

/* In each element the outermost first, if their boxes are nested. */
static int compare_nesting(const void *x, const void *y) {
  const part *a = ((const crossing *)x)->part;
  const part *b = ((const crossing *)y)->part;
  if (a->element != b->element)
    return a->element < b->element ? -1 : 1;
  return (a->at[1].x > b->at[1].x) - (a->at[1].x < b->at[1].x);
}

/* Keep the sheets whose crossings do not cancel. Returns how many there are. */
static size_t cancel(crossing *all, size_t count) {
  size_t kept = 0;
  qsort(all, count, sizeof *all, compare_sheets);
  for (size_t n = 0; n < count;) {
    crossing sum = all[n];
    for (n++; n < count && all[n].sheet == sum.sheet; n++)
      sum.sum += all[n].sum;
    if (sum.sum != 0)
      all[kept++] = sum;
  }
  return kept;
}

/* Is what is crossed a chain of walls of solids and their cavities, in each element? */
static bool in_cavity(shell *b, crossing *all, size_t count) {
  qsort(all, count, sizeof *all, compare_nesting);
  bool proved = count % 2 == 0;
  for (size_t n = 0; n < count && proved; n++) {
    proved = !all[n].part->twisted && all[n].sum == (n % 2 == 0 ? 1 : -1) &&
             (n % 2 == 0 || all[n].part->element == all[n - 1].part->element);
  }
  if (!proved)
    return false;
  if (b->piece == NULL)
    b->piece = pieces_of(b->body, &b->of);
  bool *seen = memory(NULL, b->of.parts, sizeof *seen);
  memset(seen, 0, b->of.parts * sizeof *seen);
  for (size_t n = 0; n < count; n++) {
    const size_t piece = b->piece[all[n].part - b->of.part];
    proved = proved && !seen[piece];
    seen[piece] = true;
  }
  free(seen);
  return proved;
}

/* Does the ray from p along d prove that p, which is in the box of no element's open parts, is
 * outside b? */
static bool ray_proves(shell *b, point p, point d, const doubts *doubt) {
  crossing *all = NULL;
  size_t count = 0;
  ray_meets at = RAY_MISSES;
  for (size_t n = 0; n < b->body->count && at != RAY_UNSURE; n++) {
    const part *of = &b->of.part[b->of.part_of[n]];
    if (b->of.sheet_of[n] == NONE || beyond_part(of, p, doubt->length))
      continue;
    at = ray_meet(&b->body->triangle[n], p, d, doubt);
    if (at != RAY_MISSES && b->of.sheet_of[n] == FLAT)
      at = RAY_UNSURE;
    if (at == RAY_LEAVES || at == RAY_ENTERS) {
      GROW(all, count);
      all[count++] = (crossing){b->of.sheet_of[n], of, at == RAY_LEAVES ? 1 : -1};
    }
  }
  bool proved = at != RAY_UNSURE;
  if (proved && count > 0) {
    count = cancel(all, count);
    proved = count == 0 || in_cavity(b, all, count);
  }
  free(all);
  return proved;
}

/* Is the point p, of a part that touches no triangle of b, proved to be outside b? */
static bool point_outside(shell *b, point p) {
  const doubts doubt = doubts_at(b->body, p);
  if (beyond(b->body->low, b->body->high, p, doubt.length))
    return true;
  for (size_t n = 0; n < b->body->elements; n++) {
    if (b->open[n].any && !beyond(b->open[n].low, b->open[n].high, p, doubt.length))
      return false;
  }
  for (int n = 0; n < RAYS; n++) {
    if (ray_proves(b, p, rays()[n], &doubt))
      return true;
  }
  return false;
}

bool shell_outside(const shell *a, shell *b, pose at) {
  enum { VERTICES = sizeof a->of.part->at / sizeof *a->of.part->at };
  for (size_t n = 0; n < a->of.parts; n++) {
    const part *of = &a->of.part[n];
    bool proved = a->body->element[of->element].hull; /* its polygon is a part */
    for (int k = 0; k < VERTICES && !proved; k++)
      proved = point_outside(b, pose_apply(at, point_of(of->at[k])));
    if (!proved)
      return false;
  }
  return true;
}
