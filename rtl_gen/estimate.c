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
  INDEX,
  LANES,
  LANES_WORD,
  SHARED_QUEUE,
  TREE_WORD,
  TREE,
  STREAM_WORD,
  STREAM,
  READY,
  GATED,
  TIGHT,
  TERMS
};
static const struct {
  const char *name;
  double gates, flip_flops;
} terms[TERMS] = {
    [FULL_ADDERS] = {"full_adders", -4.8314, 0},
    [ADDITIONS] = {"additions", 6.0068, 0},
    [RIPPLES] = {"ripples", 4.9904, 0},
    [MULTIPLEXERS] = {"multiplexers", 2.5629, 0},
    [ROWS] = {"rows", 13.791, 0},
    [REGISTERS] = {"registers", 5.7748, 1},
    [CONTROL] = {"control", 2.5722, 1.22},
    [HOLDING] = {"holding", 6.3191, 1},
    [COORDINATES] = {"coordinates", 14.095, 1},
    [WORD] = {"word", -39.858, 0},
    [CORES] = {"cores", 911.09, -7.5034},
    [AABB] = {"aabb", 373.48, 18.477},
    [EXTENTS] = {"extents", 401.71, 28.258},
    [LIMITS] = {"limits", 4.54, 0.022656},
    [BANDS] = {"bands", 42.053, -0.8405},
    [OBJECT_WORD] = {"object_word", 669.83, 44.415},
    [OBJECT] = {"object", 5043.5, 553.87},
    [INDEX] = {"index", 280.19, 30.771},
    [LANES] = {"lanes", 339.51, 1},
    [LANES_WORD] = {"lanes_word", 71.731, 6},
    [SHARED_QUEUE] = {"shared_queue", 357.53, 71.399},
    [TREE_WORD] = {"tree_word", 1762.2, 57.863},
    [TREE] = {"tree", 76938, 5273},
    [STREAM_WORD] = {"stream_word", 206.43, 16.894},
    [STREAM] = {"stream", 2338, 186.82},
    [READY] = {"ready", 187.29, 18.102},
    [GATED] = {"gated", 2.7973, 0.0052929},
    [TIGHT] = {"tight", -72.953, 0},
};
/* Relative errors: of cores; more with clearances, several cores, an engine. */
static const struct {
  double gates, flip_flops;
} plain_error = {0.05, 0.02}, clearance_error = {0.09, 0.1}, cores_error = {0.08, 0.13},
  engine_error = {0.06, 0.08};

/* Energy of a core, pJ a cycle, with glitches: of a flip-flop; of a GE of logic, of it for each ns
 * that the longest stage takes, and in a core of II = 1 (scripts/experiments/estimate energy). */
enum { ENERGY_TERMS = 4 };
static const double energy_per_term[ESTIMATE_PAIRS][ENERGY_TERMS] = {
    [ESTIMATE_SEPARATED] = {-0.00659, 0.004, 0.00016, -0.00189},
    [ESTIMATE_COLLIDING] = {-0.00834, 0.00441, 0.00014, -0.00111},
    [ESTIMATE_COPLANAR] = {-0.00682, 0.00385, 0.000126, -0.000749}};
static const double energy_error[ESTIMATE_PAIRS] = {0.5, 0.55, 0.75};

/* The same of a separated pair that an AABB test keeps from the core: of a flip-flop. */
static const double tested_energy = 0.016, tested_error = 0.5;

/* Leakage, pJ a ns of a GE; GE of a flip-flop. */
static const double leakage = 1.59e-5, flip_flop_gates = 6.5;

_Static_assert((int)TERMS <= (int)ESTIMATE_TERMS, "sepax_estimate holds all terms");

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
  term[EXTENTS] = d->config.extent_a > 0 ? w : 0;
  term[GATED] = d->config.clock_gating ? parts.registers + parts.control : 0;
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
  term[INDEX] = engine == SEPAX_ENGINE_OBJECT ? log2((double)c->memory_a * c->memory_b) : 0;
  term[LANES_WORD] = w * c->lanes;
  term[SHARED_QUEUE] = w * (c->cores - 1);
  term[TREE_WORD] = engine == SEPAX_ENGINE_TREE ? w : 0;
  term[TREE] = engine == SEPAX_ENGINE_TREE;
  term[STREAM_WORD] = engine == SEPAX_ENGINE_STREAM ? w : 0;
  term[STREAM] = engine == SEPAX_ENGINE_STREAM;
  term[READY] = c->registered_ready ? w : 0;
}

static void weigh(sepax_estimate *e, const sepax_design *d) {
  for (int i = 0; i < TERMS; i++) {
    e->gates += terms[i].gates * e->term[i];
    e->flip_flops += terms[i].flip_flops * e->term[i];
  }
  const bool engine = sepax__config_engine(&d->config) != SEPAX_ENGINE_NONE;
  double gates = plain_error.gates;
  double flip_flops = plain_error.flip_flops;
  if (engine) {
    gates = engine_error.gates;
    flip_flops = engine_error.flip_flops;
  }
  if (d->config.cores > 1) {
    gates = cores_error.gates;
    flip_flops = cores_error.flip_flops;
  }
  if (d->limits > 0) {
    gates = fmax(gates, clearance_error.gates);
    flip_flops = fmax(flip_flops, clearance_error.flip_flops);
  }
  e->gates_error = gates * e->gates;
  e->flip_flops_error = flip_flops * e->flip_flops + 16;
}

/* Cores of which energy was measured. */
static bool has_energy(const sepax_design *d) {
  const sepax_config *c = &d->config;
  return sepax__config_engine(c) == SEPAX_ENGINE_NONE && d->limits == 0 && c->extent_a == 0 &&
         !c->clock_gating && c->corner == SEPAX_CORNER_TYPICAL;
}

static void weigh_energy(sepax_estimate *e, const sepax_config *c) {
  const double ns = c->clock_ps / 1000.0;
  const double logic = e->gates - flip_flop_gates * e->flip_flops;
  const double term[ENERGY_TERMS] = {e->flip_flops, logic, logic * e->term[TIGHT] * ns,
                                     c->ii == 1 ? logic : 0};
  for (int pair = 0; pair < ESTIMATE_PAIRS; pair++) {
    const bool tested = pair == ESTIMATE_SEPARATED && c->early_out;
    double cycle = tested ? tested_energy * e->flip_flops : 0;
    for (int i = 0; i < ENERGY_TERMS && !tested; i++) {
      cycle += energy_per_term[pair][i] * term[i];
    }
    e->energy[pair] = c->ii * (cycle + leakage * e->gates * ns) / 1000;
    e->energy_error[pair] = (tested ? tested_error : energy_error[pair]) * e->energy[pair];
  }
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
    weigh(e, design);
    e->energy_known = has_energy(design);
    weigh_energy(e, &design->config);
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
