/* cycles.c - the exact datapath in time: starts of units, the cycles of its two judges. */
#include "datapath/binding.h"
#include "exact.h"

#include "util/error.h"

/* At II = 3 class 5 of orient2d (A_c and the edge c + 2 of B) begins with c = 1: then all can start
 * before the last trapezoid is there. orient3d over B does so, too. */
static void rotate_classes(exact_plan *p) {
  graph *g = &p->datapath.graph;
  for (int n = 0; n < (p->limits > 0 ? 3 : 1); n++) {
    g->kind[p->graph.kind.orient2d[n]].rotated = 1U << 5;
  }
  g->kind[g->node[p->graph.w[0]].kind].rotated = 1U << 0;
}

/* Starts. orient2d start together, B's and A's own not before them; z sums when they are needed, as
 * z waits in its registers anyway; all else as soon as it can. On an FPGA, where a multiplexer
 * costs more than a register, z sums start at the beginning of an II window: each coordinate is
 * then in one place. */
static void start_units(exact_plan *p) {
  datapath *d = &p->datapath;
  const exact_kinds *k = &p->graph.kind;
  int projections = p->limits > 0 ? 3 : 1;
  times_start(d, k->trapezoid[0], 0);
  int start = times_earliest(d, k->orient2d[0]);
  int own = times_earliest(d, k->own_orient2d[0]);
  own = own > start ? own : start;
  for (int n = 0; n < projections; n++) {
    times_start(d, k->orient2d[n], start);
    times_start(d, k->own_orient2d[n], own);
  }
  if (p->stages.zdiff_shared) {
    times_start(d, k->zdiff, start);
  }
  int z_start = p->delay->family ? start - start % p->design->config.ii : start;
  times_start(d, k->zsum, z_start);
  if (!p->single) {
    times_start(d, k->order_z, z_start + 1); /* of z sums in their registers */
  }
  times_start(d, k->own_zsum, own - (p->running ? 2 : p->stages.own_zsum));
  for (int kind = 0; kind < d->graph.kinds; kind++) {
    const graph_kind *prism = &d->graph.kind[k->prism];
    bool running = p->running && kind == k->running_sum; /* waits for the units of its own kind */
    times_start(d, kind, running ? prism->start[0] + prism->latency : -1);
  }
}

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

int exact_projection_cycle(const exact_plan *p) { return p->plane_cycle - p->delay->family; }

/* The pair as if coplanar is judged in the last cycle of an II window, so that a second pass takes
 * the next one; the verdict when all is there. */
static void set_judges(exact_plan *p) {
  int ii = p->design->config.ii;
  int windows = 0;
  times_need_operands(&p->datapath);
  if (!p->single) {
    int needed = p->stages.sign + p->delay->family;
    windows = (latest_defined(p, p->graph.projection) + needed + ii) / ii;
    p->plane_cycle = windows * ii - 1;
    need_all(p, p->graph.projection, exact_projection_cycle(p));
  }
  int defined = latest_defined(p, p->graph.verdict);
  p->verdict_cycle = defined > windows * ii ? defined : windows * ii;
  need_all(p, p->graph.verdict, p->verdict_cycle);
  p->latency = p->verdict_cycle + 3;
}

bool exact_plan_make(exact_plan *p, const sepax_design *design, sepax_error *error) {
  int ii = design->config.ii;
  *p = (exact_plan){.design = design,
                    .delay = delay_model_of(design->config.target),
                    .limits = design->limits,
                    .single = design->config.flag || design->limits > 0,
                    .running = ii == 3};
  p->own_running = p->running && p->delay->family;
  exact_stages_make(p);
  double shortest = p->stages.shortest * delay_corner(&design->config);
  if (shortest * 1000 > design->config.clock_ps) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "clock-ns: %g is too short for W = %d; give %.2f or more",
                      design->config.clock_ps / 1000.0, design->core_word, shortest + 0.005);
  }
  p->datapath.schedule.ii = ii;
  p->datapath.chains = p->delay->family;
  p->datapath.advance.gated = design->config.clock_gating;
  p->datapath.coordinates =
      (coordinates){.ii = ii, .rotate = ii % 3 == 0, .still = p->delay->family};
  exact_graph_make(p);
  if (p->running) {
    rotate_classes(p);
  }
  binding_make(&p->datapath.graph, ii);
  start_units(p);
  set_judges(p);
  schedule_store(&p->datapath.schedule, p->delay);
  p->datapath.coordinates.second_pass = !p->single;
  p->datapath.coordinates.again = p->plane_cycle;
  coordinates_store(&p->datapath.coordinates, p->datapath.graph.kind[p->graph.kind.zsum].start[0]);
  return true;
}
