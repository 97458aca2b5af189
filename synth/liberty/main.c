/* SPDX-License-Identifier: MIT */
/* main.c - what the scripts ask about a Liberty file.
 *
 *   liberty FILE.lib                                     its cells as JSON
 *   liberty -d DELAY -k LEAKAGE -s SUFFIX FILE.lib       a slower, less leaky variant of it
 *
 * The JSON: library, leakage_unit_w, capacitance_unit_f, and cells by name: area, footprint,
 * leakage, state (ff, latch, ... with their functions; none: combinational), and pins by name:
 * direction, capacitance, function, three_state, clock_gate (clock, enable, test or out: what the
 * pin is to a clock gate whose latch opens while the clock is low), max_capacitance,
 * max_transition, max_fanout (the pin's own limit, or else the library's default) and fanout_load.
 * What the file does not say is null. Exit status 2: it could not be done. */
#include "derive.h"
#include "tree.h"

#include <err.h>
#include <getopt.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>

static json_t *text_of(const node *n, const char *name) {
  const char *value = tree_value(n, name);
  return value == NULL ? json_null() : json_string(value);
}

static json_t *number_of(const node *n, const char *name) {
  return tree_value(n, name) == NULL ? json_null() : json_real(tree_number(n, name, 0));
}

/* What a register or latch is made of: its kind, the names of its states, all its functions. */
static json_t *state_of(const node *n) {
  json_t *state = json_pack("{s:s, s:s}", "kind", n->name, "names", n->args);
  for (const node *f = n->child; f != NULL; f = f->next) {
    if (f->value != NULL) {
      json_object_set_new(state, f->name, json_string(f->value));
    }
  }
  return state;
}

/* Limits of a pin: its own, or else the library's default. */
static void add_limits(json_t *pin, const node *library, const node *n) {
  static const char *const own[] = {"max_capacitance", "max_transition", "max_fanout",
                                    "fanout_load"};
  static const char *const by_default[] = {"default_max_capacitance", "default_max_transition",
                                           "default_max_fanout", "default_fanout_load"};
  for (size_t k = 0; k < sizeof own / sizeof own[0]; k++) {
    bool has = tree_value(n, own[k]) != NULL;
    json_object_set_new(pin, own[k],
                        has ? number_of(n, own[k]) : number_of(library, by_default[k]));
  }
}

static json_t *pin_of(const node *library, const node *cell, const node *n) {
  const char *gate = tree_clock_gate(cell, n);
  json_t *pin = json_pack("{s:o, s:o, s:o, s:o, s:o}", "direction", text_of(n, "direction"),
                          "capacitance", number_of(n, "capacitance"), "function",
                          text_of(n, "function"), "three_state", text_of(n, "three_state"),
                          "clock_gate", gate == NULL ? json_null() : json_string(gate));
  add_limits(pin, library, n);
  return pin;
}

static json_t *cell_of(const node *library, const node *cell) {
  static const char *const kinds[] = {"ff", "ff_bank", "latch", "latch_bank", "statetable"};
  json_t *pins = json_object();
  json_t *states = json_array();
  for (const node *n = tree_child(cell, "pin"); n != NULL; n = tree_next(n)) {
    json_object_set_new(pins, n->args, pin_of(library, cell, n));
  }
  for (size_t k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
    for (const node *n = tree_child(cell, kinds[k]); n != NULL; n = tree_next(n)) {
      json_array_append_new(states, state_of(n));
    }
  }
  return json_pack("{s:o, s:o, s:o, s:o, s:o}", "area", number_of(cell, "area"), "footprint",
                   text_of(cell, "cell_footprint"), "leakage",
                   number_of(cell, "cell_leakage_power"), "state", states, "pins", pins);
}

static int print_cells(const node *library) {
  json_t *cells = json_object();
  for (const node *n = tree_child(library, "cell"); n != NULL; n = tree_next(n)) {
    json_object_set_new(cells, n->args, cell_of(library, n));
  }
  const node *load = tree_child(library, "capacitive_load_unit");
  double watt = tree_unit(tree_value(library, "leakage_power_unit"), 1e-9);
  double farad = tree_unit(load == NULL ? NULL : load->args, 1e-12);
  json_t *all =
      json_pack("{s:s, s:f, s:f, s:o}", "library", library->args == NULL ? "" : library->args,
                "leakage_unit_w", watt, "capacitance_unit_f", farad, "cells", cells);
  int status = json_dumpf(all, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(15));
  putchar('\n');
  json_decref(all);
  return status == 0 ? 0 : 2;
}

int main(int argc, char **argv) {
  const char *given[128] = {NULL}; /* by the option's letter */
  int options = 0;
  for (int option; (option = getopt(argc, argv, "d:k:s:")) != -1; options++) {
    given[option] = optarg;
  }
  bool all = given['d'] != NULL && given['k'] != NULL && given['s'] != NULL;
  if (optind + 1 != argc || (options > 0 && !all)) {
    errx(2, "usage: liberty [-d DELAY -k LEAKAGE -s SUFFIX] FILE.lib");
  }
  const node *library = tree_read(argv[optind]);
  if (!all) {
    return print_cells(library);
  }
  derive(library, given['d'], given['k'], given['s']);
  return 0;
}
