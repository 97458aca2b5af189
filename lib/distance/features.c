/* SPDX-License-Identifier: MIT */
/* features.c - which features of two triangles are nearest to each other: signs of integers.
 *
 * The distance of two convex sets is taken at points p and q iff no point of A is beyond p in the
 * direction w from p to q, and none of B before q. A pair of features has one such w, up to its
 * length: normal to both. So a pair is nearest iff p and q are in the features, and the other
 * vertices are on the right sides; no two distances are compared. Two features that share a point
 * are at distance 0, as is an edge that pierces a face. */
#include "distance.h"

#include <string.h>

typedef struct {
  big c[3];
} big_vec;

/* The vertices of both triangles, in one of the two orders. */
typedef struct {
  const posed_points *points;
  const int *from, *to; /* three vertices of each triangle */
  exact_nearest *found;
} task;

static void between(const task *t, int p, int q, big_vec *r) {
  for (int i = 0; i < 3; i++) {
    big_subtract(&r->c[i], &t->points->c[i][q], &t->points->c[i][p]);
  }
}

static void cross(big_vec *r, const big_vec *p, const big_vec *q) {
  big term;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    big_multiply(&r->c[i], &p->c[j], &q->c[k]);
    big_multiply(&term, &p->c[k], &q->c[j]);
    big_subtract(&r->c[i], &r->c[i], &term);
  }
}

static void dot(big *r, const big_vec *p, const big_vec *q) {
  big term;
  big_set_zero(r);
  for (int i = 0; i < 3; i++) {
    big_multiply(&term, &p->c[i], &q->c[i]);
    big_add(r, r, &term);
  }
}

/* The sign of w . (q - p). */
static int side(const task *t, const big_vec *w, int p, int q) {
  big_vec way;
  big r;
  between(t, p, q, &way);
  dot(&r, w, &way);
  return r.sign;
}

/* sign * w, which is normal to features with vertices p and q, separates all but them. */
static bool supports(const task *t, const big_vec *w, int sign, int p, int q) {
  for (int k = 0; k < 3; k++) {
    if ((t->from[k] != p && sign * side(t, w, p, t->from[k]) > 0) ||
        (t->to[k] != q && sign * side(t, w, q, t->to[k]) < 0)) {
      return false;
    }
  }
  return true;
}

/* The 64 highest bits of |p| and the 64 below; its size is (result) * 2^*exponent. */
static twofold leading(const big *p, int *exponent) {
  twofold r = {0, 0};
  int limbs = p->limbs < 3 ? p->limbs : 3;
  for (int n = 1; n <= limbs; n++) {
    uint64_t limb = p->limb[p->limbs - n];
    double high = (double)(limb >> 32) * 0x1p32;
    double low = (double)(limb & UINT32_MAX);
    r = twofold_add(r, twofold_scaled(sum_of(high, low), -64 * n));
  }
  *exponent = 64 * p->limbs;
  return r;
}

/* |p / q|. */
static twofold ratio(const big *p, const big *q) {
  int exponent_p;
  int exponent_q;
  twofold over = leading(p, &exponent_p);
  twofold under = leading(q, &exponent_q);
  return twofold_scaled(twofold_divide(over, under), exponent_p - exponent_q);
}

/* 0 <= p <= q */
static bool is_share(const big *p, const big *q) {
  return p->sign >= 0 && (p->sign == 0 || big_compare_sizes(p, q) <= 0);
}

static void set_edge(const task *t, int p, int q, const big *share, const big *whole) {
  big rest;
  big_subtract(&rest, whole, share);
  t->found->weight[p] = ratio(&rest, whole);
  t->found->weight[q] = ratio(share, whole);
}

static bool points_nearest(const task *t, int p, int q) {
  big_vec w;
  between(t, p, q, &w);
  if (!supports(t, &w, 1, p, q)) {
    return false;
  }
  dot(&t->found->over, &w, &w);
  big_set_zero(&t->found->under);
  big_add_shifted(&t->found->under, 1, 1, 0);
  t->found->weight[p] = t->found->weight[q] = twofold_of(1);
  return true;
}

