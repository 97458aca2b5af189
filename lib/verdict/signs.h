/* SPDX-License-Identifier: MIT */
/* signs.h - from the signs of orient3d and orient2d to the axis that separates two triangles
 * (private). exact.c has the formulas. */
#ifndef SEPAX_SIGNS_H
#define SEPAX_SIGNS_H

#include "sepax_grid.h"

static const int next[3] = {1, 2, 0};

/* Signs of orient3d, all negated in common: of N_A.(B_k - A_0), of N_B.(A_k - B_0) and of
 * (e_i x f_j).(B_j - A_i), where e_i is the edge from A_i to A_i+1, f_j that from B_j to B_j+1. */
typedef struct {
  int s[3], w[3], d[3][3];
} orient3d_signs;

/* Signs of orient2d, as in exact_sums.h. */
typedef struct {
  int own_a, own_b, a[3][3], b[3][3];
} orient2d_signs;

static inline bool zeros(const int sign[3]) { return (sign[0] | sign[1] | sign[2]) == 0; }

static inline bool zero_matrix(const int sign[3][3]) {
  return zeros(sign[0]) && zeros(sign[1]) && zeros(sign[2]);
}

static inline bool all_zero_3d(const orient3d_signs *v) {
  return zeros(v->s) && zeros(v->w) && zero_matrix(v->d);
}

static inline bool all_zero_2d(const orient2d_signs *s) {
  return s->own_a == 0 && s->own_b == 0 && zero_matrix(s->a) && zero_matrix(s->b);
}

static inline bool one_side(const int sign[3]) {
  return sign[0] != 0 && sign[0] == sign[1] && sign[0] == sign[2];
}

/* Axis e_i x f_j separates: f_j crosses A's plane upwards, e_i crosses B's plane, and B is on the
 * outer side of A's edge; or all three the other way round. */
static inline bool edges_separate(const orient3d_signs *v, int i, int j) {
  int d = v->d[i][j];
  return d != 0 && d * v->s[j] <= 0 && d * v->s[next[j]] >= 0 && d * v->w[i] <= 0 &&
         d * v->w[next[i]] >= 0;
}

static inline bool both_sides(const int sign[3]) {
  bool above = sign[0] > 0 || sign[1] > 0 || sign[2] > 0;
  return above && (sign[0] < 0 || sign[1] < 0 || sign[2] < 0);
}

/* edges_separate, but that the edges may meet. Of triangles on both sides of each other's planes,
 * so that no edge is in the other's plane. */
static inline bool edges_separate_weakly(const orient3d_signs *v, int i, int j) {
  const int from_b = v->s[j];
  const int to_b = v->s[next[j]];
  const int from_a = v->w[i];
  const int to_a = v->w[next[i]];
  return (from_a <= 0 && to_a >= 0 && from_b <= 0 && to_b >= 0 && v->d[i][j] >= 0) ||
         (from_a >= 0 && to_a <= 0 && from_b >= 0 && to_b <= 0 && v->d[i][j] <= 0);
}

/* The triangles have an area, are not in one plane, and their interiors share a point. Each then
 * has vertices on both sides of the other's plane and meets the line of both planes in a segment.
 * The segments share more than an end unless an edge of A and one of B, at facing ends, separate
 * them or meet. */
static inline bool strict_in_space(const orient3d_signs *v) {
  if (!both_sides(v->s) || !both_sides(v->w)) {
    return false;
  }
  for (int k = 0; k < 9; k++) {
    if (edges_separate_weakly(v, k / 3, k % 3)) {
      return false;
    }
  }
  return true;
}

static inline int axis_in_space(const orient3d_signs *v) {
  if (one_side(v->s)) {
    return SEPAX_AXIS_NORMAL_A;
  }
  if (one_side(v->w)) {
    return SEPAX_AXIS_NORMAL_B;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      if (edges_separate(v, i, j)) {
        return SEPAX_AXIS_EDGES + 3 * i + j;
      }
    }
  }
  return SEPAX_AXIS_NONE;
}

/* The verdict where not all orient3d are zero. */
static inline sepax_verdict judged_in_space(const orient3d_signs *v) {
  int axis = axis_in_space(v);
  bool collision = axis == SEPAX_AXIS_NONE;
  return (sepax_verdict){
      .collision = collision, .strict = collision && strict_in_space(v), .axis = axis};
}

static inline sepax_verdict judged_in_plane(bool separated) {
  return (sepax_verdict){.collision = !separated,
                         .coplanar = true,
                         .axis = separated ? SEPAX_AXIS_PLANE : SEPAX_AXIS_NONE};
}

/* The other triangle is strictly on one side of some edge, and the third vertex of the edge's own
 * triangle is not on this side. */
static inline bool edge_separates(const orient2d_signs *s) {
  for (int i = 0; i < 3; i++) {
    if ((one_side(s->a[i]) && s->a[i][0] != s->own_a) ||
        (one_side(s->b[i]) && s->b[i][0] != s->own_b)) {
      return true;
    }
  }
  return false;
}

#endif
