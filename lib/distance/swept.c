/* SPDX-License-Identifier: MIT */
/* swept.c - whether two bodies are apart while one of them moves.
 *
 * A point of A in a triangle is a combination of the triangle's vertices, with the same weights
 * throughout. So while it goes straight on, it stays in the convex hull of the six places of these
 * vertices, and the points of a box of A stay in the hull of the two places of the box. A direction
 * on which such a hull and a part of B have a gap proves them to be apart by that gap, however far
 * A moves across the direction. Both trees are descended together. Directions of boxes come from
 * their axes, those of two triangles from the search of Gilbert, Johnson and Keerthi, which may err
 * without harm because only the gap counts.
 *
 * Rounding. With u = 2^-53 and S the sum of all lengths (scale_of), a placed point is wrong by less
 * than 16 u S, a vector of half a side by 2^-48 S, as body.h says, and a projection of ten terms by
 * less than 64 u S |n|. A gap is thus wrong by less than 2^-44 S |n|; 2^-40 S is left for that. */
#include "distance/swept.h"
#include "util/vector.h"

#include <math.h>
#include <string.h>

enum { STACK = 1024, PLACES = 2, POINTS = 6, STEPS = 24, AXES = 9 };

/* A box or a triangle in all its places. */
typedef struct {
  bool is_triangle;
  int places;                /* 2 of A, 1 of B */
  double centre[PLACES][3];  /* of a box, */
  double side[PLACES][3][3]; /* half its sides as vectors; */
  double point[POINTS][3];   /* or the points of a triangle, three for each place */
  double size;               /* about half its length */
} part;

typedef struct {
  const sepax_body *body[2];
  const sepax_pose *pose[PLACES];
  double need;      /* the gap that is asked for, with rounding */
  double way[2][3]; /* the last two directions that had a gap */
  size_t left;
} sweep;

/* -------------------------------------------------------------------------- parts */

static void turn(const sepax_pose *pose, const double v[3], double to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = vector_dot(pose->rotation[i], v);
  }
}

static void make_triangle(const sweep *s, int body, uint32_t place, part *p) {
  const sepax_body *b = s->body[body];
  p->is_triangle = true;
  memcpy(p->point, b->triangle[place], sizeof b->triangle[place]);
  p->size = 0;
  for (int k = 0; k < 3; k++) {
    double edge[3];
    for (int i = 0; i < 3; i++) {
      edge[i] = p->point[(k + 1) % 3][i] - p->point[k][i];
    }
    p->size = fmax(p->size, vector_length(edge) / 2);
  }
  for (int n = 3 * p->places - 1; n >= 0 && body == 0; n--) {
    double v[3];
    turn(s->pose[n / 3], b->triangle[place][n % 3], v);
    for (int i = 0; i < 3; i++) {
      p->point[n][i] = v[i] + s->pose[n / 3]->translation[i];
    }
  }
}

static void make_box(const sweep *s, int body, uint32_t node, part *p) {
  const sepax_body *b = s->body[body];
  const body_frame *f = &b->frame[node];
  double centre[3];
  p->is_triangle = false;
  p->size = 0;
  for (int i = 0; i < 3; i++) {
    centre[i] = b->centre[i] + b->scale * f->centre[i];
    p->size += b->scale * f->half[i];
  }
  for (int n = 0; n < p->places; n++) {
    for (int k = 0; k < 3; k++) {
      double side[3];
      for (int i = 0; i < 3; i++) {
        side[i] = b->scale * f->half[k] * f->axis[k][i];
      }
      if (body == 0) {
        turn(s->pose[n], side, p->side[n][k]);
      } else {
        memcpy(p->side[n][k], side, sizeof side);
      }
    }
    memcpy(p->centre[n], centre, sizeof centre);
    if (body == 0) {
      turn(s->pose[n], centre, p->centre[n]);
      for (int i = 0; i < 3; i++) {
        p->centre[n][i] += s->pose[n]->translation[i];
      }
    }
  }
}

/* Part `child` of a body, as a tree numbers children. */
static void make(const sweep *s, int body, uint32_t child, part *p) {
  p->places = body == 0 ? PLACES : 1;
  if ((child & BODY_TRIANGLE) != 0) {
    make_triangle(s, body, child - BODY_TRIANGLE, p);
  } else {
    make_box(s, body, child, p);
  }
}

