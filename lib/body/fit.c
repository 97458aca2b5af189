/* SPDX-License-Identifier: MIT */
/* fit.c - the oriented boxes of a tree.
 *
 * A box of one triangle stands on its plane and one of its edges (base_of). A box of more stands on
 * the principal axes of their surface, or on x, y, z, where that encloses less. */
#include "body.h"
#include "util/box.h"
#include "util/threads.h"
#include "util/vector.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const int next[3] = {1, 2, 0};

enum { PART = 64 }; /* nodes that a thread takes at a time */

#define FAR 1e30F /* a place that no box reaches */

typedef double axes[3][3]; /* [axis][coordinate]; the axes have length 1 and are at right angles */

static const axes upright = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

/* ------------------------------------------------------------------------ vectors */

/* Make the vector's length 1. False if it is too short to have a direction. */
static bool normalise(double v[3]) {
  double length = vector_length(v);
  if (!(length > 1e-100)) {
    return false;
  }
  double scale = 1 / length;
  for (int i = 0; i < 3; i++) {
    v[i] *= scale;
  }
  return true;
}

/* --------------------------------------------------------------------- directions */

/* Choose two axes at right angles to the first. */
static void complete(axes a) {
  int least = 0;
  for (int i = 1; i < 3; i++) {
    least = fabs(a[0][i]) < fabs(a[0][least]) ? i : least;
  }
  vector_cross(upright[least], a[0], a[1]);
  normalise(a[1]);
  vector_cross(a[0], a[1], a[2]);
}

/* The edge on which a box stands. On each edge at which no angle is obtuse the box has twice the
 * area of the triangle; of these edges it is that on which length and height have the least sum. So
 * a right triangle stands on a leg, where its box ends with both legs; the box on its longest edge
 * would stand out over them by half the triangle. The height is twice the area over the length. A
 * sliver stands on its longest edge, because its area is not exact. */
static int base_of(const double edge[3][3]) {
  double normal[3];
  double length[3];
  int longest = 0;
  for (int k = 0; k < 3; k++) {
    length[k] = vector_length(edge[k]);
    longest = length[k] > length[longest] ? k : longest;
  }
  vector_cross(edge[0], edge[1], normal);
  double area = vector_length(normal);
  int base = longest;
  if (area > 0x1p-20 * length[longest] * length[longest]) {
    for (int k = 0; k < 3; k++) {
      double foot = -vector_dot(edge[k], edge[next[next[k]]]) / length[k];
      double out = fmax(-foot, foot - length[k]);
      if (out < 0x1p-20 * length[k] &&
          length[k] + area / length[k] < 0.999 * (length[base] + area / length[base])) {
        base = k;
      }
    }
  }
  return base;
}

/* Returns the vertex that is not on the base, or -1 if the triangle is a point. */
static int axes_of_triangle(const double v[3][3], axes a) {
  double edge[3][3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      edge[k][i] = v[next[k]][i] - v[k][i];
    }
  }
  int base = base_of(edge);
  memcpy(a[0], edge[base], sizeof a[0]);
  if (!normalise(a[0])) {
    memcpy(a, upright, sizeof upright);
    return -1;
  }
  vector_cross(a[0], edge[next[base]], a[2]);
  if (!normalise(a[2])) {
    complete(a);
    return next[next[base]];
  }
  /* compute it again, because the edge of a sliver leaves its normal inexact */
  vector_cross(a[2], a[0], a[1]);
  normalise(a[1]);
  vector_cross(a[0], a[1], a[2]);
  return next[next[base]];
}

/* Integrals over the surface of triangles: the area, and of x_i and x_i x_j over the area. */
typedef struct {
  double area, first[3], second[3][3];
} moments;

static void add_triangle(moments *m, const double v[3][3]) {
  double e[3];
  double f[3];
  double normal[3];
  double centre[3];
  for (int i = 0; i < 3; i++) {
    e[i] = v[1][i] - v[0][i];
    f[i] = v[2][i] - v[0][i];
    centre[i] = v[0][i] + v[1][i] + v[2][i];
  }
  vector_cross(e, f, normal);
  double area = sqrt(vector_dot(normal, normal));
  m->area += area;
  for (int i = 0; i < 3; i++) {
    m->first[i] += area * centre[i] / 3;
    for (int j = i; j < 3; j++) {
      double vertices = v[0][i] * v[0][j] + v[1][i] * v[1][j] + v[2][i] * v[2][j];
      m->second[i][j] += area * (vertices + centre[i] * centre[j]) / 12;
    }
  }
}

