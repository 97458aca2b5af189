/* SPDX-License-Identifier: MIT */
/* ticks.h - the time of the object engine, cycle by cycle as docs/reference/object-engine.md tells:
 * comparator lanes that hold a triangle each, a FIFO of masks, a priority encoder, cores. It shares
 * nothing with the golden model, and takes a cycle at a time. */
#ifndef TICKS_H
#define TICKS_H

#include "harness.h"

#include <stdlib.h>
#include <string.h>

/* Passes that triangle i of A and j of B make through a core, 0 where their AABBs are disjoint. */
typedef struct {
  const bool *candidate; /* [i * count_b + j] */
  size_t count_a, count_b;
} ticks_workload;

/* The candidates found in each step, in steps[], of which there is space for ticks_steps(). */
static inline size_t ticks_steps(const ticks_workload *workload, size_t lanes) {
  size_t round = workload->count_b > lanes ? workload->count_b : lanes;
  return ((workload->count_a + lanes - 1) / lanes + 1) * round;
}

static inline size_t ticks_walk(const ticks_workload *workload, size_t lanes, unsigned *steps) {
  size_t round = workload->count_b > lanes ? workload->count_b : lanes;
  size_t held[SEPAX_LANES_MAX];
  size_t next = 0;
  size_t count = 0;
  size_t last = 0; /* steps up to the last in which some lane compares */
  for (size_t k = 0; k < lanes; k++) {
    held[k] = workload->count_a;
  }
  while (count < ticks_steps(workload, lanes)) {
    size_t j = count % round;
    if (j < lanes) { /* lane j gets a new triangle, or none */
      held[j] = next < workload->count_a ? next : workload->count_a;
      next++;
    }
    steps[count] = 0;
    bool used = false;
    for (size_t k = 0; k < lanes; k++) {
      used = used || held[k] < workload->count_a;
      if (held[k] < workload->count_a && j < workload->count_b) {
        steps[count] += workload->candidate[held[k] * workload->count_b + j];
      }
    }
    count++;
    last = used ? count : last;
  }
  return last;
}

static inline unsigned long long ticks(const unsigned *steps, size_t count, unsigned ii,
                                       size_t cores) {
  enum { MASKS = 10, BUFFER = 2, LANES_TO_FIFO = 5, AROUND_CORE = 6 };
  unsigned *fifo = malloc((count + 1) * sizeof *fifo);
  unsigned busy[SEPAX_CORES_MAX] = {0};
  size_t head = 0;
  size_t tail = 0;
  size_t step = 0;
  unsigned mask = 0;
  int buffer = 0;
  unsigned long long now = 0;
  unsigned long long walked = 0;
  unsigned long long taken = 0;
  assert_non_null(fifo);
  while (step < count || head < tail || mask > 0 || buffer > 0) {
    now++;
    if (step < count && tail - head <= MASKS) {
      fifo[tail] = steps[step];
      tail += steps[step++] > 0;
      walked = now;
    }
    bool full = buffer == BUFFER;
    size_t free = cores;
    for (size_t k = 0; k < cores; k++) {
      busy[k] -= busy[k] > 0;
      free = busy[k] == 0 ? k : free;
    }
    if (buffer > 0 && free < cores) {
      busy[free] = ii;
      buffer--;
      taken = now;
      full = false;
    }
    if (mask > 0 && !full) {
      mask--;
      buffer++;
    }
    if (mask == 0 && head < tail) {
      mask = fifo[head++];
    }
  }
  free(fifo);
  unsigned long long answered = taken > 0 ? taken + AROUND_CORE : 0;
  return answered > walked + LANES_TO_FIFO ? answered : walked + LANES_TO_FIFO;
}

#endif
