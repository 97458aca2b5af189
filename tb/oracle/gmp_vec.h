/* gmp_vec.h - vectors of integers of any size, for the oracles. */
#ifndef SEPAX_GMP_VEC_H
#define SEPAX_GMP_VEC_H

#include <gmp.h>

typedef struct {
  mpz_t c[3];
} vec;

static inline void vec_init(vec *a) { mpz_inits(a->c[0], a->c[1], a->c[2], NULL); }

static inline void vec_clear(vec *a) { mpz_clears(a->c[0], a->c[1], a->c[2], NULL); }

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

#endif
