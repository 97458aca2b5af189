/* SPDX-License-Identifier: MIT */
#include "distance.h"

#include "geometry.h"
#include "gmp_vec.h"
#include "oracle.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---------------------------------------------------------------------- in doubles */

typedef struct {
  double squared;
  point way; /* from A to B */
} nearest;

static void offer(nearest *n, point from, point to) {
  point way = minus(to, from);
  double squared = inner(way, way);
  if (squared < n->squared) {
    *n = (nearest){squared, way};
  }
}

static double clamp(double t) { return t < 0 ? 0 : t > 1 ? 1 : t; }

/* The point of segment p, p + u that is next to x. */
static point foot(point x, point p, point u) {
  double length = inner(u, u);
  return length > 0 ? along(p, clamp(inner(minus(x, p), u) / length), u) : p;
}

static void offer_segments(nearest *n, point p, point u, point q, point v) {
  point ends[2] = {p, along(p, 1, u)};
  point others[2] = {q, along(q, 1, v)};
  for (int k = 0; k < 2; k++) {
    offer(n, ends[k], foot(ends[k], q, v));
    offer(n, foot(others[k], p, u), others[k]);
  }
  point c = outer(u, v);
  double square = inner(c, c);
  if (square > 0) {
    point d = minus(q, p);
    double s = inner(outer(d, v), c) / square;
    double t = inner(outer(d, u), c) / square;
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) {
      offer(n, along(p, s, u), along(q, t, v));
    }
  }
}

/* The foot of x in a triangle, if there is one. */
static bool foot_inside(point x, const point t[3], point *at) {
  point normal = outer(minus(t[1], t[0]), minus(t[2], t[0]));
  double square = inner(normal, normal);
  for (int k = 0; k < 3; k++) {
    if (inner(outer(minus(t[(k + 1) % 3], t[k]), minus(x, t[k])), normal) < 0) {
      return false;
    }
  }
  *at = square > 0 ? along(x, -inner(minus(x, t[0]), normal) / square, normal) : x;
  return square > 0;
}

static double distance_of_points(point p[2][3], double way[3]) {
  nearest n = {INFINITY, {{0, 0, 0}}};
  for (int i = 0; i < 3; i++) {
    point u = minus(p[0][(i + 1) % 3], p[0][i]);
    point at;
    for (int j = 0; j < 3; j++) {
      offer_segments(&n, p[0][i], u, p[1][j], minus(p[1][(j + 1) % 3], p[1][j]));
    }
    if (foot_inside(p[0][i], p[1], &at)) {
      offer(&n, p[0][i], at);
    }
    if (foot_inside(p[1][i], p[0], &at)) {
      offer(&n, at, p[1][i]);
    }
  }
  for (int i = 0; i < 3; i++) {
    way[i] = n.way.c[i];
  }
  return sqrt(n.squared);
}

double distance_rounded(const sepax_tri *a, const sepax_tri *b, double way[3]) {
  point p[2][3];
  for (int k = 0; k < 3; k++) {
    p[0][k] = point_of(a->v[k]);
    p[1][k] = point_of(b->v[k]);
  }
  return distance_of_points(p, way);
}

double distance_rounded_real(const double a[3][3], const double b[3][3], double way[3]) {
  point p[2][3];
  memcpy(p[0], a, sizeof p[0]);
  memcpy(p[1], b, sizeof p[1]);
  return distance_of_points(p, way);
}

/* The distance exceeds the limit, as the projections on a whole-numbered vector say: exact. */
static bool proved_farther(const sepax_tri *a, const sepax_tri *b, int64_t limit) {
  double way[3];
  double most = 0;
  distance_rounded(a, b, way);
  for (int i = 0; i < 3; i++) {
    most = fmax(most, fabs(way[i]));
  }
  if (!(most > 0)) {
    return false;
  }
  int64_t c[3];
  int64_t square = 0;
  for (int i = 0; i < 3; i++) {
    c[i] = (int64_t)llround(way[i] / most * 0x1p21);
    square += c[i] * c[i];
  }
  int64_t high = INT64_MIN;
  int64_t low = INT64_MAX;
  for (int k = 0; k < 3; k++) {
    int64_t of_a = c[0] * a->v[k].x + c[1] * a->v[k].y + c[2] * a->v[k].z;
    int64_t of_b = c[0] * b->v[k].x + c[1] * b->v[k].y + c[2] * b->v[k].z;
    high = of_a > high ? of_a : high;
    low = of_b < low ? of_b : low;
  }
  __int128 gap = low - high;
  return gap > 0 && gap * gap > (__int128)(limit * limit) * square;
}

