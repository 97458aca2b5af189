/* SPDX-License-Identifier: MIT */
/* workloads.c - finds the candidates of a pose, and computes the cycles of a design for them.
 * docs/reference/size.md. */
#include "size/workloads.h"

#include "object_engine/time.h"
#include "util/error.h"

#include <stdlib.h>

/* ------------------------------------------------------------------- candidates */

typedef struct {
  aabb box;
  uint32_t number;
} numbered;

static int by_low_x(const void *p, const void *q) {
  int64_t a = ((const numbered *)p)->box.low[0];
  int64_t b = ((const numbered *)q)->box.low[0];
  return (a > b) - (a < b);
}

/* The first of the sorted AABBs that begins at x or later. */
static size_t first_from(const numbered *sorted, size_t count, int64_t x) {
  size_t low = 0;
  while (count > 0) {
    size_t half = count / 2;
    bool before = sorted[low + half].box.low[0] < x;
    low = before ? low + half + 1 : low;
    count = before ? count - half - 1 : half;
  }
  return low;
}

static bool add_candidate(sepax_workload *workload, size_t *capacity, uint32_t i, uint32_t j) {
  if (workload->candidates == *capacity) {
    *capacity = *capacity == 0 ? 1024 : 2 * *capacity;
    uint32_t(*grown)[2] = realloc(workload->candidate, *capacity * sizeof *grown);
    if (grown == NULL) {
      return false;
    }
    workload->candidate = grown;
  }
  workload->candidate[workload->candidates][0] = i;
  workload->candidate[workload->candidates++][1] = j;
  return true;
}

static bool find_candidates(sepax_workload *workload, const workload_bodies *r, numbered *b) {
  size_t capacity = 0;
  int64_t longest = 0;
  for (size_t n = 0; n < r->count[1]; n++) {
    b[n] = (numbered){r->bounds[1][n], (uint32_t)n};
    int64_t side = b[n].box.high[0] - b[n].box.low[0];
    longest = side > longest ? side : longest;
  }
  qsort(b, r->count[1], sizeof *b, by_low_x);
  for (size_t i = 0; i < r->count[0]; i++) {
    const aabb p = r->bounds[0][i];
    for (size_t n = first_from(b, r->count[1], p.low[0] - r->margin - longest);
         n < r->count[1] && b[n].box.low[0] <= p.high[0] + r->margin; n++) {
      if (!aabb_disjoint(&p, &b[n].box, r->margin) &&
          !add_candidate(workload, &capacity, (uint32_t)i, b[n].number)) {
        return false;
      }
    }
  }
  return true;
}

bool sepax__workload_find(sepax_workload *workload, const workload_bodies *bodies,
                          sepax_error *error) {
  sepax_workload found = {0};
  numbered *sorted = malloc(bodies->count[1] * sizeof *sorted);
  bool ok = sorted != NULL && find_candidates(&found, bodies, sorted);
  free(sorted);
  if (!ok) {
    free(found.candidate);
    return sepax_fail(error, SEPAX_ERROR_MEMORY,
                      "no memory for the candidates among %zu and %zu triangles; sample "
                      "fewer poses",
                      bodies->count[0], bodies->count[1]);
  }
  *workload = found;
  return true;
}

/* ------------------------------------------------------------------------ cycles */

/* An object that is larger than its memory is processed in parts. */
typedef struct {
  uint64_t count, memory, lanes;
} part_sizes;

static uint64_t parts(const part_sizes *p) { return (p->count + p->memory - 1) / p->memory; }

static uint64_t size_of_part(const part_sizes *p, uint64_t n) {
  uint64_t rest = p->count - n * p->memory;
  return rest < p->memory ? rest : p->memory;
}

/* Steps of `of_a` triangles of A against the parts of B before part n. */
static uint64_t steps_before(uint64_t of_a, const part_sizes *b, uint64_t n) {
  uint64_t full = n < parts(b) ? n : n - 1;
  return full * engine_steps(of_a, b->memory, b->lanes) +
         (n > full ? engine_steps(of_a, size_of_part(b, full), b->lanes) : 0);
}

