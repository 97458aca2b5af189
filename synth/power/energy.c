/* SPDX-License-Identifier: MIT */
/* energy.c - transitions of nets become leakage, internal and switching power, by the library. */
#include "analysis.h"
#include "glitches.h"
#include "liberty/text.h"

#include <math.h>

enum { ALL = -1 };

static double of_lanes(const gates_count count, int group) {
  double sum = 0;
  for (int k = 0; k < GATES_GROUPS; k++) {
    sum += group == ALL || group == k ? (double)count[k] : 0;
  }
  return sum / (group == ALL ? GATES_LANES : GATES_LANES / GATES_GROUPS);
}

/* Of a group of lanes or of all: act, and m->one. */
static void find_activities(const analysis *m, const gates_count count[], int group, double act[]) {
  const gates *g = &m->g;
  for (int k = 0; k < g->nets; k++) {
    bool global = m->want->global >= 0;
    double all = (double)g->cycles;
    act[k] = global ? m->want->global : m->want->fault * of_lanes(count[k], group) / all;
    m->one[k] = global ? 0.5 : of_lanes(g->ones[k], group) / all;
  }
  for (int c = 0; c < g->cells; c++) { /* up and down in each cycle that a clock gate passes */
    const gates_cell *cell = &g->cell[c];
    for (int k = 0; cell->phase != 0 && k < cell->type->pins; k++) {
      int net = cell->net[k];
      if (cell->type->pin[k].output && net >= 0) {
        double passes = cell->phase > 0 ? m->one[net] : 1 - m->one[net];
        act[net] = 2 * passes;
        m->one[net] = cell->phase > 0 ? passes / 2 : 1 - passes / 2;
      }
    }
  }
  act[0] = act[1] = m->one[0] = 0;
  m->one[1] = 1;
  act[g->clock] = 2;
  m->one[g->clock] = 0.5;
}

/* Of the groups' power, or energy a pair. */
static double find_error(const analysis *m, const gates_count count[]) {
  double of_group[GATES_GROUPS];
  for (int k = 0; k < GATES_GROUPS; k++) {
    find_activities(m, count, k, m->act);
    of_group[k] = power_sum(m);
    if (m->taken_by[k] > 0) {
      of_group[k] /= (double)m->taken_by[k];
    }
  }
  return gates_error(of_group);
}

void power_count(analysis *m) {
  const gates_count *all =
      (const gates_count *)(m->g.changes != NULL ? m->g.changes : m->g.toggles);
  m->act = text_alloc((size_t)m->g.nets, sizeof *m->act);
  m->one = text_alloc((size_t)m->g.nets, sizeof *m->one);
  if (m->want->global < 0) {
    m->error = find_error(m, all);
  }
  find_activities(m, all, ALL, m->act);
  m->settled = m->act;
  if (m->g.changes != NULL) {
    m->settled = text_alloc((size_t)m->g.nets, sizeof *m->settled);
    find_activities(m, (const gates_count *)m->g.toggles, ALL, m->settled);
  }
}

static void find_loads(analysis *m) {
  gates *g = &m->g;
  m->loads = text_alloc((size_t)g->nets, sizeof *m->loads);
  m->load = text_alloc((size_t)g->nets, sizeof *m->load);
  for (int c = 0; c < g->cells; c++) {
    const lib_cell *type = g->cell[c].type;
    for (int k = 0; k < type->pins; k++) {
      if (!type->pin[k].output && g->cell[c].net[k] >= 0) {
        m->load[g->cell[c].net[k]] += type->pin[k].capacitance;
        m->loads[g->cell[c].net[k]]++;
      }
    }
  }
  for (int k = 0; k < g->ports; k++) {
    for (int bit = 0; bit < g->port[k].bits; bit++) {
      m->loads[g->port[k].net[bit]] += g->port[k].output;
    }
  }
  for (int k = 0; k < g->nets; k++) {
    m->load[k] += m->lib.wire[m->loads[k] < LIB_FANOUT ? m->loads[k] : LIB_FANOUT - 1];
  }
}

/* Of what the cell drives; slopes of its inputs are known. */
static void find_slopes(analysis *m, const gates_cell *cell) {
  for (int k = 0; k < cell->type->arcs; k++) {
    const lib_arc *arc = &cell->type->arc[k];
    int to = cell->net[arc->to];
    if (to < 0 || arc->from < 0) {
      continue;
    }
    double load = m->load[to] / m->lib.farad;
    for (int edge = 0; edge < 2; edge++) {   /* of the output */
      for (int from = 0; from < 2; from++) { /* of the input */
        bool causes = arc->clocked ? from == 0 : from == edge ? arc->on_rise : arc->on_fall;
        double in = arc->clocked ? 0 : m->slope[cell->net[arc->from]][from];
        double slope = causes ? lib_look_up(&arc->slope[edge], in, load) : 0;
        if (slope > m->slope[to][edge]) {
          m->slope[to][edge] = slope;
        }
      }
    }
  }
}

