/* query.c - which triangles of two bodies in their poses collide.
 *
 * Both trees are descended together. A box of one body, turned into the other's coordinates, is
 * tested against the eight children of a node there: along the three axes of the node's boxes and
 * the three of the posed box. Every number of this test is rounded; `slack` covers it. Pairs of
 * triangles whose boxes may meet are posed in doubles and judged several at once; where a sign is
 * not certain, sepax_exact_posed decides on the exact coordinates. */
#include "placement.h"
#include "util/error.h"
#include "util/list.h"
#include "verdict/signs.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#if defined __x86_64__
#include <immintrin.h>
#endif

#define UNROLL _Pragma("GCC unroll 3")

/* A box, or a triangle, in the other's coordinates: half its extents along x, y, z and along three
 * axes of its own, of any length. `along` is where its middle is on them, from the centre. */
typedef struct {
  float centre[3], reach[3];
  float axis[3][3], along[3], own[3];
} posed_box;

/* ------------------------------------------------------------ instruction sets */

#define NAME(x) x##_portable
#define TARGET
#define FLOATS 4
#define LANES 2
#define BITS(v) \
  ((uint32_t)(((v)[0] < 0) | ((v)[1] < 0) << 1 | ((v)[2] < 0) << 2 | ((v)[3] < 0) << 3))
#define REAL_BITS(v) ((uint32_t)((v)[0] >> 63 | (v)[1] >> 63 << 1))
#include "boxes.h"

#if defined __x86_64__
#define NAME(x) x##_avx2
#define TARGET __attribute__((target("avx2")))
#define FLOATS 8
#define LANES 4
#define BITS(v) ((uint32_t)_mm256_movemask_ps((__m256)(v)))
#define REAL_BITS(v) ((uint32_t)_mm256_movemask_pd((__m256d)(v)))
#include "boxes.h"
#endif

/* ------------------------------------------------------------------- the search */

enum { STACK = 512 }; /* 64 levels of either tree, up to 7 children waiting on each */

/* The children in `left` of an opened node, against one box of the other body. */
typedef struct {
  const body_node *node;
  uint32_t left, other; /* other: the child of the other body */
  int open;             /* the body of the node */
  box others;
} opened;

typedef struct {
  const sepax_body *body[2];
  const sepax_query *query;
  bool avx2;
  placement at;
  sepax_pairs *found;
  size_t capacity, hits;
  bool no_memory, ended;
  size_t visits, judged, exact;
} search;

static void record(search *s, uint32_t i, uint32_t j) {
  s->hits++;
  if (s->query->only_any) {
    s->ended = true;
    return;
  }
  s->no_memory =
      !list_add_pair(s->found, &s->capacity, s->body[0]->number[i], s->body[1]->number[j]);
  s->ended = s->no_memory || (s->query->most > 0 && s->hits == s->query->most);
}

/* A's triangles against one of B, posed. */
static void judge(search *s, const uint32_t *list, int count, uint32_t j,
                  const double posed[3][3]) {
  const int lanes = s->avx2 ? 4 : 2;
  double c[72];
  for (int first = 0; first < count && !s->ended; first += lanes) {
    for (int n = 0; n < lanes; n++) {
      const double(*a)[3] = s->body[0]->triangle[list[first + n < count ? first + n : first]];
      for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
          c[(6 * i + k) * lanes + n] = a[k][i];
          c[(6 * i + 3 + k) * lanes + n] = posed[k][i];
        }
      }
    }
    uint32_t uncertain;
    uint32_t hits = s->avx2 ? judge_avx2(c, s->at.error, &uncertain)
                            : judge_portable(c, s->at.error, &uncertain);
    for (int n = 0; n < lanes && first + n < count && !s->ended; n++) {
      uint32_t i = list[first + n];
      bool hit = (hits >> n & 1) != 0;
      s->judged++;
      if ((uncertain >> n & 1) != 0) {
        s->exact++;
        sepax_verdict v = sepax_exact_posed(s->body[0]->triangle[i], s->at.pose[0],
                                            s->body[1]->triangle[j], s->at.pose[1]);
        hit = s->query->strict ? v.strict : v.collision;
      }
      if (hit) {
        record(s, i, j);
      }
    }
  }
}

static void pose_box(const motion *m, const box *b, posed_box *p) {
  for (int i = 0; i < 3; i++) {
    p->centre[i] = m->shift[i];
    p->reach[i] = m->slack;
    p->own[i] = m->slack;
    p->along[i] = 0;
  }
  memcpy(p->axis, m->axis, sizeof p->axis);
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      p->centre[i] += m->axis[k][i] * b->centre[k];
      p->reach[i] += m->size[k][i] * b->half[k];
      p->own[i] += m->gram[i][k] * b->half[k];
    }
  }
}

/* Around a posed triangle: its axes are its normal, its longest edge, and what is normal to both.
 */