/* Vertex p, edge q, r. With v = r - q and d = p - q the foot is q + v (d . v) / (v . v). */
static bool edge_nearest(const task *t, int p, int q, int r) {
  big_vec v;
  big_vec d;
  big_vec w;
  big share;
  big whole;
  between(t, q, r, &v);
  between(t, q, p, &d);
  dot(&share, &d, &v);
  dot(&whole, &v, &v);
  if (whole.sign == 0 || !is_share(&share, &whole)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    big term;
    big_multiply(&w.c[i], &v.c[i], &share);
    big_multiply(&term, &d.c[i], &whole);
    big_subtract(&w.c[i], &w.c[i], &term);
  }
  if (!supports(t, &w, 1, p, q)) {
    return false;
  }
  cross(&w, &d, &v);
  dot(&t->found->over, &w, &w);
  big_copy(&t->found->under, &whole);
  t->found->weight[p] = twofold_of(1);
  set_edge(t, q, r, &share, &whole);
  return true;
}

/* Edges p, q and r, s. With u = q - p, v = s - r, d = r - p, c = u x v the ends of the common
 * perpendicular are p + u (d x v) . c / c . c and r + v (d x u) . c / c . c. */
static bool edges_nearest(const task *t, const int from[2], const int to[2]) {
  big_vec u;
  big_vec v;
  big_vec d;
  big_vec c;
  big_vec e;
  big whole;
  big share[2];
  between(t, from[0], from[1], &u);
  between(t, to[0], to[1], &v);
  between(t, from[0], to[0], &d);
  cross(&c, &u, &v);
  dot(&whole, &c, &c);
  if (whole.sign == 0) {
    return false;
  }
  cross(&e, &d, &v);
  dot(&share[0], &e, &c);
  cross(&e, &d, &u);
  dot(&share[1], &e, &c);
  dot(&t->found->over, &d, &c);
  if (!is_share(&share[0], &whole) || !is_share(&share[1], &whole) ||
      (t->found->over.sign != 0 && !supports(t, &c, t->found->over.sign, from[0], to[0]))) {
    return false;
  }
  big_copy(&t->found->under, &whole);
  t->found->linear = true;
  set_edge(t, from[0], from[1], &share[0], &whole);
  set_edge(t, to[0], to[1], &share[1], &whole);
  return true;
}

/* Vertex p and the other face. With e_k = f_k - f_0, n = e_1 x e_2, d = p - f_0 the foot has
 * weights (d x e_2) . n / n . n and (e_1 x d) . n / n . n of f_1, f_2. */
static bool face_nearest(const task *t, int p) {
  big_vec e[2];
  big_vec n;
  big_vec d;
  big_vec c;
  big whole;
  big share[3];
  between(t, t->to[0], t->to[1], &e[0]);
  between(t, t->to[0], t->to[2], &e[1]);
  between(t, t->to[0], p, &d);
  cross(&n, &e[0], &e[1]);
  dot(&whole, &n, &n);
  if (whole.sign == 0) {
    return false;
  }
  cross(&c, &d, &e[1]);
  dot(&share[1], &c, &n);
  cross(&c, &e[0], &d);
  dot(&share[2], &c, &n);
  big_subtract(&share[0], &whole, &share[1]);
  big_subtract(&share[0], &share[0], &share[2]);
  dot(&t->found->over, &d, &n);
  int sign = t->found->over.sign;
  if (share[0].sign < 0 || share[1].sign < 0 || share[2].sign < 0 ||
      (sign != 0 && !supports(t, &n, -sign, p, t->to[0]))) {
    return false;
  }
  big_copy(&t->found->under, &whole);
  t->found->linear = true;
  t->found->weight[p] = twofold_of(1);
  for (int k = 0; k < 3; k++) {
    t->found->weight[t->to[k]] = ratio(&share[k], &whole);
  }
  return true;
}

/* Edge p, q has its ends on different sides of the other face, and passes its edges on one. */
static bool pierces(const task *t, int p, int q) {
  big_vec way;
  big_vec to[3];
  big_vec c;
  big volume[3];
  big height[2];
  big whole;
  between(t, t->to[0], t->to[1], &to[1]);
  between(t, t->to[0], t->to[2], &to[2]);
  cross(&c, &to[1], &to[2]);
  between(t, t->to[0], p, &way);
  dot(&height[0], &c, &way);
  between(t, t->to[0], q, &way);
  dot(&height[1], &c, &way);
  if (height[0].sign * height[1].sign >= 0) {
    return false;
  }
  between(t, p, q, &way);
  for (int k = 0; k < 3; k++) {
    between(t, p, t->to[k], &to[k]);
  }
  big_set_zero(&whole);
  for (int k = 0; k < 3; k++) {
    cross(&c, &to[(k + 1) % 3], &to[(k + 2) % 3]);
    dot(&volume[k], &c, &way);
    big_add(&whole, &whole, &volume[k]);
  }
  for (int k = 0; k < 3; k++) {
    if (volume[k].sign != 0 && volume[k].sign != whole.sign) {
      return false;
    }
  }
  for (int k = 0; k < 3; k++) {
    t->found->weight[t->to[k]] = ratio(&volume[k], &whole);
  }
  big_subtract(&whole, &height[0], &height[1]);
  t->found->weight[p] = ratio(&height[1], &whole);
  t->found->weight[q] = ratio(&height[0], &whole);
  big_set_zero(&t->found->over);
  big_set_zero(&t->found->under);
  big_add_shifted(&t->found->under, 1, 1, 0);
  return true;
}