/* The first step of a pair of parts. The steps of all parts are numbered in one sequence. */
static uint64_t first_step(const part_sizes *a, const part_sizes *b, uint64_t n, uint64_t m) {
  return n * steps_before(a->memory, b, parts(b)) + steps_before(size_of_part(a, n), b, m);
}

static int by_size(const void *p, const void *q) {
  uint64_t a = *(const uint64_t *)p;
  uint64_t b = *(const uint64_t *)q;
  return (a > b) - (a < b);
}

static uint64_t engine_cycles(const sepax_workload *workload, const part_sizes *a,
                              const part_sizes *b, const sepax_config *config, uint64_t *steps) {
  for (size_t k = 0; k < workload->candidates; k++) {
    uint64_t i = workload->candidate[k][0];
    uint64_t j = workload->candidate[k][1];
    uint64_t n = i / a->memory;
    uint64_t m = j / b->memory;
    steps[k] = first_step(a, b, n, m) +
               engine_step_of(i - n * a->memory, j - m * b->memory, size_of_part(b, m), b->lanes);
  }
  if (workload->candidates > 0) {
    qsort(steps, workload->candidates, sizeof *steps, by_size);
  }
  uint64_t cycles = 0;
  size_t k = 0;
  for (uint64_t part = 0; part < parts(a) * parts(b); part++) {
    uint64_t n = part / parts(b);
    uint64_t at = first_step(a, b, n, part % parts(b));
    uint64_t end =
        at + engine_steps(size_of_part(a, n), size_of_part(b, part % parts(b)), b->lanes);
    engine_time t = engine_time_begin(config);
    while (k < workload->candidates && steps[k] < end) {
      size_t first = k;
      while (k < workload->candidates && steps[k] == steps[first]) {
        k++;
      }
      engine_idle(&t, steps[first] - at);
      engine_step(&t, k - first);
      at = steps[first] + 1;
    }
    engine_idle(&t, end - at);
    cycles += engine_finish(&t, 0);
  }
  return cycles;
}

static void sizes_of(part_sizes size[2], const size_t count[2], const sepax_config *c) {
  size[0] = (part_sizes){count[0], (uint64_t)c->memory_a, (uint64_t)c->lanes};
  size[1] = (part_sizes){count[1], (uint64_t)c->memory_b, (uint64_t)c->lanes};
}

uint64_t sepax__workload_cycles(const sepax_workload *workload, const size_t count[2],
                                const sepax_config *config, uint64_t *steps) {
  if (config->lanes == 0) {
    return (uint64_t)count[0] * count[1] * (uint64_t)config->ii;
  }
  part_sizes size[2];
  sizes_of(size, count, config);
  return engine_cycles(workload, &size[0], &size[1], config, steps);
}

/* Each step takes a cycle. In each part, a core that takes n pairs takes the last of them (n - 1)
 * II cycles after the first. */
uint64_t sepax__workload_least_cycles(uint64_t candidates, const size_t count[2],
                                      const sepax_config *config) {
  uint64_t ii = (uint64_t)config->ii;
  if (config->lanes == 0) {
    return (uint64_t)count[0] * count[1] * ii;
  }
  part_sizes size[2];
  sizes_of(size, count, config);
  uint64_t steps = first_step(&size[0], &size[1], parts(&size[0]) - 1, parts(&size[1]));
  uint64_t each = candidates / (uint64_t)config->cores;
  uint64_t idle = parts(&size[0]) * parts(&size[1]);
  uint64_t busy = each > idle ? (each - idle) * ii : 0;
  return steps > busy ? steps : busy;
}

/* A's memory receives one part after the other. For each part of A, B's memory receives all parts
 * of B. An object that fits its memory stays there. */
uint64_t sepax__workload_loading(const size_t count[2], const sepax_config *config) {
  part_sizes size[2];
  sizes_of(size, count, config);
  uint64_t of_a = parts(&size[0]) > 1 ? size[0].count : 0;
  uint64_t of_b = parts(&size[1]) > 1 ? parts(&size[0]) * size[1].count : size[1].count;
  return 3 * (of_a + of_b);
}