static void pose_triangle(const search *s, const double posed[3][3], posed_box *p) {
  const sepax_body *a = s->body[0];
  float v[3][3];
  float slack = s->at.to[0].slack;
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      v[k][i] = (float)((posed[k][i] - a->centre[i]) / a->scale);
    }
    float low = fminf(fminf(v[0][i], v[1][i]), v[2][i]);
    float high = fmaxf(fmaxf(v[0][i], v[1][i]), v[2][i]);
    p->centre[i] = 0.5F * (low + high);
    p->reach[i] = 0.5F * (high - low) + slack;
  }
  float e[3][3];
  int longest = 0;
  float most = -1;
  for (int k = 0; k < 3; k++) {
    float length = 0;
    for (int i = 0; i < 3; i++) {
      e[k][i] = v[next[k]][i] - v[k][i];
      length += e[k][i] * e[k][i];
    }
    longest = length > most ? k : longest;
    most = length > most ? length : most;
  }
  const float *d = e[longest];
  const float *f = e[next[longest]];
  float scale = 1 / sqrtf(most + 1e-30F);
  float n[3];
  float size = 0;
  for (int i = 0; i < 3; i++) {
    n[i] = d[next[i]] * f[next[next[i]]] - d[next[next[i]]] * f[next[i]];
    size += n[i] * n[i];
  }
  float unit = 1 / sqrtf(size + 1e-30F);
  for (int i = 0; i < 3; i++) {
    p->axis[0][i] = n[i] * unit;
    p->axis[1][i] = d[i] * scale;
  }
  for (int i = 0; i < 3; i++) {
    p->axis[2][i] = p->axis[0][next[i]] * p->axis[1][next[next[i]]] -
                    p->axis[0][next[next[i]]] * p->axis[1][next[i]];
  }
  for (int k = 0; k < 3; k++) {
    float low = 0;
    float high = 0;
    for (int j = 0; j < 3; j++) {
      float at = 0;
      for (int i = 0; i < 3; i++) {
        at += p->axis[k][i] * (v[j][i] - p->centre[i]);
      }
      low = j == 0 || at < low ? at : low;
      high = j == 0 || at > high ? at : high;
    }
    p->along[k] = 0.5F * (low + high);
    p->own[k] = 0.5F * (high - low) + 2 * slack;
  }
}

static uint32_t overlaps(const search *s, const body_node *node, const posed_box *p) {
  return s->avx2 ? overlaps_avx2(node, p) : overlaps_portable(node, p);
}

static float size_of(const box *b) { return b->half[0] + b->half[1] + b->half[2]; }

/* All triangles of A below a node against one of B. */
static void judge_below(search *s, uint32_t root, uint32_t j) {
  double posed[3][3];
  posed_box p;
  uint32_t list[64];
  uint32_t stack[STACK] = {root};
  int count = 0;
  int depth = 1;
  place_triangle_b(&s->at, s->body[1]->triangle[j], posed);
  pose_triangle(s, posed, &p);
  while (depth > 0 && !s->ended) {
    const body_node *node = &s->body[0]->node[stack[--depth]];
    s->visits++;
    for (uint32_t mask = overlaps(s, node, &p); mask != 0; mask &= mask - 1) {
      uint32_t child = node->child[__builtin_ctz(mask)];
      if ((child & BODY_TRIANGLE) != 0) {
        list[count++] = child - BODY_TRIANGLE;
      } else {
        stack[depth++] = child;
      }
    }
    if (count > 64 - BODY_WIDE || depth == 0) {
      judge(s, list, count, j, posed);
      count = 0;
    }
  }
}

static void descend(search *s) {
  opened *stack = malloc(STACK * sizeof *stack);
  if (stack == NULL) {
    s->no_memory = true;
    return;
  }
  float ratio = (float)(s->body[1]->scale / s->body[0]->scale);
  const box all = {{0}, {1, 1, 1}};
  posed_box posed;
  int depth = 0;
  stack[0] = (opened){s->body[0]->node, 0, 0, 0, all};
  pose_box(&s->at.to[0], &all, &posed);
  stack[0].left = overlaps(s, stack[0].node, &posed);
  while (depth >= 0 && !s->ended) {
    opened *at = &stack[depth];
    if (at->left == 0) {
      depth--;
      continue;
    }
    int lane = __builtin_ctz(at->left);
    at->left &= at->left - 1;
    box own;
    for (int i = 0; i < 3; i++) {
      own.centre[i] = at->node->centre[i][lane];
      own.half[i] = at->node->half[i][lane];
    }
    uint32_t child[2];
    const box *boxes[2];
    child[at->open] = at->node->child[lane];
    child[!at->open] = at->other;
    boxes[at->open] = &own;
    boxes[!at->open] = &at->others;
    if ((child[1] & BODY_TRIANGLE) != 0) {
      uint32_t j = child[1] - BODY_TRIANGLE;
      if ((child[0] & BODY_TRIANGLE) == 0) {
        judge_below(s, child[0], j);
      } else {
        double vertices[3][3];
        uint32_t i = child[0] - BODY_TRIANGLE;
        place_triangle_b(&s->at, s->body[1]->triangle[j], vertices);
        judge(s, &i, 1, j, vertices);
      }
      continue;
    }
    bool bottom = (child[0] & BODY_TRIANGLE) != 0 ||
                  (s->body[0]->node[child[0]].child[0] & BODY_TRIANGLE) != 0;
    int open = bottom || size_of(boxes[1]) * ratio > size_of(boxes[0]);
    opened *to = &stack[++depth];
    to->open = open;
    to->node = &s->body[open]->node[child[open]];
    to->other = child[!open];
    to->others = *boxes[!open];
    pose_box(&s->at.to[open], &to->others, &posed);
    to->left = overlaps(s, to->node, &posed);
    s->visits++;
  }
  free(stack);
}

bool sepax_bodies_collide(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                          const sepax_pose *pose_b, const sepax_query *query, sepax_pairs *found,
                          sepax_error *error) {
  static const sepax_query usual = {0};
  search s = {.body = {a, b}, .found = found};
  s.query = query != NULL ? query : &usual;
  *found = (sepax_pairs){0};
#if defined __x86_64__
  s.avx2 = s.query->path != SEPAX_PATH_PORTABLE && __builtin_cpu_supports("avx2");
#endif
  place_bodies(&s.at, a, pose_a, b, pose_b);
  descend(&s);
  if (s.query->only_any) {
    found->count = s.hits;
  }
  if (s.no_memory) {
    sepax_pairs_free(found);
    return sepax_fail(error, "no memory for the colliding pairs");
  }
  return true;
}
