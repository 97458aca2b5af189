/* clearance.c - conservative clearance: is the distance of a pair provably above D LSB, although
 * its coordinates were rounded to LSB? docs/clearance.md has the proof.
 *
 * The integer triangles have a gap on an axis c. The real triangles have a distance above D if
 *   2 gap > (2 + D) |c|_1 + D |c|_inf
 * The axes are x, y, z, N_A, N_B, the nine e_i x f_j, and the cross products of each edge with x,
 * y, z; an axis of edges counts only where these edges are the near ends of their triangles.
 *
 * Widths at W = 32: axes 67 bits, projections 101, limits 100. */
#include "sepax_design.h"
#include "util/wide.h"

typedef struct {
  const sepax_design *design;
  wide_vec p[2][3], edge[2][3]; /* of A, of B; from A_1 */
  int reached;                  /* limits that some axis so far has proved */
  int axis;                     /* the first that proved as many */
} search;

static wide_vec unit(int axis) { return (wide_vec){{axis == 0, axis == 1, axis == 2}}; }

/* How many limits a gap on axis c exceeds. */
static int limits_exceeded(const sepax_design *design, const wide_vec *c, wide gap) {
  wide sum = 0;
  wide most = 0;
  for (int i = 0; i < 3; i++) {
    wide size = wide_magnitude(c->c[i]);
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

/* The gap of A below B where `sign` is 1, of B below A where it is -1; <= 0 where there is none.
 * Vertices near[0] of A and near[1] of B must be the near ends; -1 allows any. */
static wide gap_between(const search *s, const wide_vec *c, const int near[2], int sign) {
  wide end[2]; /* the highest of A, the lowest of B, for sign 1 */
  for (int t = 0; t < 2; t++) {
    int toward = t == 0 ? sign : -sign;
    wide at[3];
    wide most = 0;
    for (int k = 0; k < 3; k++) {
      at[k] = toward * wide_dot(*c, s->p[t][k]);
      most = k == 0 || at[k] > most ? at[k] : most;
    }
    if (near[t] >= 0 && at[near[t]] < most) {
      return 0;
    }
    end[t] = most;
  }
  return -end[1] - end[0];
}

static void try_axis(search *s, int axis, const wide_vec *c, int near_a, int near_b) {
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
