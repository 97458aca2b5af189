/* SPDX-License-Identifier: MIT */
/* separation.c - two trees of boxes, down to pairs of triangles. Everything is in the coordinates
 * of the second body; the first goes by s (spin x p + drift), s from -1 to 1, and up to `curve`
 * elsewhere, which is part of what an axis must show.
 *
 * A vector n of length 1 separates a swept vertex p of the first body from a vertex q of the second
 * by more than `need` where n p - |n u| - n q > need, u being p's way. All of a triangle, at the
 * same s, is between its vertices, so that the vertices tell. */
#include "separation.h"

#include "report.h"

#include <float.h>
#include <stdlib.h>

typedef struct {
  const box_tree *a, *b;
  const motion *m;
  double need;
  double spin; /* its length */
} scene;

typedef struct {
  int a, b;
} work;

static vec turned(const motion *m, vec p) {
  return (vec){m->column[0].x * p.x + m->column[1].x * p.y + m->column[2].x * p.z,
               m->column[0].y * p.x + m->column[1].y * p.y + m->column[2].y * p.z,
               m->column[0].z * p.x + m->column[1].z * p.y + m->column[2].z * p.z};
}

static vec placed(const motion *m, vec p) { return vec_plus(turned(m, p), m->shift); }

static vec way(const motion *m, vec at) { return vec_plus(vec_cross(m->spin, at), m->drift); }

/* A box of a where b is. */
typedef struct {
  int of; /* -1: none */
  vec middle, way;
  vec axis[3], side[3]; /* half of a side */
  const double *half;
  double spread; /* how much farther its points go than the middle, at most */
} moved;

static void move(const scene *s, int of, moved *w) {
  const box *a = &s->a->box[of];
  w->of = of;
  w->middle = placed(s->m, a->middle);
  w->way = way(s->m, w->middle);
  w->half = a->half;
  for (int k = 0; k < 3; k++) {
    w->axis[k] = turned(s->m, a->axis[k]);
    w->side[k] = vec_times(a->half[k], w->axis[k]);
  }
  w->spread = s->spin * a->radius * (1 + 0x1p-46);
}

static double shadow(const vec *side, vec n) {
  return fabs(vec_dot(n, side[0])) + fabs(vec_dot(n, side[1])) + fabs(vec_dot(n, side[2]));
}

/* The sides of the boxes as axes. */
static bool boxes_separated(const scene *s, const moved *a, const box *b) {
  const vec from = vec_minus(a->middle, b->middle);
  const double need = s->need + a->spread;
  for (int k = 0; k < 3; k++) {
    const vec n = b->axis[k];
    if (fabs(vec_dot(n, from)) - fabs(vec_dot(n, a->way)) - b->half[k] - shadow(a->side, n) >
        need) {
      return true;
    }
  }
  const vec side[3] = {vec_times(b->half[0], b->axis[0]), vec_times(b->half[1], b->axis[1]),
                       vec_times(b->half[2], b->axis[2])};
  for (int k = 0; k < 3; k++) {
    const vec n = a->axis[k];
    if (fabs(vec_dot(n, from)) - fabs(vec_dot(n, a->way)) - a->half[k] - shadow(side, n) > need) {
      return true;
    }
  }
  return false;
}

/* -------------------------------------------------- the point of a simplex nearest to the origin
 */

typedef struct {
  vec at[4];
  int count;
} simplex;

static vec nearest_of_two(simplex *s) {
  const vec edge = vec_minus(s->at[1], s->at[0]);
  const double t = -vec_dot(s->at[0], edge);
  const double length = vec_dot(edge, edge);
  if (t > 0 && t < length)
    return vec_plus(s->at[0], vec_times(t / length, edge));
  if (t > 0)
    s->at[0] = s->at[1];
  s->count = 1;
  return s->at[0];
}

static void take_nearer(const simplex *candidate, simplex *best, vec *so_far) {
  simplex s = *candidate;
  const vec p = nearest_of_two(&s);
  if (vec_dot(p, p) < vec_dot(*so_far, *so_far)) {
    *so_far = p;
    *best = s;
  }
}

static const vec FAR_AWAY = {DBL_MAX, 0, 0};

static vec nearest_of_three(simplex *s) {
  const vec a = s->at[0];
  const vec b = s->at[1];
  const vec c = s->at[2];
  const vec normal = vec_cross(vec_minus(b, a), vec_minus(c, a));
  const double square = vec_dot(normal, normal);
  const double of_a = vec_dot(normal, vec_cross(b, c));
  const double of_b = vec_dot(normal, vec_cross(c, a));
  const double of_c = vec_dot(normal, vec_cross(a, b));
  if (square > 0 && of_a > 0 && of_b > 0 && of_c > 0) {
    return vec_times(vec_dot(normal, a) / square, normal);
  }
  simplex best = *s;
  vec so_far = FAR_AWAY;
  take_nearer(&(simplex){{a, b}, 2}, &best, &so_far);
  take_nearer(&(simplex){{b, c}, 2}, &best, &so_far);
  take_nearer(&(simplex){{c, a}, 2}, &best, &so_far);
  *s = best;
  return so_far;
}

/* {0, 0, 0} where the origin is inside. */
static vec nearest_of_four(simplex *s) {
  simplex best = *s;
  vec so_far = FAR_AWAY;
  bool inside = true;
  for (int n = 0; n < 4; n++) {
    simplex face = {{s->at[(n + 1) % 4], s->at[(n + 2) % 4], s->at[(n + 3) % 4]}, 3};
    const vec normal =
        vec_cross(vec_minus(face.at[1], face.at[0]), vec_minus(face.at[2], face.at[0]));
    const double own = vec_dot(normal, vec_minus(s->at[n], face.at[0]));
    const double origin = -vec_dot(normal, face.at[0]);
    if (own * origin > 0)
      continue; /* on the inner side of this face */
    inside = false;
    const vec p = nearest_of_three(&face);
    if (vec_dot(p, p) < vec_dot(so_far, so_far)) {
      so_far = p;
      best = face;
    }
  }
  if (inside)
    return (vec){0, 0, 0};
  *s = best;
  return so_far;
}