static void add_moments(moments *to, const moments *m) {
  to->area += m->area;
  for (int i = 0; i < 3; i++) {
    to->first[i] += m->first[i];
    for (int j = i; j < 3; j++) {
      to->second[i][j] += m->second[i][j];
    }
  }
}

/* One turn of Jacobi's method for eigenvectors: s[p][q] becomes 0. */
static void turn(axes s, axes a, int p, int q) {
  if (fabs(s[p][q]) <= 1e-6 * (fabs(s[p][p]) + fabs(s[q][q]))) {
    return;
  }
  double half = (s[q][q] - s[p][p]) / (2 * s[p][q]);
  double t = (half < 0 ? -1 : 1) / (fabs(half) + sqrt(half * half + 1));
  double c = 1 / sqrt(t * t + 1);
  double sine = t * c;
  for (int k = 0; k < 3; k++) {
    double kp = s[k][p];
    double kq = s[k][q];
    s[k][p] = c * kp - sine * kq;
    s[k][q] = sine * kp + c * kq;
  }
  for (int k = 0; k < 3; k++) {
    double pk = s[p][k];
    double qk = s[q][k];
    s[p][k] = c * pk - sine * qk;
    s[q][k] = sine * pk + c * qk;
    pk = a[p][k];
    qk = a[q][k];
    a[p][k] = c * pk - sine * qk;
    a[q][k] = sine * pk + c * qk;
  }
}

static void principal_axes(const moments *m, axes a) {
  axes s;
  memcpy(a, upright, sizeof upright);
  if (!(m->area > 1e-100)) {
    return;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = i; j < 3; j++) {
      s[i][j] = s[j][i] = (m->second[i][j] - m->first[i] * m->first[j] / m->area) / m->area;
    }
  }
  for (int n = 0; n < 6; n++) {
    turn(s, a, 0, 1);
    turn(s, a, 1, 2);
    turn(s, a, 2, 0);
  }
  normalise(a[0]);
  vector_cross(a[0], a[1], a[2]);
  if (!normalise(a[2])) {
    memcpy(a, upright, sizeof upright);
    return;
  }
  vector_cross(a[2], a[0], a[1]);
}

/* -------------------------------------------------------------------------- boxes */

typedef struct {
  float axis[3][3], centre[3], half[3];
} oriented;

/* Not inlined, because the code that reads axes and centre back must read the rounded floats: gcc
 * 12 with -O3 would use the doubles. */
static __attribute__((noinline)) void set_axes(oriented *r, const axes a) {
  for (int k = 0; k < 9; k++) {
    r->axis[k / 3][k % 3] = (float)a[k / 3][k % 3];
  }
}

static __attribute__((noinline)) void set_centre(oriented *r, const double centre[3]) {
  for (int i = 0; i < 3; i++) {
    r->centre[i] = (float)centre[i];
  }
}

/* Round half sides.
 *
 * The axes are rounded to single precision, so that they have length 1 and are at right angles
 * within 2^-22; half[i] then need be larger than |axis_i . (x - centre)| by 2^-20 of all three.
 * Every number of a search's test is rounded by less than 2^-17 of them (query.c), and MORE covers
 * both. No number is too small for single precision, because half sides are at least 2^-46
 * (enclose). */
static void set_half(oriented *r, const double half[3]) {
  const double MORE = 0x1p-15;
  double more = MORE * (half[0] + half[1] + half[2]);
  for (int i = 0; i < 3; i++) {
    r->half[i] = (float)((half[i] + more) * (1 + 0x1p-23));
  }
}

/* Round a box. Axes are rounded by 2^-24, so a triangle of the box is within 2^-22 of all three
 * half sides of the rounded one, which the margin of set_half covers. */
static void round_box(const body_frame *f, oriented *r) {
  double half[3];
  double moved[3];
  set_axes(r, f->axis);
  set_centre(r, f->centre);
  for (int i = 0; i < 3; i++) {
    moved[i] = (double)r->centre[i] - f->centre[i];
  }
  for (int i = 0; i < 3; i++) {
    half[i] = f->half[i] + fabs(vector_dot(f->axis[i], moved));
  }
  set_half(r, half);
}

