/* SPDX-License-Identifier: MIT */
/* cycles.c - the exact datapath in time: when the units of each kind start. latency.c has the end.
 */
#include "datapath/binding.h"
#include "exact.h"

#include <string.h>

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
  /* A running sum takes three cycles; if it cannot begin so early, then the orient2d waits. */
  int own_start = own + exact_zsum_latency(p) - exact_own_zsum_latency(p) - (p->running ? 2 : 0);
  own_start = own_start > 0 ? own_start : 0;
  if (p->own_running) { /* all differences in one II window: each coordinate is in one place */
    int before = own_start > 0 ? own_start - 1 : 0;
    before -= before % p->design->config.ii;
    times_start(d, k->own_zdiff, before);
    own_start = before + 1;
  }
  times_start(d, k->own_zsum, own_start);
  for (int kind = 0; kind < d->graph.kinds; kind++) {
    const graph_kind *prism = &d->graph.kind[k->prism];
    bool running = p->running && kind == k->running_sum; /* waits for the units of its own kind */
    times_start(d, kind, running ? prism->start[0] + prism->latency : -1);
  }
}

void exact_schedule(exact_plan *p) {
  const sepax_config *config = &p->design->config;
  memset(&p->graph, 0, sizeof p->graph);
  memset(&p->datapath, 0, sizeof p->datapath);
  p->datapath.schedule.ii = config->ii;
  p->datapath.chains = p->delay->family;
  p->datapath.advance = (advance){.gated = config->clock_gating,
                                  .ahead = !p->single,
                                  .ii = config->ii,
                                  .copied = p->delay->family && config->ii > 1};
  p->datapath.coordinates = (coordinates){.ii = config->ii, .rotate = config->ii % 3 == 0};
  exact_graph_make(p);
  if (p->running) {
    rotate_classes(p);
  }
  binding_make(&p->datapath.graph, config->ii);
  start_units(p);
  exact_place_judges(p);
  schedule_store(&p->datapath.schedule, p->delay);
  coordinates_store(&p->datapath.coordinates, p->datapath.graph.kind[p->graph.kind.zsum].start[0]);
}
