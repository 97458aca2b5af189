/* SPDX-License-Identifier: MIT */
/* distance.c - the distance of two posed triangles.
 *
 * Doubles find candidates for the nearest features. Numbers of twice the precision then enclose the
 * distance: two points of the triangles are at that distance at least, and so is the gap of the
 * projections on any direction w at most. If both agree to 2^-55 the distance is known, whatever
 * the features were; else integers of any size find it (features.c). */
#include "distance.h"
#include "util/vector.h"

#include <string.h>

typedef twofold_vector vector;

/* The vertices in units of 2^exponent, from A_0, which is at `origin`; the largest coordinate is
 * below 1, and at least 1/2 unless it is very small. `lost`: how far two vertices can be nearer to
 * each other or farther than said.
 *
 * In units of 2^coarse, coordinates and translations are below 1, and those of a pose
 * are sums of four terms that are below 4.01 together: three sums, each wrong by 3 u^2 of it, 37
 * u^2. The difference of two, below 8.02, is wrong by 98 u^2 < 2^-99, the vector by less than
 * 2^-98, a distance by 2^-97. Of unmoved vertices both terms are doubles and the difference is
 * exact. What underflows is below 2^-1050. */
typedef struct {
  vector v[6];
  int exponent;
  vector origin; /* in units of 2^coarse */
  int coarse;
  double lost;
} twofold_points;

/* ---------------------------------------------------------------------- vectors */

static vector vector_minus(const vector *p, const vector *q) {
  vector r;
  for (int i = 0; i < 3; i++) {
    r.c[i] = twofold_subtract(p->c[i], q->c[i]);
  }
  return r;
}

/* p + t u */
static vector along(const vector *p, twofold t, const vector *u) {
  vector r;
  for (int i = 0; i < 3; i++) {
    r.c[i] = twofold_add(p->c[i], twofold_multiply(t, u->c[i]));
  }
  return r;
}

static double largest(const vector *p, double most) {
  for (int i = 0; i < 3; i++) {
    most = fmax(most, fabs(p->c[i].high));
  }
  return most;
}

/* The exponent of x > 0 as of frexp, or 0 if 2^-exponent would not be finite. */
static int exponent_of(double x) {
  int exponent = 0;
  frexp(x, &exponent);
  return exponent > -1000 ? exponent : -1000;
}

/* ---------------------------------------------------------------------- vertices */

static double largest_number(const double v[3][3], const sepax_pose *pose) {
  double most = 0;
  for (int k = 0; k < 9; k++) {
    most = fmax(most, fabs(v[k / 3][k % 3]));
    most = pose != NULL ? fmax(most, fabs(pose->translation[k / 3])) : most;
  }
  return most;
}

/* A posed vertex times `unit`, which is a power of two. */
static vector posed_vertex(const double v[3], const sepax_pose *pose, double unit) {
  vector r;
  for (int i = 0; i < 3; i++) {
    if (pose == NULL) {
      r.c[i] = twofold_of(v[i] * unit);
      continue;
    }
    r.c[i] = twofold_of(pose->translation[i] * unit);
    for (int k = 0; k < 3; k++) {
      r.c[i] = twofold_add(r.c[i], product_of(pose->rotation[i][k], v[k] * unit));
    }
  }
  return r;
}

static void find_twofold_points(twofold_points *p, const double a[3][3], const sepax_pose *pa,
                                const double b[3][3], const sepax_pose *pb) {
  p->coarse = exponent_of(fmax(largest_number(a, pa), largest_number(b, pb)));
  double unit = ldexp(1, -p->coarse);
  double most = 0;
  for (int k = 0; k < 6; k++) {
    p->v[k] = k < 3 ? posed_vertex(a[k], pa, unit) : posed_vertex(b[k - 3], pb, unit);
  }
  p->origin = p->v[0];
  for (int k = 0; k < 6; k++) {
    p->v[k] = vector_minus(&p->v[k], &p->origin);
    most = largest(&p->v[k], most);
  }
  int fine = exponent_of(most);
  unit = ldexp(1, -fine);
  for (int k = 0; k < 18; k++) {
    twofold *x = &p->v[k / 3].c[k % 3];
    *x = (twofold){x->high * unit, x->low * unit};
  }
  p->exponent = p->coarse + fine;
  p->lost = ((pa == NULL && pb == NULL ? 0 : 0x1p-97) + 0x1p-1050) * unit;
}

/* -------------------------------------------------------------- likely features */

typedef struct {
  double p[2][3][3];
  feature_list list;
  double square[FEATURES]; /* squares of the distances */
} candidates;

static void minus(const double p[3], const double q[3], double r[3]) {
  for (int i = 0; i < 3; i++) {
    r[i] = p[i] - q[i];
  }
}

