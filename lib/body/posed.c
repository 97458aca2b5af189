/* SPDX-License-Identifier: MIT */
/* posed.c - the exact verdict on two triangles of doubles in a pose.
 *
 * A posed coordinate is r_0 x + r_1 y + r_2 z + t, a sum of products of doubles: an integer times a
 * power of two. All 18 coordinates of a pair get the lowest of their exponents in common, which
 * changes no sign of an orient3d, and A_0 becomes the origin. Coordinates that then fit 32 bits go
 * to sepax_exact; longer ones go through the same formulas (verdict/exact.c) in integers of any
 * size. */
#include "body/number.h"
#include "body/posed.h"
#include "sepax_grid.h"
#include "verdict/signs.h"

#include <limits.h>

/* A posed coordinate as a sum of up to four products of doubles. */
typedef struct {
  number p[4], q[4];
  int terms;
} coordinate_terms;

static void add_term(coordinate_terms *c, double p, double q, int *lowest) {
  number x = number_of(p);
  number y = number_of(q);
  if (x.sign != 0 && y.sign != 0) {
    int exponent = x.exponent + y.exponent;
    *lowest = exponent < *lowest ? exponent : *lowest;
    c->p[c->terms] = x;
    c->q[c->terms++] = y;
  }
}

static void find_terms(coordinate_terms c[3], const double v[3], const sepax_pose *pose,
                       int *lowest) {
  for (int i = 0; i < 3; i++) {
    c[i].terms = 0;
    if (pose == NULL) {
      add_term(&c[i], v[i], 1, lowest);
      continue;
    }
    for (int k = 0; k < 3; k++) {
      add_term(&c[i], pose->rotation[i][k], v[k], lowest);
    }
    add_term(&c[i], pose->translation[i], 1, lowest);
  }
}

static void sum_terms(big *r, const coordinate_terms *c, int lowest) {
  big_set_zero(r);
  for (int k = 0; k < c->terms; k++) {
    big_add_shifted(r, c->p[k].sign * c->q[k].sign, (unsigned __int128)c->p[k].size * c->q[k].size,
                    c->p[k].exponent + c->q[k].exponent - lowest);
  }
}

int sepax__find_posed_points(posed_points *p, const double a[3][3], const sepax_pose *pa,
                             const double b[3][3], const sepax_pose *pb) {
  coordinate_terms terms[6][3];
  int lowest = INT_MAX;
  for (int v = 0; v < 6; v++) {
    find_terms(terms[v], v < 3 ? a[v] : b[v - 3], v < 3 ? pa : pb, &lowest);
  }
  for (int axis = 0; axis < 3; axis++) {
    for (int v = 0; v < 6; v++) {
      sum_terms(&p->c[axis][v], &terms[v][axis], lowest);
    }
    for (int v = 5; v >= 0; v--) {
      big_subtract(&p->c[axis][v], &p->c[axis][v], &p->c[axis][0]);
    }
  }
  return lowest < INT_MAX ? lowest : 0;
}

/* ------------------------------------------------------------- 32 bits are enough */

static bool fits_32_bits(const posed_points *p) {
  for (int axis = 0; axis < 3; axis++) {
    for (int v = 0; v < 6; v++) {
      const big *x = &p->c[axis][v];
      if (x->limbs > 1 || (x->limbs == 1 && x->limb[0] > INT32_MAX)) {
        return false;
      }
    }
  }
  return true;
}

static int32_t small(const big *x) { return x->limbs == 0 ? 0 : x->sign * (int32_t)x->limb[0]; }

static sepax_verdict verdict_32(const posed_points *p) {
  sepax_tri tri[2];
  for (int v = 0; v < 6; v++) {
    tri[v / 3].v[v % 3] = (sepax_vec){small(&p->c[0][v]), small(&p->c[1][v]), small(&p->c[2][v])};
  }
  return sepax_exact(&tri[0], &tri[1]);
}

/* ---------------------------------------------------------------------- any size */

/* The terms t_ij of vertices i < j in the projection on x and y; 15 products. */
typedef struct {
  big t[6][6];
} trapezoids;

static void find_trapezoids(trapezoids *t, const big x[6], const big y[6]) {
  big run;
  big sum;
  for (int i = 0; i < 6; i++) {
    for (int j = i + 1; j < 6; j++) {
      big_subtract(&run, &x[j], &x[i]);
      big_add(&sum, &y[i], &y[j]);
      big_multiply(&t->t[i][j], &run, &sum);
    }
  }
}