/* Enclose triangles, in units of the body, in a box with axes a.
 *
 * LEAST covers rounding. Let u = 2^-53. Coordinates are at most 1, so a point x is at most sqrt(3)
 * from the origin, and on each axis middle and half side are at most that together. A coordinate is
 * rounded by u, its product with an axis by 6 u, a half side by 2 u more, the centre by 9 u as a
 * vector. The axes are not quite orthonormal: squares of lengths are wrong by 26 u, cosines by 8 u.
 * So the u_i of body_frame differ from axis_i . (x - centre), and axis_i . centre from the middle,
 * by (26 + 2 * 8) u sqrt(3) = 73 u in all, because one is small where the other is not. All these
 * are less than 2^-46 together. */
static void enclose(const facet_points *v, uint32_t count, const axes a, body_frame *f) {
  const double LEAST = 0x1p-46;
  real_pair first[3]; /* axes 0 and 1, by coordinate */
  real_pair last[3];  /* axis 2 and its opposite */
  for (int k = 0; k < 3; k++) {
    first[k] = (real_pair){a[0][k], a[1][k]};
    last[k] = (real_pair){a[2][k], -a[2][k]};
  }
  real_pair least = {INFINITY, INFINITY};
  real_pair most = {-INFINITY, -INFINITY};
  real_pair ends = {-INFINITY, -INFINITY};
  for (uint32_t n = 0; n < count; n++) {
    for (int k = 0; k < 3; k++) {
      const double *x = v[n][k];
      real_pair at = first[0] * x[0] + first[1] * x[1] + first[2] * x[2];
      least = real_pair_least(least, at);
      most = real_pair_most(most, at);
      ends = real_pair_most(ends, last[0] * x[0] + last[1] * x[1] + last[2] * x[2]);
    }
  }
  const double low[3] = {least[0], least[1], -ends[1]};
  const double high[3] = {most[0], most[1], ends[0]};
  memcpy(f->axis, a, sizeof f->axis);
  for (int i = 0; i < 3; i++) {
    f->centre[i] = (a[0][i] * (low[0] + high[0]) + a[1][i] * (low[1] + high[1]) +
                    a[2][i] * (low[2] + high[2])) /
                   2;
    f->half[i] = (high[i] - low[i]) / 2 + LEAST;
  }
}

/* The half area of a node's AABB. */
static double upright_area(const body_node *node, int lane) {
  double half[3];
  for (int i = 0; i < 3; i++) {
    half[i] = (double)node->half[i][lane];
  }
  return half[0] * half[1] + half[1] * half[2] + half[2] * half[0];
}

static double area_of(const body_frame *f) {
  return f->half[0] * f->half[1] + f->half[1] * f->half[2] + f->half[2] * f->half[0];
}

static void store(body_boxes *to, int lane, const oriented *r, uint32_t child) {
  for (int i = 0; i < 3; i++) {
    to->centre[i][lane] = r->centre[i];
    to->half[i][lane] = r->half[i];
    for (int j = 0; j < 3; j++) {
      to->axis[i][j][lane] = r->axis[i][j];
    }
  }
  to->child[lane] = child;
}

/* Returns the foot (body.h). If rounding moves the centre by more than 2^-11 of the half sides,
 * then the triangle in the box is not known well enough, and the foot is infinite. */
static float fit_triangle(const facet_points *v, oriented *r) {
  axes a;
  body_frame f;
  double from_centre[3];
  double moved = 0;
  int apex = axes_of_triangle(v[0], a);
  enclose(v, 1, a, &f);
  round_box(&f, r);
  for (int i = 0; i < 3; i++) {
    moved += fabs((double)r->centre[i] - f.centre[i]);
    from_centre[i] = v[0][apex < 0 ? 0 : apex][i] - (double)r->centre[i];
  }
  bool known = apex >= 0 && moved < 0x1p-11 * (f.half[0] + f.half[1] + f.half[2]);
  return known ? (float)vector_dot(a[0], from_centre) : INFINITY;
}

/* The exact AABB of triangles, in units of the file. */
static void find_aabb(const facet_points *v, uint32_t count, body_frame *f) {
  for (int i = 0; i < 3; i++) {
    f->aabb[0][i] = INFINITY;
    f->aabb[1][i] = -INFINITY;
  }
  for (uint32_t n = 0; n < count; n++) {
    for (int k = 0; k < 9; k++) {
      double x = v[n][k / 3][k % 3];
      double *low = &f->aabb[0][k % 3];
      double *high = &f->aabb[1][k % 3];
      *low = x < *low ? x : *low;
      *high = x > *high ? x : *high;
    }
  }
}

