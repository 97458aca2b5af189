/* SPDX-License-Identifier: MIT */
#include "bodies.h"

#include <assert.h>
#include <float.h>
#include <math.h>
#include <stdlib.h>

/* A vertex in its pose, less the common origin. */
typedef struct {
  long double c[3];
} place;

/* All vertices of both bodies. */
typedef struct {
  place *vertex[2];
  long double error; /* of a coordinate of a place */
  int exponent;      /* places are below 2^exponent */
} places;

/* A pair's distance, rounded, and less than that what is certain. */
typedef struct {
  double rounded;
  long double least;
} estimate;

/* Each coordinate is three products and four sums; the error of all is less than 8 roundings of the
 * sum of their absolute values, and those of both bodies are as large as `error` together. */
static void find_places(places *p, const oracle_body *const body[2]) {
  long double largest = 0;
  long double origin[3] = {0, 0, 0};
  long double farthest = 0;
  for (int k = 0; k < 2; k++) {
    p->vertex[k] = calloc(3 * body[k]->count, sizeof(place));
    assert(p->vertex[k] != NULL);
    for (size_t n = 0; n < 9 * body[k]->count; n++) {
      const double *v = body[k]->facet[n / 9].v[n / 3 % 3];
      const sepax_pose *pose = body[k]->pose;
      long double sum = 0;
      long double size = 0;
      for (int i = 0; i < 3; i++) {
        long double by = pose != NULL ? pose->rotation[n % 3][i] : (size_t)i == n % 3;
        sum += by * (long double)v[i];
        size += fabsl(by * (long double)v[i]);
      }
      sum += pose != NULL ? (long double)pose->translation[n % 3] : 0;
      size += pose != NULL ? fabsl((long double)pose->translation[n % 3]) : 0;
      origin[n % 3] = k == 0 && n < 3 ? sum : origin[n % 3];
      p->vertex[k][n / 3].c[n % 3] = sum - origin[n % 3];
      largest = fmaxl(largest, size);
      farthest = fmaxl(farthest, fabsl(sum - origin[n % 3]));
    }
  }
  p->error = 32 * LDBL_EPSILON * largest;
  (void)frexpl(farthest, &p->exponent);
}

static estimate find_estimate(const places *p, size_t i, size_t j) {
  double rounded[2][3][3];
  double way[3];
  long double size = 0;
  long double square = 0;
  long double low = INFINITY;
  long double high = -INFINITY;
  for (int k = 0; k < 9; k++) {
    rounded[0][k / 3][k % 3] =
        (double)ldexpl(p->vertex[0][3 * i + (size_t)k / 3].c[k % 3], -p->exponent);
    rounded[1][k / 3][k % 3] =
        (double)ldexpl(p->vertex[1][3 * j + (size_t)k / 3].c[k % 3], -p->exponent);
  }
  double distance =
      distance_rounded_real((const double(*)[3])rounded[0], (const double(*)[3])rounded[1], way);
  for (int k = 0; k < 3; k++) {
    size += fabsl((long double)way[k]);
    square += (long double)way[k] * (long double)way[k];
  }
  estimate e = {distance, 0};
  if (!(size > 0x1p-400L)) {
    return e;
  }
  for (int k = 0; k < 3; k++) {
    long double of_a = 0;
    long double of_b = 0;
    for (int c = 0; c < 3; c++) {
      of_a += (long double)way[c] * p->vertex[0][3 * i + (size_t)k].c[c];
      of_b += (long double)way[c] * p->vertex[1][3 * j + (size_t)k].c[c];
    }
    high = fmaxl(high, of_a);
    low = fminl(low, of_b);
  }
  /* The places and the sums of products, in A and in B. */
  long double lost = 2 * size * (p->error + 8 * LDBL_EPSILON * ldexpl(1, p->exponent));
  e.least = (low - high - lost) / sqrtl(square) * (1 - 0x1p-58L);
  return e;
}

void oracle_bodies_square(exact_square *least, const oracle_body *a, const oracle_body *b) {
  const oracle_body *const body[2] = {a, b};
  places p;
  find_places(&p, body);
  size_t pairs = a->count * b->count;
  estimate *list = calloc(pairs, sizeof *list);
  assert(list != NULL && pairs > 0);
  size_t first = 0;
  for (size_t n = 0; n < pairs; n++) {
    list[n] = find_estimate(&p, n / b->count, n % b->count);
    first = list[n].rounded < list[first].rounded ? n : first;
  }
  distance_square_posed(least, a->facet[first / b->count].v, a->pose, b->facet[first % b->count].v,
                        b->pose);
  exact_square other;
  exact_square_init(&other);
  long double enough = nextafter(exact_square_root(least), INFINITY);
  for (size_t n = 0; n < pairs; n++) {
    if (n == first || list[n].least > enough) {
      continue;
    }
    distance_square_posed(&other, a->facet[n / b->count].v, a->pose, b->facet[n % b->count].v,
                          b->pose);
    if (exact_square_compare(&other, least) < 0) {
      mpz_swap(least->over, other.over);
      mpz_swap(least->under, other.under);
      least->exponent = other.exponent;
      enough = nextafter(exact_square_root(least), INFINITY);
    }
  }
  exact_square_clear(&other);
  free(list);
  free(p.vertex[0]);
  free(p.vertex[1]);
}
