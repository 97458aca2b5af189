/* SPDX-License-Identifier: MIT */
/* troubles.c - what befalls a list of long jobs while their poses are on their way: the bus and the
 * memory stall, jobs end early, STOP, errors of the memory, damaged nodes, poses that are refused.
 * Each pose is compared with the golden model. */
#include "bench.h"
#include "sepax_vectors.h"
#include "util/bytes.h"

#include <stdio.h>

static sepax_random rng;
static size_t range(size_t lo, size_t hi) {
  return (size_t)sepax_random_range(&rng, (int64_t)lo, (int64_t)hi);
}

/* What a batch suffers while poses are on their way. */
typedef enum { STRESS, LEAVE, STOP, ERRORS, DAMAGE, REFUSAL, TROUBLES } trouble;

/* A byte that damages a node of any body, or a pose, when it is 0x7f: bits 23:16 of the node's
 * first child; the highest of a number of the matrix. */
static uint8_t *some_byte(trouble kind, const bench_batch *b, size_t poses) {
  const uint8_t *job = bench_at(b->list + SEPAX_TREE_JOB_BYTES * range(0, b->jobs - 1));
  const uint8_t *body = job + (range(0, 1) != 0 ? SEPAX_TREE_BODY_BYTES : 0);
  if (kind == REFUSAL) {
    size_t at = (size_t)(bytes_get64(job + 64) - bench_base);
    return bench_at(at + SEPAX_TREE_POSE_STRIDE * range(0, poses - 1) + 51); /* of the matrix */
  }
  size_t nodes = bytes_get32(body + 8);
  size_t at = (size_t)(bytes_get64(body) - bench_base);
  size_t node = range(0, nodes < 4 ? nodes - 1 : 3); /* most poses go no deeper than these */
  return bench_at(at + SEPAX_TREE_NODE_BYTES * node + 18);
}

static void with_trouble(trouble kind, const bench_batch *batch, size_t poses, bench_batch *sum) {
  bench_batch one = *batch;
  memory_options options = {.latency = 100, .stress = range(1, 1000000)};
  uint8_t *byte = NULL, kept = 0;
  if (kind == STOP) {
    one.stop_at = (int)range(0, poses * one.jobs - 1);
  } else if (kind == ERRORS) {
    options.error_odds = range(1000, 20 * poses);
    one.errors = true;
  } else if (kind == DAMAGE || kind == REFUSAL) {
    byte = some_byte(kind, &one, poses);
    kept = *byte;
    *byte = 0x7f;
    one.any = kind == DAMAGE;
  }
  for (uint32_t n = 0; n < one.jobs; n++) {
    uint8_t *modes = bench_at(one.list + SEPAX_TREE_JOB_BYTES * n + 76);
    *modes = SEPAX_TREE_FIRST | SEPAX_TREE_AGAIN;
    *modes |= (uint8_t)(kind == LEAVE && range(0, 1) != 0 ? SEPAX_TREE_LEAVE : 0);
  }
  bench_attach(options);
  bench_run(&one);
  if (byte != NULL) {
    *byte = kept;
  }
  sum->poses += one.poses;
  sum->hits += one.hits;
  sum->stopped += one.stopped;
  sum->damaged += one.damaged;
  sum->bus += one.bus;
  sum->refused += one.refused;
  sum->mismatches += one.mismatches;
}

void bench_troubles(const bench_batch *batch, size_t poses, uint64_t seed) {
  static const struct {
    const char *name;
    int batches;
  } troubles[TROUBLES] = {{"STRESS", 1}, {"LEAVE", 3},  {"STOP", 5},
                          {"errors", 9}, {"damage", 9}, {"refusals", 5}};
  uint64_t mismatches = 0;
  rng.state = seed;
  printf("%10s %8s %9s %8s %8s %8s %8s %8s %10s\n", "", "batches", "poses", "collide", "stopped",
         "damaged", "errors", "refused", "mismatches");
  for (trouble kind = STRESS; kind < TROUBLES; kind++) {
    bench_batch sum = {.list = 0};
    for (int n = 0; n < troubles[kind].batches; n++) {
      with_trouble(kind, batch, poses, &sum);
    }
    printf("%10s %8d %9llu %8llu %8llu %8llu %8llu %8llu %10llu\n", troubles[kind].name,
           troubles[kind].batches, (unsigned long long)sum.poses, (unsigned long long)sum.hits,
           (unsigned long long)sum.stopped, (unsigned long long)sum.damaged,
           (unsigned long long)sum.bus, (unsigned long long)sum.refused,
           (unsigned long long)sum.mismatches);
    fflush(stdout);
    mismatches += sum.mismatches;
  }
  printf("%zu poses of %u pairs of bodies in trouble, %llu mismatches\n", poses, batch->jobs,
         (unsigned long long)mismatches);
}
