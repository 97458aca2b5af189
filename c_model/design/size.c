/* size.c - gates of a design before it is mapped, and the design of the fewest gates that judges a
 * scene in time. docs/size.md. */
#include "design/jobs.h"
#include "util/error.h"

#include <stdlib.h>

/* ----------------------------------------------------------------------- gates */

enum { TERMS = 7 };

/* GE of what each term counts: docs/results/area-nangate45.csv (Nangate45 typical, 2 ns as timed by
 * synth/area/map) as scripts/experiments/fit-area fits it, with the largest relative error on its
 * designs. */
static const double ge_per_term[TERMS] = {4.6195, 8.7755, 1134.1, 35.031, 637.73, 1631.2, 635.7};
static const int fitted_least = 8; /* bits of a coordinate */
static const int fitted_most = 24;
static const double largest_error = 0.0831;

/* The same of what an object engine has around its core (docs/results/area-engine.csv,
 * scripts/experiments/fit-area -l): GE for each lane and bit of W, for each bit of W, and constant.
 * The fit has two word lengths, which give no error; 5 % is assumed. */
static const double ge_per_lane_bit = 92.735;
static const double ge_per_engine_bit = 405.8;
static const double ge_of_engine = 12714;
static const double engine_error = 0.05;

/* Intervals of the designs that were mapped. */
static const int intervals[] = {1, 2, 3, 4, 6, 9, 18};
enum { INTERVALS = sizeof intervals / sizeof intervals[0] };

static int units(int operations, int ii) { return (operations + ii - 1) / ii; }

/* What a core of w bits behind the AABB test is made of (docs/exact.md#formats): the bits of its
 * multipliers, a x b; the bits of the results of its sums; registers of any schedule; registers
 * that hold values within an II window (no more beyond 9 cycles); multiplexers of operands, where 3
 * does not divide II; control; the AABB test. */
static void count_terms(double term[TERMS], const sepax_design *d) {
  int ii = d->config.ii;
  int w = d->core_word;
  int trapezoids = units(15, ii);
  int prisms = units(18, ii) + 1;
  term[0] = trapezoids * (w + 1) * (w + 1) + prisms * (2 * w + 1) * (w + 3);
  term[1] = (trapezoids + units(20, ii)) * (2 * w + 1) + (prisms + units(15, ii)) * (3 * w + 2);
  term[2] = w;
  term[3] = w * (ii < 9 ? ii : 9);
  term[4] = ii > 1 && ii % 3 != 0 ? w : 0;
  term[5] = 1;
  term[6] = d->aabb_test ? d->config.word : 0;
}

double sepax_gates(const sepax_design *design, double *error) {
  double term[TERMS];
  double core = 0;
  count_terms(term, design);
  for (int i = 0; i < TERMS; i++) {
    core += ge_per_term[i] * term[i];
  }
  const sepax_config *c = &design->config;
  if (c->lanes == 0) {
    *error = core * largest_error;
    return core;
  }
  double around = ge_of_engine + (ge_per_engine_bit + ge_per_lane_bit * c->lanes) * c->word;
  *error = core * c->cores * largest_error + around * engine_error;
  return core * c->cores + around;
}

/* ----------------------------------------------------------------------- designs */

static int memory_for(size_t count) {
  int memory = SEPAX_MEMORY_MIN;
  while (memory < SEPAX_MEMORY_MAX && (size_t)memory < count) {
    memory *= 2;
  }
  return memory;
}

typedef struct {
  sepax_sized_design *design; /* every one that there is */
  size_t count;
  uint64_t *steps; /* job_cycles */
} choice;

static bool add_design(choice *all, const sepax_size *size, const sepax_config *config,
                       sepax_error *error) {
  sepax_design design;
  if (!sepax_design_init(&design, config, error)) {
    return false;
  }
  uint64_t passes = 0;
  for (int n = 0; n <= size->poses; n++) {
    passes = size->job[n].passes > passes ? size->job[n].passes : passes;
  }
  sepax_sized_design *m = &all->design[all->count++];
  *m = (sepax_sized_design){.config = *config};
  m->gates = sepax_gates(&design, &m->gates_error);
  m->fitted = config->clock_ps == 2000 && design.core_word >= fitted_least &&
              design.core_word <= fitted_most;
  m->cycles = job_least_cycles(passes, size->count, config);
  return true;
}

/* With a lower bound of their cycles. */
static bool add_designs(choice *all, const sepax_size *size, int clock_ps, int lanes,
                        sepax_error *error) {
  sepax_config config = sepax_config_default();
  config.word = size->grid.word;
  config.clock_ps = clock_ps;
  config.lanes = lanes;
  if (lanes > 0) {
    config.memory_a = memory_for(size->count[0]);
    config.memory_b = memory_for(size->count[1]);
  }
  const int kinds = size->core_word < size->grid.word ? 2 : 1; /* extents only where they help */
  for (int extents = 0; extents < kinds; extents++) {
    config.extent_a = extents > 0 ? (int)size->extent[0] : 0;
    config.extent_b = extents > 0 ? (int)size->extent[1] : 0;
    for (int n = 0; n < INTERVALS; n++) {
      config.ii = intervals[n];
      for (config.cores = 1; config.cores <= (lanes > 0 ? SEPAX_CORES_MAX : 1); config.cores++) {
        if (!add_design(all, size, &config, error)) {
          return false;
        }
      }
    }
  }
  return true;
}

