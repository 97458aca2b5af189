/* SPDX-License-Identifier: MIT */
/* gmp_vec.h - vectors of integers of any size, and what both oracles compute with. */
#ifndef SEPAX_GMP_VEC_H
#define SEPAX_GMP_VEC_H

#include "sepax_models.h"

#include <gmp.h>

typedef struct {
  mpz_t c[3];
} vec;

static inline void vec_set(vec *r, const sepax_vec *a) {
  mpz_set_si(r->c[0], a->x);
  mpz_set_si(r->c[1], a->y);
  mpz_set_si(r->c[2], a->z);
}

static inline void vec_sub(vec *r, const vec *a, const vec *b) {
  for (int i = 0; i < 3; i++) {
    mpz_sub(r->c[i], a->c[i], b->c[i]);
  }
}

/* r is neither a nor b. */
static inline void vec_cross(vec *r, const vec *a, const vec *b) {
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    mpz_mul(r->c[i], a->c[j], b->c[k]);
    mpz_submul(r->c[i], a->c[k], b->c[j]);
  }
}

static inline void vec_dot(mpz_t r, const vec *a, const vec *b) {
  mpz_mul(r, a->c[0], b->c[0]);
  mpz_addmul(r, a->c[1], b->c[1]);
  mpz_addmul(r, a->c[2], b->c[2]);
}

/* The numbers of a pair. */
typedef union {
  struct {
    vec p[6];             /* the vertices: three of A, three of B */
    vec n[2];             /* the normals of A, of B */
    vec u, v, d, c, e, x; /* temporaries */
    mpz_t s, t, square, distance, limit;
    mpz_t over, under; /* over / under: the least square so far (distance.c) */
  };
  mpz_t all[3 * 14 + 7];
} work;

static inline void work_new(work *w) {
  for (size_t i = 0; i < sizeof w->all / sizeof *w->all; i++) {
    mpz_init(w->all[i]);
  }
}

static inline void work_normals(work *w) {
  for (int i = 0; i < 2; i++) {
    vec_sub(&w->u, &w->p[3 * i + 1], &w->p[3 * i]);
    vec_sub(&w->v, &w->p[3 * i + 2], &w->p[3 * i]);
    vec_cross(&w->n[i], &w->u, &w->v);
  }
}

static inline void work_init(work *w, const sepax_tri *a, const sepax_tri *b) {
  work_new(w);
  for (int i = 0; i < 6; i++) {
    vec_set(&w->p[i], i < 3 ? &a->v[i] : &b->v[i - 3]);
  }
  work_normals(w);
}

/* Vertices of doubles in poses (NULL: as they are) and the limit, times a power of two that makes
 * them integers (oracle.c). Returns the exponent of the unit of these integers. */
int work_init_posed(work *w, const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                    const sepax_pose *pose_b, double limit);

static inline void work_clear(work *w) {
  for (size_t i = 0; i < sizeof w->all / sizeof *w->all; i++) {
    mpz_clear(w->all[i]);
  }
}

/* True iff ((d x along) . c) / (c . c), with c . c in `square`, is in 0 ... 1. */
static inline bool parameter_inside(work *w, const vec *along) {
  vec_cross(&w->e, &w->d, along);
  vec_dot(w->s, &w->e, &w->c);
  return mpz_sgn(w->s) >= 0 && mpz_cmp(w->s, w->square) <= 0;
}

/* True iff the common perpendicular of segments pq and rs, which are not parallel, meets both. With
 * u = q - p, v = s - r, d = r - p, c = u x v its ends are p + l u and r + m v for
 * l = (d x v) . c / c . c and m = (d x u) . c / c . c. */
static inline bool perpendicular_meets(work *w, const vec *p, const vec *q, const vec *r,
                                       const vec *s) {
  vec_sub(&w->u, q, p);
  vec_sub(&w->v, s, r);
  vec_sub(&w->d, r, p);
  vec_cross(&w->c, &w->u, &w->v);
  vec_dot(w->square, &w->c, &w->c);
  return mpz_sgn(w->square) != 0 && parameter_inside(w, &w->v) && parameter_inside(w, &w->u);
}

#endif
