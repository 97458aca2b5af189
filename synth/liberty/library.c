/* SPDX-License-Identifier: MIT */
/* library.c - reads cells.h's library from the statements of a Liberty file. */
#include "function.h"
#include "table.h"
#include "text.h"
#include "tree.h"

#include <stdlib.h>
#include <string.h>

/* The pins but internal ones; of[k] is the statement of pin k. */
static void read_pin_names(lib_cell *cell, const library *lib, const node *n, const node *of[]) {
  for (const node *p = tree_child(n, "pin"); p != NULL; p = tree_next(p)) {
    const char *direction = tree_value(p, "direction");
    if (direction == NULL || strcmp(direction, "internal") == 0) {
      continue;
    }
    if (cell->pins == LIB_PINS) {
      text_fail("too many pins in", cell->name);
    }
    of[cell->pins] = p;
    lib_pin *pin = &cell->pin[cell->pins++];
    *pin = (lib_pin){.name = p->args,
                     .output = strcmp(direction, "output") == 0,
                     .capacitance = tree_number(p, "capacitance", 0) * lib->farad};
    pin->known = !pin->output;
    if (!pin->output && cell->inputs++ < LIB_INPUTS) {
      pin->rows = function_column(cell->inputs - 1);
    }
  }
}

/* The register `ff`, whose state and complement get names; without it the cell is none that the
 * netlists have, and library_cell's user sees that it has no function. */
static bool read_register(lib_cell *cell, const node *ff, char *state[2]) {
  char *comma = strchr(ff->args, ',');
  const char *next = tree_value(ff, "next_state");
  const char *clock = tree_value(ff, "clocked_on");
  if (comma == NULL || next == NULL || clock == NULL || tree_child(ff, "clear") != NULL ||
      tree_child(ff, "preset") != NULL) {
    return false;
  }
  state[0] = tree_trimmed(ff->args, comma);
  state[1] = tree_trimmed(comma + 1, comma + strlen(comma));
  cell->next = function_rows(cell, next, state);
  cell->clock = lib_pin_index(cell, clock);
  cell->register_ = cell->clock >= 0;
  return cell->register_;
}

/* A latch, open, as the simulation of a cycle finds it at its end. */
static bool read_latch(lib_cell *cell, const node *latch, char *state[2]) {
  char *comma = strchr(latch->args, ',');
  const char *data = tree_value(latch, "data_in");
  const char *enable = tree_value(latch, "enable");
  if (comma == NULL || data == NULL || enable == NULL || tree_child(latch, "clear") != NULL ||
      tree_child(latch, "preset") != NULL) {
    return false;
  }
  state[0] = tree_trimmed(latch->args, comma);
  state[1] = tree_trimmed(comma + 1, comma + strlen(comma));
  char *const none[2] = {NULL, NULL};
  cell->next = function_rows(cell, data, none);
  uint64_t open = function_rows(cell, enable, none);
  for (int k = 0; k < cell->pins; k++) {
    bool low = open == ~cell->pin[k].rows;
    if (!cell->pin[k].output && (low || open == cell->pin[k].rows)) {
      cell->clock = k;
      cell->open_low = low;
      cell->latch = true;
    }
  }
  return cell->latch;
}

static void read_powers(lib_cell *cell, const node *root, const node *p, int pin, char *state[2]) {
  for (const node *n = tree_child(p, "internal_power"); n != NULL; n = tree_next(n)) {
    const char *related = tree_value(n, "related_pin");
    const char *when = tree_value(n, "when");
    cell->power = text_more(cell->power, (size_t)cell->powers, sizeof *cell->power);
    lib_power *power = &cell->power[cell->powers++];
    *power = (lib_power){.pin = pin,
                         .related = related == NULL ? -1 : lib_pin_index(cell, related),
                         .when = when == NULL ? ~UINT64_C(0) : function_rows(cell, when, state)};
    table_read(&power->energy[0], root, tree_child(n, "rise_power"));
    table_read(&power->energy[1], root, tree_child(n, "fall_power"));
  }
}

static void read_arcs(lib_cell *cell, const node *root, const node *p, int pin) {
  for (const node *n = tree_child(p, "timing"); n != NULL; n = tree_next(n)) {
    const char *related = tree_value(n, "related_pin");
    const char *sense = tree_value(n, "timing_sense");
    const char *type = tree_value(n, "timing_type");
    if (related == NULL || tree_child(n, "rise_transition") == NULL) {
      continue;
    }
    cell->arc = text_more(cell->arc, (size_t)cell->arcs, sizeof *cell->arc);
    lib_arc *arc = &cell->arc[cell->arcs++];
    *arc = (lib_arc){.to = pin,
                     .from = lib_pin_index(cell, related),
                     .clocked = type != NULL && strcmp(type, "rising_edge") == 0,
                     .on_rise = sense == NULL || strcmp(sense, "negative_unate") != 0,
                     .on_fall = sense == NULL || strcmp(sense, "positive_unate") != 0};
    table_read(&arc->slope[0], root, tree_child(n, "rise_transition"));
    table_read(&arc->slope[1], root, tree_child(n, "fall_transition"));
    table_read(&arc->delay[0], root, tree_child(n, "cell_rise"));
    table_read(&arc->delay[1], root, tree_child(n, "cell_fall"));
  }
}

