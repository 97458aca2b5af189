/* SPDX-License-Identifier: MIT */
/* core.c - sepax_core: what its template needs of the plan. */
#include "datapath/emission.h"
#include "exact.h"

static void set_numbers(emit_holes *h, const exact_plan *p) {
  const sepax_format *f = p->design->exact_format;
  int ii = p->design->config.ii;
  int waits = exact_waits(p);
  emit_hole_set(h, "every", ii > 1 ? "%d cycles" : "cycle", ii);
  emit_hole_numbers(
      h, (emit_number[]){{"slots", ii > 1},
                         {"last_slot", ii - 1},
                         {"plane", !p->single},
                         {"waits", waits},
                         {"copied", p->datapath.advance.copied},
                         {"rotate", p->datapath.coordinates.rotate},
                         {"plane_cycle", p->plane_cycle},
                         {"projection_cycle", exact_projection_cycle(p)},
                         {"verdict_cycle", p->verdict_cycle},
                         {"result_cycle", p->verdict_cycle + p->delay->family},
                         {"z_w", f[SEPAX_X_Z_SUM].width},
                         {"c_w", f[SEPAX_X_CROSS].width},
                         {"l_w", f[SEPAX_X_LIMIT].width},
                         {"m_w", p->limits * f[SEPAX_X_EDGE_LIMIT].width},
                         {"t_units", p->datapath.graph.kind[p->graph.kind.trapezoid[0]].units},
                         {"h_units", (18 + ii - 1) / ii + 1},
                         {NULL, 0}});
  emit_hole_set(h, "separated_next", waits > 1 ? "{separated_q[%d:0], separated}" : "separated",
                waits - 2);
  const gen_line waited = gen_format("separated_q[%d]", waits - 1);
  emit_hole_set(h, "in_plane", "%s", p->single ? "1'b0" : waits > 0 ? waited.text : "separated");
}

/* The first cycle of a kind's units. */
static void set_start(emit_holes *h, const char *name, const exact_plan *p, graph_value v) {
  const graph_kind *k = graph_kind_of(&p->datapath.graph, v);
  int first = k->start[0];
  for (int unit = 1; unit < k->units; unit++) {
    first = k->start[unit] < first ? k->start[unit] : first;
  }
  emit_hole_set(h, name, "%2d", first);
}

/* The buses of a module that reads ports of the same names in this cycle. */
static void set_buses(emit_holes *h, const char *name, const exact_plan *p, const exact_bus *bus,
                      int cycle) {
  emit_text *out = emit_hole_open(h, name);
  for (; bus->port != NULL; bus++) {
    emission_bus(&p->datapath, out, gen_format("all_%s", bus->port).text, bus->value, cycle);
  }
  emit_hole_close(h);
}

/* Enables that the core reads, as its ports and as the control connects them: by live_q, which
 * counts from the cycle behind the one that takes a pair; what loads then is enabled by what comes.
 */
static void set_advances(emit_holes *h, const exact_plan *p) {
  const advance *a = &p->datapath.advance;
  bool shared = p->design->config.ii > 1;
  bool chained = p->stages.chained != 0;
  int ahead = exact_axis_latency(p);
  /* Chained units select their operands until the verdict, behind the last registers. */
  int last = shared && chained && p->verdict_cycle > 1 ? p->verdict_cycle : shared || ahead == 0;
  bool read = shared || ahead > 0;
  emit_text *out = emit_hole_open(h, "advances");
  for (int cycle = 0; cycle < ADVANCE_CYCLES; cycle++) {
    if (a->used[cycle]) {
      text_printf(out, "  input  wire       advance_%d, // registers of cycle %d move\n", cycle,
                  cycle);
      last = cycle > last ? cycle : last;
      read |= cycle > 0;
    }
  }
  out = emit_hole_open(h, "advance_ports");
  for (int cycle = 0; cycle < ADVANCE_CYCLES; cycle++) {
    if (a->used[cycle]) {
      const gen_line live = gen_format("live_q[%d]", ahead + cycle - 1);
      text_printf(out, "    .advance_%d(%s),\n", cycle, ahead + cycle == 0 ? "load" : live.text);
    }
  }
  emit_hole_close(h);
  emit_hole_set(h, "begins_at_last", a->gated && ahead == 0 ? "1" : "0");
  emit_hole_set(h, "slot_rests", a->gated ? "; 0 without a pair" : "");
  emit_hole_set(h, "live", a->gated && read ? "1" : "0");
  last += ahead;
  emit_hole_set(h, "live_msb", "%d", last - 1);
  emit_hole_set(h, "live_zero", "%d'd0", last);
  emit_hole_set(h, "live_next", last > 1 ? "{live_q[%d:0], first}" : "first", last - 2);
}

static void set_inputs(emit_holes *h, const exact_plan *p) {
  emit_text *out = emit_hole_open(h, "inputs");
  for (int n = 0; n < 18; n++) {
    text_printf(out, "  input  wire signed [%d:0] in_%s_%c, // taken at the end of an II window\n",
                p->design->core_word - 1, graph_vertex_name(n / 3), "xyz"[n % 3]);
  }
  emit_hole_close(h);
}

void gen_exact_core(emitter *e, exact_plan *p, emit_holes *h) {
  set_numbers(h, p);
  set_start(h, "t_cycle", p, p->graph.t[0][0][1]);
  set_start(h, "g_cycle", p, p->graph.g[0][0][1][3]);
  set_start(h, "h_cycle", p, p->graph.h[0][1][3]);
  set_start(h, "d_cycle", p, p->graph.d[0][0]);
  emit_hole_set(h, "v_cycle", "%2d", p->verdict_cycle);
  set_inputs(h, p);
  if (p->design->config.ii > 1) {
    const gen_line slot = advance_slot(&p->datapath.advance, p->plane_cycle, p->plane_cycle);
    emit_hole_set(h, "plane_slot", "%s", slot.text);
  }
  emission_holes(&p->datapath, h);
  set_advances(h, p);
  set_buses(h, "plane", p, p->graph.projection, exact_projection_cycle(p));
  set_buses(h, "verdict", p, p->graph.verdict, p->verdict_cycle);
  emit_template(e, "sepax_core", h->hole);
}
