/* SPDX-License-Identifier: MIT */
/* verdicts.c - pairs a second of the software verdicts on one core, side by side on the same
 * pairs of W = 18: first the families uniform and local in turn, 48 % of which collide,
 * then each family, of which the slowest is told. Best of ROUNDS rounds, the argument (5). */
#include "columns.h"

#include <stdio.h>

enum { PAIRS = 1 << 15 };

typedef struct {
  sepax_pair *pair;
  pair_columns batch;
  sepax_design paper;
} work;

typedef size_t method_function(const work *w);

/* How many of all pairs collide, one by one. */
#define SINGLY(name, verdict)            \
  static size_t name(const work *w) {    \
    size_t collisions = 0;               \
    for (size_t n = 0; n < PAIRS; n++) { \
      const sepax_pair *p = &w->pair[n]; \
      collisions += (verdict);           \
    }                                    \
    return collisions;                   \
  }

SINGLY(exact, sepax_exact(&p->a, &p->b).collision)
SINGLY(reference, sepax_reference(&p->a, &p->b))
SINGLY(sat54, sepax_sat54(&p->a, &p->b))
SINGLY(float64, sepax_float64(&p->a, &p->b))
SINGLY(float32, sepax_float32(&p->a, &p->b))
SINGLY(interval64, sepax_interval64(&p->a, &p->b))
SINGLY(interval32, sepax_interval32(&p->a, &p->b))
SINGLY(guigue64, sepax_guigue64(&p->a, &p->b))
SINGLY(guigue32, sepax_guigue32(&p->a, &p->b))
SINGLY(filtered, sepax_filtered(&p->a, &p->b, NULL))
SINGLY(paper, sepax_paper(&w->paper, p).collision)

static size_t by_simd(const work *w, sepax_simd simd) {
  size_t collisions = 0;
  sepax_exact_pairs(simd, &w->batch.a, &w->batch.b, PAIRS, w->batch.bits);
  for (size_t n = 0; n < PAIRS / 64; n++) {
    collisions += (size_t)__builtin_popcountll(w->batch.bits[n]);
  }
  return collisions;
}

static size_t portable(const work *w) { return by_simd(w, SEPAX_SIMD_PORTABLE); }
static size_t avx2(const work *w) { return by_simd(w, SEPAX_SIMD_AVX2); }
static size_t avx512(const work *w) { return by_simd(w, SEPAX_SIMD_AVX512); }

static const struct {
  const char *name;
  method_function *run;
  sepax_simd simd;
} methods[] = {{"exact", exact, SEPAX_SIMD_BEST},
               {"avx512", avx512, SEPAX_SIMD_AVX512},
               {"avx2", avx2, SEPAX_SIMD_AVX2},
               {"portable", portable, SEPAX_SIMD_PORTABLE},
               {"float64", float64, SEPAX_SIMD_BEST},
               {"float32", float32, SEPAX_SIMD_BEST},
               {"interval64", interval64, SEPAX_SIMD_BEST},
               {"interval32", interval32, SEPAX_SIMD_BEST},
               {"guigue64", guigue64, SEPAX_SIMD_BEST},
               {"guigue32", guigue32, SEPAX_SIMD_BEST},
               {"filtered", filtered, SEPAX_SIMD_BEST},
               {"reference", reference, SEPAX_SIMD_BEST},
               {"sat54", sat54, SEPAX_SIMD_BEST},
               {"paper", paper, SEPAX_SIMD_BEST}};
enum { METHODS = sizeof methods / sizeof methods[0] };

typedef struct {
  double rate;
  size_t collisions;
} result;

/* Family -1: uniform and local in turn. */
static void draw(work *w, int family) {
  sepax_random random = {1};
  for (size_t n = 0; n < PAIRS; n++) {
    w->pair[n] = sepax_family_pair(family < 0 ? n % 2 : (size_t)family, 18, &random);
    columns_set(&w->batch, n, &w->pair[n]);
  }
}

static void measure(const work *w, int rounds, result results[METHODS]) {
  for (int round = 0; round < rounds; round++) {
    for (int i = 0; i < METHODS; i++) {
      if (!sepax_simd_runs(methods[i].simd)) {
        continue;
      }
      double start = seconds_now();
      results[i].collisions = methods[i].run(w);
      double rate = PAIRS / (seconds_now() - start);
      results[i].rate = rate > results[i].rate ? rate : results[i].rate;
    }
  }
}

int main(int argc, char **argv) {
  int rounds = argc > 1 ? atoi(argv[1]) : 5;
  sepax_config config = sepax_config_default();
  config.arch = SEPAX_ARCH_PAPER;
  work w = {.pair = allocate(PAIRS * sizeof(sepax_pair)),
            .batch = columns_of(PAIRS),
            .paper = design_from(config)};
  result usual[METHODS] = {{0, 0}};
  result least[METHODS] = {{0, 0}};
  size_t slowest[METHODS] = {0};
  draw(&w, -1);
  measure(&w, rounds, usual);
  for (int family = 0; sepax_family_name((size_t)family) != NULL; family++) {
    result here[METHODS] = {{0, 0}};
    draw(&w, family);
    measure(&w, rounds, here);
    for (int i = 0; i < METHODS; i++) {
      if (family == 0 || here[i].rate < least[i].rate) {
        least[i] = here[i];
        slowest[i] = (size_t)family;
      }
    }
  }
  printf("%-10s %12s %10s %12s %14s %10s  %s\n", "verdict", "pairs/s", "ratio", "collisions",
         "slowest: pairs/s", "ratio", "family");
  for (int i = 0; i < METHODS; i++) {
    if (sepax_simd_runs(methods[i].simd)) {
      printf("%-10s %12.0f %10.2f %12zu %16.0f %10.2f  %s\n", methods[i].name, usual[i].rate,
             usual[i].rate / usual[0].rate, usual[i].collisions, least[i].rate,
             least[i].rate / least[0].rate, sepax_family_name(slowest[i]));
    }
  }
  free(w.pair);
  columns_free(&w.batch);
  return 0;
}