/* r += t_ij, which is -t_ji. */
static void add_trapezoid(big *r, const trapezoids *t, int i, int j) {
  const big *term = i < j ? &t->t[i][j] : &t->t[j][i];
  big_add_signed(r, r, term, i < j ? term->sign : -term->sign);
}

/* g_ijk = t_ij + t_jk + t_ki. */
static void find_orient2d(big *g, const trapezoids *t, int i, int j, int k) {
  big_set_zero(g);
  add_trapezoid(g, t, i, j);
  add_trapezoid(g, t, j, k);
  add_trapezoid(g, t, k, i);
}

/* r += sign h_ijk, h_ijk = g_ijk (z_i + z_j + z_k). */
static void add_prism(big *r, const trapezoids *t, const big z[6], const int at[3], int sign) {
  big g;
  big sum;
  big h;
  find_orient2d(&g, t, at[0], at[1], at[2]);
  big_add(&sum, &z[at[0]], &z[at[1]]);
  big_add(&sum, &sum, &z[at[2]]);
  big_multiply(&h, &g, &sum);
  big_add_signed(r, r, &h, sign * h.sign);
}

/* The sign of orient3d of vertices p, q, r, s: h_qrs - h_prs + h_pqs - h_pqr, in which the sum of
 * signed prism volumes under a closed surface is that of its inside. */
static int orient3d(const trapezoids *t, const big z[6], int p, int q, int r, int s) {
  const int face[4][3] = {{p, q, s}, {q, r, s}, {r, p, s}, {p, q, r}};
  big sum;
  big_set_zero(&sum);
  for (int k = 0; k < 4; k++) {
    add_prism(&sum, t, z, face[k], k < 3 ? 1 : -1);
  }
  return sum.sign;
}

static orient3d_signs find_orient3d(const trapezoids *t, const big z[6]) {
  orient3d_signs v;
  for (int i = 0; i < 3; i++) {
    v.s[i] = orient3d(t, z, 0, 1, 2, 3 + i);
    v.w[i] = orient3d(t, z, 3, 4, 5, i);
    for (int j = 0; j < 3; j++) {
      v.d[i][j] = orient3d(t, z, i, next[i], 3 + next[j], 3 + j);
    }
  }
  return v;
}

static orient2d_signs find_orient2d_signs(const trapezoids *t) {
  orient2d_signs s;
  big g;
  find_orient2d(&g, t, 0, 1, 2);
  s.own_a = g.sign;
  find_orient2d(&g, t, 3, 4, 5);
  s.own_b = g.sign;
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      find_orient2d(&g, t, i, next[i], 3 + k);
      s.a[i][k] = g.sign;
      find_orient2d(&g, t, 3 + i, 3 + next[i], k);
      s.b[i][k] = g.sign;
    }
  }
  return s;
}

static int compare(const big *p, const big *q) {
  big difference;
  big_subtract(&difference, p, q);
  return difference.sign;
}

/* True if in some coordinate all of A's vertices are below all of B's, or above. */
static bool disjoint_aabbs(const posed_points *p) {
  for (int axis = 0; axis < 3; axis++) {
    bool below = true;
    bool above = true;
    for (int i = 0; i < 3; i++) {
      for (int j = 3; j < 6; j++) {
        int order = compare(&p->c[axis][i], &p->c[axis][j]);
        below = below && order < 0;
        above = above && order > 0;
      }
    }
    if (below || above) {
      return true;
    }
  }
  return false;
}

static sepax_verdict verdict_any(const posed_points *p) {
  trapezoids t;
  find_trapezoids(&t, p->c[0], p->c[1]);
  orient3d_signs v = find_orient3d(&t, p->c[2]);
  if (!all_zero_3d(&v)) {
    return judged_in_space(&v);
  }
  for (int pass = 0; pass < 3; pass++) {
    if (pass > 0) {
      find_trapezoids(&t, p->c[pass], p->c[next[pass]]);
    }
    orient2d_signs s = find_orient2d_signs(&t);
    if (!all_zero_2d(&s)) {
      return judged_in_plane(edge_separates(&s));
    }
  }
  return judged_in_plane(disjoint_aabbs(p));
}

sepax_verdict sepax_exact_posed(const double a[3][3], const sepax_pose *pa, const double b[3][3],
                                const sepax_pose *pb) {
  posed_points p;
  sepax__find_posed_points(&p, a, pa, b, pb);
  return fits_32_bits(&p) ? verdict_32(&p) : verdict_any(&p);
}
