/* query.c - which triangles of two bodies in their poses collide.
 *
 * Both trees are descended together. A box of one body, turned into the other's coordinates, is
 * tested against the eight children of a node there, on the three axes of each child, the three of
 * the box, and their nine cross products. Pairs of triangles whose boxes may meet are posed in
 * doubles and judged several at once; where a sign is not certain, sepax_exact_posed decides on the
 * exact coordinates.
 *
 * Rounding of the test. With u = 2^-24 and H the sum of the six half sides, boxes that meet have
 * centres within H of each other. Then the offset on an axis is wrong by 9 u H, a cosine by 13 u,
 * a sum of half sides by 4 u H. A pose is a rotation within 1e-6 (sepax_pose_valid), one relative
 * to the other, and its inverse, within 6e-6 < 101 u, by which cosines of axes of one box differ
 * from 0 and 1. All that is below 2^-17 H on the axes of the boxes, where half sides have 2^-15 of
 * each box's own more than they need (fit.c), and below 2^-16 H on the cross products, to which
 * BOX_SLACK H is added. What is not a number separates nothing. */
#include "judge.h"
#include "turned.h"
#include "util/error.h"
#include "util/list.h"
#include "verdict/signs.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define UNROLL _Pragma("GCC unroll 3")
#define BOX_SLACK 0x1p-15F

/* ------------------------------------------------------------ instruction sets */

#define NAME(x) x##_portable
#define TARGET
#define FLOATS 4
#define MADD(p, q, r) ((p) * (q) + (r))
#define ALL(x) (x)
#define BITS(v) \
  ((uint32_t)(((v)[0] < 0) | ((v)[1] < 0) << 1 | ((v)[2] < 0) << 2 | ((v)[3] < 0) << 3))
#include "boxes.h"

#if defined __x86_64__
#define NAME(x) x##_avx2
#define TARGET __attribute__((target("avx2,fma")))
#define FLOATS 8
#define MADD(p, q, r) ((__typeof__(r))_mm256_fmadd_ps((__m256)(p), (__m256)(q), (__m256)(r)))
#define ALL(x) _mm256_set1_ps(x)
#define BITS(v) ((uint32_t)_mm256_movemask_ps((__m256)(v)))
#include "boxes.h"
#endif

/* ------------------------------------------------------------------- the search */

/* Each of 64 levels of both trees leaves up to seven pairs. */
enum { STACK = 1024, BATCH = 64 };

/* Where the boxes of a pair are: BODY_WIDE * node + lane. */
typedef struct {
  uint32_t at[2];
} box_pair;

typedef struct {
  const sepax_body *body[2];
  const sepax_query *query;
  posed_pairs pairs;
  sepax_pairs *found;
  size_t capacity, hits;
  bool no_memory, ended;
  double end;                 /* of the time; 0: none */
  uint32_t waiting[BATCH][2]; /* pairs of triangles */
  int count, batch;           /* batch: so many are judged at once */
  size_t visits, judged;
} search;

static void record(search *s, uint32_t i, uint32_t j) {
  const sepax_query *q = s->query;
  size_t a = s->body[0]->number[i];
  size_t b = s->body[1]->number[j];
  s->hits++;
  if (q->each != NULL) {
    s->ended = !q->each(q->context, a, b);
  } else if (!q->only_any) {
    s->no_memory = !list_add_pair(s->found, &s->capacity, a, b);
  }
  s->ended = s->ended || s->no_memory || q->only_any || (q->most > 0 && s->hits == q->most);
}

static double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* The pairs of triangles that wait. */
static void judge(search *s) {
  uint64_t hits = judge_posed_pairs(&s->pairs, s->waiting, s->count);
  for (; hits != 0 && !s->ended; hits &= hits - 1) {
    const uint32_t *pair = s->waiting[__builtin_ctzll(hits)];
    record(s, pair[0], pair[1]);
  }
  s->judged += (size_t)s->count;
  s->count = 0;
}

static float size_at(const sepax_body *b, uint32_t at) {
  const body_boxes *boxes = &b->boxes[at / BODY_WIDE];
  uint32_t lane = at % BODY_WIDE;
  return boxes->half[0][lane] + boxes->half[1][lane] + boxes->half[2][lane];
}