/* ------------------------------------------------------------------- in rationals */

/* Squares of distances are `distance` / `square`, that of the limit is `limit`. */

/* distance / square <= limit, with square > 0. A search for the least square has a limit below 0:
 * nothing is near, and `over` / `under` becomes the least. */
static bool near_enough(work *w) {
  if (mpz_sgn(w->limit) < 0) {
    mpz_mul(w->s, w->over, w->square);
    mpz_mul(w->t, w->distance, w->under);
    if (mpz_sgn(w->under) == 0 || mpz_cmp(w->t, w->s) < 0) {
      mpz_set(w->over, w->distance);
      mpz_set(w->under, w->square);
    }
    return false;
  }
  mpz_mul(w->t, w->square, w->limit);
  return mpz_cmp(w->distance, w->t) <= 0;
}

static bool points_near(work *w, const vec *p, const vec *q) {
  vec_sub(&w->d, q, p);
  vec_dot(w->distance, &w->d, &w->d);
  mpz_set_ui(w->square, 1);
  return near_enough(w);
}

/* To the inside of a segment; its ends are other points. */
static bool point_near_segment(work *w, const vec *x, const vec *p, const vec *q) {
  vec_sub(&w->u, q, p);
  vec_sub(&w->d, x, p);
  vec_dot(w->square, &w->u, &w->u);
  vec_dot(w->s, &w->d, &w->u);
  if (mpz_sgn(w->s) <= 0 || mpz_cmp(w->s, w->square) >= 0) {
    return false;
  }
  vec_cross(&w->c, &w->d, &w->u);
  vec_dot(w->distance, &w->c, &w->c);
  return near_enough(w);
}

/* To the plane of triangle i, the foot being in it. */
static bool point_near_face(work *w, const vec *x, int i) {
  const vec *t = &w->p[3 * i];
  vec_dot(w->square, &w->n[i], &w->n[i]);
  bool inside = mpz_sgn(w->square) != 0;
  for (int k = 0; k < 3 && inside; k++) {
    vec_sub(&w->u, &t[(k + 1) % 3], &t[k]);
    vec_sub(&w->d, x, &t[k]);
    vec_cross(&w->c, &w->u, &w->d);
    vec_dot(w->s, &w->c, &w->n[i]);
    inside = mpz_sgn(w->s) >= 0;
  }
  vec_dot(w->s, &w->d, &w->n[i]);
  mpz_mul(w->distance, w->s, w->s);
  return inside && near_enough(w);
}

/* Where the common perpendicular meets both. */
static bool segments_near(work *w, const vec *p, const vec *q, const vec *r, const vec *s) {
  bool inside = perpendicular_meets(w, p, q, r, s);
  vec_dot(w->s, &w->d, &w->c);
  mpz_mul(w->distance, w->s, w->s);
  return inside && near_enough(w);
}

static bool any_near(work *w) {
  vec *a = w->p;
  vec *b = w->p + 3;
  for (int i = 0; i < 3; i++) {
    for (int j = 0; j < 3; j++) {
      const vec *a_end = &a[(i + 1) % 3];
      const vec *b_end = &b[(j + 1) % 3];
      if (points_near(w, &a[i], &b[j]) || point_near_segment(w, &a[i], &b[j], b_end) ||
          point_near_segment(w, &b[j], &a[i], a_end) ||
          segments_near(w, &a[i], a_end, &b[j], b_end)) {
        return true;
      }
    }
    if (point_near_face(w, &a[i], 1) || point_near_face(w, &b[i], 0)) {
      return true;
    }
  }
  return false;
}

bool distance_within_exact(const sepax_tri *a, const sepax_tri *b, int64_t limit) {
  work w;
  work_init(&w, a, b);
  mpz_set_si(w.limit, (long)limit);
  mpz_mul(w.limit, w.limit, w.limit);
  bool near = any_near(&w) || oracle_collide(a, b);
  work_clear(&w);
  return near;
}

