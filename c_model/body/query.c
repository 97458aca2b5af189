/* query.c - which triangles of two bodies in their poses collide.
 *
 * Both trees are descended together. A box of one body, turned into the other's coordinates, is
 * tested against the eight children of a node there: along the three axes of the node's boxes and
 * the three of the posed box. Every number of this test is rounded; `slack` covers it. Pairs of
 * triangles whose boxes may meet are posed in doubles and judged several at once; where a sign is
 * not certain, sepax_exact_posed decides on the exact coordinates. */
#include "body.h"
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

/* From the coordinates of one tree to those of the other: v -> sum of axis[k] v_k + shift. */
typedef struct {
  float axis[3][3], size[3][3]; /* size: |axis| */
  float gram[3][3];             /* |axis[k] . axis[j]| */
  float shift[3];
  float slack;
} motion;

typedef struct {
  float centre[3], half[3];
} box;

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
  const sepax_pose *pose[2];
  const sepax_query *query;
  bool avx2;
  motion to[2];        /* to[0]: B's boxes into A's coordinates; to[1]: A's into B's */
  double linear[3][3]; /* B's triangles into A's file coordinates */
  double offset[3];
  double error; /* of each coordinate then */
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
    uint32_t hits =
        s->avx2 ? judge_avx2(c, s->error, &uncertain) : judge_portable(c, s->error, &uncertain);
    for (int n = 0; n < lanes && first + n < count && !s->ended; n++) {
      uint32_t i = list[first + n];
      bool hit = (hits >> n & 1) != 0;
      s->judged++;
      if ((uncertain >> n & 1) != 0) {
        s->exact++;
        hit = sepax_exact_posed(s->body[0]->triangle[i], s->pose[0], s->body[1]->triangle[j],
                                s->pose[1])
                  .collision;
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

/* The vertices of B's triangle j in A's file coordinates. */
static void pose_vertices(const search *s, uint32_t j, double posed[3][3]) {
  const double(*b)[3] = s->body[1]->triangle[j];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      posed[k][i] = s->linear[i][0] * b[k][0] + s->linear[i][1] * b[k][1] +
                    s->linear[i][2] * b[k][2] + s->offset[i];
    }
  }
}

/* Around a posed triangle: its axes are its normal, its longest edge, and what is normal to both.
 */
static void pose_triangle(const search *s, const double posed[3][3], posed_box *p) {
  const sepax_body *a = s->body[0];
  float v[3][3];
  float slack = s->to[0].slack;
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
  pose_vertices(s, j, posed);
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
  pose_box(&s->to[0], &all, &posed);
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
        pose_vertices(s, j, vertices);
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
    pose_box(&s->to[open], &to->others, &posed);
    to->left = overlaps(s, to->node, &posed);
    s->visits++;
  }
  free(stack);
}

/* ---------------------------------------------------------------------- the poses */

static const sepax_pose unmoved = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static void transpose_adjugate(const double m[3][3], double r[3][3]) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      int i1 = next[i];
      int i2 = next[i1];
      int j1 = next[j];
      int j2 = next[j1];
      r[j][i] = m[i1][j1] * m[i2][j2] - m[i1][j2] * m[i2][j1];
    }
  }
}

/* The inverse of a matrix that is nearly a rotation. */
static void invert(const double m[3][3], double r[3][3]) {
  transpose_adjugate(m, r);
  double determinant = m[0][0] * r[0][0] + m[0][1] * r[1][0] + m[0][2] * r[2][0];
  for (int k = 0; k < 9; k++) {
    r[k / 3][k % 3] /= determinant;
  }
}

static void multiply(const double p[3][3], const double q[3][3], double r[3][3]) {
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      r[i][j] = p[i][0] * q[0][j] + p[i][1] * q[1][j] + p[i][2] * q[2][j];
    }
  }
}

