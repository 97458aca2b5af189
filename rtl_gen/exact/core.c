/* core.c - sepax_core: the graph's units, and what judges their results. */
#include "clearance/clearance.h"
#include "datapath/emission.h"
#include "exact.h"

#include <stdlib.h>

static void ports(emit_module *m, const exact_plan *p) {
  const gen_line word = gen_format("%d", p->design->core_word);
  int verdict = p->verdict_cycle;
  emit_signal(m, EMIT_INPUT, false, "clk", "", "clock");
  if (p->design->config.ii > 1) {
    emit_signal(m, EMIT_INPUT, false, "slot", gen_format("%d", p->design->config.ii).text,
                "bit k: cycle k of the II window, one-hot");
  }
  for (int v = 0; v < 6; v++) {
    for (int axis = 'x'; axis <= 'z'; axis++) {
      emit_signal(m, EMIT_INPUT, true, gen_format("in_%s_%c", graph_vertex_name(v), axis).text,
                  word.text, "taken at the end of an II window");
    }
  }
  if (!p->single) {
    emit_signal(m, EMIT_INPUT, false, "again", "", "take the pair once more, u for x and z for y");
    emit_signal(m, EMIT_OUTPUT, false, "flat", "", "in cycle %d: all orient2d are zero",
                p->plane_cycle);
    emit_signal(m, EMIT_OUTPUT, false, "separated", "", "with it: separated in the projection");
    emit_signal(m, EMIT_OUTPUT, false, "disjoint_x", "", "with it: AABBs disjoint in x");
    emit_signal(m, EMIT_OUTPUT, false, "disjoint_z", "", "with it: AABBs disjoint in z");
    emit_signal(m, EMIT_INPUT, false, "second", "", "in cycle %d: the pair's second pass", verdict);
  }
  if (p->limits > 0) {
    emit_signal(m, EMIT_OUTPUT, false, "coplanar", "", "in cycle %d: all orient3d are zero",
                verdict);
    emit_signal(m, EMIT_OUTPUT, false, "band", "2", "with it: 0 free, 1 warning, 2 collision");
    emit_signal(m, EMIT_OUTPUT, false, "axis", "4", "with it: the axis that proves the band, or 0");
    return;
  }
  emit_signal(m, EMIT_INPUT, false, "in_plane", "", "in cycle %d: separated if coplanar", verdict);
  emit_signal(m, EMIT_OUTPUT, false, "coplanar", "",
              "in cycle %d: all orient3d are zero, or a second pass", verdict);
  emit_signal(m, EMIT_OUTPUT, false, "axis", "4", "in cycle %d: the axis that separates, or 0",
              verdict);
}

static void widths(emit_module *m, const exact_plan *p) {
  static const struct {
    const char *name;
    int format;
    const char *about;
  } row[] = {{"W", SEPAX_X_COORDINATE, "bits of a coordinate"},
             {"G_W", SEPAX_X_ORIENT2D, "of a trapezoid term or an orient2d"},
             {"Z_W", SEPAX_X_Z_SUM, "of a z sum"},
             {"O_W", SEPAX_X_OWN_Z_SUM, "of B's z sum"},
             {"V_W", SEPAX_X_ORIENT3D, "of a signed prism volume or an orient3d"}};
  const sepax_format *f = p->design->exact_format;
  for (size_t i = 0; i < sizeof row / sizeof row[0]; i++) {
    emit_parameter(m, EMIT_LOCALPARAM, row[i].name, f[row[i].format].width, row[i].about);
  }
  /* What prisms deduct of a z sum: 1 for each digit but the highest. */
  if (!p->single) {
    emit_parameter(m, EMIT_LOCALPARAM, "DIGITS", f[SEPAX_X_Z_SUM].digits,
                   "radix-4 digits of a z sum");
    emit_text(m, "localparam signed [Z_W-1:0] BIAS = // of z sums, as prisms deduct it\n"
                 "  {{(Z_W+2-2*DIGITS){1'b0}}, {(DIGITS-1){2'b01}}};");
  }
  if (p->running) {
    emit_parameter(m, EMIT_LOCALPARAM, "OWN_DIGITS", f[SEPAX_X_OWN_Z_SUM].digits, "of B's z sum");
    emit_text(m, "localparam signed [O_W-1:0] OWN_BIAS =\n"
                 "  {{(O_W+2-2*OWN_DIGITS){1'b0}}, {(OWN_DIGITS-1){2'b01}}};");
  }
  if (p->limits > 0) {
    clearance_widths(m, p);
  }
}

