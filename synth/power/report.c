/* SPDX-License-Identifier: MIT */
/* report.c - what build/power writes. */
#include "analysis.h"
#include "liberty/text.h"
#include "util/write_file.h"

#include <err.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>

/* What OpenSTA lets be set: inputs of the top, and all pins of cells. */
static bool write_pins(FILE *out, const void *context) {
  const analysis *m = context;
  const gates *g = &m->g;
  for (int k = 0; k < g->ports; k++) {
    const gates_port *port = &g->port[k];
    for (int bit = 0; bit < port->bits && !port->output && port->net[0] != g->clock; bit++) {
      fprintf(out, port->bits > 1 ? "port %s[%d]" : "port %s", port->name, bit);
      fprintf(out, " %.6g %.6g\n", m->act[port->net[bit]], m->one[port->net[bit]]);
    }
  }
  for (int c = 0; c < g->cells; c++) {
    const gates_cell *cell = &g->cell[c];
    for (int k = 0; k < cell->type->pins; k++) {
      int net = cell->net[k];
      if (net > 1 && net != g->clock) {
        fprintf(out, "pin %s%s/%s %.6g %.6g\n", g->instance[cell->instance].path, cell->name,
                cell->type->pin[k].name, m->act[net], m->one[net]);
      }
    }
  }
  return true;
}

static bool write_cells(FILE *out, const void *context) {
  const analysis *m = context;
  for (int c = 0; c < m->g.cells; c++) {
    const gates_cell *cell = &m->g.cell[c];
    watts w = power_of(m, cell);
    fprintf(out, "%s%s %s %.6g %.6g %.6g\n", m->g.instance[cell->instance].path, cell->name,
            cell->type->name, w.internal, w.switching, w.leakage);
  }
  return true;
}

static void write_file(const char *path, bool (*write)(FILE *, const void *), const analysis *m) {
  sepax_error error = {0};
  if (path != NULL && !sepax_write_file(path, write, m, &error)) {
    errx(2, "%s", error.text);
  }
}

static void add(watts *to, watts w) {
  to->leakage += w.leakage;
  to->internal += w.internal;
  to->switching += w.switching;
}

static double sum_of(watts w) { return w.leakage + w.internal + w.switching; }

/* The object, and in it the power. */
static json_t *with_power(json_t *object, watts w) {
  json_object_update_new(object,
                         json_pack("{s:f, s:f, s:f, s:f}", "leakage_w", w.leakage, "internal_w",
                                   w.internal, "switching_w", w.switching, "total_w", sum_of(w)));
  return object;
}

/* The same without what comes and goes between two edges. */
static double settled_sum(const analysis *m) {
  analysis quiet = *m;
  quiet.act = m->settled;
  return power_sum(&quiet);
}

void power_report(const analysis *m) {
  const gates *g = &m->g;
  write_file(m->want->pins, write_pins, m);
  write_file(m->want->by_cell, write_cells, m);
  watts *own = text_alloc((size_t)g->instances, sizeof *own);
  int *cells = text_alloc((size_t)g->instances, sizeof *cells);
  watts all = {0, 0, 0};
  watts registers = {0, 0, 0};
  for (int c = 0; c < g->cells; c++) {
    watts w = power_of(m, &g->cell[c]);
    add(&own[g->cell[c].instance], w);
    add(&all, w);
    if (g->cell[c].type->register_) {
      add(&registers, w);
    }
    cells[g->cell[c].instance]++;
  }
  json_t *instances = json_array();
  for (int k = 0; k < g->instances; k++) {
    json_t *row = json_pack("{s:s, s:s, s:i}", "path", g->instance[k].path, "module",
                            g->instance[k].module, "cells", cells[k]);
    json_array_append_new(instances, with_power(row, own[k]));
  }
  free(own);
  free(cells);
  double cycle_pj = sum_of(all) * m->want->period * 1e3;
  double lane_cycles = (double)g->cycles * GATES_LANES;
  json_t *report = json_pack(
      "{s:f, s:i, s:I, s:I, s:I, s:I, s:I, s:I, s:f, s:i, s:f, s:o}", "period_ns", m->want->period,
      "lanes", GATES_LANES, "cycles", (json_int_t)g->cycles, "pairs", (json_int_t)m->taken,
      "judged", (json_int_t)m->judged, "collisions", (json_int_t)m->collisions, "coplanar",
      (json_int_t)m->coplanar, "wrong", (json_int_t)m->wrong, "undecided_percent",
      m->pairs > 0 ? 100.0 * (double)m->undecided / (double)m->pairs : 0.0, "cells", g->cells,
      "cycle_pj", cycle_pj, "pair_pj",
      m->taken > 0 ? json_real(cycle_pj * lane_cycles / (double)m->taken) : json_null());
  if (m->want->global < 0) {
    json_object_set_new(report, "error", json_real(m->error));
  }
  if (m->engine->runs) {
    json_object_update_new(report,
                           json_pack("{s:f, s:s}", "run_nj", cycle_pj * 1e-3 * (double)g->cycles,
                                     "memories", "not counted"));
  }
  if (m->want->glitches > 0) {
    double without = settled_sum(m);
    json_object_update_new(report,
                           json_pack("{s:f, s:f, s:f}", "settled_w", without, "glitch_factor",
                                     sum_of(all) / without, "latest_ns", 1e-3 * m->g.latest));
  }
  if (m->poses > 0) {
    double nj = cycle_pj * 1e-3 * lane_cycles / (double)m->poses;
    json_object_update_new(report,
                           json_pack("{s:I, s:f}", "poses", (json_int_t)m->poses, "pose_nj", nj));
  }
  json_object_update_new(with_power(report, all),
                         json_pack("{s:o, s:f, s:o}", "registers",
                                   with_power(json_object(), registers), "clock_pins_pj",
                                   m->load[g->clock] * m->lib.volt * m->lib.volt * 1e12,
                                   "instances", instances));
  if (json_dumpf(report, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(6)) != 0 ||
      fputs("\n", stdout) < 0) {
    errx(2, "the report cannot be written");
  }
  json_decref(report);
}
