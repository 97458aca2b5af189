/* SPDX-License-Identifier: MIT */
/* chains.c - which kinds of units need no register behind them. A unit without one is chained to
 * the units that read it: they settle in the same cycle. The delay model adds up what a chain
 * passes, less what units of it do at the same time. */
#include "engine/engine.h"
#include "exact.h"

#include <math.h>

/* ns until values settle, counted from the registers in front of a chain. */
typedef struct {
  const exact_plan *p;
  unsigned chained;
  double reg;   /* clock to output and setup together */
  double stage; /* the longest chain that has ended */
} chain;

/* A chain ends in registers. */
static void end_at(chain *c, double time) { c->stage = fmax(c->stage, c->reg + time); }

/* Behind units of these kinds: settled at `time` if they are chained, else in registers. */
static double pass(chain *c, unsigned kind, double time) {
  if (exact_is_chained(c->chained, kind)) {
    return time - (kind == EXACT_CHAIN_D ? 0 : c->p->delay->overlap);
  }
  end_at(c, time);
  return 0;
}

/* Operands of adders, in a shared unit selected by slot. */
static double selected(const chain *c, double time) {
  const delay_model *m = c->p->delay;
  int ii = c->p->design->config.ii;
  if (ii == 1) {
    return time + m->shared_value;
  }
  int inputs = ii <= 3 ? 2 : ii < 6 ? ii : 6;
  return fmax(delay_operands(m, c->p->design->core_word) + m->fixed_slots, time + m->shared_value) +
         delay_mux(m, inputs);
}

/* z sums from coordinates. */
static double z_sums(const chain *c) {
  const delay_model *m = c->p->delay;
  const sepax_format *f = c->p->design->exact_format;
  double addition = delay_adder(m, f[SEPAX_X_OWN_Z_SUM].width);
  return selected(c, 0) + (c->p->stages.zdiff_shared ? 3 * delay_compressor(m) + 2 * addition
                                                     : 4 * delay_compressor(m) + addition);
}

/* With a clearance: the first registers inside the units that read orient2d. */
static void limit(chain *c, double orient2d) {
  const delay_model *m = c->p->delay;
  double maximum =
      delay_adder(m, c->p->design->exact_format[SEPAX_X_CROSS].width) + delay_mux(m, 2);
  end_at(c, selected(c, orient2d) + 2 * maximum);
}

/* The plane judged from orient2d; the verdict that needs to know the plane in its own cycle. */
static void judge(chain *c, double orient2d, double sign) {
  const delay_model *m = c->p->delay;
  double plane = orient2d + delay_test(m, c->p->design->exact_format[SEPAX_X_ORIENT2D].width);
  end_at(c, fmax(sign, c->p->single ? 0 : plane) + m->decide);
}

double exact_chain_time(const exact_plan *p, unsigned chained) {
  const exact_stages *s = &p->stages;
  const delay_model *m = p->delay;
  const sepax_format *f = p->design->exact_format;
  chain c = {p, chained, delay_register(m), 0};
  double t = pass(&c, EXACT_CHAIN_T, s->trapezoid.settled);
  double addition = delay_compressor(m) + delay_adder(m, f[SEPAX_X_ORIENT2D].width);
  double g = pass(&c, EXACT_CHAIN_G, selected(&c, t) + addition);
  double z = pass(&c, EXACT_CHAIN_G, z_sums(&c));
  double product = fmax(s->prism.settled, s->own_prism.settled);
  if (s->zdiff_shared) {
    product = fmax(product, s->prism_of_two.settled);
  }
  double h = pass(&c, EXACT_CHAIN_H, fmax(g, z) + product);
  int orient3d = f[SEPAX_X_ORIENT3D].width;
  double volume = selected(&c, h) + 2 * delay_compressor(m) + delay_adder(m, orient3d);
  end_at(&c, volume);
  double d = pass(&c, EXACT_CHAIN_D, volume + delay_test(m, orient3d));
  judge(&c, g, d);
  if (p->limits > 0) {
    limit(&c, g);
  }
  return c.stage;
}

/* Carries run through a chain of units from the low bits to the high ones, all at the same pace, so
 * that a chain waits for them only once, in the widest addition. That is an upper estimate: the
 * fast additions in front of it count in full. The AABB test has three comparisons, one after the
 * other. */
double exact_ripple_time(const exact_plan *p) {
  const delay_model *m = p->delay;
  int widest = p->design->exact_format[SEPAX_X_ORIENT3D].width;
  if (p->limits > 0 || engine_generator_of(&p->design->config)->generate != NULL) {
    return INFINITY;
  }
  double test = p->design->aabb_test
                    ? m->reg + m->aabb + 3 * (m->adder[0] + m->ripple * p->design->config.word)
                    : 0;
  test = fmax(test, exact_axis_ripple_time(p));
  return fmax(test, exact_chain_time(p, EXACT_CHAIN_ALL) - delay_adder(m, widest) + m->adder[0] +
                        m->ripple * widest);
}

/* Have units of these kinds no register inside? */
static bool is_one_stage(const exact_plan *p, unsigned chained) {
  const exact_stages *s = &p->stages;
  bool t = s->trapezoid.latency == 0 && !s->trapezoid_sums;
  bool g = !s->fetch_2d && (p->running || !s->own_zsum);
  bool h = s->prism.latency == 0 && s->own_prism.latency == 0 &&
           (!s->zdiff_shared || s->prism_of_two.latency == 0);
  bool d = s->orient3d == 0 && !s->fetch_3d && p->limits == 0;
  return (t || !exact_is_chained(chained, EXACT_CHAIN_T)) &&
         (g || !exact_is_chained(chained, EXACT_CHAIN_G)) &&
         (h || !exact_is_chained(chained, EXACT_CHAIN_H)) &&
         (d || !exact_is_chained(chained, EXACT_CHAIN_D));
}

bool exact_may_chain(const exact_plan *p, unsigned chained, double period) {
  return chained == 0 ||
         (!p->delay->family && is_one_stage(p, chained) && exact_chain_time(p, chained) <= period);
}
