/* SPDX-License-Identifier: MIT */
/* filtered.c - the test of Guigue and Devillers on doubles with a bound on each sign, and
 * sepax_exact where a sign is in doubt: never wrong.
 *
 * Differences of coordinates are whole numbers of up to 33 bits, so doubles hold them. Let
 * size = sum of |x| (|y z'| + |z y'|) over the three terms of orient3d. Below 2^53 it is computed
 * without rounding, and so is orient3d, whose partial sums are not greater: its sign is known, also
 * where it is 0. Otherwise, with u = 2^-53, a minor has two products and a difference, each wrong
 * by a factor 1 + u, its product with x one more, and the sum of three terms two more: orient3d is
 * wrong by less than ((1 + u)^5 - 1) size < 6 u size. The size computed is of positive terms by the
 * same number of roundings, so not less than (1 - 6 u) size: a bound of 8 u times the size computed
 * is enough. orient2d is the same with two products and a difference. */
#include "models/guigue.h"
#include "sepax_models.h"

#include <math.h>

typedef struct {
  double v[6][3];
  bool doubt;
} judged_points;

/* The sign of a sum of terms whose magnitudes add up to `size`. If the sign is not certain, then
 * the result is 0 and the pair is in doubt. */
static int certain_sign(judged_points *p, double sum, double size) {
  if (size >= 0x1p53 && !(fabs(sum) > 0x1p-50 * size)) {
    p->doubt = true;
    return 0;
  }
  return (sum > 0) - (sum < 0);
}

static int orient3d(void *points, int p, int q, int r, int s) {
  judged_points *at = points;
  double d[3][3];
  for (int i = 0; i < 3; i++) {
    d[0][i] = at->v[q][i] - at->v[p][i];
    d[1][i] = at->v[r][i] - at->v[p][i];
    d[2][i] = at->v[s][i] - at->v[p][i];
  }
  double sum = 0;
  double size = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    double left = d[0][j] * d[1][k];
    double right = d[0][k] * d[1][j];
    sum += d[2][i] * (left - right);
    size += fabs(d[2][i]) * (fabs(left) + fabs(right));
  }
  return certain_sign(at, sum, size);
}

/* Twice the area of p, q, r in the projection along an axis. */
static int orient2d(judged_points *at, int p, int q, int r, int axis) {
  int i = (axis + 1) % 3;
  int j = (axis + 2) % 3;
  double left = (at->v[q][i] - at->v[p][i]) * (at->v[r][j] - at->v[p][j]);
  double right = (at->v[q][j] - at->v[p][j]) * (at->v[r][i] - at->v[p][i]);
  return certain_sign(at, left - right, fabs(left) + fabs(right));
}

/* The test if all vertices are in one plane. If both triangles have an area, then some projection
 * shows both areas, and the triangles are separated if and only if some edge has the other triangle
 * beyond it. Otherwise the pair is in doubt. */
static bool coplanar(void *points) {
  judged_points *at = points;
  int axis = 0;
  int own[2] = {0, 0};
  while (axis < 3 && (own[0] == 0 || own[1] == 0)) {
    own[0] = orient2d(at, 0, 1, 2, axis);
    own[1] = orient2d(at, 3, 4, 5, axis);
    axis++;
  }
  if (own[0] == 0 || own[1] == 0) {
    at->doubt = true;
    return true;
  }
  for (int i = 0; i < 6; i++) {
    int first = i - i % 3;
    bool beyond = true;
    for (int k = 0; k < 3 && beyond; k++) {
      beyond = orient2d(at, i, first + (i + 1) % 3, 3 - first + k, axis - 1) == -own[first / 3];
    }
    if (beyond) {
      return false;
    }
  }
  return true;
}

bool sepax_filtered(const sepax_tri *a, const sepax_tri *b, bool *settled) {
  judged_points p;
  p.doubt = false;
  for (int i = 0; i < 6; i++) {
    const sepax_vec *v = i < 3 ? &a->v[i] : &b->v[i - 3];
    p.v[i][0] = v->x;
    p.v[i][1] = v->y;
    p.v[i][2] = v->z;
  }
  bool collision = guigue_collide(&p, orient3d, coplanar);
  if (settled != NULL) {
    *settled = !p.doubt;
  }
  return p.doubt ? sepax_exact(a, b).collision : collision;
}
