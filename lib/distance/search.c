/* SPDX-License-Identifier: MIT */
/* search.c - the pairs of triangles of two posed bodies that may be within a limit.
 *
 * Both trees are descended together, nearest boxes first. A box of one body, turned into the
 * other's coordinates, is compared with the eight children of a node there: the gaps on the three
 * axes of a child, and those on the three of the box, are each the sides of a box that lies between
 * them. Pairs of triangles whose boxes may be near enough are posed in doubles, several at once;
 * two points of them are at their distance at least, and the gap on a direction is at most that.
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
#include "search.h"
#include "body/turned.h"
#include "util/simd.h"

#include <float.h>
#include <math.h>
#include <string.h>
#include <time.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define SIMD_UNROLL _Pragma("GCC unroll 6")
#define BOUND_SLACK 0x1p-18

/* Of coordinates from A_0, with u = 2^-53 and m the largest: a vertex is wrong by u m, an edge by 3
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
} facing;

/* The distance of a pair of triangles is within least ... most. */
typedef struct {
  double least, most, way[3];
} pair_enclosure;

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

/* -------------------------------------------------------------- pairs of triangles */

uint32_t sepax__place_at(const sepax_body *b, uint32_t at) {
  return child_at(b, at) - BODY_TRIANGLE;
}

/* The way between two bodies, in the coordinates of both, is an axis for boxes. */
static void set_way(search *s, const double way[3]) {
  double length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
  double scale = length > 0x1p-400 && length < 0x1p400 ? 1 / length : 0;
  for (int body = 0; body < 2; body++) {
    for (int i = 0; i < 3; i++) {
      double x = 0;
      for (int j = 0; j < 3; j++) {
        x += s->pose[body].rotation[j][i] * way[j] * scale;
      }
      s->way[body][i] = (float)x;
    }
  }
}

static void drop_waiting(search *s) {
  int count = 0;
  for (int n = 0; n < s->count; n++) {
    if (s->waiting[n].least <= s->most) {
      s->waiting[count++] = s->waiting[n];
    }
  }
  s->count = count;
}

static void enclose(const search *s, const double *from, pair_enclosure *e) {
#if defined __x86_64__
  if (!s->portable) {
    enclose_avx2(from, s->pose, e);
    return;
  }
#endif
  enclose_portable(from, s->pose, e);
}

static void take_waiting(search *s) {
  const int lanes = s->portable ? 2 : 4;
  double from[18 * 4];
  pair_enclosure e[4];
  drop_waiting(s);
  for (int first = 0; first < s->count && !s->ended; first += lanes) {
    int used = s->count - first < lanes ? s->count - first : lanes;
    for (int n = 0; n < lanes; n++) {
      const box_pair *pair = &s->waiting[n < used ? first + n : first];
      for (int body = 0; body < 2; body++) {
        const double(*v)[3] =
            s->body[body]->triangle[sepax__place_at(s->body[body], pair->at[body])];
        for (int k = 0; k < 9; k++) {
          from[(9 * body + k) * lanes + n] = v[k / 3][k % 3] * s->pose[body].unit;
        }
      }
    }
    enclose(s, from, e);
    for (int n = 0; n < used && !s->ended; n++) {
      if (!(e[n].least > s->limit * s->unit)) {
        s->take(s, s->waiting[first + n].at, e[n].least / s->unit, e[n].most / s->unit);
      }
      if (e[n].most < s->shortest) {
        s->shortest = e[n].most;
        s->nearest = s->waiting[first + n];
        set_way(s, e[n].way);
      }
    }
  }
  s->count = 0;
}

/* -------------------------------------------------------------------- the descent */

/* Each of 64 levels of both trees leaves up to seven pairs. */
enum { STACK = 2048, SEEDS = 2 };

static float size_at(const sepax_body *b, uint32_t at) {
  const body_boxes *boxes = &b->boxes[at / BODY_WIDE];
  uint32_t lane = at % BODY_WIDE;
  return boxes->half[0][lane] + boxes->half[1][lane] + boxes->half[2][lane];
}

/* Which body's node to open: the larger, as far as it has one. */
static int opened(const search *s, const box_pair *p, const uint32_t child[2]) {
  if (((child[0] | child[1]) & BODY_TRIANGLE) != 0) {
    return (child[0] & BODY_TRIANGLE) != 0;
  }
  return size_at(s->body[1], p->at[1]) * s->at.to[0].ratio > size_at(s->body[0], p->at[0]);
}

