/* SPDX-License-Identifier: MIT */
/* estimate.c - gates, flip-flops and energy of a design by formulas that were fitted to mapped
 * designs. docs/reference/estimate.md. */
#include "estimate.h"

#include "design/engine_table.h"
#include "exact/clearance.h"
#include "exact/exact.h"
#include "generate.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>

/* The terms, and the GE and the flip-flops that a fit gives to each of them
 * (scripts/experiments/estimate). */
enum {
  FULL_ADDERS,
  ADDITIONS,
  RIPPLES,
  MULTIPLEXERS,
  ROWS,
  REGISTERS,
  CONTROL,
  HOLDING,
  COORDINATES,
  WORD,
  CORES,
  AABB,
  EXTENTS,
  LIMITS,
  BANDS,
  OBJECT_WORD,
  OBJECT,
  LANES,
  TREE_WORD,
  TREE,
  STREAM_WORD,
  STREAM,
  READY,
  TIGHT,
  TERMS
};
static const struct {
  const char *name;
  double gates, flip_flops;
} terms[TERMS] = {
    [FULL_ADDERS] = {"full_adders", -3.2195, 0},
    [ADDITIONS] = {"additions", 6.5285, 0},
    [RIPPLES] = {"ripples", 5.4444, 0},
    [MULTIPLEXERS] = {"multiplexers", 3.0448, 0},
    [ROWS] = {"rows", 12.36, 0},
    [REGISTERS] = {"registers", 5.772, 1},
    [CONTROL] = {"control", -14.676, 1.4318},
    [HOLDING] = {"holding", 6.6151, 1},
    [COORDINATES] = {"coordinates", 18.242, 1},
    [WORD] = {"word", -297.36, 0},
    [CORES] = {"cores", 1654.9, -15.755},
    [AABB] = {"aabb", 385.14, 18.502},
    [EXTENTS] = {"extents", 269.49, 19.384},
    [LIMITS] = {"limits", 577.07, 4.7875},
    [BANDS] = {"bands", 347.68, -11.638},
    [OBJECT_WORD] = {"object_word", 625.62, 33.229},
    [OBJECT] = {"object", 9220.1, 993.75},
    [LANES] = {"lanes", 108.67, 8.5096},
    [TREE_WORD] = {"tree_word", 1780, 0},
    [TREE] = {"tree", 76700, 0},
    [STREAM_WORD] = {"stream_word", 0, 0},
    [STREAM] = {"stream", 0, 0},
    [READY] = {"ready", 172.13, 18.75},
    [TIGHT] = {"tight", 81.193, 0},
};
static const double gates_error = 0.08;
static const double flip_flops_error = 0.05;

const char *sepax_estimate_term(int term) { return term < TERMS ? terms[term].name : NULL; }

/* The longest stage of the plan, over the clock period. */
static double tightness(const exact_plan *p) {
  const sepax_config *c = &p->design->config;
  double stage = p->stages.shortest;
  if (p->stages.chained != 0) {
    stage = fmax(stage, p->ripple ? exact_ripple_time(p) : exact_chain_time(p, p->stages.chained));
  }
  return stage * delay_corner(c) * 1000 / c->clock_ps;
}

/* What a clearance adds: additions of the limits, comparisons with them. */
static int sums_of_limits(const sepax_design *d) {
  int sums = 0;
  for (int k = 0; k < d->limits; k++) {
    sums += clearance_digits(d->margin[k] + 1) + clearance_digits(d->margin[k] - 1);
  }
  return sums;
}

static void count_core(double term[], const exact_plan *p) {
  const exact_parts parts = exact_parts_of(p);
  const sepax_design *d = p->design;
  const int w = d->core_word;
  term[FULL_ADDERS] = parts.full_adders;
  term[p->ripple ? RIPPLES : ADDITIONS] = parts.additions;
  term[MULTIPLEXERS] = parts.multiplexers;
  term[ROWS] = parts.rows;
  term[REGISTERS] = parts.registers;
  term[CONTROL] = parts.control;
  term[HOLDING] = parts.holding;
  term[COORDINATES] = parts.coordinates;
  term[WORD] = w;
  term[CORES] = 1;
  term[AABB] = d->aabb_test ? d->config.word : 0;
  term[EXTENTS] = d->config.extent_a > 0 ? d->config.word : 0;
  term[LIMITS] = (double)w * sums_of_limits(d) / d->config.ii;
  term[BANDS] = (double)w * d->limits;
  for (int i = 0; i <= BANDS; i++) {
    term[i] *= d->config.cores;
  }
}

static void count_around(double term[], const sepax_config *c) {
  const sepax_engine engine = sepax__config_engine(c);
  const int w = c->word;
  term[OBJECT_WORD] = engine == SEPAX_ENGINE_OBJECT ? w : 0;
  term[OBJECT] = engine == SEPAX_ENGINE_OBJECT;
  term[LANES] = engine == SEPAX_ENGINE_OBJECT ? w * c->lanes : 0;
  term[TREE_WORD] = engine == SEPAX_ENGINE_TREE ? w : 0;
  term[TREE] = engine == SEPAX_ENGINE_TREE;
  term[STREAM_WORD] = engine == SEPAX_ENGINE_STREAM ? w : 0;
  term[STREAM] = engine == SEPAX_ENGINE_STREAM;
  term[READY] = c->registered_ready ? w : 0;
}

static void weigh(sepax_estimate *e) {
  for (int i = 0; i < TERMS; i++) {
    e->gates += terms[i].gates * e->term[i];
    e->flip_flops += terms[i].flip_flops * e->term[i];
  }
  e->gates_error = gates_error * e->gates;
  e->flip_flops_error = flip_flops_error * e->flip_flops;
}

static bool estimate_exact(const sepax_design *design, sepax_estimate *e, sepax_error *error) {
  exact_plan *plan = malloc(sizeof *plan);
  if (plan == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a plan");
  }
  bool ok = exact_plan_make(plan, design, error);
  if (ok) {
    e->latency = exact_latency(plan);
    e->gates_known = design->config.target == SEPAX_TARGET_ASIC;
  }
  if (ok && e->gates_known) {
    count_core(e->term, plan);
    count_around(e->term, &design->config);
    e->term[TIGHT] = tightness(plan);
    weigh(e);
  }
  free(plan);
  return ok;
}

bool sepax_estimate_design(const sepax_design *design, sepax_estimate *estimate,
                           sepax_error *error) {
  const sepax_config *c = &design->config;
  const double clock = 1e12 / c->clock_ps;
  *estimate = (sepax_estimate){.latency = design->latency,
                               .pairs = clock * c->cores / c->ii,
                               .compared = clock * c->lanes,
                               .memory_bits = sepax_memory_bits(c)};
  return generate_check(c, error) &&
         (c->arch != SEPAX_ARCH_EXACT || estimate_exact(design, estimate, error));
}