/* From B's tree to A's, with linear part and offset in file units.
 *
 * In units of A's scale all numbers of a test are sums of up to 7 terms that are below
 * S = (1 + ratio)(2 + far + 4 ratio), each rounded to 24 bits at most 8 times: below 2^-18 S in
 * all. The doubles before round by less than 2^-44 of the largest offset and centre. */
static void find_motion(motion *m, const sepax_body *a, const sepax_body *b,
                        const double linear[3][3], const double offset[3]) {
  double ratio = b->scale / a->scale;
  double far = 0;
  for (int i = 0; i < 3; i++) {
    double shift = offset[i] - a->centre[i];
    for (int k = 0; k < 3; k++) {
      shift += linear[i][k] * b->centre[k];
      m->axis[k][i] = (float)(linear[i][k] * ratio);
      m->size[k][i] = fabsf(m->axis[k][i]);
    }
    shift /= a->scale;
    m->shift[i] = (float)shift;
    far = fmax(far, fabs(shift));
  }
  for (int j = 0; j < 3; j++) {
    for (int k = 0; k < 3; k++) {
      m->gram[j][k] = fabsf(m->axis[j][0] * m->axis[k][0] + m->axis[j][1] * m->axis[k][1] +
                            m->axis[j][2] * m->axis[k][2]);
    }
  }
  double lost = 0; /* by rounding of the doubles above, in units of A's scale */
  for (int i = 0; i < 3; i++) {
    lost = fmax(lost, fabs(offset[i]) + fabs(a->centre[i]) + 4 * fabs(b->centre[i]));
  }
  m->slack = (float)(0x1p-18 * (1 + ratio) * (2 + far + 4 * ratio) +
                     0x1p-44 * (1 + ratio) * lost / a->scale);
}

static double largest(const sepax_body *b) {
  double most = 0;
  for (int i = 0; i < 3; i++) {
    most = fmax(most, fabs(b->centre[i]));
  }
  return most + b->scale;
}

static void find_motions(search *s) {
  const sepax_pose *pa = s->pose[0] != NULL ? s->pose[0] : &unmoved;
  const sepax_pose *pb = s->pose[1] != NULL ? s->pose[1] : &unmoved;
  double inverse[3][3];
  double back[3][3];
  double offset[3];
  invert(pa->rotation, inverse);
  if (s->pose[0] == NULL) {
    memcpy(inverse, unmoved.rotation, sizeof inverse);
  }
  multiply(inverse, pb->rotation, s->linear);
  double away = 0;
  for (int i = 0; i < 3; i++) {
    s->offset[i] = 0;
    for (int k = 0; k < 3; k++) {
      s->offset[i] += inverse[i][k] * (pb->translation[k] - pa->translation[k]);
      away = fmax(away, fabs(pb->translation[k]) + fabs(pa->translation[k]));
    }
  }
  /* Up to 32 roundings of terms that are at most 4 times the largest number. */
  s->error = 0x1p-53 * 128 * (largest(s->body[1]) + away);
  if (s->pose[0] == NULL && s->pose[1] == NULL) {
    s->error = 0;
  }
  invert(s->linear, back);
  for (int i = 0; i < 3; i++) {
    offset[i] = 0;
    for (int k = 0; k < 3; k++) {
      offset[i] -= back[i][k] * s->offset[k];
    }
  }
  find_motion(&s->to[0], s->body[0], s->body[1], s->linear, s->offset);
  find_motion(&s->to[1], s->body[1], s->body[0], back, offset);
}

bool sepax_bodies_collide(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                          const sepax_pose *pose_b, const sepax_query *query, sepax_pairs *found,
                          sepax_error *error) {
  static const sepax_query usual = {0};
  search s = {.body = {a, b}, .pose = {pose_a, pose_b}, .found = found};
  s.query = query != NULL ? query : &usual;
  *found = (sepax_pairs){0};
#if defined __x86_64__
  s.avx2 = s.query->path != SEPAX_PATH_PORTABLE && __builtin_cpu_supports("avx2");
#endif
  find_motions(&s);
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
