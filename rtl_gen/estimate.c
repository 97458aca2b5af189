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
#include <string.h>

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
  LANES_WORD,
  SHARED_QUEUE,
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
    [FULL_ADDERS] = {"full_adders", -4.4343, 0},
    [ADDITIONS] = {"additions", 6.3325, 0},
    [RIPPLES] = {"ripples", 5.1468, 0},
    [MULTIPLEXERS] = {"multiplexers", 2.7998, 0},
    [ROWS] = {"rows", 13.068, 0},
    [REGISTERS] = {"registers", 4.3656, 1},
    [CONTROL] = {"control", 63.471, 1.5063},
    [HOLDING] = {"holding", 5.5085, 1},
    [COORDINATES] = {"coordinates", 13.954, 1},
    [WORD] = {"word", 101.07, 0},
    [CORES] = {"cores", -1815.5, -18.559},
    [AABB] = {"aabb", 366.85, 18.399},
    [EXTENTS] = {"extents", 227.63, 18.517},
    [LIMITS] = {"limits", 7.1529, 0.087606},
    [BANDS] = {"bands", 13.374, -1.8325},
    [OBJECT_WORD] = {"object_word", 851.78, 64.474},
    [OBJECT] = {"object", 7668.2, 797.78},
    [LANES] = {"lanes", 223.6, 34.952},
    [LANES_WORD] = {"lanes_word", 74.201, 2.9975},
    [SHARED_QUEUE] = {"shared_queue", 274.47, 75.389},
    [TREE_WORD] = {"tree_word", 2012.4, 51.487},
    [TREE] = {"tree", 75084, 5311.5},
    [STREAM_WORD] = {"stream_word", 200.46, 17.082},
    [STREAM] = {"stream", 2218.6, 181.6},
    [READY] = {"ready", 173.48, 18.076},
    [TIGHT] = {"tight", -153.06, 0},
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

/* Bits of the components in all units that compute limits, and of the limits: both in *bits. */
static void count_limits(const exact_plan *p, double *components, double *limits) {
  const sepax_format *f = p->design->exact_format;
  for (int n = 0; n < p->datapath.graph.kinds; n++) {
    const graph_kind *k = &p->datapath.graph.kind[n];
    if (strcmp(k->row.symbol, "le") == 0) {
      *components += k->units * p->design->core_word;
      *limits += k->units * f[SEPAX_X_EDGE_LIMIT].width;
    } else if (k->row.module != NULL && strstr(k->row.module, "_limit") != NULL) {
      *components += k->units * f[k->row.symbol[1] == 'o' ? SEPAX_X_ORIENT2D : SEPAX_X_CROSS].width;
      *limits += k->units * f[SEPAX_X_LIMIT].width;
    }
  }
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
  count_limits(p, &term[BANDS], &term[LIMITS]);
  term[LIMITS] *= sums_of_limits(d);
  for (int i = 0; i <= BANDS; i++) {
    term[i] *= d->config.cores;
  }
}

static void count_around(double term[], const sepax_config *c) {
  const sepax_engine engine = sepax__config_engine(c);
  const int w = c->word;
  term[OBJECT_WORD] = engine == SEPAX_ENGINE_OBJECT ? w : 0;
  term[OBJECT] = engine == SEPAX_ENGINE_OBJECT;
  term[LANES] = c->lanes;
  term[LANES_WORD] = w * c->lanes;
  term[SHARED_QUEUE] = w * (c->cores - 1);
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
