#include "gmp_vec.h"
#include "oracle.h"

typedef struct {
  vec v[3];
  vec normal;
  size_t drop; /* normal.c[drop] is not zero; 3 if the triangle has no area */
} triangle;

typedef struct {
  triangle t[2];
  vec u, v, d, c, cross, point; /* temporaries */
  mpz_t s, w, dp, dq;
} work;

static void vec_set(vec *r, const sepax_vec *a) {
  mpz_set_si(r->c[0], a->x);
  mpz_set_si(r->c[1], a->y);
  mpz_set_si(r->c[2], a->z);
}

/* The first component that is not zero, or 3. */
static size_t vec_pivot(const vec *a) {
  size_t i = 0;
  while (i < 3 && mpz_sgn(a->c[i]) == 0)
    i++;
  return i;
}

static void work_init(work *w, const sepax_tri *a, const sepax_tri *b) {
  vec *temporary[] = {&w->u, &w->v, &w->d, &w->c, &w->cross, &w->point};
  for (size_t i = 0; i < sizeof temporary / sizeof *temporary; i++)
    vec_init(temporary[i]);
  mpz_inits(w->s, w->w, w->dp, w->dq, NULL);
  for (size_t i = 0; i < 2; i++) {
    triangle *t = &w->t[i];
    for (size_t k = 0; k < 3; k++) {
      vec_init(&t->v[k]);
      vec_set(&t->v[k], i == 0 ? &a->v[k] : &b->v[k]);
    }
    vec_sub(&w->u, &t->v[1], &t->v[0]);
    vec_sub(&w->v, &t->v[2], &t->v[0]);
    vec_init(&t->normal);
    vec_cross(&t->normal, &w->u, &w->v);
    t->drop = vec_pivot(&t->normal);
  }
}

static void work_clear(work *w) {
  vec *temporary[] = {&w->u, &w->v, &w->d, &w->c, &w->cross, &w->point};
  for (size_t i = 0; i < sizeof temporary / sizeof *temporary; i++)
    vec_clear(temporary[i]);
  mpz_clears(w->s, w->w, w->dp, w->dq, NULL);
  for (size_t i = 0; i < 2; i++) {
    for (size_t k = 0; k < 3; k++)
      vec_clear(&w->t[i].v[k]);
    vec_clear(&w->t[i].normal);
  }
}

/* Point x on the closed segment pq: on its line and in its box. */
static bool point_on_segment(work *w, const vec *x, const vec *p, const vec *q) {
  vec_sub(&w->u, q, p);
  vec_sub(&w->d, x, p);
  vec_cross(&w->cross, &w->u, &w->d);
  if (vec_pivot(&w->cross) < 3)
    return false;
  for (size_t i = 0; i < 3; i++) {
    int to_p = mpz_cmp(x->c[i], p->c[i]);
    int to_q = mpz_cmp(x->c[i], q->c[i]);
    if ((to_p < 0 && to_q < 0) || (to_p > 0 && to_q > 0))
      return false;
  }
  return true;
}

/* True iff ((d x e) . c) / (c . c), with c . c in w->w, is in 0 ... 1. */
static bool parameter_in_segment(work *w, const vec *e) {
  vec_cross(&w->cross, &w->d, e);
  vec_dot(w->s, &w->cross, &w->c);
  return mpz_sgn(w->s) >= 0 && mpz_cmp(w->s, w->w) <= 0;
}

/* Closed segments pq and rs. With u = q - p, v = s - r, d = r - p, c = u x v:
 * p + l u = r + m v has l = (d x v) . c / c . c and m = (d x u) . c / c . c. When
 * c = 0 they are parallel or points and meet iff p or q is on rs or rs inside pq. */
static bool segments_meet(work *w, const vec *p, const vec *q, const vec *r, const vec *s) {
  vec_sub(&w->u, q, p);
  vec_sub(&w->v, s, r);
  vec_cross(&w->c, &w->u, &w->v);
  if (vec_pivot(&w->c) == 3)
    return point_on_segment(w, p, r, s) || point_on_segment(w, q, r, s) ||
           point_on_segment(w, r, p, q);
  vec_sub(&w->d, r, p);
  vec_dot(w->s, &w->d, &w->c);
  if (mpz_sgn(w->s) != 0)
    return false;
  vec_dot(w->w, &w->c, &w->c);
  return parameter_in_segment(w, &w->v) && parameter_in_segment(w, &w->u);
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
  vec_dot(r, &t->normal, &w->d);
}

static bool segment_meets_triangle(work *w, const vec *p, const vec *q, const triangle *t) {
  if (t->drop == 3)
    return segment_meets_edges(w, p, q, t);
  plane_distance(w, w->dp, p, t);
  plane_distance(w, w->dq, q, t);
  if (mpz_sgn(w->dp) == 0 && mpz_sgn(w->dq) == 0) {
    mpz_set_ui(w->w, 1);
    return point_in_triangle(w, p, w->w, t) || segment_meets_edges(w, p, q, t);
  }
  if (mpz_sgn(w->dp) == mpz_sgn(w->dq))
    return false;
  /* pq crosses the plane in (dp q - dq p) / (dp - dq). */
  for (size_t i = 0; i < 3; i++) {
    mpz_mul(w->point.c[i], w->dp, q->c[i]);
    mpz_submul(w->point.c[i], w->dq, p->c[i]);
  }
  mpz_sub(w->w, w->dp, w->dq);
  return point_in_triangle(w, &w->point, w->w, t);
}

bool oracle_collide(const sepax_tri *a, const sepax_tri *b) {
  work w;
  work_init(&w, a, b);
  bool meet = false;
  for (size_t i = 0; i < 2 && !meet; i++) {
    const vec *v = w.t[i].v;
    for (size_t k = 0; k < 3 && !meet; k++)
      meet = segment_meets_triangle(&w, &v[k], &v[(k + 1) % 3], &w.t[1 - i]);
  }
  work_clear(&w);
  return meet;
}

bool oracle_coplanar(const sepax_tri *a, const sepax_tri *b) {
  work w;
  work_init(&w, a, b);
  /* u: from the first vertex to another point, c: normal to u and a third. */
  const vec *origin = &w.t[0].v[0];
  bool line = false;
  bool plane = false;
  bool coplanar = true;
  for (size_t i = 1; i < 6 && coplanar; i++) {
    vec_sub(&w.d, &w.t[i / 3].v[i % 3], origin);
    if (plane) {
      vec_dot(w.s, &w.c, &w.d);
      coplanar = mpz_sgn(w.s) == 0;
    } else if (line) {
      vec_cross(&w.c, &w.u, &w.d);
      plane = vec_pivot(&w.c) < 3;
    } else {
      vec_sub(&w.u, &w.t[i / 3].v[i % 3], origin);
      line = vec_pivot(&w.u) < 3;
    }
  }
  work_clear(&w);
  return coplanar;
}