/* From each pin to each output: the mean of both edges, by the slowest of its arcs. */
static cell_delays find_delays(const analysis *m, const gates_cell *cell) {
  size_t pins = (size_t)cell->type->pins;
  cell_delays delay = text_alloc(pins * pins, sizeof *delay);
  for (int k = 0; k < cell->type->arcs; k++) {
    const lib_arc *arc = &cell->type->arc[k];
    if (arc->from < 0 || cell->net[arc->to] < 0) {
      continue;
    }
    double load = m->load[cell->net[arc->to]] / m->lib.farad;
    double sum = 0;
    for (int edge = 0; edge < 2; edge++) {
      int from = arc->on_rise ? edge : 1 - edge; /* the input's edge */
      double in = arc->clocked ? 0 : m->slope[cell->net[arc->from]][from];
      sum += lib_look_up(&arc->delay[edge], in, load);
    }
    double ps = 1000 * sum / 2;
    uint16_t *to = &delay[(size_t)arc->from * pins + (size_t)arc->to];
    if (ps > *to) {
      *to = ps < UINT16_MAX ? (uint16_t)lround(ps) : UINT16_MAX;
    }
  }
  return delay;
}

void power_prepare(analysis *m) {
  find_loads(m);
  m->slope = text_alloc((size_t)m->g.nets, sizeof *m->slope);
  for (int c = 0; c < m->g.cells; c++) {
    find_slopes(m, &m->g.cell[c]);
  }
  if (m->want->glitches > 0) {
    cell_delays *delay = text_alloc((size_t)m->g.cells, sizeof *delay);
    for (int c = 0; c < m->g.cells; c++) {
      delay[c] = find_delays(m, &m->g.cell[c]);
    }
    glitches_begin(&m->g, delay, m->want->glitches);
  }
}

/* Energy (J) of a transition by these tables, rising and falling in equal parts. */
static double energy_of(const analysis *m, const gates_cell *cell, const lib_power *power) {
  int from = cell->net[power->related >= 0 ? power->related : power->pin];
  int out = cell->net[power->pin];
  double load = cell->type->pin[power->pin].output ? m->load[out] / m->lib.farad : 0;
  double sum = 0;
  for (int edge = 0; edge < 2; edge++) {
    sum += lib_look_up(&power->energy[edge], from < 0 ? 0 : m->slope[from][edge], load);
  }
  return sum / 2 * m->lib.joule;
}

/* Inside the cell for transitions of a pin, in a cycle (J). An output's is the mean of its tables,
 * by how often their inputs move. */
static double pin_energy(const analysis *m, const gates_cell *cell, int pin, const double row[],
                         int rows) {
  const lib_cell *type = cell->type;
  bool by_inputs = type->pin[pin].output && !m->want->as_sta;
  double energy = 0;
  double weight = 0;
  double plain = 0;
  int tables = 0;
  for (int k = 0; k < type->powers; k++) {
    const lib_power *power = &type->power[k];
    if (power->pin != pin) {
      continue;
    }
    double likely = 0;
    for (int r = 0; r < rows; r++) {
      likely += (power->when >> r & 1) != 0 ? row[r] : 0;
    }
    double each = energy_of(m, cell, power);
    double w = likely * (by_inputs && power->related >= 0 ? m->act[cell->net[power->related]] : 1);
    energy += w * each;
    weight += w;
    plain += each;
    tables++;
  }
  double mean = !by_inputs || tables == 0 ? energy : weight > 0 ? energy / weight : plain / tables;
  return mean * m->act[cell->net[pin]] * (m->want->as_sta ? 2 : 1);
}

/* Inside the cell, in a cycle (J). */
static double internal_energy(const analysis *m, const gates_cell *cell) {
  const lib_cell *type = cell->type;
  double one[LIB_PINS];
  double row[1 << LIB_INPUTS];
  double state = 0.5;
  double differ = 0.5;
  for (int k = 0; k < type->pins; k++) {
    one[k] = cell->net[k] >= 0 ? m->one[cell->net[k]] : 0.5;
    if (type->register_ && type->pin[k].output && cell->net[k] >= 0) {
      state = (type->pin[k].rows & 1) == 0 ? one[k] : 1 - one[k];
      differ = m->want->global >= 0 ? 0.5 : m->act[cell->net[k]];
    }
  }
  int rows = type->powers > 0 ? lib_rows(type, one, state, differ, row) : 0;
  double sum = 0;
  for (int k = 0; k < type->pins; k++) {
    sum += cell->net[k] < 0 ? 0 : pin_energy(m, cell, k, row, rows);
  }
  return sum;
}

watts power_of(const analysis *m, const gates_cell *cell) {
  double rate = 1e9 / m->want->period;
  double volt = m->lib.volt;
  watts w = {.leakage = cell->type->leakage, .internal = internal_energy(m, cell) * rate};
  for (int k = 0; k < cell->type->pins; k++) {
    int net = cell->net[k];
    if (cell->type->pin[k].output && net >= 0) {
      w.switching += 0.5 * m->load[net] * volt * volt * m->act[net] * rate;
    }
  }
  return w;
}

double power_sum(const analysis *m) {
  double sum = 0;
  for (int c = 0; c < m->g.cells; c++) {
    watts w = power_of(m, &m->g.cell[c]);
    sum += w.leakage + w.internal + w.switching;
  }
  return sum;
}
