/* search.c - the pairs of triangles of two posed bodies that may be within a limit.
 *
 * Both trees are descended together, nearest boxes first. A box of one body, turned into the
 * other's coordinates, is compared with the eight children of a node there: the gaps on the three
 * axes of a child, and those on the three of the box, are each the sides of a box that lies between
 * them. Pairs of triangles whose boxes may be near enough are posed in doubles, several at once;
 * two points of them are at their distance at least, and the gap on a direction is at most that.
 *
 * Rounding of boxes. With u = 2^-24, H the sum of the six half sides and T the offset of the
 * centres, |x| + |y| + |z|, an offset on an axis is wrong by 9 u T, a cosine by 13 u, a sum of half
 * sides by 4 u H. A pose is a rotation within 1e-6 (sepax_pose_valid), one relative to the other,
 * and its inverse, within 6e-6 < 101 u, by which cosines of axes of one box differ from 0 and 1,
 * and distances in the coordinates of a body from those of the world. An offset on an axis of the
 * other box, a sum of three products, is wrong by 40 u T more, and a gap by less than 2^-17 H +
 * 2^-16 T; half sides have 2^-15 of each box's own more than they need (body/fit.c). That gaps are
 * not at right angles, and the root of their squares, less than 2^-16 T, makes 2^-17 T more. Each
 * gap is shortened by 2^-15 T. */
#include "search.h"

#include <float.h>
#include <math.h>
#include <string.h>
#include <time.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define UNROLL _Pragma("GCC unroll 6")
#define BOUND_SLACK 0x1p-15F

/* Of coordinates from A_0, with u = 2^-53 and m the largest: a vertex is wrong by u m, an edge by 3
 * u m, a point of an edge or face by 16 u m, as coordinates; a way by 48 u m, as a vector. On a
 * direction w a vertex is wrong by 7 u m |w|, a gap by 18 u m |w|, and its quotient by |w|, which
 * is 4 m at most, by 16 u m more. What underflows is below 2^-500. */
#define PAIR_ERROR 0x1p-47

static const int next[3] = {1, 2, 0};

/* A box in the other body's coordinates; its centre is centre + rest. */
typedef struct {
  float centre[3], rest[3], half[3], axis[3][3];
} posed_box;

#define NAME(x) x##_portable
#define TARGET
#define FLOATS 4
#define LANES 2
#include "reach.h"

#if defined __x86_64__
#define NAME(x) x##_avx2
#define TARGET __attribute__((target("avx2")))
#define FLOATS 8
#define LANES 4
#include "reach.h"
#endif

/* -------------------------------------------------------------------------- poses */

