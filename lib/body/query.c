/* SPDX-License-Identifier: MIT */
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
#include "query.h"
#include "turned.h"
#include "util/options.h"
#include "util/clock.h"
#include "util/list.h"
#include "verdict/signs.h"
#include "util/simd.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define SIMD_UNROLL _Pragma("GCC unroll 3")
#define BOX_SLACK 0x1p-15F

enum { AT_ONCE = 8, BATCH = 64 };

/* A test of the children of a node against a box of the other body, which `move` turns. */
typedef struct {
  const body_boxes *node, *from;
  const motion *move;
  uint32_t lane;             /* lane of the box in `from` */
  uint32_t boxes, triangles; /* bit k: child k, a box or a triangle, may meet it */
} box_task;

/* ------------------------------------------------------------ instruction sets */

#define SIMD_FLOATS 4
#define SIMD_NODES 1
#define SIMD_NAME(x) x##_portable
#define SIMD_TARGET
#define SIMD_MADD(p, q, r) ((p) * (q) + (r))
#define SIMD_LOAD(v, node, member, n) memcpy(&(v), (node)[0]->member + (n), sizeof(v))
#define SIMD_OF(p, member) ((p)[0]->member - (SIMD_FLOAT){0})
#define SIMD_BOOL SIMD_MASK
#define SIMD_SEPARATE(mask, p, q) ((mask) |= SIMD_SIZE(p) > (q))
#define SIMD_BITS(v) \
  ((uint32_t)(((v)[0] < 0) | ((v)[1] < 0) << 1 | ((v)[2] < 0) << 2 | ((v)[3] < 0) << 3))
#define SIMD_SIGNS(v) SIMD_BITS(v)
#include "boxes.h"

#if defined __x86_64__
#define SIMD_FLOATS 8
#define SIMD_NODES 1
#define SIMD_NAME(x) x##_avx2
#define SIMD_TARGET __attribute__((target("avx2,fma")))
#define SIMD_MADD(p, q, r) ((SIMD_FLOAT)_mm256_fmadd_ps((__m256)(p), (__m256)(q), (__m256)(r)))
#define SIMD_LOAD(v, node, member, n) memcpy(&(v), (node)[0]->member + (n), sizeof(v))
#define SIMD_OF(p, member) ((SIMD_FLOAT)_mm256_set1_ps((p)[0]->member))
#define SIMD_BOOL SIMD_MASK
#define SIMD_SEPARATE(mask, p, q) ((mask) |= SIMD_SIZE(p) > (q))
#define SIMD_BITS(v) ((uint32_t)_mm256_movemask_ps((__m256)(v)))
#define SIMD_SIGNS(v) SIMD_BITS(v)
#include "boxes.h"

#define SIMD_FLOATS 16
#define SIMD_NODES 2
#define SIMD_NAME(x) x##_avx512
#define SIMD_TARGET __attribute__((target("avx512f,avx512dq,avx512vl,avx2,fma")))
#define SIMD_MADD(p, q, r) ((SIMD_FLOAT)_mm512_fmadd_ps((__m512)(p), (__m512)(q), (__m512)(r)))
#define SIMD_LOAD(v, node, member, n)                                            \
  ((v) = (SIMD_FLOAT)_mm512_insertf32x8(                                         \
       _mm512_castps256_ps512(_mm256_loadu_ps((const void *)(node)[0]->member)), \
       _mm256_loadu_ps((const void *)(node)[1]->member), 1),                     \
   (void)(n))
#define SIMD_OF(p, member)                                                        \
  ((SIMD_FLOAT)_mm512_mask_broadcastss_ps(_mm512_set1_ps((p)[0]->member), 0xff00, \
                                          _mm_set_ss((p)[1]->member)))
#define SIMD_BOOL __mmask16
#define SIMD_SEPARATE(mask, p, q) \
  ((mask) |= _mm512_cmp_ps_mask((__m512)SIMD_SIZE(p), (__m512)(q), _CMP_GT_OQ))
#define SIMD_BITS(v) ((uint32_t)(v))
#define SIMD_SIGNS(v) ((uint32_t)_mm512_movepi32_mask((__m512i)(v)))
#include "boxes.h"
#endif

/* ------------------------------------------------------------------- the search */

/* The largest number of waiting pairs. AT_ONCE pairs leave up to 8 each on each of 64 levels of
 * both trees. The stack is sorted by level, so the pairs of a level are taken only after all pairs
 * below it. */
enum { STACK = 2 * 64 * BODY_WIDE * AT_ONCE };

typedef void box_comparer(box_task *tasks, int count);

/* A pair of boxes: BODY_WIDE * node + lane in each body. */
typedef struct {
  uint32_t at[2];
} box_pair;