/* Insert a pair of features in the order of the distances, each pair once. */
static void offer(candidates *c, int a, int b, double square) {
  feature_list *l = &c->list;
  int at = l->count;
  for (int n = 0; n < l->count; n++) {
    if (l->a[n] == a && l->b[n] == b) {
      return;
    }
  }
  for (; at > 0 && square < c->square[at - 1]; at--) {
    l->a[at] = l->a[at - 1];
    l->b[at] = l->b[at - 1];
    c->square[at] = c->square[at - 1];
  }
  l->a[at] = (uint8_t)a;
  l->b[at] = (uint8_t)b;
  c->square[at] = square;
  l->count++;
}

static double within_unit(double t) { return t > 0 ? (t < 1 ? t : 1) : 0; }

static int edge_feature(double t, int from, int to) {
  return (t < 1 ? 1 << from : 0) | (t > 0 ? 1 << to : 0);
}

/* Offer the nearest points p + s u and q + t v of two edges, with s and t in 0 ... 1. */
static void offer_edges(candidates *c, int i, int j) {
  int i_end = (i + 1) % 3;
  int j_end = (j + 1) % 3;
  double u[3];
  double v[3];
  double d[3];
  minus(c->p[0][i_end], c->p[0][i], u);
  minus(c->p[1][j_end], c->p[1][j], v);
  minus(c->p[1][j], c->p[0][i], d);
  double uu = vector_dot(u, u);
  double vv = vector_dot(v, v);
  double uv = vector_dot(u, v);
  double du = vector_dot(d, u);
  double dv = vector_dot(d, v);
  double area = uu * vv - uv * uv;
  double s = area > 0x1p-50 * uu * vv ? within_unit((du * vv - uv * dv) / area) : 0;
  double t = vv > 0 ? within_unit((s * uv - dv) / vv) : 0;
  s = uu > 0 ? within_unit((t * uv + du) / uu) : 0;
  for (int k = 0; k < 3; k++) {
    d[k] += t * v[k] - s * u[k];
  }
  offer(c, edge_feature(s, i, i_end), edge_feature(t, j, j_end), vector_dot(d, d));
}

/* Offer the vertices x of one triangle above the face of the other, and edges that pierce the
 * face. */
static void offer_face(candidates *c, const double x[3][3], const double f[3][3], bool of_b) {
  double e[3][3];
  double n[3];
  double height[3] = {0, 0, 0};
  for (int k = 0; k < 3; k++) {
    minus(f[(k + 1) % 3], f[k], e[k]);
  }
  vector_cross(e[0], e[1], n);
  double square = vector_dot(n, n);
  if (!(square > 0)) {
    return;
  }
  for (int k = 0; k < 3; k++) {
    bool inside = true;
    for (int j = 0; j < 3; j++) {
      double d[3];
      double side[3];
      minus(x[k], f[j], d);
      height[k] = j == 0 ? vector_dot(d, n) : height[k];
      vector_cross(e[j], d, side);
      inside = inside && vector_dot(side, n) >= 0;
    }
    if (inside) {
      offer(c, of_b ? 7 : 1 << k, of_b ? 1 << k : 7, height[k] * height[k] / square);
    }
  }
  for (int k = 0; k < 3; k++) {
    int l = (k + 1) % 3;
    if (height[k] * height[l] < 0) {
      bool inside = true;
      for (int j = 0; j < 3; j++) {
        double d[3];
        double side[3];
        for (int i = 0; i < 3; i++) {
          d[i] = (x[k][i] - f[j][i]) * height[l] - (x[l][i] - f[j][i]) * height[k];
        }
        vector_cross(e[j], d, side);
        inside = inside && vector_dot(side, n) * (height[l] - height[k]) >= 0;
      }
      if (inside) {
        int edge = 1 << k | 1 << l;
        offer(c, of_b ? 7 : edge, of_b ? edge : 7, 0);
      }
    }
  }
}

static void find_candidates(const twofold_points *p, candidates *c) {
  c->list.count = 0;
  for (int k = 0; k < 18; k++) {
    c->p[k / 9][k / 3 % 3][k % 3] = p->v[k / 3].c[k % 3].high;
  }
  for (int k = 0; k < 9; k++) {
    offer_edges(c, k / 3, k % 3);
  }
  offer_face(c, c->p[0], c->p[1], false);
  offer_face(c, c->p[1], c->p[0], true);
}

/* -------------------------------------------------------------------- enclosure */

/* The distance is within least ... most, in units of 2^exponent. */
typedef struct {
  twofold least, most;
  vector nearest[2];
  vector way; /* the gap on this direction is `least`, except for rounding */
} enclosure;