/* List the vertices of a feature; returns their number. */
static int vertices(int feature, const int of[3], int v[3]) {
  int count = 0;
  for (int k = 0; k < 3; k++) {
    if ((feature >> k & 1) != 0) {
      v[count++] = of[k];
    }
  }
  return count;
}

static bool are_nearest(const posed_points *p, int a, int b, exact_nearest *found) {
  static const int of[2][3] = {{0, 1, 2}, {3, 4, 5}};
  int v[2][3];
  int first = __builtin_popcount((unsigned)a) > __builtin_popcount((unsigned)b);
  int from = vertices(first ? b : a, of[first], v[0]);
  int to = vertices(first ? a : b, of[!first], v[1]);
  task t = {p, of[first], of[!first], found};
  memset(found->weight, 0, sizeof found->weight);
  found->linear = false;
  if (from == 1) {
    return to == 1   ? points_nearest(&t, v[0][0], v[1][0])
           : to == 2 ? edge_nearest(&t, v[0][0], v[1][0], v[1][1])
                     : face_nearest(&t, v[0][0]);
  }
  return from == 2 && (to == 2 ? edges_nearest(&t, v[0], v[1]) : pierces(&t, v[0][0], v[0][1]));
}

void sepax__find_exact_nearest(const posed_points *p, const feature_list *likely,
                               exact_nearest *found) {
  for (int n = 0; n < likely->count; n++) {
    if (are_nearest(p, likely->a[n], likely->b[n], found)) {
      return;
    }
  }
  for (int n = 0; n < 49; n++) {
    if (are_nearest(p, 1 + n / 7, 1 + n % 7, found)) {
      return;
    }
  }
  assert(false); /* never reached: some features of two convex sets are nearest */
}

twofold sepax__exact_distance(const exact_nearest *n, int *exponent) {
  int exponent_over;
  int exponent_under;
  twofold over = leading(&n->over, &exponent_over);
  twofold under = leading(&n->under, &exponent_under);
  if (n->linear) { /* make both exponents multiples of 64 */
    *exponent = exponent_over - exponent_under / 2;
    return twofold_divide(over, twofold_root(under));
  }
  *exponent = (exponent_over - exponent_under) / 2;
  return twofold_root(twofold_divide(over, under));
}

/* r *= 2^shift */
static void shift_up(big *r, int shift) {
  big power = {.sign = 1, .limbs = shift / 64 + 1};
  big product;
  assert(power.limbs <= BIG_LIMBS);
  power.limb[shift / 64] = UINT64_C(1) << shift % 64;
  big_multiply(&product, r, &power);
  big_copy(r, &product);
  r->sign = product.sign;
}

int sepax__exact_compare(const exact_nearest *n, int exponent, double limit) {
  int exponent_limit;
  double size = frexp(limit, &exponent_limit);
  if (n->over.sign == 0 || limit == 0) {
    return (n->over.sign != 0) - (limit > 0);
  }
  assert(n->over.limbs > 0);
  big square;
  big most;
  big least;
  big whole = {.sign = 1, .limbs = 1, .limb = {(uint64_t)ldexp(size, 53)}};
  big_multiply(&square, &whole, &whole);
  big_multiply(&most, &square, &n->under);
  big_copy(&least, &n->over);
  least.sign = 1;
  if (n->linear) {
    big_multiply(&least, &n->over, &n->over);
  }
  int up = 2 * (exponent_limit - 53 - exponent);
  shift_up(up > 0 ? &most : &least, up > 0 ? up : -up);
  return big_compare_sizes(&least, &most);
}