typedef struct {
  const sepax_body *body[2];
  const sepax_query *query; /* or NULL for sepax__find_collision */
  posed_pairs pairs;
  sepax_pairs *found;
  size_t capacity, hits;
  bool no_memory, ended;
  double end;                                       /* when the time limit ends; 0: no limit */
  uint32_t waiting[BATCH + BODY_WIDE * AT_ONCE][2]; /* pairs of triangles that wait to be judged:
                                                       places, or boxes if pairs.rough */
  int count, batch; /* pairs that wait; pairs that are judged at once */
  box_comparer *compare_boxes;
  int at_once; /* pairs of boxes that are compared at once */
  size_t visits;
  uint64_t work, work_most; /* units of work; work_most 0: no limit */
  uint32_t place[2];        /* of the pair that sepax__find_collision finds; a box if in doubt */
  bool in_doubt;
} search;

static void record(search *s, uint32_t i, uint32_t j) {
  const sepax_query *q = s->query;
  if (q == NULL) {
    s->place[0] = i;
    s->place[1] = j;
    s->hits = 1;
    s->ended = true;
    return;
  }
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

/* Judge pairs by their boxes; one that collides, or else one in doubt, ends the search. */
static void judge_roughly(search *s, const uint32_t (*at)[2], int count) {
  uint32_t place[BATCH][2];
  uint64_t doubt;
  for (int n = 0; n < count; n++) {
    for (int k = 0; k < 2; k++) {
      place[n][k] = child_at(s->body[k], at[n][k]) - BODY_TRIANGLE;
    }
  }
  uint64_t hits = sepax__judge_posed_pairs(&s->pairs, (const uint32_t(*)[2])place, count, &doubt);
  if (hits != 0) {
    const uint32_t *pair = place[__builtin_ctzll(hits)];
    record(s, pair[0], pair[1]);
  } else if (doubt != 0) {
    memcpy(s->place, at[__builtin_ctzll(doubt)], sizeof s->place);
    s->in_doubt = s->ended = true;
  }
}

/* Judge up to BATCH waiting pairs of triangles; fewer where work is limited. */
static void judge(search *s) {
  int most = s->work_most > 0 ? s->batch : BATCH;
  int count = s->count < most ? s->count : most;
  uint64_t exact;
  s->count -= count;
  s->work += (uint64_t)count;
  const uint32_t(*waiting)[2] = (const uint32_t(*)[2])s->waiting + s->count;
  if (s->pairs.rough) {
    judge_roughly(s, waiting, count);
    return;
  }
  uint64_t hits = sepax__judge_posed_pairs(&s->pairs, waiting, count, &exact);
  s->work += WORK_EXACT * (uint64_t)__builtin_popcountll(exact);
  for (; hits != 0 && !s->ended; hits &= hits - 1) {
    const uint32_t *pair = waiting[__builtin_ctzll(hits)];
    record(s, pair[0], pair[1]);
  }
}

/* A pair of boxes, one of which is opened. */
typedef struct {
  int open;
  uint32_t node, other, child; /* the opened node; the other box, and its child */
} opening;

static void prefetch_triangle(const search *s, int body, uint32_t number) {
  const char *at = (const char *)s->body[body]->triangle[number];
  __builtin_prefetch(at);
  __builtin_prefetch(at + sizeof(facet_points) - 1);
}

static void open_pair(const search *s, const box_pair *p, opening *o, box_task *t) {
  uint32_t child[2] = {child_at(s->body[0], p->at[0]), child_at(s->body[1], p->at[1])};
  int open = opened_body(s->body, p->at, s->pairs.at.to[0].ratio);
  *o = (opening){open, child[open], p->at[!open], child[!open]};
  t->node = &s->body[open]->boxes[child[open]];
  t->from = &s->body[!open]->boxes[o->other / BODY_WIDE];
  t->move = &s->pairs.at.to[open];
  t->lane = o->other % BODY_WIDE;
  for (size_t line = 0; line < sizeof *t->node; line += 64) {
    __builtin_prefetch((const char *)t->node + line);
  }
}

/* Push children that may meet the box on the stack, or onto the list of waiting triangle pairs. */
static void take_children(search *s, const opening *o, const box_task *t, box_pair *stack,
                          int *depth) {
  const int open = o->open;
  uint32_t boxes = t->boxes;
  if ((o->child & BODY_TRIANGLE) == 0) {
    boxes |= t->triangles;
  } else {
    for (uint32_t mask = t->triangles; mask != 0; mask &= mask - 1) {
      uint32_t lane = (uint32_t)__builtin_ctz(mask);
      uint32_t number = t->node->child[lane] - BODY_TRIANGLE;
      s->waiting[s->count][open] = s->pairs.rough ? BODY_WIDE * o->node + lane : number;
      s->waiting[s->count++][!open] = s->pairs.rough ? o->other : o->child - BODY_TRIANGLE;
      prefetch_triangle(s, open, number);
    }
  }
  for (; boxes != 0; boxes &= boxes - 1) {
    stack[*depth].at[open] = BODY_WIDE * o->node + (uint32_t)__builtin_ctz(boxes);
    stack[(*depth)++].at[!open] = o->other;
  }
}

/* Take pairs from the top of the stack and compare them. */
static void visit(search *s, box_pair *stack, int *depth) {
  box_task task[AT_ONCE];
  opening open[AT_ONCE];
  int count = *depth < s->at_once ? *depth : s->at_once;
  *depth -= count;
  for (int n = 0; n < count; n++) {
    open_pair(s, &stack[*depth + n], &open[n], &task[n]);
  }
  s->compare_boxes(task, count);
  s->visits += (size_t)count;
  s->work += (uint64_t)count;
  for (int n = 0; n < count; n++) {
    take_children(s, &open[n], &task[n], stack, depth);
  }
}

static bool out_of_work(const search *s) { return s->work_most > 0 && s->work >= s->work_most; }

/* True once a limit of work or time is reached. The clock is read at every 64th visit. */
static bool beyond_limits(const search *s, size_t *clock) {
  if (out_of_work(s)) {
    return true;
  }
  if (s->end > 0 && s->visits >= *clock) {
    *clock = s->visits + 64;
    return seconds_now() >= s->end;
  }
  return false;
}

/* Judge pairs until no more than `left` wait. False if a limit of work ended that. */
static bool judge_down_to(search *s, int left) {
  while (s->count > left && !s->ended) {
    if (out_of_work(s)) {
      return false;
    }
    judge(s);
  }
  return true;
}

/* False if a limit ended the search. */
static bool descend(search *s) {
  box_pair stack[STACK];
  int depth = 1;
  size_t clock = 0;
  for (int k = 0; k < 2; k++) {
    stack[0].at[k] = BODY_WIDE * (uint32_t)s->body[k]->nodes;
  }
  while (depth > 0 && !s->ended) {
    if (beyond_limits(s, &clock)) {
      return false;
    }
    visit(s, stack, &depth);
    if (!judge_down_to(s, s->batch - 1)) {
      return false;
    }
  }
  return judge_down_to(s, 0);
}

static box_comparer *comparer(int lanes) {
#if defined __x86_64__
  if (lanes > 2) {
    return lanes == 8 ? compare_boxes_avx512 : compare_boxes_avx2;
  }
#endif
  (void)lanes;
  return compare_boxes_portable;
}

/* Prepare a search of bodies in valid poses; `few` if it ends at its first pairs. */
static void begin(search *s, const sepax_pose *pose_a, const sepax_pose *pose_b, bool strict,
                  bool few, sepax_simd simd, double seconds) {
  s->pairs = (posed_pairs){.first = {s->body[0]->triangle[0][0], s->body[1]->triangle[0][0]},
                           .stride = {9, 9},
                           .strict = strict,
                           .lanes = sepax__posed_pairs_lanes(simd)};
  sepax__place_bodies(&s->pairs.at, s->body[0], pose_a, s->body[1], pose_b);
  s->batch = few ? 4 : BATCH;
  s->at_once = few ? 2 : AT_ONCE;
  s->compare_boxes = comparer(s->pairs.lanes);
  s->end = seconds > 0 ? seconds_now() + seconds : 0;
}

bool sepax__find_collision(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, sepax_simd simd, search_limits *limits,
                           uint32_t place[2]) {
  search s = {.body = {a, b}, .work_most = limits->most};
  begin(&s, pose_a, pose_b, false, true, simd, limits->seconds);
  s.pairs.rough = limits->rough;
  limits->ended = !descend(&s) || s.in_doubt;
  limits->in_doubt = s.in_doubt;
  limits->work = s.work;
  memcpy(place, s.place, sizeof s.place);
  return s.hits > 0;
}

bool sepax_bodies_collide(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                          const sepax_pose *pose_b, const sepax_query *query, sepax_pairs *found,
                          sepax_error *error) {
  sepax_query q;
  search s = {.body = {a, b}, .found = found, .query = &q};
  *found = (sepax_pairs){0};
  if (!sepax__options(&q, sizeof q, query, "sepax_query", error) ||
      !sepax__poses_valid(pose_a, pose_b, error)) {
    return false;
  }
  if (!(q.seconds >= 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a search has a limit of %g seconds; give 0 for none, or more", q.seconds);
  }
  if (sepax__balls_disjoint(a, pose_a, b, pose_b)) {
    return true;
  }
  begin(&s, pose_a, pose_b, q.strict, q.only_any || q.most > 0, q.simd, q.seconds);
  bool whole = descend(&s);
  found->count = s.hits;
  found->ended = s.ended || !whole;
  if (s.no_memory) {
    sepax_pairs_free(found);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the colliding pairs");
  }
  return true;
}