bool distance_within_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                           const sepax_pose *pose_b, double limit) {
  work w;
  work_init_posed(&w, a, pose_a, b, pose_b, limit);
  mpz_mul(w.limit, w.limit, w.limit);
  bool near = any_near(&w) || oracle_collide_posed(a, pose_a, b, pose_b);
  work_clear(&w);
  return near;
}

void exact_square_init(exact_square *s) {
  mpz_inits(s->over, s->under, NULL);
  s->exponent = 0;
}

void exact_square_clear(exact_square *s) { mpz_clears(s->over, s->under, NULL); }

void distance_square_posed(exact_square *r, const double a[3][3], const sepax_pose *pose_a,
                           const double b[3][3], const sepax_pose *pose_b) {
  work w;
  r->exponent = 2L * work_init_posed(&w, a, pose_a, b, pose_b, 0);
  if (oracle_collide_posed(a, pose_a, b, pose_b)) {
    mpz_set_ui(w.under, 1);
  } else {
    mpz_set_si(w.limit, -1);
    (void)any_near(&w);
  }
  mpz_swap(r->over, w.over);
  mpz_swap(r->under, w.under);
  work_clear(&w);
}

/* The sign of p 2^p_exponent - q 2^q_exponent, both at least 0. Their sizes decide at first. */
static int compare_scaled(const mpz_t p, long p_exponent, const mpz_t q, long q_exponent) {
  if (mpz_sgn(p) == 0 || mpz_sgn(q) == 0) {
    return (mpz_sgn(p) != 0) - (mpz_sgn(q) != 0);
  }
  long p_top = (long)mpz_sizeinbase(p, 2) + p_exponent;
  long q_top = (long)mpz_sizeinbase(q, 2) + q_exponent;
  if (p_top != q_top) {
    return p_top < q_top ? -1 : 1;
  }
  mpz_t shifted;
  mpz_init(shifted);
  bool up = p_exponent > q_exponent;
  mpz_mul_2exp(shifted, up ? p : q, (mp_bitcnt_t)labs(p_exponent - q_exponent));
  int order = up ? mpz_cmp(shifted, q) : mpz_cmp(p, shifted);
  mpz_clear(shifted);
  return (order > 0) - (order < 0);
}

int exact_square_compare(const exact_square *p, const exact_square *q) {
  mpz_t left;
  mpz_t right;
  mpz_inits(left, right, NULL);
  mpz_mul(left, p->over, q->under);
  mpz_mul(right, q->over, p->under);
  int order = compare_scaled(left, p->exponent, right, q->exponent);
  mpz_clears(left, right, NULL);
  return order;
}

int exact_square_compare_length(const exact_square *s, double length) {
  int exponent;
  double mantissa = frexp(length, &exponent);
  exact_square other;
  exact_square_init(&other);
  mpz_set_d(other.over, ldexp(mantissa, 53));
  mpz_mul(other.over, other.over, other.over);
  mpz_set_ui(other.under, 1);
  other.exponent = 2L * (exponent - 53);
  int order = exact_square_compare(s, &other);
  exact_square_clear(&other);
  return order;
}

double exact_square_root(const exact_square *s) {
  if (mpz_sgn(s->over) == 0) {
    return 0;
  }
  long over;
  long under;
  double ratio = mpz_get_d_2exp(&over, s->over) / mpz_get_d_2exp(&under, s->under);
  long exponent = over - under + s->exponent;
  long odd = labs(exponent) % 2;
  long half = (exponent - odd) / 2;
  double near = ldexp(sqrt(ldexp(ratio, (int)odd)), (int)half);
  while (exact_square_compare_length(s, near) < 0) {
    near = nextafter(near, 0);
  }
  for (double next; next = nextafter(near, INFINITY), exact_square_compare_length(s, next) >= 0;) {
    near = next;
  }
  return near;
}

bool distance_within(const sepax_tri *a, const sepax_tri *b, int64_t limit, size_t *quick) {
  if (proved_farther(a, b, limit)) {
    if (quick != NULL) {
      ++*quick;
    }
    return false;
  }
  return distance_within_exact(a, b, limit);
}
