/* SPDX-License-Identifier: MIT */
/* bounds.c - bounds of the distance of boxes and of triangles of two posed bodies.
 *
 * A box of one body, turned into the other's coordinates, is compared with the eight children of a
 * node there: the gaps on the three axes of a child, and those on the three of the box, are each
 * the sides of a box that lies between them. Pairs of triangles are posed in doubles, several at
 * once; two points of them are at their distance at least, and the gap on a direction is at most
 * that.
 *
 * Rounding of boxes. With u = 2^-24, H the sum of the six half sides and T the offset of the
 * centres, |x| + |y| + |z|, an offset on an axis is wrong by 9 u T, a cosine by 13 u, an offset on
 * an axis of the other box, a sum of three products, by 40 u T, and that axes of single precision
 * are not quite at right angles makes 8 u T: less than 2^-18 T. Sums of half sides are wrong by
 * less than 2^-17 H, as are, in valid poses, the cosines of axes of one box; half sides have 2^-15
 * of each box's own more than they need (body/fit.c).
 *
 * Poses are not quite rotations. Where no entry of R R^T differs from the identity by more than d,
 * R makes lengths longer or shorter by 2 d at most, one relative to the other by 4 d. A gap on an
 * axis of the other box is wrong by 4 d T, the root of the squares of three by 4 d T, a distance in
 * the coordinates of a body by 2 d T: 16 d T is more than all. Each gap is shortened by T times
 * `slack`, 2^-18 + 16 d. */
#include "bounds.h"
#include "body/turned.h"
#include "frames.h"
#include "util/simd.h"
#include "util/vector.h"

#include <float.h>
#include <math.h>
#include <string.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define SIMD_UNROLL _Pragma("GCC unroll 6")
#define BOUND_SLACK 0x1p-18

/* Of coordinates from A_0, with u = 2^-53 and m the largest: a vertex is wrong by u m, an edge by 4
 * u m, a point of an edge or face by 16 u m, as coordinates; a way by 48 u m, as a vector. On a
 * direction w a vertex is wrong by 7 u m |w|, a gap by 18 u m |w|, and its quotient by |w|, which
 * is 4 m at most, by 16 u m more. What underflows is below 2^-500. */
#define PAIR_ERROR 0x1p-47

static const int next[3] = {1, 2, 0};

/* What is the same for all boxes of a body: the way between the bodies, and the largest square of a
 * distance that counts, in the body's units. */
typedef struct {
  const motion *motion;
  const float *way;
  float slack, most;
  float foot; /* of the triangle that is compared, in units of its body; infinite if it is a box */
} facing;

#define SIMD_NAME(x) x##_portable
#define SIMD_TARGET
#define SIMD_FLOATS 4
#define SIMD_LANES 2
#define SIMD_BITS(v) \
  ((uint32_t)(((v)[0] < 0) | ((v)[1] < 0) << 1 | ((v)[2] < 0) << 2 | ((v)[3] < 0) << 3))
#include "reach.h"

#if defined __x86_64__
#define SIMD_NAME(x) x##_avx2
#define SIMD_TARGET __attribute__((target("avx2,fma")))
#define SIMD_FLOATS 8
#define SIMD_LANES 4
#define SIMD_BITS(v) ((uint32_t)_mm256_movemask_ps((__m256)(v)))
#include "reach.h"
#endif

/* -------------------------------------------------------------------------- poses */

static double largest(const sepax_body *b, const sepax_pose *pose) {
  double most = sepax__largest_coordinate(b);
  for (int i = 0; i < 3 && pose != NULL; i++) {
    most = fmax(most, fabs(pose->translation[i]));
  }
  return most;
}

/* Coordinates and translations are at most 1 in the unit. A placed coordinate is a sum of four
 * terms that are below 2.74 together, rounded six times: wrong by 17 u, the vertex by 30 u. */
