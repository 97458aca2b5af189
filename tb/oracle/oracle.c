/* SPDX-License-Identifier: MIT */
#include "oracle.h"
#include "gmp_vec.h"

#include <limits.h>
#include <math.h>

typedef struct {
  const vec *v, *normal;
  size_t drop; /* normal.c[drop] is not zero; 3 if the triangle has no area */
} triangle;

/* The first component that is not zero, or 3. */
static size_t vec_pivot(const vec *a) {
  size_t i = 0;
  while (i < 3 && mpz_sgn(a->c[i]) == 0)
    i++;
  return i;
}

/* Point x on the closed segment pq: on its line and in its box. */
static bool point_on_segment(work *w, const vec *x, const vec *p, const vec *q) {
  vec_sub(&w->u, q, p);
  vec_sub(&w->d, x, p);
  vec_cross(&w->e, &w->u, &w->d);
  if (vec_pivot(&w->e) < 3)
    return false;
  for (size_t i = 0; i < 3; i++) {
    int to_p = mpz_cmp(x->c[i], p->c[i]);
    int to_q = mpz_cmp(x->c[i], q->c[i]);
    if ((to_p < 0 && to_q < 0) || (to_p > 0 && to_q > 0))
      return false;
  }
  return true;
}

/* Closed segments pq and rs: a common perpendicular of length 0, or, when they are parallel or
 * points, p or q on rs or rs inside pq. */
static bool segments_meet(work *w, const vec *p, const vec *q, const vec *r, const vec *s) {
  bool inside = perpendicular_meets(w, p, q, r, s);
  if (mpz_sgn(w->square) == 0)
    return point_on_segment(w, p, r, s) || point_on_segment(w, q, r, s) ||
           point_on_segment(w, r, p, q);
  vec_dot(w->s, &w->d, &w->c);
  return inside && mpz_sgn(w->s) == 0;
}

/* Point x / scale of the plane of t, which has an area: in the projection along
 * axis t->drop it is not left of one edge and right of another. */
static bool point_in_triangle(work *w, const vec *x, const mpz_t scale, const triangle *t) {
  size_t i = (t->drop + 1) % 3;
  size_t j = (t->drop + 2) % 3;
  bool left = false;
  bool right = false;
  for (size_t k = 0; k < 3; k++) {
    const vec *p = &t->v[k];
    vec_sub(&w->u, &t->v[(k + 1) % 3], p);
    mpz_set(w->d.c[i], x->c[i]);
    mpz_submul(w->d.c[i], scale, p->c[i]);
    mpz_set(w->d.c[j], x->c[j]);
    mpz_submul(w->d.c[j], scale, p->c[j]);
    mpz_mul(w->s, w->u.c[i], w->d.c[j]);
    mpz_submul(w->s, w->u.c[j], w->d.c[i]);
    left = left || mpz_sgn(w->s) > 0;
    right = right || mpz_sgn(w->s) < 0;
  }
  return !(left && right);
}

static bool segment_meets_edges(work *w, const vec *p, const vec *q, const triangle *t) {
  for (size_t k = 0; k < 3; k++)
    if (segments_meet(w, p, q, &t->v[k], &t->v[(k + 1) % 3]))
      return true;
  return false;
}

/* r = normal . (p - v0): zero for p in the plane of t. */
static void plane_distance(work *w, mpz_t r, const vec *p, const triangle *t) {
  vec_sub(&w->d, p, &t->v[0]);
  vec_dot(r, t->normal, &w->d);
}

static bool segment_meets_triangle(work *w, const vec *p, const vec *q, const triangle *t) {
  if (t->drop == 3)
    return segment_meets_edges(w, p, q, t);
  plane_distance(w, w->distance, p, t);
  plane_distance(w, w->t, q, t);
  int side_p = mpz_sgn(w->distance);
  int side_q = mpz_sgn(w->t);
  if (side_p == 0 && side_q == 0) {
    mpz_set_ui(w->square, 1);
    return point_in_triangle(w, p, w->square, t) || segment_meets_edges(w, p, q, t);
  }
  if (side_p == side_q)
    return false;
  /* pq crosses the plane in (dp q - dq p) / (dp - dq). */
  for (size_t i = 0; i < 3; i++) {
    mpz_mul(w->x.c[i], w->distance, q->c[i]);
    mpz_submul(w->x.c[i], w->t, p->c[i]);
  }
  mpz_sub(w->square, w->distance, w->t);
  return point_in_triangle(w, &w->x, w->square, t);
}

static bool edges_meet(work *w) {
  bool meet = false;
  for (size_t i = 0; i < 2; i++) {
    const triangle t = {&w->p[3 * i], &w->n[i], vec_pivot(&w->n[i])};
    const vec *v = &w->p[3 * (1 - i)];
    for (size_t k = 0; k < 3; k++)
      meet = meet || segment_meets_triangle(w, &v[k], &v[(k + 1) % 3], &t);
  }
  return meet;
}

bool oracle_collide(const sepax_tri *a, const sepax_tri *b) {
  work w;
  work_init(&w, a, b);
  bool meet = edges_meet(&w);
  work_clear(&w);
  return meet;
}

/* factor[0] * factor[1] * 2^exponent; a factor of 0 and any exponent for zero. */
typedef struct {
  int64_t factor[2];
  int exponent;
} term;

static term term_of(double p, double q) {
  const double x[2] = {p, q};
  term t = {{0, 0}, 0};
  for (int i = 0; i < 2; i++) {
    int exponent;
    t.factor[i] = (int64_t)ldexp(frexp(x[i], &exponent), 53);
    if (t.factor[i] != 0) {
      int zeros = __builtin_ctzll((unsigned long long)t.factor[i]);
      t.factor[i] /= (int64_t)1 << zeros;
      t.exponent += exponent - 53 + zeros;
    }
  }
  return t;
}