static vec nearest(simplex *s) {
  switch (s->count) {
  case 1:
    return s->at[0];
  case 2:
    return nearest_of_two(s);
  case 3:
    return nearest_of_three(s);
  default:
    return nearest_of_four(s);
  }
}

/* ------------------------------------------------------------------------ pairs of triangles */

typedef struct {
  vec at[3], way[3];
} swept;

static swept sweep(const motion *m, const triangle *t) {
  swept s;
  for (int n = 0; n < 3; n++) {
    s.at[n] = placed(m, t->at[n]);
    s.way[n] = way(m, s.at[n]);
  }
  return s;
}

/* The least of a's projections less the greatest of b's: along a vector of any length. The
 * difference of the two vertices goes to *w. */
static double project(const swept *a, const triangle *b, vec n, vec *w) {
  double low = DBL_MAX;
  double high = -DBL_MAX;
  vec first = {0, 0, 0};
  vec second = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    const double goes = vec_dot(n, a->way[k]);
    const double p = vec_dot(n, a->at[k]) - fabs(goes);
    if (p < low) {
      low = p;
      first = goes > 0 ? vec_minus(a->at[k], a->way[k]) : vec_plus(a->at[k], a->way[k]);
    }
    const double q = vec_dot(n, b->at[k]);
    if (q > high) {
      high = q;
      second = b->at[k];
    }
  }
  *w = vec_minus(first, second);
  return low - high;
}

/* Gilbert, Johnson and Keerthi's search of the point of the difference of two hulls that is nearest
 * to the origin. Each direction on the way is tried as an axis: only these projections prove
 * something, the search itself may err. */
static bool triangles_separated(const swept *a, const triangle *b, double need) {
  enum { STEPS = 40 };
  simplex s = {{vec_minus(a->at[0], b->at[0])}, 1};
  vec v = s.at[0];
  for (int step = 0; step < STEPS; step++) {
    const double square = vec_dot(v, v);
    const double length = sqrt(square);
    if (!(length > need))
      return false;
    vec w;
    const double least = project(a, b, v, &w);
    if (least > need * length)
      return true;
    if (square - least <= 1e-12 * square || s.count == 4)
      return false;
    s.at[s.count++] = w;
    v = nearest(&s);
  }
  return false;
}

static bool leaves_separated(const scene *s, const box *a, const box *b) {
  for (int n = 0; n < a->count; n++) {
    const swept moving = sweep(s->m, &s->a->triangle[a->first + n]);
    for (int k = 0; k < b->count; k++) {
      if (!triangles_separated(&moving, &s->b->triangle[b->first + k], s->need))
        return false;
    }
  }
  return true;
}

bool separated(const box_tree *a, const box_tree *b, const motion *m, double distance) {
  /* A step takes one entry and leaves two; each goes one level down in one of the trees, which are
   * balanced: no deeper than 32 levels. */
  work stack[128] = {{0, 0}};
  int entries = 1;
  const scene s = {a, b, m, distance + m->curve + m->rounding, vec_length(m->spin)};
  moved first = {.of = -1};
  while (entries > 0) {
    const work w = stack[--entries];
    const box *of_a = &a->box[w.a];
    const box *of_b = &b->box[w.b];
    if (first.of != w.a)
      move(&s, w.a, &first);
    if (boxes_separated(&s, &first, of_b))
      continue;
    if (of_a->count > 0 && of_b->count > 0) {
      if (!leaves_separated(&s, of_a, of_b))
        return false;
      continue;
    }
    if (of_b->count > 0 || (of_a->count == 0 && of_a->radius > of_b->radius)) {
      stack[entries++] = (work){of_a->first, w.b};
      stack[entries++] = (work){of_a->first + 1, w.b};
    } else {
      stack[entries++] = (work){w.a, of_b->first};
      stack[entries++] = (work){w.a, of_b->first + 1};
    }
  }
  return true;
}

/* Of a box, the least projection on n. */
static double least_of(vec low, vec high, vec n) {
  return fmin(n.x * low.x, n.x * high.x) + fmin(n.y * low.y, n.y * high.y) +
         fmin(n.z * low.z, n.z * high.z);
}

/* n at + s n (spin x at + drift) = (n + s n x spin) at + s n drift: the least of it, for one s, is
 * that of a box; and as a function of s it is linear, so that the ends tell. */
static double least_at(const surface *a, const motion *m, vec n, double s) {
  const vec tilted = vec_plus(n, vec_times(s, vec_cross(n, m->spin)));
  const vec own = {vec_dot(tilted, m->column[0]), vec_dot(tilted, m->column[1]),
                   vec_dot(tilted, m->column[2])};
  return least_of(a->low, a->high, own) + vec_dot(tilted, m->shift) + s * vec_dot(n, m->drift);
}

gap gap_along(const surface *a, const surface *b, const motion *m, vec axis) {
  const vec n = vec_times(1 / vec_length(axis), axis);
  const double other = -least_of(b->low, b->high, vec_times(-1, n));
  return (gap){least_at(a, m, n, 0) - other,
               fmin(least_at(a, m, n, -1), least_at(a, m, n, 1)) - other - m->curve - m->rounding};
}
