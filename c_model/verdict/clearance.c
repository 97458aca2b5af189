/* clearance.c - the safe side: is a pair provably farther apart than D LSB, although its
 * coordinates were rounded to LSB? docs/clearance.md has the proof.
 *
 * On an axis c the triangles have a gap; the real ones are farther apart than D if
 *   2 gap > (2 + D) |c|_1 + D |c|_inf
 * The axes are x, y, z, N_A, N_B, the nine e_i x f_j, and for each edge its cross products
 * with x, y, z; an axis of edges counts only where those edges are the near ends.
 *
 * Widths at W = 32: axes 67 bits, projections 101, limits 100. */
#include "sepax_design.h"

enum { AXIS_NORMAL_A = 10, AXIS_NORMAL_B = 11, AXIS_OF_EDGE = 12 };

typedef __int128 wide;

typedef struct {
  wide c[3];
} vec;

typedef struct {
  const sepax_design *design;
  vec p[2][3], edge[2][3]; /* of A, of B; from A_1 */
  int reached;             /* limits that some axis so far has proved */
  int axis;                /* the first that proved as many */
} search;

static vec difference(const vec *p, const vec *q) {
  return (vec){{p->c[0] - q->c[0], p->c[1] - q->c[1], p->c[2] - q->c[2]}};
}

static vec cross(const vec *p, const vec *q) {
  return (vec){{p->c[1] * q->c[2] - p->c[2] * q->c[1], p->c[2] * q->c[0] - p->c[0] * q->c[2],
                p->c[0] * q->c[1] - p->c[1] * q->c[0]}};
}

static wide dot(const vec *p, const vec *q) {
  return p->c[0] * q->c[0] + p->c[1] * q->c[1] + p->c[2] * q->c[2];
}

static vec unit(int axis) { return (vec){{axis == 0, axis == 1, axis == 2}}; }

static wide magnitude(wide x) { return x < 0 ? -x : x; }

/* How many limits a gap on axis c exceeds. */
static int limits_exceeded(const sepax_design *design, const vec *c, wide gap) {
  wide sum = 0;
  wide most = 0;
  for (int i = 0; i < 3; i++) {
    wide size = magnitude(c->c[i]);
    sum += size;
    most = size > most ? size : most;
  }
  int count = 0;
  while (count < design->limits) {
    wide d = design->margin[count] - 1;
    if (2 * gap <= (2 + d) * sum + d * most) {
      break;
    }
    count++;
  }
  return count;
}

/* Vertices near[0] of A and near[1] of B are to be the near ends; -1: whichever are. The gap is
 * that of A below B, where `sign` is 1, or B below A, where it is -1; <= 0 where there is none. */
static wide gap_between(const search *s, const vec *c, const int near[2], int sign) {
  wide end[2]; /* the highest of A, the lowest of B */
  for (int t = 0; t < 2; t++) {
    int toward = t == 0 ? sign : -sign;
    wide at[3];
    wide most = 0;
    for (int k = 0; k < 3; k++) {
      at[k] = toward * dot(c, &s->p[t][k]);
      most = k == 0 || at[k] > most ? at[k] : most;
    }
    if (near[t] >= 0 && at[near[t]] < most) {
      return 0;
    }
    end[t] = most;
  }
  return -end[1] - end[0];
}

static void try_axis(search *s, int axis, const vec *c, int near_a, int near_b) {
  const int near[2] = {near_a, near_b};
  for (int sign = -1; sign <= 1; sign += 2) {
    int count = limits_exceeded(s->design, c, gap_between(s, c, near, sign));
    if (count > s->reached) {
      s->reached = count;
      s->axis = axis;
    }
  }
}

static void load(search *s, const sepax_tri *a, const sepax_tri *b) {
  for (int i = 0; i < 6; i++) {
    sepax_vec v = i < 3 ? a->v[i] : b->v[i - 3];
    s->p[i / 3][i % 3] =
        (vec){{(wide)v.x - a->v[0].x, (wide)v.y - a->v[0].y, (wide)v.z - a->v[0].z}};
  }
  for (int i = 0; i < 6; i++) {
    s->edge[i / 3][i % 3] = difference(&s->p[i / 3][(i + 1) % 3], &s->p[i / 3][i % 3]);
  }
}

static void try_all(search *s) {
  for (int i = 0; i < 3; i++) {
    vec c = unit(i);
    try_axis(s, SEPAX_AXIS_AABB, &c, -1, -1);
  }
  for (int t = 0; t < 2; t++) {
    vec c = cross(&s->edge[t][0], &s->edge[t][1]);
    try_axis(s, t == 0 ? AXIS_NORMAL_A : AXIS_NORMAL_B, &c, -1, -1);
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      vec c = cross(&s->edge[0][i], &s->edge[1][j]);
      try_axis(s, 1 + 3 * i + j, &c, i, j);
    }
  }
  for (int i = 0; i < 18; i++) {
    vec z = unit(i % 3);
    vec c = cross(&s->edge[i / 9][i / 3 % 3], &z);
    try_axis(s, AXIS_OF_EDGE, &c, i < 9 ? i / 3 : -1, i < 9 ? -1 : i / 3 - 3);
  }
}

sepax_verdict sepax_clearance(const sepax_design *design, const sepax_tri *a, const sepax_tri *b) {
  search s = {.design = design};
  load(&s, a, b);
  try_all(&s);
  sepax_band band = s.reached == design->limits ? SEPAX_BAND_FREE
                    : s.reached > 0             ? SEPAX_BAND_WARNING
                                                : SEPAX_BAND_COLLISION;
  return (sepax_verdict){.collision = band == SEPAX_BAND_COLLISION,
                         .coplanar = sepax_exact(a, b).coplanar,
                         .axis = s.axis,
                         .band = band};
}
