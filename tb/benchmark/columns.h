/* SPDX-License-Identifier: MIT */
/* columns.h - what benchmarks and tb/pairs share: the clock, designs, pairs as columns. */
#ifndef BENCHMARK_COLUMNS_H
#define BENCHMARK_COLUMNS_H

#include "sepax_design.h"
#include "sepax_vectors.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static inline double seconds_now(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline void __attribute__((noreturn)) bench_fail(const sepax_error *error) {
  fprintf(stderr, "bench: %s\n", error->text);
  exit(2);
}

static inline sepax_design design_from(sepax_config config) {
  sepax_design design;
  sepax_error error = {0};
  if (!sepax_design_init(&design, &config, &error)) {
    bench_fail(&error);
  }
  return design;
}

static inline void *allocate(size_t bytes) {
  void *memory = malloc(bytes);
  if (memory == NULL) {
    fputs("benchmark: no memory\n", stderr);
    exit(2);
  }
  return memory;
}

/* Pairs as columns. */
typedef struct {
  int32_t *column[18];
  sepax_columns a, b;
  uint64_t *bits;
} pair_columns;

static inline pair_columns columns_of(size_t pairs) {
  pair_columns batch = {.bits = allocate((pairs + 63) / 64 * sizeof *batch.bits)};
  for (int i = 0; i < 18; i++) {
    batch.column[i] = allocate(pairs * sizeof **batch.column);
    (i < 9 ? &batch.a : &batch.b)->c[i / 3 % 3][i % 3] = batch.column[i];
  }
  return batch;
}

static inline void columns_free(pair_columns *batch) {
  for (int i = 0; i < 18; i++) {
    free(batch->column[i]);
  }
  free(batch->bits);
}

static inline void columns_set(pair_columns *batch, size_t n, const sepax_pair *pair) {
  for (int i = 0; i < 18; i++) {
    const sepax_vec *v = i < 9 ? &pair->a.v[i / 3] : &pair->b.v[i / 3 - 3];
    batch->column[i][n] = i % 3 == 0 ? v->x : i % 3 == 1 ? v->y : v->z;
  }
}

static inline bool bit_at(const uint64_t *bits, size_t n) {
  return (bits[n / 64] >> n % 64 & 1) != 0;
}

#endif