static twofold limited(twofold t, twofold most) {
  return !(t.high > 0) ? twofold_of(0) : twofold_less(most, t) ? most : t;
}

static twofold quotient(twofold p, twofold q) {
  return q.high > 0 ? twofold_divide(p, q) : twofold_of(0);
}

/* Weights of the vertices where the hulls of the features are nearest, and what is normal to both.
 * x: a vertex or an edge; y has as many vertices, or more. */
static vector nearest_of(const twofold_points *p, const int x[2], int count_x, const int y[3],
                         int count_y, twofold weight[6]) {
  const twofold one = {1, 0};
  const vector *at = p->v;
  vector d = vector_minus(&at[y[0]], &at[x[0]]);
  weight[x[0]] = weight[y[0]] = one;
  if (count_y == 1) {
    return d;
  }
  vector v = vector_minus(&at[y[1]], &at[y[0]]);
  if (count_x == 2) {
    vector u = vector_minus(&at[x[1]], &at[x[0]]);
    vector c = twofold_cross(&u, &v);
    vector dv = twofold_cross(&d, &v);
    vector du = twofold_cross(&d, &u);
    twofold square = twofold_dot(&c, &c);
    weight[x[1]] = limited(quotient(twofold_dot(&dv, &c), square), one);
    weight[x[0]] = twofold_subtract(one, weight[x[1]]);
    weight[y[1]] = limited(quotient(twofold_dot(&du, &c), square), one);
    weight[y[0]] = twofold_subtract(one, weight[y[1]]);
    return c;
  }
  if (count_y == 2) {
    twofold t = quotient(twofold_minus(twofold_dot(&d, &v)), twofold_dot(&v, &v));
    weight[y[1]] = limited(t, one);
    weight[y[0]] = twofold_subtract(one, weight[y[1]]);
    return along(&d, t, &v);
  }
  vector w = vector_minus(&at[y[2]], &at[y[0]]);
  vector n = twofold_cross(&v, &w);
  vector dw = twofold_cross(&w, &d);
  vector vd = twofold_cross(&d, &v);
  twofold square = twofold_dot(&n, &n);
  weight[y[1]] = limited(quotient(twofold_dot(&dw, &n), square), one);
  weight[y[0]] = twofold_subtract(one, weight[y[1]]);
  weight[y[2]] = limited(quotient(twofold_dot(&vd, &n), square), weight[y[0]]);
  weight[y[0]] = twofold_subtract(weight[y[0]], weight[y[2]]);
  return n;
}

static void weighted_points(const twofold_points *p, const twofold weight[6], vector r[2]) {
  for (int k = 0; k < 6; k++) {
    const vector none = {{{0, 0}, {0, 0}, {0, 0}}};
    r[k / 3] = along(k % 3 == 0 ? &none : &r[k / 3], weight[k], &p->v[k]);
  }
}

/* The gap of the projections on w, divided by the length of w; 0 or less if there is none. */
static twofold gap_along(const twofold_points *p, const vector *w) {
  vector unit;
  twofold low[2];
  twofold high[2];
  double scale = ldexp(1, -exponent_of(largest(w, 0)));
  for (int i = 0; i < 3; i++) {
    unit.c[i] = (twofold){w->c[i].high * scale, w->c[i].low * scale};
  }
  for (int k = 0; k < 6; k++) {
    twofold t = twofold_dot(&unit, &p->v[k]);
    low[k / 3] = k % 3 == 0 || twofold_less(t, low[k / 3]) ? t : low[k / 3];
    high[k / 3] = k % 3 == 0 || twofold_less(high[k / 3], t) ? t : high[k / 3];
  }
  twofold gap = twofold_subtract(low[1], high[0]);
  twofold back = twofold_subtract(low[0], high[1]);
  return quotient(twofold_less(gap, back) ? back : gap, twofold_root(twofold_dot(&unit, &unit)));
}

/* A bound on the error of both bounds. Weights are at least 0, and their sum is 1 within 6 u^2, so
 * the points belong to the triangles within 2^-99. The points are wrong by 60 u^2, as coordinates,
 * and `most` by less than 2^-97. Projections on a w of length 1/2 at least are wrong by 45 u^2.
 * `least` is a difference of two of them, divided by that length, so it is wrong by less than
 * 2^-97, too. Underflow loses far less. */
static twofold error_of(const twofold_points *p) { return twofold_of(0x1p-96 + p->lost); }