/* A module that reads buses of the same names as its ports, in this cycle. */
static void judge(emission *e, const char *module, const char *connections, const exact_bus *bus,
                  int cycle) {
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  emit_text(e->m, "\n// In cycle %d of a pair:", cycle);
  for (; bus->port != NULL; bus++) {
    const gen_line name = gen_format("all_%s", bus->port);
    emission_bus(e, name.text, bus->value, cycle);
    fprintf(out, ", %s=%s", bus->port, name.text);
  }
  fclose(out);
  emit_instance(e->m, module, module + 6, "", "%s%s", connections, text);
  free(text);
}

void gen_exact_every(const exact_plan *p, char text[24]) {
  if (p->design->config.ii == 1) {
    snprintf(text, 24, "cycle");
  } else {
    snprintf(text, 24, "%d cycles", p->design->config.ii);
  }
}

/* The first cycle of a kind's units; a line of the banner. */
static void print_start(FILE *out, const exact_plan *p, graph_value v, const char *what) {
  const graph_kind *k = graph_kind_of(&p->datapath.graph, v);
  int first = k->start[0];
  for (int unit = 1; unit < k->units; unit++) {
    first = k->start[unit] < first ? k->start[unit] : first;
  }
  fprintf(out, "\n  cycle %2d  %s", first, what);
}

static char *banner_of(const exact_plan *p) {
  char every[24];
  char *text = NULL;
  size_t size = 0;
  FILE *out = open_memstream(&text, &size);
  const exact_graph *e = &p->graph;
  const graph *g = &p->datapath.graph;
  gen_exact_every(p, every);
  fprintf(out,
          "The exact datapath: the 15 orient3d of the six vertices from 34 products, a pair every\n"
          "%s. Names say which vertices: t_a1b2 is the trapezoid term of the edge from A_1\n"
          "to B_2, g_a1b2b3 the orient2d of that triangle, h its signed prism volume.",
          every);
  print_start(out, p, e->t[0][0][1], "trapezoid terms t: 15 products in ");
  fprintf(out, "%d multipliers", g->kind[e->kind.trapezoid[0]].units);
  print_start(out, p, e->g[0][0][1][3], "orient2d g, z sums z");
  print_start(out, p, e->h[0][1][3], "signed prism volumes h: 19 products in ");
  fprintf(out, "%d multipliers", (18 + p->design->config.ii - 1) / p->design->config.ii + 1);
  print_start(out, p, e->d[0][0], "orient3d d of edges");
  fprintf(out,
          "\n  cycle %2d  the verdict\n"
          "Cycle 0 is the first in which a pair stands in the first registers.",
          p->verdict_cycle);
  fclose(out);
  return text;
}

void gen_exact_core(emitter *e, const exact_plan *p) {
  char *banner = banner_of(p);
  emission core = {.m = emit_begin(e, "sepax_core", banner), .d = &p->datapath};
  free(banner);
  ports(core.m, p);
  widths(core.m, p);
  emission_declare(&core);
  for (int kind = 0; kind < p->datapath.graph.kinds; kind++) {
    emission_units(&core, kind);
  }
  if (!p->single) {
    judge(&core, "sepax_projection",
          "flat=flat, separated=separated, disjoint_x=disjoint_x, disjoint_z=disjoint_z",
          p->graph.projection, p->plane_cycle);
  }
  if (p->limits > 0) {
    judge(&core, "sepax_decide_band", "coplanar=coplanar, band=band, axis=axis", p->graph.verdict,
          p->verdict_cycle);
  } else {
    judge(&core, "sepax_decide",
          p->single ? "second=1'b0, in_plane=in_plane, coplanar=coplanar, axis=axis"
                    : "second=second, in_plane=in_plane, coplanar=coplanar, axis=axis",
          p->graph.verdict, p->verdict_cycle);
  }
  emit_end(core.m);
}
