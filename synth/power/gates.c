/* SPDX-License-Identifier: MIT */
/* gates.c - simulates a mapped netlist, 64 lanes at once. */
#include "gates.h"
#include "liberty/text.h"

#include <math.h>
#include <string.h>

static const gates_port *port_of(const gates *g, const char *name) {
  for (int k = 0; k < g->ports; k++) {
    if (strcmp(g->port[k].name, name) == 0) {
      return &g->port[k];
    }
  }
  return NULL;
}

const gates_port *gates_find(const gates *g, const char *name, int bits) {
  const gates_port *port = port_of(g, name);
  if (port == NULL) {
    text_fail("has no port", name);
  }
  if (bits != 0 && port->bits != bits) {
    text_fail("has not the bits of the design's port", name);
  }
  return port;
}

int gates_clock(const gates *g) {
  return gates_find(g, port_of(g, "aclk") != NULL ? "aclk" : "clk", 1)->net[0];
}

void gates_reset(gates *g, bool on) {
  bool low = port_of(g, "aresetn") != NULL;
  *gates_bit(g, low ? "aresetn" : "rst") = on == low ? 0 : ~UINT64_C(0);
}

uint64_t *gates_bit(const gates *g, const char *name) {
  return &g->value[gates_find(g, name, 1)->net[0]];
}

void gates_set(gates *g, const int net[], int bits, unsigned lane, uint64_t value) {
  uint64_t mask = UINT64_C(1) << lane;
  for (int k = 0; k < bits; k++) {
    g->value[net[k]] = (value >> k & 1) != 0 ? g->value[net[k]] | mask : g->value[net[k]] & ~mask;
  }
}

void gates_set_all(gates *g, const gates_port *port, uint64_t value) {
  for (int k = 0; k < port->bits; k++) {
    g->value[port->net[k]] = (value >> k & 1) != 0 ? ~UINT64_C(0) : 0;
  }
}

uint64_t gates_get(const gates *g, const int net[], int bits, unsigned lane) {
  uint64_t value = 0;
  for (int k = 0; k < bits; k++) {
    value |= (g->value[net[k]] >> lane & 1) << k;
  }
  return value;
}

/* ---------------------------------------------------------------------- counting */

void gates_tally(gates_count count, uint64_t lanes) {
  if (lanes == 0) {
    return;
  }
  lanes -= lanes >> 1 & 0x5555555555555555; /* of each two bits how many are 1, four, eight */
  lanes = (lanes & 0x3333333333333333) + (lanes >> 2 & 0x3333333333333333);
  lanes = (lanes + (lanes >> 4)) & 0x0f0f0f0f0f0f0f0f;
  for (int k = 0; k < GATES_GROUPS; k++) {
    count[k] += lanes >> (8 * k) & 0xff;
  }
}

double gates_error(const double of_group[GATES_GROUPS]) {
  double sum = 0;
  double squares = 0;
  for (int k = 0; k < GATES_GROUPS; k++) {
    sum += of_group[k];
  }
  double mean = sum / GATES_GROUPS;
  for (int k = 0; k < GATES_GROUPS; k++) {
    squares += (of_group[k] - mean) * (of_group[k] - mean);
  }
  return mean > 0 ? sqrt(squares / (GATES_GROUPS - 1) / GATES_GROUPS) / mean : 0;
}

/* -------------------------------------------------------------------- simulation */

/* The table is halved by each input: rows in which it is 0 and 1 become one. */
uint64_t gates_evaluate(const lib_cell *type, uint64_t table, const uint64_t in[], uint64_t state) {
  uint64_t row[1 << LIB_INPUTS] = {0};
  int rows = 1 << (type->inputs + type->register_);
  for (int r = 0; r < rows; r++) {
    row[r] = (table >> r & 1) != 0 ? ~UINT64_C(0) : 0;
  }
  for (int k = 0; rows > 1; k++) {
    if (k < type->pins && type->pin[k].output) {
      continue;
    }
    uint64_t by = k < type->pins ? in[k] : state;
    rows /= 2;
    for (int r = 0; r < rows; r++) {
      row[r] = (row[2 * r] & ~by) | (row[2 * r + 1] & by);
    }
  }
  return row[0];
}

static uint64_t evaluate(const gates *g, const gates_cell *cell, uint64_t table) {
  uint64_t in[LIB_PINS];
  for (int k = 0; k < cell->type->pins; k++) {
    in[k] = cell->type->pin[k].output ? 0 : g->value[cell->net[k]];
  }
  return gates_evaluate(cell->type, table, in, cell->state);
}

void gates_settle(gates *g) {
  for (int c = 0; c < g->cells; c++) {
    const gates_cell *cell = &g->cell[c];
    for (int p = 0; p < cell->type->pins; p++) {
      if (cell->type->pin[p].output && cell->net[p] >= 0) {
        g->value[cell->net[p]] = evaluate(g, cell, cell->type->pin[p].rows);
      }
    }
  }
}

void gates_rise(gates *g, bool count) {
  if (count) {
    g->cycles++;
    for (int k = 0; k < g->nets; k++) {
      gates_tally(g->toggles[k], g->value[k] ^ g->before[k]);
      gates_tally(g->ones[k], g->value[k]);
    }
    if (g->count_all != NULL) {
      g->count_all(g);
    }
  }
  memcpy(g->before, g->value, (size_t)g->nets * sizeof *g->before);
  for (int c = 0; c < g->cells && g->cell[c].type->register_; c++) {
    gates_cell *cell = &g->cell[c];
    int clock = cell->net[cell->type->clock];
    uint64_t edge = clock == g->clock ? ~UINT64_C(0) : g->value[clock];
    cell->state = (evaluate(g, cell, cell->type->next) & edge) | (cell->state & ~edge);
  }
}