/* The least and the greatest number on a direction. */
static void project(const part *p, const double n[3], double end[2]) {
  end[0] = INFINITY;
  end[1] = -INFINITY;
  for (int k = 0; p->is_triangle && k < 3 * p->places; k++) {
    double x = vector_dot(n, p->point[k]);
    end[0] = fmin(end[0], x);
    end[1] = fmax(end[1], x);
  }
  for (int k = 0; !p->is_triangle && k < p->places; k++) {
    double x = vector_dot(n, p->centre[k]);
    double reach = 0;
    for (int i = 0; i < 3; i++) {
      reach += fabs(vector_dot(n, p->side[k][i]));
    }
    end[0] = fmin(end[0], x - reach);
    end[1] = fmax(end[1], x + reach);
  }
}

/* Do the parts have a gap along this direction that is large enough? */
static bool has_gap(sweep *s, const part p[2], const double n[3]) {
  double end[2][2];
  double length = vector_length(n);
  if (!(length > 0x1p-300 && length < 0x1p300)) {
    return false;
  }
  project(&p[0], n, end[0]);
  project(&p[1], n, end[1]);
  double gap = fmax(end[0][0] - end[1][1], end[1][0] - end[0][1]);
  if (!(gap > s->need * length * (1 + 0x1p-40))) {
    return false;
  }
  if (n != s->way[0]) {
    const double unit[3] = {n[0] / length, n[1] / length, n[2] / length}; /* n may be way[1] */
    memcpy(s->way[1], s->way[0], sizeof s->way[1]);
    memcpy(s->way[0], unit, sizeof unit);
  }
  return true;
}

/* --------------------------------------------------------------------- triangles */

/* A few points, differences of points of two parts, and the point of their hull that is nearest to
 * the origin. */
typedef struct {
  int count;
  double point[4][3];
  double nearest[3];
} simplex;

/* Solve a symmetric system of up to three equations. False if it is near to singular. */
static bool solve(int size, double m[3][4]) {
  for (int k = 0; k < size; k++) {
    int best = k;
    for (int i = k + 1; i < size; i++) {
      best = fabs(m[i][k]) > fabs(m[best][k]) ? i : best;
    }
    for (int j = 0; j < 4; j++) {
      double x = m[k][j];
      m[k][j] = m[best][j];
      m[best][j] = x;
    }
    if (!(fabs(m[k][k]) > 0)) {
      return false;
    }
    for (int i = 0; i < size; i++) {
      double part_of = i == k ? 0 : m[i][k] / m[k][k];
      for (int j = k; j < 4; j++) {
        m[i][j] -= part_of * m[k][j];
      }
    }
  }
  return true;
}

/* The point nearest to the origin in the plane, line or point through those points of the simplex
 * that the bits name, if it lies between all of them. */
static bool nearest_of(const simplex *s, unsigned bits, double at[3]) {
  int of[4] = {0};
  int count = 0;
  double m[3][4] = {{0}};
  double edge[3][3];
  for (int n = 0; n < s->count; n++) {
    if ((bits >> n & 1) != 0) {
      of[count++] = n;
    }
  }
  const double *first = s->point[of[0]];
  for (int k = 1; k < count; k++) {
    for (int i = 0; i < 3; i++) {
      edge[k - 1][i] = s->point[of[k]][i] - first[i];
    }
  }
  for (int k = 0; k < count - 1; k++) {
    for (int j = 0; j < count - 1; j++) {
      m[k][j] = vector_dot(edge[k], edge[j]);
    }
    m[k][3] = -vector_dot(edge[k], first);
  }
  if (!solve(count - 1, m)) {
    return false;
  }
  double rest = 1;
  memcpy(at, first, 3 * sizeof *at);
  for (int k = 0; k < count - 1; k++) {
    double weight = m[k][3] / m[k][k];
    rest -= weight;
    if (weight < 0) {
      return false;
    }
    for (int i = 0; i < 3; i++) {
      at[i] += weight * edge[k][i];
    }
  }
  return rest >= 0;
}

/* Reduce the simplex to the points that hold its nearest point. */
static void reduce(simplex *s) {
  double best = INFINITY;
  unsigned chosen = 1;
  for (unsigned bits = 1; bits < 1U << s->count; bits++) {
    double at[3];
    if (nearest_of(s, bits, at) && vector_dot(at, at) < best) {
      best = vector_dot(at, at);
      chosen = bits;
      memcpy(s->nearest, at, sizeof at);
    }
  }
  int count = 0;
  for (int n = 0; n < s->count; n++) {
    if ((chosen >> n & 1) != 0) {
      memmove(s->point[count++], s->point[n], sizeof s->point[n]);
    }
  }
  s->count = count;
}

/* The point of a part that is farthest along a direction, or least far if `sign` is -1. */
static const double *farthest(const part *p, const double n[3], double sign) {
  int best = 0;
  for (int k = 1; k < 3 * p->places; k++) {
    if (sign * (vector_dot(n, p->point[k]) - vector_dot(n, p->point[best])) > 0) {
      best = k;
    }
  }
  return p->point[best];
}

