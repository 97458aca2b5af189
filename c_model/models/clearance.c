/* SPDX-License-Identifier: MIT */
/* clearance.c - conservative clearance: is the distance of a pair provably above D LSB, although
 * its coordinates were rounded to LSB? docs/reference/clearance.md has the proof.
 *
 * The integer triangles have a gap on an axis c. The real triangles have a distance above D if
 *   2 gap > (2 + D) |c|_1 + D |c|_inf                     as the hardware judges, or if
 *   gap > |c|_1 and (gap - |c|_1)^2 > D^2 |c|_2^2          the tight rule, which bounds no length.
 * The axes are x, y, z, N_A, N_B, the nine e_i x f_j, and the cross products of each edge with x,
 * y, z; an axis of edges counts only where these edges are the near ends of their triangles.
 *
 * Widths at W = 32: axes 67 bits, projections 101, limits 100; squares of the tight rule 204. */
#include "sepax_design.h"
#include "util/wide.h"

typedef struct {
  const sepax_design *design;
  bool tight;
  wide_vec p[2][3], edge[2][3]; /* p[0] of A, p[1] of B, relative to A_1 */
  int reached;                  /* number of limits that the axes so far have proved */
  int axis;                     /* the first axis that proved that number */
} search;

static wide_vec unit(int axis) { return (wide_vec){{axis == 0, axis == 1, axis == 2}}; }

/* A number of 256 bits, the lowest 64 first. */
typedef struct {
  uint64_t word[4];
} square;

/* Add x^2 to *sum; |x| < 2^126. */
static void add_square(square *sum, wide x) {
  typedef unsigned __int128 unsigned_wide;
  unsigned_wide size = (unsigned_wide)wide_magnitude(x);
  unsigned_wide low = (uint64_t)size;
  unsigned_wide high = size >> 64;
  unsigned_wide middle = 2 * low * high; /* < 2^127 */
  unsigned_wide word[4] = {(uint64_t)(low * low), (low * low >> 64) + (uint64_t)middle,
                           (uint64_t)(high * high) + (middle >> 64), high * high >> 64};
  unsigned_wide carry = 0;
  for (int i = 0; i < 4; i++) {
    carry += word[i] + sum->word[i];
    sum->word[i] = (uint64_t)carry;
    carry >>= 64;
  }
}

static bool is_greater(const square *p, const square *q) {
  for (int i = 3; i >= 0; i--) {
    if (p->word[i] != q->word[i]) {
      return p->word[i] > q->word[i];
    }
  }
  return false;
}

/* True if gap > sum + d |c|_2, where sum is |c|_1. */
static bool exceeds_length(const wide_vec *c, wide sum, wide d, wide gap) {
  square left = {{0}};
  square right = {{0}};
  if (gap <= sum) {
    return false;
  }
  add_square(&left, gap - sum);
  for (int i = 0; i < 3; i++) {
    add_square(&right, d * c->c[i]);
  }
  return is_greater(&left, &right);
}

/* The number of limits that a gap on axis c exceeds. */
static int limits_exceeded(const search *s, const wide_vec *c, wide gap) {
  wide sum = 0;
  wide most = 0;
  for (int i = 0; i < 3; i++) {
    wide size = wide_magnitude(c->c[i]);
    sum += size;
    most = size > most ? size : most;
  }
  int count = 0;
  while (count < s->design->limits) {
    wide d = s->design->margin[count] - 1;
    if (s->tight ? !exceeds_length(c, sum, d, gap) : 2 * gap <= (2 + d) * sum + d * most) {
      break;
    }
    count++;
  }
  return count;
}

/* The gap between A and B on an axis: of A below B if `sign` is 1, of B below A if it is -1. The
 * gap is <= 0 if the projections overlap. It counts only if vertex near[0] of A and vertex near[1]
 * of B are the near ends; -1 allows any vertex, and so does the tight rule. */
