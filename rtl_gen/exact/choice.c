/* SPDX-License-Identifier: MIT */
/* choice.c - the plan of architecture exact for a clock: which registers its period needs.
 *
 * Up to 2 ns every kind of units has registers behind it, and only the registers inside units
 * follow the clock. A slower clock may chain kinds (chains.c). Such a clock takes the plan of 2 ns
 * and replaces it by each plan for a longer period, up to its own, that has no more latency, no
 * more flip-flops and no more gates. These periods are the same steps for every clock. So the
 * choice of a clock is that of the faster clock one step before, or a better one: a slower clock
 * never costs more. */
#include "exact.h"

#include "util/error.h"

#include <math.h>
#include <string.h>

enum { FIRST_PS = 2000, LAST_PS = 60000 };

/* The step behind a clock, in ps: 1 to 8 %. */
static int next_step(int ps) {
  return ps + (ps < 4000 ? 50 : ps < 6000 ? 200 : ps < 12000 ? 500 : 1000);
}

/* A plan that may be chosen, and what it costs. */
typedef struct {
  double period;
  unsigned chained;
  exact_counts counts;
} candidate;

/* Is it no worse in anything, and better in something? */
static bool is_better(exact_counts a, exact_counts b) {
  return a.latency <= b.latency && a.flip_flops <= b.flip_flops && a.gates <= b.gates &&
         (a.latency < b.latency || a.flip_flops < b.flip_flops || a.gates < b.gates);
}

/* What the graph or the schedule could not hold; NULL: nothing. */
static const char *fault_of(const datapath *d) {
  return d->graph.fault != NULL ? d->graph.fault : d->schedule.fault;
}

/* Place registers for this period. Is it long enough? */
static bool place(exact_plan *p, double period) {
  exact_stages_make(p, period);
  return p->stages.shortest <= period;
}

/* What plans of a step depend on. */
typedef struct {
  int of[27];
} placement;

/* Could a plan of this step be another one than those of the step before? */
static bool is_new(const exact_plan *p, double period, placement *before) {
  const exact_stages *s = &p->stages;
  const arith_plan *const multiplier[] = {&s->trapezoid, &s->prism, &s->own_prism, &s->prism_of_two,
                                          &s->axis.product};
  placement now = {{exact_axis_latency(p), s->trapezoid_sums, s->orient3d, s->orient3d_latency,
                    s->fetch_2d, s->fetch_3d, s->slot_copies, s->own_zsum, s->zdiff_shared, s->most,
                    s->total}};
  for (int i = 0; i < 5; i++) {
    now.of[11 + 3 * i] = multiplier[i]->latency;
    now.of[12 + 3 * i] = multiplier[i]->registers;
    now.of[13 + 3 * i] = multiplier[i]->cut.parts;
  }
  for (unsigned chained = 0; chained <= EXACT_CHAIN_ALL; chained++) {
    now.of[26] |= exact_may_chain(p, chained, period) << chained;
  }
  bool same = memcmp(&now, before, sizeof now) == 0;
  *before = now;
  return !same;
}

/* The plans of one step: of those that are better than `best` the one with the fewest gates. */
static void choose_chains(exact_plan *p, double period, candidate *best) {
  candidate found = *best;
  for (unsigned chained = 0; chained <= EXACT_CHAIN_ALL; chained++) {
    p->stages.chained = chained;
    if (!exact_may_chain(p, chained, period)) {
      continue;
    }
    exact_schedule(p);
    candidate one = {period, chained, exact_count(p)};
    bool first = best->period <= 0;
    if (fault_of(&p->datapath) == NULL && (first || is_better(one.counts, best->counts)) &&
        (found.period <= 0 || found.period < period || one.counts.gates < found.counts.gates)) {
      found = one;
    }
  }
  *best = found;
}

/* The best plan for this period, and registers placed for it. Chained: what it chains. */
static unsigned choose(exact_plan *p, double period) {
  candidate best = {0};
  placement before = {{0}};
  double slower = delay_corner(&p->design->config);
  if (p->design->config.clock_ps <= FIRST_PS) {
    return 0;
  }
  for (int ps = FIRST_PS; ps <= LAST_PS && ps <= p->design->config.clock_ps; ps = next_step(ps)) {
    double step = ps / 1000.0 / slower;
    if (place(p, step) && is_new(p, step, &before)) {
      choose_chains(p, step, &best);
    }
    if (best.chained == EXACT_CHAIN_ALL) {
      break;
    }
  }
  place(p, best.period > 0 ? best.period : period);
  return best.chained;
}

/* The least period of 10 ps steps, in ps, whose own stages fit into it. Registers stand elsewhere
 * at a longer period, so that the longest stage of a shorter one need not be the answer. */
static int least_period(exact_plan *p, double slower) {
  enum { STEP = 10, MOST = 1000000 };
  int ps = 0;
  int needed = (int)ceil(p->stages.shortest * slower * 1000);
  while (needed > ps && ps < MOST) {
    ps = (needed + STEP - 1) / STEP * STEP;
    place(p, ps / 1000.0 / slower);
    needed = (int)ceil(p->stages.shortest * slower * 1000);
  }
  return ps;
}

bool exact_plan_make(exact_plan *p, const sepax_design *design, sepax_error *error) {
  const sepax_config *config = &design->config;
  *p = (exact_plan){.design = design,
                    .delay = delay_model_of(config->target),
                    .limits = design->limits,
                    .single = config->flag || design->limits > 0,
                    .running = config->ii == 3};
  p->own_running = p->running && p->delay->family;
  double slower = delay_corner(config);
  double period = config->clock_ps / 1000.0 / slower;
  place(p, period);
  double shortest = p->stages.shortest * slower;
  if (shortest * 1000 > config->clock_ps) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT, "clock-ns: %g is too short for W = %d; give %.2f or more",
        config->clock_ps / 1000.0, design->core_word, least_period(p, slower) / 1000.0);
  }
  p->stages.chained = choose(p, period);
  p->ripple = p->stages.chained == EXACT_CHAIN_ALL && exact_ripple_time(p) <= period;
  exact_schedule(p);
  if (fault_of(&p->datapath) != NULL) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT, "the datapath of W = %d, II = %d has %s",
                      config->word, config->ii, fault_of(&p->datapath));
  }
  return true;
}