/* Find a direction on which two triangles have a gap that is large enough. */
static bool find_gap(sweep *s, const part p[2]) {
  simplex now = {.count = 0};
  for (int i = 0; i < 3; i++) {
    now.nearest[i] = p[0].point[0][i] - p[1].point[0][i];
  }
  for (int step = 0; step < STEPS; step++) {
    if (has_gap(s, p, now.nearest)) {
      return true;
    }
    const double *a = farthest(&p[0], now.nearest, -1);
    const double *b = farthest(&p[1], now.nearest, 1);
    double least = vector_dot(now.nearest, now.nearest);
    double new_point[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    if (now.count == 4 || !(least > 0) ||
        least - vector_dot(now.nearest, new_point) <= 0x1p-40 * least) {
      return false; /* the origin is within, or this is the nearest point: the gap is too small */
    }
    memcpy(now.point[now.count++], new_point, sizeof new_point);
    reduce(&now);
  }
  return false;
}

/* ---------------------------------------------------------------------- the descent */

static void set_across(const part *p, double axis[3]) {
  double edge[2][3];
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 3; i++) {
      edge[k][i] = p->point[k + 1][i] - p->point[0][i];
    }
  }
  vector_cross(edge[0], edge[1], axis);
}

static void set_middle(const part *p, double middle[3]) {
  for (int i = 0; i < 3; i++) {
    middle[i] = 0;
    for (int k = 0; k < p->places; k++) {
      middle[i] += p->is_triangle ? p->point[3 * k][i] : p->centre[k][i];
    }
    middle[i] /= p->places;
  }
}

/* Is it proved that two parts are far enough apart? */
static bool proved(sweep *s, const part p[2]) {
  double axis[AXES][3];
  double middle[2][3];
  int count = 0;
  if (has_gap(s, p, s->way[0]) || has_gap(s, p, s->way[1])) {
    return true;
  }
  for (int body = 0; body < 2; body++) {
    set_middle(&p[body], middle[body]);
    for (int k = 0; k < (p[body].is_triangle ? 1 : 3); k++) {
      if (p[body].is_triangle) {
        set_across(&p[body], axis[count++]);
      } else {
        memcpy(axis[count++], p[body].side[0][k], sizeof axis[0]);
      }
    }
  }
  for (int i = 0; i < 3; i++) {
    axis[count][i] = middle[0][i] - middle[1][i];
  }
  count++;
  for (int n = 0; n < count; n++) {
    if (has_gap(s, p, axis[n])) {
      return true;
    }
  }
  return p[0].is_triangle && p[1].is_triangle && find_gap(s, p);
}

typedef struct {
  uint32_t child[2];
} pair;

/* Put the children of one part of a pair on the stack, the larger part's. False if it is full. */
static bool open_pair(const sweep *s, const part p[2], const pair *of, pair stack[STACK],
                      int *depth) {
  int open = p[0].is_triangle ? 1 : p[1].is_triangle ? 0 : p[1].size > p[0].size;
  const body_boxes *boxes = &s->body[open]->boxes[of->child[open]];
  for (int lane = 0; lane < BODY_WIDE && boxes->child[lane] != BODY_NONE; lane++) {
    if (*depth == STACK) {
      return false;
    }
    stack[*depth] = *of;
    stack[(*depth)++].child[open] = boxes->child[lane];
  }
  return true;
}

static double scale_of(const sweep *s) {
  double sum = 0;
  for (int body = 0; body < 2; body++) {
    sum += vector_length(s->body[body]->centre) + s->body[body]->radius;
  }
  return sum + fmax(vector_length(s->pose[0]->translation), vector_length(s->pose[1]->translation));
}

bool sepax__swept_apart(const sepax_body *a, const sepax_pose *from, const sepax_pose *to,
                        const sepax_body *b, double distance, size_t work) {
  sweep s = {.body = {a, b}, .pose = {from, to}, .left = work};
  pair stack[STACK];
  int depth = 1;
  s.need = distance + 0x1p-40 * scale_of(&s);
  stack[0] = (pair){{0, 0}};
  while (depth > 0) {
    const pair of = stack[--depth];
    part p[2];
    if (s.left-- == 0) {
      return false;
    }
    make(&s, 0, of.child[0], &p[0]);
    make(&s, 1, of.child[1], &p[1]);
    if (!proved(&s, p) &&
        ((p[0].is_triangle && p[1].is_triangle) || !open_pair(&s, p, &of, stack, &depth))) {
      return false;
    }
  }
  return true;
}