/* The box at `at` of a body against the children of a node of the other body, `open`. */
static uint32_t overlaps(const search *s, int open, uint32_t node, uint32_t at) {
  const body_boxes *boxes = &s->body[open]->boxes[node];
  const body_boxes *from = &s->body[!open]->boxes[at / BODY_WIDE];
  uint32_t lane = at % BODY_WIDE;
  return s->pairs.lanes > 2 ? overlaps_avx2(boxes, &s->pairs.at.to[open], from, lane)
                            : overlaps_portable(boxes, &s->pairs.at.to[open], from, lane);
}

/* Which body's node to open: the larger, as far as it has one. */
static int opened(const search *s, const box_pair *p, const uint32_t child[2]) {
  if (((child[0] | child[1]) & BODY_TRIANGLE) != 0) {
    return (child[0] & BODY_TRIANGLE) != 0;
  }
  return size_at(s->body[1], p->at[1]) * s->pairs.at.to[0].ratio > size_at(s->body[0], p->at[0]);
}

static void visit(search *s, const box_pair *p, box_pair *stack, int *depth) {
  uint32_t child[2] = {child_at(s->body[0], p->at[0]), child_at(s->body[1], p->at[1])};
  int open = opened(s, p, child);
  uint32_t node = child[open];
  const body_boxes *boxes = &s->body[open]->boxes[node];
  bool other_is_triangle = (child[!open] & BODY_TRIANGLE) != 0;
  s->visits++;
  for (uint32_t mask = overlaps(s, open, node, p->at[!open]); mask != 0;) {
    uint32_t lane = 31 - (uint32_t)__builtin_clz(mask);
    uint32_t below = boxes->child[lane];
    mask ^= 1U << lane;
    if (other_is_triangle && (below & BODY_TRIANGLE) != 0) {
      if (below != BODY_NONE) {
        s->waiting[s->count][open] = below - BODY_TRIANGLE;
        s->waiting[s->count++][!open] = child[!open] - BODY_TRIANGLE;
      }
    } else if (below != BODY_NONE) {
      stack[*depth].at[open] = BODY_WIDE * node + lane;
      stack[(*depth)++].at[!open] = p->at[!open];
    }
  }
}

static void descend(search *s) {
  box_pair stack[STACK];
  int depth = 1;
  for (int k = 0; k < 2; k++) {
    stack[0].at[k] = BODY_WIDE * (uint32_t)s->body[k]->nodes;
  }
  while (depth > 0 && !s->ended) {
    if (s->end > 0 && s->visits % 64 == 0 && seconds_now() >= s->end) {
      s->ended = true;
      return;
    }
    box_pair p = stack[--depth];
    visit(s, &p, stack, &depth);
    if (s->count >= s->batch || s->count > BATCH - BODY_WIDE) {
      judge(s);
    }
  }
  if (!s->ended) {
    judge(s);
  }
}

bool sepax_bodies_collide(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                          const sepax_pose *pose_b, const sepax_query *query, sepax_pairs *found,
                          sepax_error *error) {
  static const sepax_query usual = {0};
  search s = {.body = {a, b}, .found = found};
  s.query = query != NULL ? query : &usual;
  *found = (sepax_pairs){0};
  if (balls_disjoint(a, pose_a, b, pose_b)) {
    return true;
  }
  s.pairs = (posed_pairs){.first = {a->triangle[0][0], b->triangle[0][0]},
                          .stride = {9, 9},
                          .strict = s.query->strict,
                          .lanes = posed_pairs_lanes(s.query->path)};
  place_bodies(&s.pairs.at, a, pose_a, b, pose_b);
  s.batch = s.query->only_any || s.query->most > 0 ? 4 : BATCH;
  s.end = s.query->seconds > 0 ? seconds_now() + s.query->seconds : 0;
  descend(&s);
  found->count = s.hits;
  found->ended = s.ended;
  if (s.no_memory) {
    sepax_pairs_free(found);
    return sepax_fail(error, "no memory for the colliding pairs");
  }
  return true;
}