/* The cycles of the pose that takes the most; of one that takes more than `limit`, where there is
 * one. *pose is the one to try first, and becomes that which took the most. */
static uint64_t cycles_in_poses(const choice *all, const sepax_size *size,
                                const sepax_config *config, uint64_t limit, int *pose) {
  uint64_t most = 0;
  int begin = *pose;
  for (int n = 0; n <= size->poses && most <= limit; n++) {
    int at = (begin + n) % (size->poses + 1);
    uint64_t cycles = job_cycles(&size->job[at], size->count, config, all->steps);
    *pose = cycles > most ? at : *pose;
    most = cycles > most ? cycles : most;
  }
  return most;
}

static int by_gates(const void *p, const void *q) {
  const sepax_sized_design *a = p;
  const sepax_sized_design *b = q;
  return a->gates != b->gates ? (a->gates > b->gates) - (a->gates < b->gates)
                              : (a->cycles > b->cycles) - (a->cycles < b->cycles);
}

/* Of those with one bound the dearer first: it is likely to be faster. */
static int by_cycles(const void *p, const void *q) {
  const sepax_sized_design *a = p;
  const sepax_sized_design *b = q;
  return a->cycles != b->cycles ? (a->cycles > b->cycles) - (a->cycles < b->cycles)
                                : by_gates(q, p);
}

/* The first of all, by gates, that takes no more than `limit` cycles in any pose. */
static bool find_cheapest(choice *all, const sepax_size *size, uint64_t limit,
                          sepax_sized_design *best) {
  int pose = 0;
  qsort(all->design, all->count, sizeof *all->design, by_gates);
  for (size_t n = 0; n < all->count; n++) {
    *best = all->design[n];
    if (best->cycles <= limit) {
      best->cycles = cycles_in_poses(all, size, &best->config, limit, &pose);
      if (best->cycles <= limit) {
        return true;
      }
    }
  }
  return false;
}

static uint64_t fewest_cycles(choice *all, const sepax_size *size) {
  int pose = 0;
  uint64_t fewest = UINT64_MAX;
  qsort(all->design, all->count, sizeof *all->design, by_cycles);
  for (size_t n = 0; n < all->count && all->design[n].cycles < fewest; n++) {
    uint64_t cycles = cycles_in_poses(all, size, &all->design[n].config, fewest, &pose);
    fewest = cycles < fewest ? cycles : fewest;
  }
  return fewest;
}

static bool choose(choice *all, const sepax_size *size, double seconds, double period,
                   int lanes_most, sepax_sized_design *best, sepax_error *error) {
  double limit = seconds / period * (1 + 1e-9);
  if (find_cheapest(all, size, limit < 0x1p63 ? (uint64_t)limit : UINT64_MAX, best)) {
    best->seconds = (double)best->cycles * period;
    return true;
  }
  return sepax_fail(error,
                    "time: %.4g ms are not enough: at %g ns the fastest design of up to %d lanes "
                    "takes %.4g ms; allow that, or coarsen the meshes",
                    1e3 * seconds, 1e9 * period, lanes_most,
                    1e3 * period * (double)fewest_cycles(all, size));
}

bool sepax_size_design(sepax_sized_design *sized, const sepax_size *size, double seconds,
                       int clock_ps, int lanes_least, int lanes_most, sepax_error *error) {
  size_t passes = 0;
  for (int n = 0; n <= size->poses; n++) {
    passes = size->job[n].passes > passes ? size->job[n].passes : passes;
  }
  size_t most = (size_t)(lanes_most - lanes_least + 1) * 2 * INTERVALS * SEPAX_CORES_MAX;
  choice all = {malloc(most * sizeof *all.design), 0, malloc((passes + 1) * sizeof *all.steps)};
  if (all.design == NULL || all.steps == NULL) {
    free(all.design);
    free(all.steps);
    return sepax_fail(error, "no memory for %zu designs and %zu candidates", most, passes);
  }
  bool ok = true;
  for (int lanes = lanes_least; lanes <= lanes_most && ok; lanes++) {
    ok = add_designs(&all, size, clock_ps, lanes, error);
  }
  sepax_sized_design best;
  ok = ok && choose(&all, size, seconds, clock_ps * 1e-12, lanes_most, &best, error);
  if (ok) {
    *sized = best;
  }
  free(all.design);
  free(all.steps);
  return ok;
}
