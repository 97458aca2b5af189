/* bench.h - what the software benches share: the clock, pairs as columns. */
#ifndef BENCH_H
#define BENCH_H

#include "sepax.h"

#include <stdlib.h>
#include <time.h>

static inline double bench_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_MONOTONIC, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static inline void __attribute__((noreturn)) bench_fail(const sepax_error *error) {
  fprintf(stderr, "bench: %s\n", error->text);
  exit(2);
}

static inline void *bench_room(size_t bytes) {
  void *room = malloc(bytes);
  if (room == NULL) {
    fputs("bench: no memory\n", stderr);
    exit(2);
  }
  return room;
}

/* Room for pairs as columns. */
typedef struct {
  int32_t *column[18];
  sepax_columns a, b;
  uint64_t *bits;
} bench_batch;

static inline bench_batch bench_batch_of(size_t pairs) {
  bench_batch batch = {.bits = bench_room((pairs + 63) / 64 * sizeof *batch.bits)};
  for (int i = 0; i < 18; i++) {
    batch.column[i] = bench_room(pairs * sizeof **batch.column);
    (i < 9 ? &batch.a : &batch.b)->c[i / 3 % 3][i % 3] = batch.column[i];
  }
  return batch;
}

static inline void bench_batch_free(bench_batch *batch) {
  for (int i = 0; i < 18; i++) {
    free(batch->column[i]);
  }
  free(batch->bits);
}

static inline void bench_batch_set(bench_batch *batch, size_t n, const sepax_pair *pair) {
  for (int i = 0; i < 18; i++) {
    const sepax_vec *v = i < 9 ? &pair->a.v[i / 3] : &pair->b.v[i / 3 - 3];
    batch->column[i][n] = i % 3 == 0 ? v->x : i % 3 == 1 ? v->y : v->z;
  }
}

static inline bool bench_bit(const uint64_t *bits, size_t n) {
  return (bits[n / 64] >> n % 64 & 1) != 0;
}

#endif