static double largest(const sepax_body *b, const sepax_pose *pose) {
  double most = 0;
  for (int i = 0; i < 3; i++) {
    most = fmax(most, fabs(b->centre[i]));
  }
  most += b->scale;
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

static void enclose_waiting(search *s) {
  const int lanes = s->portable ? 2 : 4;
  double from[18 * 4];
  double least[4];
  double most[4];
  for (int first = 0; first < s->count && !s->ended; first += lanes) {
    int used = s->count - first < lanes ? s->count - first : lanes;
    for (int n = 0; n < lanes; n++) {
      const uint32_t *pair = s->waiting[n < used ? first + n : first].at;
      for (int body = 0; body < 2; body++) {
        const double(*v)[3] = s->body[body]->triangle[pair[body]];
        for (int k = 0; k < 9; k++) {
          from[(9 * body + k) * lanes + n] = v[k / 3][k % 3] * s->pose[body].unit;
        }
      }
    }
    if (s->portable) {
      enclose_portable(from, s->pose, least, most);
    }
#if defined __x86_64__
    if (!s->portable) {
      enclose_avx2(from, s->pose, least, most);
    }
#endif
    for (int n = 0; n < used && !s->ended; n++) {
      if (!(least[n] > s->limit * s->unit)) {
        const uint32_t *pair = s->waiting[first + n].at;
        s->take(s, pair[0], pair[1], least[n] / s->unit, most[n] / s->unit);
      }
    }
  }
  s->count = 0;
}

/* -------------------------------------------------------------------- the descent */

/* Each of 64 levels of both trees leaves up to seven pairs. */
enum { STACK = 1024 };

/* Where the boxes of a pair are, BODY_WIDE * node + lane; their distance at least. */
typedef struct {
  uint32_t at[2];
  double least;
} box_pair;

static uint32_t child_at(const sepax_body *b, uint32_t at) {
  return b->boxes[at / BODY_WIDE].child[at % BODY_WIDE];
}

static float size_at(const sepax_body *b, uint32_t at) {
  const body_boxes *boxes = &b->boxes[at / BODY_WIDE];
  uint32_t lane = at % BODY_WIDE;
  return boxes->half[0][lane] + boxes->half[1][lane] + boxes->half[2][lane];
}

static void turn_box(posed_box *p, const motion *m, const body_boxes *from, uint32_t lane) {
  for (int i = 0; i < 3; i++) {
    double at = m->scaled[0][i] * (double)from->centre[0][lane] +
                m->scaled[1][i] * (double)from->centre[1][lane] +
                m->scaled[2][i] * (double)from->centre[2][lane] + m->shifted[i];
    p->centre[i] = (float)at;
    p->rest[i] = (float)(at - (double)p->centre[i]);
    p->half[i] = m->ratio * from->half[i][lane] + m->lost;
    for (int k = 0; k < 3; k++) {
      p->axis[k][i] = m->turn[0][i] * from->axis[k][0][lane] +
                      m->turn[1][i] * from->axis[k][1][lane] +
                      m->turn[2][i] * from->axis[k][2][lane];
    }
  }
}

/* Which body's node to open: the larger, as far as it has one. */
static int opened(const search *s, const box_pair *p, const uint32_t child[2]) {
  if (((child[0] | child[1]) & BODY_TRIANGLE) != 0) {
    return (child[0] & BODY_TRIANGLE) != 0;
  }
  return size_at(s->body[1], p->at[1]) * s->at.to[0].ratio > size_at(s->body[0], p->at[0]);
}

/* Children of the opened node that may be near enough, the farthest first. */
static int near_children(const search *s, int open, uint32_t node, uint32_t other,
                         box_pair near[BODY_WIDE]) {
  const sepax_body *body = s->body[open];
  float square[BODY_WIDE];
  posed_box posed;
  int count = 0;
  turn_box(&posed, &s->at.to[open], &s->body[!open]->boxes[other / BODY_WIDE], other % BODY_WIDE);
  if (s->portable) {
    bound_portable(&body->boxes[node], &posed, square);
  }
#if defined __x86_64__
  if (!s->portable) {
    bound_avx2(&body->boxes[node], &posed, square);
  }
#endif
  double limit = s->limit / body->scale;
  double most = limit * limit * (1 + 0x1p-20) + FLT_MIN;
  for (uint32_t lane = 0; lane < BODY_WIDE; lane++) {
    if (body->boxes[node].child[lane] == BODY_NONE || (double)square[lane] > most) {
      continue;
    }
    int at = count++;
    for (; at > 0 && near[at - 1].least < (double)square[lane]; at--) {
      near[at] = near[at - 1];
    }
    near[at].least = (double)square[lane];
    near[at].at[open] = BODY_WIDE * node + lane;
    near[at].at[!open] = other;
  }
  for (int n = 0; n < count; n++) {
    near[n].least = sqrt(near[n].least) * (1 - 0x1p-20) * body->scale;
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
      s->waiting[s->count].at[open] = below - BODY_TRIANGLE;
      s->waiting[s->count].at[!open] = child[!open] - BODY_TRIANGLE;
      s->waiting[s->count++].least = near[n].least;
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

void search_pairs(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b) {
  box_pair stack[STACK];
  int depth = 1;
  size_t visits = 0;
  double end = s->seconds > 0 ? seconds_now() + s->seconds : 0;
  int exponent;
  frexp(fmax(largest(s->body[0], pose_a), largest(s->body[1], pose_b)), &exponent);
  s->unit = ldexp(1, -exponent);
  find_world_pose(&s->pose[0], pose_a, s->unit);
  find_world_pose(&s->pose[1], pose_b, s->unit);
  place_bodies(&s->at, s->body[0], pose_a, s->body[1], pose_b);
#if defined __x86_64__
  s->portable = s->portable || !__builtin_cpu_supports("avx2");
#else
  s->portable = true;
#endif
  stack[0].least = 0;
  for (int k = 0; k < 2; k++) {
    stack[0].at[k] = BODY_WIDE * (uint32_t)s->body[k]->nodes;
  }
  while (depth > 0 && !s->ended) {
    box_pair p = stack[--depth];
    if (p.least <= s->limit) {
      visit(s, &p, stack, &depth);
    }
    if (s->count >= s->batch || s->count > SEARCH_BATCH - BODY_WIDE) {
      enclose_waiting(s);
    }
    if (end > 0 && visits++ % 64 == 0 && seconds_now() >= end) {
      s->ended = true;
    }
  }
  if (!s->ended) {
    enclose_waiting(s);
  }
}
