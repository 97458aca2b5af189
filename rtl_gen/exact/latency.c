/* SPDX-License-Identifier: MIT */
/* latency.c - what fixes the latency of architecture exact: the cycles from the one that takes a
 * pair to that of its verdict, both counted. It is the sum of
 *
 * - 1, the cycle that takes the pair;
 * - 0, 1 or 2, the AABB test before the core (aabb_latency);
 * - the cycles of sepax_axis, which chooses the projection (exact_axis_latency);
 * - 1 + verdict_cycle, the datapath: from the cycle in which the pair stands in the first registers
 *   to the one in which it is judged. The target period places registers in the units (stages.c).
 *   The II says how many operations take turns in a unit, and when each starts (cycles.c);
 * - 1, on an FPGA 2, from the verdict to its cycle, in which the queue holds it. */
#include "aabb/aabb.h"
#include "exact.h"

static int latest_defined(const exact_plan *p, const exact_bus *bus) {
  int latest = 0;
  for (; bus->port != NULL; bus++) {
    for (const graph_value *v = bus->value; *v != 0; v++) {
      int cycle = times_defined(&p->datapath, *v);
      latest = cycle > latest ? cycle : latest;
    }
  }
  return latest;
}

static void need_all(exact_plan *p, const exact_bus *bus, int cycle) {
  for (; bus->port != NULL; bus++) {
    for (const graph_value *v = bus->value; *v != 0; v++) {
      times_need(&p->datapath, *v, cycle);
    }
  }
}

int exact_projection_cycle(const exact_plan *p) { return p->plane_cycle - 2 * p->delay->family; }

int exact_trapezoid_latency(const exact_plan *p) {
  const exact_stages *s = &p->stages;
  return exact_is_chained(s->chained, EXACT_CHAIN_T) ? 0
                                                     : 1 + s->trapezoid_sums + s->trapezoid.latency;
}

/* On an FPGA the order is that of registered sums, if there are such. */
int exact_order_latency(const exact_plan *p) {
  const exact_stages *s = &p->stages;
  return exact_is_chained(s->chained, EXACT_CHAIN_T) ? 0
         : p->delay->family && s->trapezoid_sums     ? 2
                                                     : 1;
}

int exact_orient2d_latency(const exact_plan *p) {
  return exact_is_chained(p->stages.chained, EXACT_CHAIN_G) ? 0 : 1 + p->stages.fetch_2d;
}

int exact_zsum_latency(const exact_plan *p) {
  return exact_is_chained(p->stages.chained, EXACT_CHAIN_G) ? 0 : 1;
}

/* A running sum feeds itself, so that it has its register. */
int exact_own_zsum_latency(const exact_plan *p) {
  return p->running ? 1 : exact_zsum_latency(p) + p->stages.own_zsum;
}

int exact_prism_latency(const exact_plan *p, const arith_plan *multiplier) {
  return exact_is_chained(p->stages.chained, EXACT_CHAIN_H) ? 0 : 1 + multiplier->latency;
}

int exact_orient3d_latency(const exact_plan *p) {
  return exact_is_chained(p->stages.chained, EXACT_CHAIN_D) ? 0 : p->stages.orient3d_latency;
}

/* The pair is judged as if it were coplanar, then, when all is there, in space. Behind the judge of
 * the plane is a register, but in a period that has time for chained units, which has time for
 * both. */
void exact_place_judges(exact_plan *p) {
  times_need_operands(&p->datapath);
  int soonest = 0;
  if (!p->single) {
    p->plane_cycle = latest_defined(p, p->graph.projection) + 2 * p->delay->family;
    need_all(p, p->graph.projection, exact_projection_cycle(p));
    soonest = p->plane_cycle + (p->stages.chained == 0);
  }
  int defined = latest_defined(p, p->graph.verdict);
  p->verdict_cycle = defined > soonest ? defined : soonest;
  need_all(p, p->graph.verdict, p->verdict_cycle);
}

int exact_waits(const exact_plan *p) {
  int ii = p->design->config.ii;
  return p->single ? 0 : (p->verdict_cycle - p->plane_cycle + ii - 1) / ii;
}

int exact_narrow_latency(const exact_plan *p) {
  return 1 + exact_axis_latency(p) + (1 + p->verdict_cycle) + 1 + p->delay->family;
}

int exact_latency(const exact_plan *p) { return aabb_latency(p->design) + exact_narrow_latency(p); }
