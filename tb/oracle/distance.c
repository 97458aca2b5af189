#include "distance.h"
#include "gmp_vec.h"

#include <math.h>

#include "oracle.h"

/* ---------------------------------------------------------------------- in doubles */

typedef struct {
  double c[3];
} point;

static point of(const sepax_vec *v) { return (point){{v->x, v->y, v->z}}; }

static point along(point p, double t, point u) {
  return (point){{p.c[0] + t * u.c[0], p.c[1] + t * u.c[1], p.c[2] + t * u.c[2]}};
}

static point minus(point p, point q) { return along(p, -1, q); }

static double inner(point p, point q) {
  return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2];
}

static point outer(point p, point q) {
  return (point){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                  p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

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

double distance_rounded(const sepax_tri *a, const sepax_tri *b, double way[3]) {
  point p[2][3];
  nearest n = {INFINITY, {{0, 0, 0}}};
  for (int k = 0; k < 3; k++) {
    p[0][k] = of(&a->v[k]);
    p[1][k] = of(&b->v[k]);
  }
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

typedef struct {
  vec p[6], u, v, d, c, e;
  mpz_t s, t, square, distance; /* distance: numerator of the square, `square` its denominator */
  mpz_t limit;                  /* squared */
} work;

/* distance / square <= limit, with square > 0. */
static bool near_enough(work *w) {
  mpz_mul(w->t, w->square, w->limit);
  return mpz_cmp(w->distance, w->t) <= 0;
}

static bool points_near(work *w, const vec *p, const vec *q) {
  vec_sub(&w->d, q, p);
  vec_dot(w->distance, &w->d, &w->d);
  return mpz_cmp(w->distance, w->limit) <= 0;
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

/* To the plane of a triangle, the foot being in it. */
static bool point_near_face(work *w, const vec *x, const vec t[3]) {
  vec_sub(&w->u, &t[1], &t[0]);
  vec_sub(&w->v, &t[2], &t[0]);
  vec_cross(&w->e, &w->u, &w->v);
  vec_dot(w->square, &w->e, &w->e);
  if (mpz_sgn(w->square) == 0) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    vec_sub(&w->u, &t[(k + 1) % 3], &t[k]);
    vec_sub(&w->d, x, &t[k]);
    vec_cross(&w->c, &w->u, &w->d);
    vec_dot(w->s, &w->c, &w->e);
    if (mpz_sgn(w->s) < 0) {
      return false;
    }
  }
  vec_sub(&w->d, x, &t[0]);
  vec_dot(w->s, &w->d, &w->e);
  mpz_mul(w->distance, w->s, w->s);
  return near_enough(w);
}

static bool parameter_inside(work *w, const vec *along) {
  vec_cross(&w->e, &w->d, along);
  vec_dot(w->s, &w->e, &w->c);
  return mpz_sgn(w->s) >= 0 && mpz_cmp(w->s, w->square) <= 0;
}

/* Where the common perpendicular meets both. */
static bool segments_near(work *w, const vec *p, const vec *q, const vec *r, const vec *s) {
  vec_sub(&w->u, q, p);
  vec_sub(&w->v, s, r);
  vec_sub(&w->d, r, p);
  vec_cross(&w->c, &w->u, &w->v);
  vec_dot(w->square, &w->c, &w->c);
  if (mpz_sgn(w->square) == 0 || !parameter_inside(w, &w->v) || !parameter_inside(w, &w->u)) {
    return false;
  }
  vec_dot(w->s, &w->d, &w->c);
  mpz_mul(w->distance, w->s, w->s);
  return near_enough(w);
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
    if (point_near_face(w, &a[i], b) || point_near_face(w, &b[i], a)) {
      return true;
    }
  }
  return false;
}

bool distance_within_exact(const sepax_tri *a, const sepax_tri *b, int64_t limit) {
  work w;
  vec *vectors[] = {&w.p[0], &w.p[1], &w.p[2], &w.p[3], &w.p[4], &w.p[5],
                    &w.u,    &w.v,    &w.d,    &w.c,    &w.e};
  for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) {
    vec_init(vectors[i]);
  }
  mpz_inits(w.s, w.t, w.square, w.distance, w.limit, NULL);
  for (int i = 0; i < 6; i++) {
    const sepax_vec *v = i < 3 ? &a->v[i] : &b->v[i - 3];
    mpz_set_si(w.p[i].c[0], v->x);
    mpz_set_si(w.p[i].c[1], v->y);
    mpz_set_si(w.p[i].c[2], v->z);
  }
  mpz_set_si(w.limit, (long)limit);
  mpz_mul(w.limit, w.limit, w.limit);
  bool near = any_near(&w) || oracle_collide(a, b);
  for (size_t i = 0; i < sizeof vectors / sizeof *vectors; i++) {
    vec_clear(vectors[i]);
  }
  mpz_clears(w.s, w.t, w.square, w.distance, w.limit, NULL);
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