/* Choose the box around triangles from their moments and the area of their AABB. */
static void fit(const facet_points *v, uint32_t count, const moments *m, double area,
                body_frame *f) {
  axes a;
  principal_axes(m, a);
  enclose(v, count, a, f);
  if (!(area_of(f) < area)) {
    enclose(v, count, upright, f);
  }
}

/* The triangles below a node, first ... first + count - 1 in the order of the tree. */
typedef struct {
  uint32_t first, count;
  moments all;
} below;

typedef struct {
  sepax_body *body;
  facet_points *v; /* triangles in units of the body */
  below *below;    /* one entry for each node */
} fitting;

static void find_below(const fitting *f, uint32_t number, uint32_t first) {
  const body_node *node = &f->body->node[number];
  below *own = &f->below[number];
  *own = (below){.first = first};
  for (uint32_t lane = 0; lane < node->children; lane++) {
    uint32_t child = node->child[lane];
    if ((child & BODY_TRIANGLE) != 0) {
      add_triangle(&own->all, f->v[first + own->count++]);
    } else {
      find_below(f, child, first + own->count);
      own->count += f->below[child].count;
      add_moments(&own->all, &f->below[child].all);
    }
  }
}

/* Fit the boxes of a node's children. */
static void fit_children(const fitting *f, size_t number) {
  const body_node *node = &f->body->node[number];
  body_boxes *boxes = &f->body->boxes[number];
  uint32_t at = f->below[number].first;
  for (int lane = 0; lane < BODY_WIDE; lane++) {
    oriented r = {{{0}}, {FAR, FAR, FAR}, {0}};
    if (lane >= (int)node->children) {
      store(boxes, lane, &r, BODY_NONE);
      continue;
    }
    uint32_t child = node->child[lane];
    if ((child & BODY_TRIANGLE) != 0) {
      f->body->foot[at] = fit_triangle(f->v + at, &r);
      at++;
    } else {
      body_frame *frame = &f->body->frame[child];
      fit(f->v + at, f->below[child].count, &f->below[child].all, upright_area(node, lane), frame);
      find_aabb(f->body->triangle + at, f->below[child].count, frame);
      round_box(frame, &r);
      at += f->below[child].count;
    }
    store(boxes, lane, &r, child);
  }
}

static void fit_part(void *context, size_t part) {
  const fitting *f = context;
  for (size_t n = part * PART; n < (part + 1) * PART && n < f->body->nodes; n++) {
    fit_children(f, n);
  }
}

/* Copy the triangles in units of the body. */
static facet_points *local_triangles(const sepax_body *b) {
  facet_points *v = sepax_allocate(b->count * sizeof *v);
  double unit = 1 / b->scale;
  for (size_t n = 0; n < b->count && v != NULL; n++) {
    for (int k = 0; k < 9; k++) {
      v[n][k / 3][k % 3] = (b->triangle[n][k / 3][k % 3] - b->centre[k % 3]) * unit;
    }
  }
  return v;
}

enum { CACHE_LINE = 64 };

bool sepax__body_fit(sepax_body *b, size_t threads) {
  fitting f = {b, local_triangles(b), sepax_allocate(b->nodes * sizeof *f.below)};
  b->memory = sepax_allocate((b->nodes + 1) * sizeof *b->boxes + CACHE_LINE - 1);
  b->frame = sepax_allocate(b->nodes * sizeof *b->frame);
  b->foot = sepax_allocate(b->count * sizeof *b->foot);
  bool ok =
      b->memory != NULL && b->frame != NULL && b->foot != NULL && f.v != NULL && f.below != NULL;
  if (ok) {
    size_t beyond = (uintptr_t)b->memory % CACHE_LINE; /* bytes beyond a cache line */
    b->boxes = (void *)((char *)b->memory + (beyond > 0 ? CACHE_LINE - beyond : 0));
    find_below(&f, 0, 0);
    sepax__threads_run(threads, (b->nodes + PART - 1) / PART, fit_part, &f);
    oriented r;
    fit(f.v, (uint32_t)b->count, &f.below[0].all, INFINITY, &b->frame[0]);
    find_aabb(b->triangle, (uint32_t)b->count, &b->frame[0]);
    round_box(&b->frame[0], &r);
    memset(&b->boxes[b->nodes], 0, sizeof *b->boxes);
    store(&b->boxes[b->nodes], 0, &r, 0);
  }
  sepax_release(f.v);
  sepax_release(f.below);
  return ok;
}