static void find_world_pose(world_pose *w, const sepax_pose *pose, double unit) {
  *w = (world_pose){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}, unit, 0x1p-500};
  if (pose != NULL) {
    memcpy(w->rotation, pose->rotation, sizeof w->rotation);
    for (int i = 0; i < 3; i++) {
      w->translation[i] = pose->translation[i] * unit;
    }
    w->error = 0x1p-48;
  }
}

/* How much an entry of R R^T may differ from the identity. */
static double skew_of(const world_pose *p) {
  double most = 0;
  for (int k = 0; k < 9; k++) {
    const double *r = p->rotation[k / 3];
    const double *q = p->rotation[k % 3];
    double product = r[0] * q[0] + r[1] * q[1] + r[2] * q[2];
    most = fmax(most, fabs(product - (k / 3 == k % 3)));
  }
  return most + 0x1p-50;
}

static void rotate(const double r[3][3], const double v[3], double to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = vector_dot(r[i], v);
  }
}

void sepax__set_way(search *s, const double way[3]) {
  set_unit(s->line, way);
  for (int body = 0; body < 2; body++) {
    for (int i = 0; i < 3; i++) {
      double x = 0;
      for (int j = 0; j < 3; j++) {
        x += s->pose[body].rotation[j][i] * s->line[j];
      }
      s->way[body][i] = (float)x;
    }
  }
}

/* ------------------------------------------------------------ in single precision */

uint32_t sepax__bound_children(const search *s, int open, uint32_t node, uint32_t other,
                               float square[BODY_WIDE]) {
  const body_boxes *boxes = &s->body[open]->boxes[node];
  const body_boxes *from = &s->body[!open]->boxes[other / BODY_WIDE];
  uint32_t child = from->child[other % BODY_WIDE];
  float foot =
      (child & BODY_TRIANGLE) != 0 ? s->body[!open]->foot[child - BODY_TRIANGLE] : INFINITY;
  const facing f = {&s->at.to[open], s->way[open], s->slack, s->most_of[open], foot};
#if defined __x86_64__
  if (!s->portable) {
    return bound_avx2(boxes, &f, from, other % BODY_WIDE, square);
  }
#endif
  return bound_portable(boxes, &f, from, other % BODY_WIDE, square);
}

/* The square of the limit, as those of boxes are counted. In single precision these, sums of three
 * squares, round by 4 u; both sides give 2^-22. */
void sepax__find_most(search *s) {
  double limit = s->limit / s->scale;
  s->most = limit < 0 ? -1 : limit * limit * (1 + 0x1p-22) + 0x1p-1000;
  for (int body = 0; body < 2; body++) {
    limit = s->limit / s->body[body]->scale;
    s->most_of[body] = limit < 0 ? -1 : (float)(limit * limit * (1 + 0x1p-22) + FLT_MIN);
  }
}

/* --------------------------------------------------------------------- in doubles */

static void place_frame(const search *s, int body, uint32_t node, placed_frame *p) {
  const body_frame *f = &s->body[body]->frame[node];
  const double(*r)[3] = s->pose[body].rotation;
  double centre[3];
  rotate(r, f->centre, centre);
  for (int i = 0; i < 3; i++) {
    rotate(r, f->axis[i], p->axis[i]);
    p->centre[i] = s->centre[body][i] + s->size[body] * centre[i];
    p->half[i] = s->size[body] * f->half[i];
  }
}

static void place_triangle(const search *s, int body, uint32_t child, placed_triangle t) {
  const world_pose *p = &s->pose[body];
  const double(*v)[3] = s->body[body]->triangle[child - BODY_TRIANGLE];
  for (int k = 0; k < 3; k++) {
    double scaled[3] = {v[k][0] * p->unit, v[k][1] * p->unit, v[k][2] * p->unit};
    rotate(p->rotation, scaled, t[k]);
    for (int i = 0; i < 3; i++) {
      t[k][i] += p->translation[i];
    }
  }
}

