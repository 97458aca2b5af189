/* SPDX-License-Identifier: MIT */
/* sat54.c - the exact verdict by the separating axis theorem written out, 54 products: a second
 * model of architecture exact, which shares no decision with exact.c.
 *
 * Origin at A_1, so A is 0, a_2, a_3. With N = a_2 x a_3, M_j = b_j x b_j+1,
 * P_j = a_2.M_j and Q_j = a_3.M_j, all projections of both triangles on N, N_B and the
 * nine e_i x f_j are sums of these. No axis e_i x f_j is ever formed. */
#include "sepax_models.h"
#include "util/wide.h"

static wide least(wide p, wide q) { return p < q ? p : q; }

static wide most(wide p, wide q) { return p > q ? p : q; }

/* Projections. s: B's vertices on N. u and v: A's vertices and B on N_B; w = u - v. d[i][j]: the
 * position of A_i on e_i x f_j, relative to B_j. */
typedef struct {
  wide s[3], u[3], w[3], d[3][3];
} projections;

static projections project(const wide_vec a[3], const wide_vec b[3]) {
  projections r;
  wide p[3];
  wide q[3];
  wide_vec n = wide_cross(a[1], a[2]);
  wide_vec m[3];
  for (int j = 0; j < 3; j++) {
    m[j] = wide_cross(b[j], b[(j + 1) % 3]);
    p[j] = wide_dot(a[1], m[j]);
    q[j] = wide_dot(a[2], m[j]);
    r.s[j] = wide_dot(n, b[j]);
  }
  wide v = wide_dot(m[1], b[0]);
  r.u[0] = 0;
  r.u[1] = p[0] + p[1] + p[2];
  r.u[2] = q[0] + q[1] + q[2];
  for (int j = 0; j < 3; j++) {
    r.w[j] = r.u[j] - v;
    r.d[0][j] = -p[j];
    r.d[1][j] = p[j] - q[j] - (r.s[(j + 1) % 3] - r.s[j]);
    r.d[2][j] = q[j];
  }
  return r;
}

static bool all_zero(const projections *r) {
  for (int i = 0; i < 3; i++) {
    if (r->s[i] != 0 || r->w[i] != 0 || r->d[i][0] != 0 || r->d[i][1] != 0 || r->d[i][2] != 0) {
      return false;
    }
  }
  return true;
}

static bool one_side(const wide v[3]) {
  return (v[0] > 0 && v[1] > 0 && v[2] > 0) || (v[0] < 0 && v[1] < 0 && v[2] < 0);
}

static bool separated_in_space(const projections *r) {
  if (one_side(r->s) || one_side(r->w)) {
    return true;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      wide across_b = r->s[j] - r->s[(j + 1) % 3];
      wide across_a = r->u[(i + 1) % 3] - r->u[i];
      if (least(0, across_b) > r->d[i][j] + most(0, across_a) ||
          most(0, across_b) < r->d[i][j] + least(0, across_a)) {
        return true;
      }
    }
  }
  return false;
}

/* For coplanar or degenerate triangles: try each edge's normal and each axis of the three
 * coordinate planes, on the original vertices. */
static bool axis_separates(wide_vec axis, const wide_vec a[3], const wide_vec b[3]) {
  wide low[2];
  wide high[2];
  for (int t = 0; t < 2; t++) {
    const wide_vec *p = t == 0 ? a : b;
    low[t] = least(wide_dot(axis, p[0]), least(wide_dot(axis, p[1]), wide_dot(axis, p[2])));
    high[t] = most(wide_dot(axis, p[0]), most(wide_dot(axis, p[1]), wide_dot(axis, p[2])));
  }
  return high[0] < low[1] || high[1] < low[0];
}

static bool separated_in_plane(const wide_vec a[3], const wide_vec b[3]) {
  static const wide_vec unit[3] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  for (int c = 0; c < 3; c++) {
    if (axis_separates(unit[c], a, b)) {
      return true;
    }
    for (int i = 0; i < 6; i++) {
      const wide_vec *p = i < 3 ? a : b;
      wide_vec edge = wide_sub(p[(i + 1) % 3], p[i % 3]);
      if (axis_separates(wide_cross(unit[c], edge), a, b)) {
        return true;
      }
    }
  }
  return false;
}

bool sepax_sat54(const sepax_tri *a, const sepax_tri *b) {
  wide_vec origin = wide_from(a->v[0]);
  wide_vec p[3];
  wide_vec q[3];
  for (int k = 0; k < 3; k++) {
    p[k] = wide_sub(wide_from(a->v[k]), origin);
    q[k] = wide_sub(wide_from(b->v[k]), origin);
  }
  projections r = project(p, q);
  return all_zero(&r) ? !separated_in_plane(p, q) : !separated_in_space(&r);
}