static uint32_t bound(const search *s, int open, uint32_t node, uint32_t other,
                      float square[BODY_WIDE]) {
  const body_boxes *boxes = &s->body[open]->boxes[node];
  const body_boxes *from = &s->body[!open]->boxes[other / BODY_WIDE];
  const facing f = {&s->at.to[open], s->way[open], s->slack, s->most_of[open]};
#if defined __x86_64__
  if (!s->portable) {
    return bound_avx2(boxes, &f, from, other % BODY_WIDE, square);
  }
#endif
  return bound_portable(boxes, &f, from, other % BODY_WIDE, square);
}

/* Children of the opened node that may be near enough, the farthest first. */
static int near_children(const search *s, int open, uint32_t node, uint32_t other,
                         box_pair near[BODY_WIDE]) {
  float square[BODY_WIDE];
  int count = 0;
  for (uint32_t mask = bound(s, open, node, other, square); mask != 0; mask &= mask - 1) {
    uint32_t lane = (uint32_t)__builtin_ctz(mask);
    double least = (double)square[lane] * s->square_of_unit[open];
    if (s->body[open]->boxes[node].child[lane] == BODY_NONE) {
      continue;
    }
    int at = count++;
    for (; at > 0 && near[at - 1].least < least; at--) {
      near[at] = near[at - 1];
    }
    near[at].least = least;
    near[at].at[open] = BODY_WIDE * node + lane;
    near[at].at[!open] = other;
  }
  return count;
}

static void visit(search *s, const box_pair *p, box_pair *stack, int *depth) {
  uint32_t child[2] = {child_at(s->body[0], p->at[0]), child_at(s->body[1], p->at[1])};
  int open = opened(s, p, child);
  box_pair near[BODY_WIDE];
  int count = near_children(s, open, child[open], p->at[!open], near);
  for (int n = 0; n < count; n++) {
    uint32_t below = child_at(s->body[open], near[n].at[open]);
    if ((child[!open] & below & BODY_TRIANGLE) != 0) {
      s->waiting[s->count++] = near[n];
    } else {
      stack[(*depth)++] = near[n];
    }
  }
}

static double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
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

static void prepare(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b) {
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
  s->slack = (float)(BOUND_SLACK + 16 * fmax(skew_of(&s->pose[0]), skew_of(&s->pose[1])));
  s->scale = fmax(s->body[0]->scale, s->body[1]->scale);
  for (int body = 0; body < 2; body++) {
    double unit = s->body[body]->scale / s->scale;
    s->square_of_unit[body] = unit * unit * (1 - 0x1p-22);
  }
  double way[3];
  for (int i = 0; i < 3; i++) {
    way[i] = 0;
    for (int body = 0; body < 2; body++) {
      const world_pose *p = &s->pose[body];
      double at = p->translation[i];
      for (int j = 0; j < 3; j++) {
        at += p->rotation[i][j] * s->body[body]->centre[j] * s->unit;
      }
      way[i] += body == 0 ? -at : at;
    }
  }
  set_way(s, way);
  s->shortest = INFINITY;
}

/* The square of the limit, as those of boxes are counted. In single precision these, sums of three
 * squares, round by 4 u; both sides give 2^-22. */
static void find_most(search *s) {
  double limit = s->limit / s->scale;
  s->most = limit * limit * (1 + 0x1p-22) + 0x1p-1000;
  for (int body = 0; body < 2; body++) {
    limit = s->limit / s->body[body]->scale;
    s->most_of[body] = (float)(limit * limit * (1 + 0x1p-22) + FLT_MIN);
  }
}

void sepax__search_pairs(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b) {
  box_pair stack[STACK];
  int depth = 1;
  size_t visits = 0;
  int seeds = SEEDS;
  const uint32_t root[2] = {BODY_WIDE * (uint32_t)s->body[0]->nodes,
                            BODY_WIDE * (uint32_t)s->body[1]->nodes};
  double end = s->seconds > 0 ? seconds_now() + s->seconds : 0;
  prepare(s, pose_a, pose_b);
  stack[0].least = 0;
  for (int k = 0; k < 2; k++) {
    stack[0].at[k] = root[k];
  }
  find_most(s);
  while (depth > 0 && !s->ended) {
    double limit = s->limit;
    if (s->count >= s->batch || s->count > SEARCH_BATCH - BODY_WIDE ||
        (s->count > 0 && isinf(limit))) {
      take_waiting(s);
      find_most(s);
    }
    if (s->limit < limit && seeds-- > 0) {
      for (int k = 0; k < 2; k++) {
        stack[depth].least = 0;
        stack[depth].at[k] = s->nearest.at[k];
        stack[depth++].at[!k] = root[!k];
      }
      continue;
    }
    box_pair p = stack[--depth];
    if (p.least <= s->most) {
      visit(s, &p, stack, &depth);
    }
    if (end > 0 && visits++ % 64 == 0 && seconds_now() >= end) {
      s->ended = true;
    }
  }
  if (!s->ended) {
    take_waiting(s);
  }
}