/* All functions first, as a `when` may ask for an output. */
static void read_pins(lib_cell *cell, const node *root, const node *const of[], char *state[2]) {
  for (int k = 0; k < cell->pins; k++) {
    const char *function = tree_value(of[k], "function");
    if (cell->pin[k].output && tree_child(of[k], "three_state") == NULL && function != NULL) {
      cell->pin[k].rows = function_rows(cell, function, state);
      cell->pin[k].known = true;
    }
  }
  for (int k = 0; k < cell->pins; k++) {
    read_powers(cell, root, of[k], k, state);
    read_arcs(cell, root, of[k], k);
  }
}

/* A clock gate: the output is 1 where the clock's edge passes it. */
static bool read_gate(lib_cell *cell, const node *n, const node *const of[]) {
  int out = -1;
  uint64_t opens = 0;
  for (int k = 0; k < cell->pins; k++) {
    const char *is = tree_clock_gate(n, of[k]);
    if (is != NULL && strcmp(is, "out") == 0) {
      out = k;
    } else if (is != NULL && strcmp(is, "clock") == 0) {
      cell->clock = k;
      cell->gate = true;
    } else if (is != NULL) {
      opens |= cell->pin[k].rows;
    }
  }
  cell->gate = cell->gate && out >= 0 && opens != 0;
  if (cell->gate) {
    cell->pin[out].rows = opens;
    cell->pin[out].known = true;
  }
  return cell->gate;
}

static void read_cell(lib_cell *cell, const library *lib, const node *root, const node *n,
                      double watt) {
  char *state[2] = {NULL, NULL};
  const node *pin[LIB_PINS] = {NULL};
  const node *ff = tree_child(n, "ff");
  const node *latch = tree_child(n, "latch");
  cell->name = n->args;
  cell->leakage = tree_number(n, "cell_leakage_power", 0) * watt;
  read_pin_names(cell, lib, n, pin);
  bool gate = cell->inputs <= LIB_INPUTS && read_gate(cell, n, pin);
  if (gate || (tree_child(n, "statetable") == NULL && cell->inputs + (ff != NULL) <= LIB_INPUTS &&
               (latch == NULL || read_latch(cell, latch, state)) &&
               (ff == NULL || read_register(cell, ff, state)))) {
    read_pins(cell, root, pin, state);
  }
}

/* The default wire load: a length for a number of loads, linear between, `slope` beyond. */
static void read_wires(library *lib, const node *root) {
  const char *name = tree_value(root, "default_wire_load");
  const node *model = name == NULL ? NULL : tree_named(root, "wire_load", name);
  if (model == NULL) {
    return;
  }
  double at = 0;
  double length = 0;
  double slope = 0;
  int next = 1;
  for (const node *n = tree_child(model, "fanout_length"); n != NULL; n = tree_next(n)) {
    double point[2];
    if (table_numbers(n->args, point, 2) != 2) {
      continue;
    }
    slope = (point[1] - length) / (point[0] - at);
    for (; next < LIB_FANOUT && next <= point[0]; next++) {
      lib->wire[next] = at == 0 ? point[1] : length + slope * (next - at);
    }
    at = point[0];
    length = point[1];
  }
  for (slope = tree_number(model, "slope", slope); next < LIB_FANOUT; next++) {
    lib->wire[next] = length + slope * (next - at);
  }
  for (next = 0; next < LIB_FANOUT; next++) {
    lib->wire[next] *= tree_number(model, "capacitance", 0) * lib->farad;
  }
}

void library_read(library *lib, const char *path) {
  const node *root = tree_read(path);
  const node *load = tree_child(root, "capacitive_load_unit");
  lib->farad = load == NULL ? 1e-12 : tree_unit(load->args, 1e-12);
  lib->volt = tree_number(root, "nom_voltage", 0);
  double volt_unit = tree_unit(tree_value(root, "voltage_unit"), 1);
  lib->joule = lib->farad * volt_unit * volt_unit;
  double watt = tree_unit(tree_value(root, "leakage_power_unit"), 1e-9);
  read_wires(lib, root);
  for (const node *n = tree_child(root, "cell"); n != NULL; n = tree_next(n)) {
    lib->cell = text_more(lib->cell, lib->cells, sizeof *lib->cell);
    lib->cell[lib->cells] = (lib_cell){0};
    read_cell(&lib->cell[lib->cells++], lib, root, n, watt);
  }
}

const lib_cell *library_cell(const library *lib, const char *name) {
  for (size_t k = 0; k < lib->cells; k++) {
    if (strcmp(lib->cell[k].name, name) == 0) {
      return &lib->cell[k];
    }
  }
  return NULL;
}
