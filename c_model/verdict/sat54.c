/* sat54.c - the exact verdict by the separating axis theorem written out, 54 products:
 * a second model of architecture exact, which shares nothing with exact.c.
 *
 * Origin at A_1, so A is 0, a_2, a_3. With N = a_2 x a_3, M_j = b_j x b_j+1,
 * P_j = a_2.M_j and Q_j = a_3.M_j, all projections of both triangles on N, N_B and the
 * nine e_i x f_j are sums of these. No axis e_i x f_j is ever formed. */
#include "sepax.h"

typedef __int128 wide;

typedef struct {
  wide x, y, z;
} wide_vec;

static wide_vec relative(sepax_vec v, sepax_vec origin) {
  return (wide_vec){(wide)v.x - origin.x, (wide)v.y - origin.y, (wide)v.z - origin.z};
}

static wide_vec cross(wide_vec p, wide_vec q) {
  return (wide_vec){p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

static wide dot(wide_vec p, wide_vec q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

static wide least(wide p, wide q) { return p < q ? p : q; }

static wide most(wide p, wide q) { return p > q ? p : q; }

/* s: B's vertices on N. u: A's vertices on N_B, v: B on N_B, w = u - v. d[i][j]: where
 * A_i lies on e_i x f_j, seen from B_j. */
typedef struct {
  wide s[3], u[3], w[3], d[3][3];
} projections;

static projections project(const wide_vec a[3], const wide_vec b[3]) {
  projections r;
  wide p[3];
  wide q[3];
  wide_vec n = cross(a[1], a[2]);
  wide_vec m[3];
  for (int j = 0; j < 3; j++) {
    m[j] = cross(b[j], b[(j + 1) % 3]);
    p[j] = dot(a[1], m[j]);
    q[j] = dot(a[2], m[j]);
    r.s[j] = dot(n, b[j]);
  }
  wide v = dot(m[1], b[0]);
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

/* Coplanar or degenerate: each edge's normal and each axis of the three coordinate
 * planes, on the vertices as they are. */
static bool axis_separates(wide_vec axis, const wide_vec a[3], const wide_vec b[3]) {
  wide low[2];
  wide high[2];
  for (int t = 0; t < 2; t++) {
    const wide_vec *p = t == 0 ? a : b;
    low[t] = least(dot(axis, p[0]), least(dot(axis, p[1]), dot(axis, p[2])));
    high[t] = most(dot(axis, p[0]), most(dot(axis, p[1]), dot(axis, p[2])));
  }
  return high[0] < low[1] || high[1] < low[0];
}

static bool separated_in_plane(const wide_vec a[3], const wide_vec b[3]) {
  static const wide_vec unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int c = 0; c < 3; c++) {
    if (axis_separates(unit[c], a, b)) {
      return true;
    }
    for (int i = 0; i < 6; i++) {
      const wide_vec *p = i < 3 ? a : b;
      wide_vec from = p[i % 3];
      wide_vec to = p[(i + 1) % 3];
      wide_vec edge = {to.x - from.x, to.y - from.y, to.z - from.z};
      if (axis_separates(cross(unit[c], edge), a, b)) {
        return true;
      }
    }
  }
  return false;
}

bool sepax_sat54(const sepax_tri *a, const sepax_tri *b) {
  wide_vec p[3];
  wide_vec q[3];
  for (int k = 0; k < 3; k++) {
    p[k] = relative(a->v[k], a->v[0]);
    q[k] = relative(b->v[k], a->v[0]);
  }
  projections r = project(p, q);
  return all_zero(&r) ? !separated_in_plane(p, q) : !separated_in_space(&r);
}