/* Coordinate `axis` of a posed vertex: four terms. */
static void find_terms(term t[4], const double v[3], const sepax_pose *pose, int axis) {
  for (int k = 0; k < 3; k++) {
    t[k] = pose != NULL ? term_of(pose->rotation[axis][k], v[k]) : term_of(k == axis, v[k]);
  }
  t[3] = term_of(pose != NULL ? pose->translation[axis] : 0, 1);
}

int work_init_posed(work *w, const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                    const sepax_pose *pose_b, double limit) {
  enum { LIMIT = 18 };
  term t[LIMIT + 1][4] = {{{{0, 0}, 0}}};
  int lowest = INT_MAX; /* exponent; times two to minus this all numbers are integers */
  for (int i = 0; i < LIMIT; i++) {
    find_terms(t[i], i < 9 ? a[i / 3] : b[i / 3 - 3], i < 9 ? pose_a : pose_b, i % 3);
  }
  t[LIMIT][0] = term_of(limit, 1);
  for (int i = 0; i < 4 * (LIMIT + 1); i++) {
    const term *one = &t[i / 4][i % 4];
    bool zero = one->factor[0] == 0 || one->factor[1] == 0;
    lowest = !zero && one->exponent < lowest ? one->exponent : lowest;
  }
  work_new(w);
  for (int i = 0; i < 4 * (LIMIT + 1); i++) {
    const term *one = &t[i / 4][i % 4];
    mpz_ptr r = i / 4 == LIMIT ? w->limit : w->p[i / 12].c[i / 4 % 3];
    if (one->factor[0] != 0 && one->factor[1] != 0) {
      mpz_set_si(w->s, one->factor[0]);
      mpz_mul_si(w->s, w->s, one->factor[1]);
      mpz_mul_2exp(w->s, w->s, (mp_bitcnt_t)(one->exponent - lowest));
      mpz_add(r, r, w->s);
    }
  }
  work_normals(w);
  return lowest;
}

bool oracle_collide_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                          const sepax_pose *pose_b) {
  work w;
  work_init_posed(&w, a, pose_a, b, pose_b, 0);
  bool meet = edges_meet(&w);
  work_clear(&w);
  return meet;
}

/* The segment in which triangle v meets the plane of t, by coordinate `axis` of its ends. False
 * where v is not on both sides of the plane. */
static bool segment_in_plane(work *w, const vec v[3], const triangle *t, size_t axis,
                             mpq_t end[2]) {
  bool above = false;
  bool below = false;
  size_t ends = 0;
  mpq_t x;
  mpq_init(x);
  for (size_t k = 0; k < 3; k++) {
    const vec *p = &v[k];
    const vec *q = &v[(k + 1) % 3];
    plane_distance(w, w->distance, p, t);
    plane_distance(w, w->t, q, t);
    above = above || mpz_sgn(w->distance) > 0;
    below = below || mpz_sgn(w->distance) < 0;
    if (mpz_sgn(w->distance) * mpz_sgn(w->t) > 0 || mpz_cmp(w->distance, w->t) == 0)
      continue;
    mpz_mul(mpq_numref(x), w->distance, q->c[axis]);
    mpz_submul(mpq_numref(x), w->t, p->c[axis]);
    mpz_sub(mpq_denref(x), w->distance, w->t);
    mpq_canonicalize(x);
    if (ends == 0 || mpq_cmp(x, end[0]) < 0)
      mpq_set(end[0], x);
    if (ends == 0 || mpq_cmp(x, end[1]) > 0)
      mpq_set(end[1], x);
    ends++;
  }
  mpq_clear(x);
  return above && below;
}

bool oracle_strict_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                         const sepax_pose *pose_b) {
  work w;
  mpq_t end[2][2];
  work_init_posed(&w, a, pose_a, b, pose_b, 0);
  vec_cross(&w.c, &w.n[0], &w.n[1]);
  size_t axis = vec_pivot(&w.c);
  bool strict = axis < 3;
  for (size_t i = 0; i < 2; i++) {
    const triangle other = {&w.p[3 - 3 * i], &w.n[1 - i], 0};
    mpq_inits(end[i][0], end[i][1], NULL);
    strict = strict && segment_in_plane(&w, &w.p[3 * i], &other, axis, end[i]);
  }
  strict = strict && mpq_cmp(end[0][0], end[1][1]) < 0 && mpq_cmp(end[1][0], end[0][1]) < 0;
  for (size_t i = 0; i < 2; i++)
    mpq_clears(end[i][0], end[i][1], NULL);
  work_clear(&w);
  return strict;
}

bool oracle_coplanar(const sepax_tri *a, const sepax_tri *b) {
  work w;
  work_init(&w, a, b);
  /* u: from the first vertex to another point, c: normal to u and a third. */
  bool line = false;
  bool plane = false;
  bool coplanar = true;
  for (size_t i = 1; i < 6 && coplanar; i++) {
    vec_sub(line ? &w.d : &w.u, &w.p[i], &w.p[0]);
    if (plane) {
      vec_dot(w.s, &w.c, &w.d);
      coplanar = mpz_sgn(w.s) == 0;
    } else if (line) {
      vec_cross(&w.c, &w.u, &w.d);
      plane = vec_pivot(&w.c) < 3;
    } else {
      line = vec_pivot(&w.u) < 3;
    }
  }
  work_clear(&w);
  return coplanar;
}