/* Narrow the enclosure of the distance by a pair of features. */
static void enclose(const twofold_points *p, int a, int b, enclosure *e) {
  int v[2][3] = {{0}};
  int count[2] = {0, 0};
  twofold weight[6] = {{0, 0}};
  for (int k = 0; k < 3; k++) {
    if ((a >> k & 1) != 0) {
      v[0][count[0]++] = k;
    }
    if ((b >> k & 1) != 0) {
      v[1][count[1]++] = 3 + k;
    }
  }
  int first = count[0] > count[1];
  e->way = nearest_of(p, v[first], count[first], v[!first], count[!first], weight);
  e->least = twofold_subtract(gap_along(p, &e->way), error_of(p));
  weighted_points(p, weight, e->nearest);
  vector w = vector_minus(&e->nearest[1], &e->nearest[0]);
  e->most = twofold_add(twofold_root(twofold_dot(&w, &w)), error_of(p));
}

/* ------------------------------------------------------------------------ results */

/* No enclosure is narrower than twice error_of, above 2^-96. So distances below this one are not
 * known to 2^-55 of themselves, whatever the features are. */
#define LEAST_ENCLOSED 0x1p-41

/* True if some candidate is proved to be nearest. */
static bool is_enclosed(const twofold_points *p, const candidates *c, enclosure *e) {
  for (int n = 0; n < c->list.count && n < 4 && c->square[n] <= c->square[0] * (1 + 0x1p-20); n++) {
    enclose(p, c->list.a[n], c->list.b[n], e);
    double width = twofold_subtract(e->most, e->least).high;
    if (width <= 0x1p-55 * e->least.high) {
      return true;
    }
    if (e->most.high < LEAST_ENCLOSED) {
      return false;
    }
  }
  return false;
}

/* Round a distance above 0 to a double, at least the smallest one. */
static double rounded(twofold distance, int exponent) {
  double r = ldexp(distance.high, exponent);
  return r > 0 ? r : 0x1p-1074;
}

static void round_points(const twofold_points *p, const vector from[2], double nearest[2][3]) {
  for (int k = 0; k < 6 && nearest != NULL; k++) {
    twofold way = twofold_scaled(from[k / 3].c[k % 3], p->exponent - p->coarse);
    nearest[k / 3][k % 3] = ldexp(twofold_add(p->origin.c[k % 3], way).high, p->coarse);
  }
}

double sepax__distance_and_way(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                               const sepax_pose *pose_b, double nearest[2][3],
                               twofold_vector *way) {
  twofold_points p;
  candidates c;
  enclosure e;
  find_twofold_points(&p, a, pose_a, b, pose_b);
  find_candidates(&p, &c);
  if (is_enclosed(&p, &c, &e)) {
    round_points(&p, e.nearest, nearest);
    *way = e.way;
    twofold sum = twofold_add(e.least, e.most);
    return rounded(sum, p.exponent - 1);
  }
  posed_points points;
  exact_nearest found = {.linear = false};
  int fine;
  int exponent = sepax__find_posed_points(&points, a, pose_a, b, pose_b);
  sepax__find_exact_nearest(&points, &c.list, &found);
  weighted_points(&p, found.weight, e.nearest);
  round_points(&p, e.nearest, nearest);
  twofold distance = sepax__exact_distance(&found, &fine);
  *way = (twofold_vector){{{0, 0}, {0, 0}, {0, 0}}};
  return found.over.sign == 0 ? 0 : rounded(distance, exponent + fine);
}

double sepax_distance_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                            const sepax_pose *pose_b, double nearest[2][3]) {
  twofold_vector way;
  return sepax__distance_and_way(a, pose_a, b, pose_b, nearest, &way);
}

bool sepax__distance_at_least(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                              const sepax_pose *pose_b, const twofold_vector *way,
                              double distance) {
  twofold_points p;
  find_twofold_points(&p, a, pose_a, b, pose_b);
  twofold least = twofold_subtract(gap_along(&p, way), error_of(&p));
  twofold enough = product_of(ldexp(distance, -p.exponent), 1 - 0x1p-53);
  return least.high > 0 && !twofold_less(least, enough);
}

int sepax__distance_compare(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                            const sepax_pose *pose_b, double limit) {
  twofold_points p;
  candidates c;
  enclosure e;
  find_twofold_points(&p, a, pose_a, b, pose_b);
  find_candidates(&p, &c);
  enclose(&p, c.list.a[0], c.list.b[0], &e);
  double scaled = ldexp(limit, -p.exponent);
  if (e.most.high < scaled * (1 - 0x1p-50)) {
    return -1;
  }
  if (e.least.high > scaled * (1 + 0x1p-50) + 0x1p-1000) {
    return 1;
  }
  posed_points points;
  exact_nearest found = {.linear = false};
  int exponent = sepax__find_posed_points(&points, a, pose_a, b, pose_b);
  sepax__find_exact_nearest(&points, &c.list, &found);
  return sepax__exact_compare(&found, exponent, limit);
}
