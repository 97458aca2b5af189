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
#include "frames.h"
#include "front.h"
#include "queue.h"
#include "support.h"
#include "util/simd.h"
#include "util/vector.h"

#include <float.h>
#include <math.h>
#include <string.h>
#include <time.h>

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

/* The distance of a pair of triangles is within least ... most. */
typedef struct {
  double least, most, way[3];
} pair_enclosure;

/* Directions on which many pairs of triangles have a gap: that of the nearest pair and that of the
 * last one. Pairs whose gap on one of them is above `enough` need no more. */
typedef struct {
  double way[2][3];
  double enough;
} short_cut;

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

/* Make a vector's length 1, or 0 if it is too short or long. */
static void set_unit(double to[3], const double v[3]) {
  double length = vector_length(v);
  double scale = length > 0x1p-400 && length < 0x1p400 ? 1 / length : 0;
  for (int i = 0; i < 3; i++) {
    to[i] = v[i] * scale;
  }
}

/* The way between two bodies, in the coordinates of both, is an axis for boxes. */
static void set_way(search *s, const double way[3]) {
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

static void drop_waiting(search *s) {
  int count = 0;
  for (int n = 0; n < s->count; n++) {
    if (s->waiting[n].least <= s->most) {
      s->waiting[count++] = s->waiting[n];
    }
  }
  s->count = count;
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

/* Keep a pair that the search need not open further. `bound` is in file units. */
static void keep(const search *s, const uint32_t at[2], double bound) {
  if (s->front != NULL) {
    const front_entry e = {{at[0], at[1]}, FRONT_CLOSED, 0};
    sepax__front_add(s->front, &e, bound);
  }
}

/* A bound in file units, of a square in those of the search. */
static double bound_of(const search *s, double square) {
  return sqrt(square) * (1 - 0x1p-50) * s->scale;
}

static void keep_waiting(const search *s, int first) {
  for (int n = first; n < s->count; n++) {
    keep(s, s->waiting[n].at, bound_of(s, s->waiting[n].least));
  }
}

static void take_waiting(search *s) {
  const int lanes = s->portable ? 2 : 4;
  double from[18 * 4];
  pair_enclosure e[4];
  short_cut cut = {.enough = INFINITY};
  memcpy(cut.way[1], s->line, sizeof s->line);
  drop_waiting(s);
  int next_one = 0;
  for (int first = 0; first < s->count && !s->ended; first += lanes) {
    int used = s->count - first < lanes ? s->count - first : lanes;
    gather(s, first, used, lanes, from);
    memcpy(cut.way[0], s->line, sizeof s->line);
    cut.enough = s->limit * s->unit;
    enclose(s, from, &cut, e);
    s->work += (uint64_t)used;
    set_unit(cut.way[1], e[0].way);
    for (int n = 0; n < used && !s->ended; n++) {
      bool may_be_near = !(e[n].least > s->limit * s->unit);
      if (may_be_near) {
        s->take(s, s->waiting[first + n].at, e[n].least / s->unit, e[n].most / s->unit);
      }
      keep(s, s->waiting[first + n].at,
           !may_be_near || s->ended ? e[n].least / s->unit * (1 - 0x1p-50) : s->limit);
      next_one++;
      if (e[n].most < s->shortest) {
        s->shortest = e[n].most;
        s->nearest = s->waiting[first + n];
        set_way(s, e[n].way);
      }
    }
  }
  keep_waiting(s, next_one);
  s->count = 0;
}

/* -------------------------------------------------------------------- the descent */

/* Each of 64 levels of both trees leaves up to seven pairs. */
enum { STACK = 2048, SEEDS = 2, DEPTH_FIRST = 128, FIRST_PROOF = 24 };

/* The pairs of boxes that are left: depth first in a stack, or best first in a queue, as far as
 * that has room. */
typedef struct {
  box_pair stack[STACK];
  int depth;
  pair_queue *queue; /* NULL: depth first */
} open_pairs;

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

/* --------------------------------------------------------------- bounds in doubles */

static void rotate(const double r[3][3], const double v[3], double to[3]) {
  for (int i = 0; i < 3; i++) {
    to[i] = vector_dot(r[i], v);
  }
}

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

/* A bound of the distance of two children in doubles, in the unit of the search; at least one of
 * them is a node. */
static double exact_bound(const search *s, const uint32_t child[2]) {
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

/* Would a bound in doubles be above the limit? It is not above the one in single precision by more
 * than what that takes off for rounding: slack times the offset of the centres, which is less than
 * twice the limit and all half sides, and 2^-15 of the half sides, each on three axes. */
static bool in_doubt(const search *s, double least, const uint32_t at[2]) {
  double half = 0;
  for (int body = 0; body < 2; body++) {
    half += (double)size_at(s->body[body], at[body]) * s->body[body]->scale / s->scale;
  }
  double limit = s->limit / s->scale;
  double lost = 8 * (limit + half) * (double)s->slack + 0x1p-13 * half;
  return isfinite(limit) && sqrt(least) + lost > limit;
}

/* Is a bound in doubles, in terms of `scale`, so near the limit that doubles do not decide? */
static bool is_tie(const search *s, double least) {
  double limit = s->limit / s->scale;
  double doubt = 8 * FRAME_ERROR;
  return least <= limit && limit - least < doubt * (limit + 1 / (s->unit * s->scale));
}

/* The bound `least` of a pair in single precision, or a better one: in doubles, or, where these do
 * not decide, by the direction of the nearest pair; infinite if that proves that it is not
 * needed. */
static double refined(search *s, double least, const uint32_t at[2]) {
  const uint32_t child[2] = {child_at(s->body[0], at[0]), child_at(s->body[1], at[1])};
  double unit = s->unit * s->scale; /* not 0, unless a translation is out of all proportion */
  if ((child[0] & child[1] & BODY_TRIANGLE) != 0 || !(unit > 0x1p-900) || !in_doubt(s, least, at)) {
    return least;
  }
  double nearest = exact_bound(s, child) / unit * (1 - 0x1p-50);
  s->work++;
  if (s->proof.possible && is_tie(s, nearest)) {
    hindrance by;
    if (sepax__prove_apart(s, child, &by)) {
      return INFINITY;
    }
  }
  return fmax(least, nearest * nearest);
}

/* --------------------------------------------------------------------- the search */

/* Keep the children of a node that are farther than the limit; `opened` are those that are not.
 * least: the square of the distance of some of them at least. */
static void keep_children(const search *s, int open, uint32_t node, const box_pair *p,
                          uint32_t opened, double least, const float square[BODY_WIDE]) {
  const uint32_t *child = s->body[open]->boxes[node].child;
  uint32_t all = 0;
  float own = INFINITY;
  for (uint32_t lane = 0; lane < BODY_WIDE && child[lane] != BODY_NONE; lane++) {
    all |= 1U << lane;
    own = (opened >> lane & 1) == 0 && square[lane] < own ? square[lane] : own;
  }
  if ((all & ~opened) != 0) {
    const front_entry e = {{p->at[0], p->at[1]}, (uint16_t)open, (uint16_t)opened};
    least = fmin(least, (double)fminf(own, FLT_MAX) * s->square_of_unit[open]);
    sepax__front_add(s->front, &e, bound_of(s, fmax(least, p->least)));
  }
}

/* Children of the opened node that may be near enough, except for `others`, the farthest first.
 * Inlined twice, because a search without a front should not pay for one. */
static inline __attribute__((always_inline)) int near_children_of(search *s, int open,
                                                                  uint32_t node, const box_pair *p,
                                                                  uint32_t others, bool keeping,
                                                                  box_pair near[BODY_WIDE]) {
  float square[BODY_WIDE];
  uint32_t on = others; /* children that go on */
  double proved = INFINITY;
  int count = 0;
  for (uint32_t mask = bound(s, open, node, p->at[!open], square) & ~others; mask != 0;
       mask &= mask - 1) {
    uint32_t lane = (uint32_t)__builtin_ctz(mask);
    /* a square that single precision cannot hold is above the largest that it can */
    double own = (double)fminf(square[lane], FLT_MAX) * s->square_of_unit[open];
    double least = fmax(own, p->least);
    if (s->body[open]->boxes[node].child[lane] == BODY_NONE) {
      continue;
    }
    box_pair q;
    q.at[open] = BODY_WIDE * node + lane;
    q.at[!open] = p->at[!open];
    q.least = refined(s, least, q.at);
    if (q.least > s->most) {
      /* by a direction: no more than the limit is certain */
      double limit = keeping ? s->limit / s->scale : 0;
      proved = fmin(proved, isinf(q.least) ? limit * limit : q.least);
      square[lane] = INFINITY;
      continue;
    }
    on |= 1U << lane;
    int at = count++;
    for (; at > 0 && near[at - 1].least < q.least; at--) {
      near[at] = near[at - 1];
    }
    near[at] = q;
  }
  if (keeping && !s->front->full) {
    keep_children(s, open, node, p, on, proved, square);
  }
  return count;
}

static __attribute__((noinline)) int near_children_kept(search *s, int open, uint32_t node,
                                                        const box_pair *p, uint32_t others,
                                                        box_pair near[BODY_WIDE]) {
  return near_children_of(s, open, node, p, others, true, near);
}

static void prefetch(const void *at, size_t bytes) {
  for (size_t line = 0; line < bytes; line += 64) {
    __builtin_prefetch((const char *)at + line);
  }
}

/* Open one node of a pair: that of the body `open`, or, if it is FRONT_CLOSED, any. */
static void visit(search *s, const box_pair *p, int open, uint32_t others, open_pairs *o) {
  uint32_t child[2] = {child_at(s->body[0], p->at[0]), child_at(s->body[1], p->at[1])};
  open = open == FRONT_CLOSED ? opened(s, p, child) : open;
  box_pair near[BODY_WIDE];
  int count = s->front == NULL ? near_children_of(s, open, child[open], p, 0, false, near)
                               : near_children_kept(s, open, child[open], p, others, near);
  s->work++;
  for (int n = 0; n < count; n++) {
    uint32_t below = child_at(s->body[open], near[n].at[open]);
    if ((child[!open] & below & BODY_TRIANGLE) != 0) {
      s->waiting[s->count++] = near[n];
    } else {
      o->stack[o->depth++] = near[n];
    }
    if ((below & BODY_TRIANGLE) == 0) {
      prefetch(&s->body[open]->boxes[below], sizeof(body_boxes));
    } else {
      prefetch(s->body[open]->triangle[below - BODY_TRIANGLE], sizeof(facet_points));
    }
  }
}

double sepax__seconds_now(void) {
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
  set_way(s, way);
  s->shortest = INFINITY;
  s->open = INFINITY;
  return exact_bound(s, (const uint32_t[2]){0, 0}) / s->unit * (1 - 0x1p-50);
}

/* The square of the limit, as those of boxes are counted. In single precision these, sums of three
 * squares, round by 4 u; both sides give 2^-22. */
static void find_most(search *s) {
  double limit = s->limit / s->scale;
  s->most = limit < 0 ? -1 : limit * limit * (1 + 0x1p-22) + 0x1p-1000;
  for (int body = 0; body < 2; body++) {
    limit = s->limit / s->body[body]->scale;
    s->most_of[body] = limit < 0 ? -1 : (float)(limit * limit * (1 + 0x1p-22) + FLT_MIN);
  }
}

void sepax__search_waiting(search *s) {
  find_most(s);
  take_waiting(s);
}

/* Go on at the nearest triangles and the other body as a whole: what is nearest to them is likely
 * near. */
static void add_seeds(const search *s, open_pairs *o) {
  for (int k = 0; k < 2; k++) {
    box_pair *seed = &o->stack[o->depth++];
    seed->least = 0;
    seed->at[k] = s->nearest.at[k];
    seed->at[!k] = BODY_WIDE * (uint32_t)s->body[!k]->nodes;
  }
}

/* Move pairs from the stack to the queue. */
static void enqueue(open_pairs *o) {
  int left = 0;
  for (int n = 0; n < o->depth; n++) {
    if (!queue_push(o->queue, &o->stack[n])) {
      o->stack[left++] = o->stack[n];
    }
  }
  o->depth = left;
}

static bool next_pair(search *s, open_pairs *o, box_pair *p) {
  while (o->depth > 0) {
    *p = o->stack[--o->depth];
    if (p->least <= s->most) {
      return true;
    }
  }
  while (o->queue != NULL && queue_pop(o->queue, p)) {
    if (p->least <= s->most) {
      return true;
    }
  }
  return false;
}

/* Look at the next entry of the front that may be near. False if there is none. */
static bool resume(search *s, open_pairs *o) {
  front_entry e;
  if (!s->resume || !sepax__front_next(s->front, &e)) {
    return false;
  }
  const box_pair p = {{e.at[0], e.at[1]}, 0};
  if ((child_at(s->body[0], p.at[0]) & child_at(s->body[1], p.at[1]) & BODY_TRIANGLE) != 0) {
    s->waiting[s->count++] = p;
  } else {
    visit(s, &p, e.open, e.others, o);
  }
  return true;
}

/* Keep what is left open; it is not nearer than `proved`. */
static void keep_open(search *s, const open_pairs *o, double proved) {
  for (int n = 0; n < s->count; n++) {
    keep(s, s->waiting[n].at, fmax(proved, bound_of(s, s->waiting[n].least)));
  }
  for (int n = 0; n < o->depth; n++) {
    keep(s, o->stack[n].at, fmax(proved, bound_of(s, o->stack[n].least)));
  }
  sepax__front_end(s->front, !s->resume, proved);
}

/* What is left is not nearer than this, in file units. */
static double least_of_open(const search *s, const open_pairs *o) {
  double least = INFINITY;
  for (int n = 0; n < o->depth; n++) {
    least = fmin(least, o->stack[n].least);
  }
  for (int n = 0; n < s->count; n++) {
    least = fmin(least, s->waiting[n].least);
  }
  if (o->queue != NULL) {
    least = fmin(least, queue_least(o->queue));
  }
  return bound_of(s, least);
}

static bool has_ended(const search *s, size_t steps, double end) {
  return (s->work_most > 0 && s->work >= s->work_most) ||
         (end > 0 && steps % 64 == 1 && sepax__seconds_now() >= end);
}

/* `queue`: where pairs go once a limit is known and the search has taken some steps; or NULL. */
static void run(search *s, pair_queue *queue) {
  open_pairs o;
  size_t steps = 0;
  size_t proof = FIRST_PROOF; /* steps before the next attempt of a proof */
  int seeds = SEEDS;
  double end = s->seconds > 0 ? sepax__seconds_now() + s->seconds : 0;
  o.depth = s->resume ? 0 : 1;
  o.queue = NULL;
  o.stack[0].least = 0;
  for (int k = 0; k < 2; k++) {
    o.stack[0].at[k] = BODY_WIDE * (uint32_t)s->body[k]->nodes;
  }
  find_most(s);
  for (box_pair p; !s->ended;) {
    double limit = s->limit;
    if (s->count >= s->batch || s->count > SEARCH_BATCH - BODY_WIDE ||
        (s->count > 0 && isinf(limit))) {
      take_waiting(s);
      find_most(s);
    }
    if (s->limit < limit && seeds-- > 0) {
      add_seeds(s, &o);
      continue;
    }
    if (next_pair(s, &o, &p)) {
      visit(s, &p, FRONT_CLOSED, 0, &o);
    } else if (!resume(s, &o)) {
      break;
    }
    steps++;
    if (queue != NULL && o.queue == NULL && steps > DEPTH_FIRST && isfinite(s->limit)) {
      o.queue = queue;
      queue_clear(queue, s->most);
    }
    if (o.queue != NULL) {
      enqueue(&o);
    }
    if (s->prove != NULL && steps >= proof && isfinite(s->shortest)) {
      if (s->prove(s)) {
        if (s->front != NULL) {
          keep_open(s, &o, s->limit);
        }
        return;
      }
      proof = 4 * steps;
    }
    if (has_ended(s, steps, end)) {
      s->ended = true;
      s->open = fmin(s->open, least_of_open(s, &o));
    }
  }
  if (!s->ended) {
    take_waiting(s);
  }
  if (s->front != NULL) {
    keep_open(s, &o, 0);
  }
}

/* Not inlined, because a search without limits needs no memory for the queue. */
static __attribute__((noinline)) void run_best_first(search *s) {
  pair_queue queue;
  queue_clear(&queue, 0);
  run(s, &queue);
}

void sepax__search_pairs(search *s) {
  if (s->best_first) {
    run_best_first(s);
  } else {
    run(s, NULL);
  }
}