double sepax__exact_bound(const search *s, const uint32_t child[2]) {
  placed_frame frame[2];
  placed_triangle t;
  for (int body = 0; body < 2; body++) {
    if ((child[body] & BODY_TRIANGLE) == 0) {
      place_frame(s, body, child[body], &frame[body]);
    } else {
      place_triangle(s, body, child[body], t);
    }
  }
  if (((child[0] | child[1]) & BODY_TRIANGLE) == 0) {
    return sepax__frames_apart(&frame[0], &frame[1], s->line, s->skew);
  }
  return sepax__frame_apart(&frame[(child[0] & BODY_TRIANGLE) != 0], t, s->line, s->skew);
}

double sepax__search_begin(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b) {
  int exponent;
  frexp(fmax(largest(s->body[0], pose_a), largest(s->body[1], pose_b)), &exponent);
  s->unit = ldexp(1, -exponent);
  find_world_pose(&s->pose[0], pose_a, s->unit);
  find_world_pose(&s->pose[1], pose_b, s->unit);
  sepax__place_bodies(&s->at, s->body[0], pose_a, s->body[1], pose_b);
#if defined __x86_64__
  s->portable = s->portable || !__builtin_cpu_supports("avx2") || !__builtin_cpu_supports("fma");
#else
  s->portable = true;
#endif
  double skew = fmax(skew_of(&s->pose[0]), skew_of(&s->pose[1]));
  s->slack = (float)(BOUND_SLACK + 16 * skew);
  s->skew = skew + 0x1p-47;
  s->scale = fmax(s->body[0]->scale, s->body[1]->scale);
  double way[3];
  for (int body = 0; body < 2; body++) {
    double unit = s->body[body]->scale / s->scale;
    double centre[3];
    s->square_of_unit[body] = unit * unit * (1 - 0x1p-22);
    s->size[body] = s->body[body]->scale * s->unit;
    for (int i = 0; i < 3; i++) {
      centre[i] = s->body[body]->centre[i] * s->unit;
    }
    rotate(s->pose[body].rotation, centre, s->centre[body]);
    for (int i = 0; i < 3; i++) {
      s->centre[body][i] += s->pose[body].translation[i];
    }
  }
  for (int i = 0; i < 3; i++) {
    way[i] = s->centre[1][i] - s->centre[0][i];
  }
  sepax__set_way(s, way);
  s->shortest = INFINITY;
  s->open = INFINITY;
  return sepax__exact_bound(s, (const uint32_t[2]){0, 0}) / s->unit * (1 - 0x1p-50);
}

/* -------------------------------------------------------------- pairs of triangles */

uint32_t sepax__place_at(const sepax_body *b, uint32_t at) {
  return child_at(b, at) - BODY_TRIANGLE;
}

static void enclose(const search *s, const double *from, const short_cut *cut, pair_enclosure *e) {
#if defined __x86_64__
  if (!s->portable) {
    enclose_avx2(from, s->pose, cut, e);
    return;
  }
#endif
  enclose_portable(from, s->pose, cut, e);
}

/* Copy pairs that wait: coordinate i of vertex k of pair n of body b goes to (9 b + 3 k + i) lanes
 * + n. */
static void gather(const search *s, int first, int used, int lanes, double *from) {
  for (int n = 0; n < lanes; n++) {
    const box_pair *pair = &s->waiting[n < used ? first + n : first];
    for (int body = 0; body < 2; body++) {
      const double(*v)[3] = s->body[body]->triangle[sepax__place_at(s->body[body], pair->at[body])];
      for (int k = 0; k < 9; k++) {
        from[(9 * body + k) * lanes + n] = v[k / 3][k % 3] * s->pose[body].unit;
      }
    }
  }
}

void sepax__enclose_waiting(const search *s, int first, int used, const short_cut *cut,
                            pair_enclosure e[ENCLOSED_MOST]) {
  double from[18 * ENCLOSED_MOST];
  gather(s, first, used, s->portable ? 2 : ENCLOSED_MOST, from);
  enclose(s, from, cut, e);
}