static wide gap_between(const search *s, const wide_vec *c, const int near[2], int sign) {
  wide end[2]; /* for sign 1: the highest of A, the lowest of B */
  for (int t = 0; t < 2; t++) {
    int toward = t == 0 ? sign : -sign;
    wide at[3];
    wide most = 0;
    for (int k = 0; k < 3; k++) {
      at[k] = toward * wide_dot(*c, s->p[t][k]);
      most = k == 0 || at[k] > most ? at[k] : most;
    }
    if (!s->tight && near[t] >= 0 && at[near[t]] < most) {
      return 0;
    }
    end[t] = most;
  }
  return -end[1] - end[0];
}

static void try_axis(search *s, int axis, const wide_vec *c, int near_a, int near_b) {
  const int near[2] = {near_a, near_b};
  for (int sign = -1; sign <= 1; sign += 2) {
    int count = limits_exceeded(s, c, gap_between(s, c, near, sign));
    if (count > s->reached) {
      s->reached = count;
      s->axis = axis;
    }
  }
}

static void load(search *s, const sepax_tri *a, const sepax_tri *b) {
  for (int i = 0; i < 6; i++) {
    sepax_vec v = i < 3 ? a->v[i] : b->v[i - 3];
    s->p[i / 3][i % 3] = wide_sub(wide_from(v), wide_from(a->v[0]));
  }
  for (int i = 0; i < 6; i++) {
    s->edge[i / 3][i % 3] = wide_sub(s->p[i / 3][(i + 1) % 3], s->p[i / 3][i % 3]);
  }
}

static void try_all(search *s) {
  for (int i = 0; i < 3; i++) {
    wide_vec c = unit(i);
    try_axis(s, SEPAX_AXIS_AABB, &c, -1, -1);
  }
  for (int t = 0; t < 2; t++) {
    wide_vec c = wide_cross(s->edge[t][0], s->edge[t][1]);
    try_axis(s, t == 0 ? SEPAX_AXIS_NORMAL_A : SEPAX_AXIS_NORMAL_B, &c, -1, -1);
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      wide_vec c = wide_cross(s->edge[0][i], s->edge[1][j]);
      try_axis(s, SEPAX_AXIS_EDGES + 3 * i + j, &c, i, j);
    }
  }
  for (int i = 0; i < 18; i++) {
    wide_vec z = unit(i % 3);
    wide_vec c = wide_cross(s->edge[i / 9][i / 3 % 3], z);
    try_axis(s, SEPAX_AXIS_PLANE, &c, i < 9 ? i / 3 : -1, i < 9 ? -1 : i / 3 - 3);
  }
}

static sepax_judgement judge(const sepax_design *design, bool tight, const sepax_tri *a,
                             const sepax_tri *b) {
  search s = {.design = design, .tight = tight};
  load(&s, a, b);
  try_all(&s);
  sepax_band band = s.reached == design->limits ? SEPAX_BAND_FREE
                    : s.reached > 0             ? SEPAX_BAND_WARNING
                                                : SEPAX_BAND_COLLISION;
  return (sepax_judgement){.collision = band == SEPAX_BAND_COLLISION,
                           .coplanar = sepax_exact(a, b).coplanar,
                           .axis = s.axis,
                           .band = band};
}

sepax_judgement sepax_clearance(const sepax_design *design, const sepax_tri *a,
                                const sepax_tri *b) {
  return judge(design, false, a, b);
}

sepax_judgement sepax_clearance_tight(const sepax_design *design, const sepax_tri *a,
                                      const sepax_tri *b) {
  return judge(design, true, a, b);
}

static bool is_near(void *design, const sepax_tri *a, const sepax_tri *b) {
  return sepax_clearance(design, a, b).band != SEPAX_BAND_FREE;
}

static bool is_near_tight(void *design, const sepax_tri *a, const sepax_tri *b) {
  return sepax_clearance_tight(design, a, b).band != SEPAX_BAND_FREE;
}

bool sepax_near_pairs(const sepax_design *design, bool tight, const sepax_tri *a, size_t count_a,
                      const sepax_tri *b, size_t count_b, const sepax_search *how,
                      sepax_pairs *found, sepax_error *error) {
  sepax_design d = *design;
  return sepax_judged_pairs(a, count_a, b, count_b, d.margin[1], tight ? is_near_tight : is_near,
                            &d, how, found, error);
}
