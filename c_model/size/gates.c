/* SPDX-License-Identifier: MIT */
/* gates.c - estimates the gates of a design before it is mapped, and counts the bits of its
 * memories. docs/reference/size.md. */
#include "size/gates.h"
#include "design/engine_table.h"

enum { TERMS = 7 };

/* GE of each term, fitted by scripts/experiments/fit-area to
 * docs/developers/results/area/nangate45.csv (Nangate45 typical, 2 ns as timed by synth/area/map),
 * and the largest relative error on these designs. */
static const double ge_per_term[TERMS] = {4.6195, 8.7755, 1134.1, 35.031, 637.73, 1631.2, 635.7};
enum {
  FITTED_LEAST = 8,
  FITTED_MOST = 24,
  FITTED_PS = 2000
}; /* the fitted designs: bits of a coordinate, clock period */
static const double largest_error = 0.0831;

/* Relative error of the part around the cores. Its fit has only two word lengths, which give no
 * error, so 5 % is assumed. */
static const double engine_error = 0.05;

/* GE that one or two clearances add to a core (docs/developers/results/area/clearance.csv,
 * scripts/experiments/fit-area -d), with the largest relative error on these designs. */
enum { CLEARANCE_TERMS = 6 };
static const double ge_per_clearance_term[CLEARANCE_TERMS] = {4.265,  7230.6, 263.85,
                                                              1305.6, 1050.1, 424.29};
static const double clearance_error = 0.0885;

static int units(int operations, int ii) { return (operations + ii - 1) / ii; }

/* Count the parts of a core of w bits (docs/reference/exact.md#formats): the bits of its
 * multipliers, a x b; the bits of the results of its sums; registers of any schedule; registers
 * that hold values within an II window (no more beyond 9 cycles); multiplexers of operands, if 3
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

/* The number of nonzero digits of n in signed binary, without two neighbours that are nonzero. */
static int digits(int n) {
  int count = 0;
  for (; n > 0; n /= 2) {
    if (n % 2 != 0) {
      count++;
      n += n % 4 == 3;
    }
  }
  return count;
}

/* The additions of sepax_limit, which computes multiples of D and D + 2. */
static int sums_of_limit(int clearance) { return digits(clearance) + digits(clearance + 2); }

/* Count the parts for clearances: multipliers of trapezoids in two more projections; limits and
 * comparisons, needed in each cycle; waiting values; multiplexers; a second limit; sums of
 * limits. */
static double gates_of_clearances(const sepax_design *d) {
  const sepax_config *c = &d->config;
  int w = d->core_word;
  double each = (double)w / c->ii;
  bool two = d->limits > 1;
  const double term[CLEARANCE_TERMS] = {
      (units(45, c->ii) - units(15, c->ii)) * (w + 1) * (w + 1),
      each,
      w * (c->ii < 9 ? c->ii : 9),
      c->ii > 1 && c->ii % 3 != 0 ? w : 0,
      two ? each : 0,
      each * (sums_of_limit(c->clearance) + (two ? sums_of_limit(c->warning) : 0))};
  double sum = 0;
  for (int i = 0; i < CLEARANCE_TERMS && d->limits > 0; i++) {
    sum += ge_per_clearance_term[i] * term[i];
  }
  return sum;
}

double sepax_gates(const sepax_design *design, double *error) {
  double term[TERMS];
  double plain = 0;
  count_terms(term, design);
  for (int i = 0; i < TERMS; i++) {
    plain += ge_per_term[i] * term[i];
  }
  const sepax_config *c = &design->config;
  double clearances = gates_of_clearances(design);
  double core = plain + clearances;
  double core_error = plain * largest_error + clearances * clearance_error;
  const engine_row *of = sepax__engine_of(c);
  double around = of->gates + (of->gates_per_bit + of->gates_per_lane_bit * c->lanes) * c->word;
  *error = core_error * c->cores + around * engine_error;
  return core * c->cores + around;
}

bool sepax__gates_fitted(const sepax_design *design) {
  return design->config.clock_ps == FITTED_PS && design->core_word >= FITTED_LEAST &&
         design->core_word <= FITTED_MOST;
}

uint64_t sepax_memory_bits(const sepax_config *config) {
  const engine_row *of = sepax__engine_of(config);
  return of->memory_bits != NULL ? of->memory_bits(config) : 0;
}
