/* size.c - gates of a design before it is mapped, and the design of the fewest gates that judges a
 * scene in time. docs/size.md. */
#include "sepax_design.h"
#include "util/error.h"

#include <math.h>

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

/* ------------------------------------------------------------------------ time */

static uint64_t larger(uint64_t a, uint64_t b) { return a > b ? a : b; }

/* The steps of the pair enumerator (docs/engine.md) for one memory of A and one of B. */
static uint64_t enumeration_cycles(uint64_t a, uint64_t b, uint64_t lanes) {
  enum { BEHIND_LAST_STEP = 6 };
  return (a + lanes - 1) / lanes * larger(b, lanes) + (a - 1) % lanes + BEHIND_LAST_STEP;
}

static uint64_t lane_cycles(uint64_t count_a, uint64_t count_b, uint64_t lanes) {
  uint64_t cycles = 0;
  for (uint64_t a = 0; a < count_a; a += SEPAX_MEMORY_MAX) {
    uint64_t here = count_a - a < SEPAX_MEMORY_MAX ? count_a - a : SEPAX_MEMORY_MAX;
    uint64_t rest = count_b % SEPAX_MEMORY_MAX;
    cycles += count_b / SEPAX_MEMORY_MAX * enumeration_cycles(here, SEPAX_MEMORY_MAX, lanes);
    cycles += rest > 0 ? enumeration_cycles(here, rest, lanes) : 0;
  }
  return cycles;
}

/* In every cycle the pair enumerator takes a step or the core is busy, so that a run takes no
 * longer than both in turn. A pair that is flat as seen along z goes through the core twice. */
static uint64_t design_cycles(const sepax_size *size, const sepax_design *d) {
  uint64_t a = size->count[0];
  uint64_t b = size->count[1];
  uint64_t ii = (uint64_t)d->config.ii;
  if (d->config.lanes == 0) {
    return a * b * ii;
  }
  return lane_cycles(a, b, (uint64_t)d->config.lanes) + (2 * size->worst + 1) * ii;
}

/* ---------------------------------------------------------------------- design */

static int memory_for(size_t count) {
  int memory = SEPAX_MEMORY_MIN;
  while (memory < SEPAX_MEMORY_MAX && (size_t)memory < count) {
    memory *= 2;
  }
  return memory;
}

static bool fill_design(sepax_sized_design *m, const sepax_size *size, int ii, int lanes,
                        bool extents, int clock_ps, sepax_error *error) {
  sepax_design design;
  *m = (sepax_sized_design){.config = sepax_config_default()};
  m->config.word = size->grid.word;
  m->config.ii = ii;
  m->config.clock_ps = clock_ps;
  m->config.extent_a = extents ? (int)size->extent[0] : 0;
  m->config.extent_b = extents ? (int)size->extent[1] : 0;
  if (lanes > 0) {
    m->config.lanes = lanes;
    m->config.memory_a = memory_for(size->count[0]);
    m->config.memory_b = memory_for(size->count[1]);
  }
  if (!sepax_design_init(&design, &m->config, error)) {
    return false;
  }
  m->gates = sepax_gates(&design, &m->gates_error);
  m->fitted =
      clock_ps == 2000 && design.core_word >= fitted_least && design.core_word <= fitted_most;
  m->cycles = design_cycles(size, &design);
  m->seconds = (double)m->cycles * clock_ps * 1e-12;
  return true;
}

bool sepax_size_design(sepax_sized_design *sized, const sepax_size *size, double seconds,
                       int clock_ps, int lanes_least, int lanes_most, sepax_error *error) {
  sepax_sized_design best = {.seconds = INFINITY};
  bool found = false;
  int kinds = size->core_word < size->grid.word ? 2 : 1;
  for (int n = 0; n < kinds * INTERVALS; n++) {
    for (int lanes = lanes_least; lanes <= lanes_most; lanes++) {
      sepax_sized_design m;
      if (!fill_design(&m, size, intervals[n % INTERVALS], lanes, n >= INTERVALS, clock_ps,
                       error)) {
        return false;
      }
      bool in_time = m.seconds <= seconds * (1 + 1e-9);
      if (in_time ? !found || m.gates < best.gates : !found && m.seconds < best.seconds) {
        best = m;
      }
      found = found || in_time;
    }
  }
  if (!found) {
    return sepax_fail(error,
                      "time: %.4g ms are not enough: at %g ns the fastest design of up to %d lanes "
                      "takes %.4g ms; allow that, or coarsen the meshes",
                      1e3 * seconds, clock_ps / 1000.0, lanes_most, 1e3 * best.seconds);
  }
  *sized = best;
  return true;
}
