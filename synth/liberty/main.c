/* main.c - what the scripts ask about a Liberty file.
 *
 *   liberty FILE.lib                                     its cells as JSON
 *   liberty -d DELAY -k LEAKAGE -s SUFFIX FILE.lib       a slower, less leaky variant of it
 *
 * The JSON: library, leakage_unit_w, capacitance_unit_f, and cells by name: area, footprint,
 * leakage, state (ff, latch, ... with their functions; none: combinational), and pins by name:
 * direction, capacitance, function, three_state. What the file does not say is null. Exit status
 * 2: it could not be done. */
#include "derive.h"
#include "text.h"
#include "tree.h"

#include <getopt.h>
#include <jansson.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static json_t *text_of(const node *n, const char *name) {
  const char *value = tree_value(n, name);
  return value == NULL ? json_null() : json_string(value);
}

static json_t *number_of(const node *n, const char *name) {
  return tree_value(n, name) == NULL ? json_null() : json_real(tree_number(n, name, 0));
}

static bool is_state(const char *name) {
  return strcmp(name, "ff") == 0 || strcmp(name, "ff_bank") == 0 || strcmp(name, "latch") == 0 ||
         strcmp(name, "latch_bank") == 0 || strcmp(name, "statetable") == 0;
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

static json_t *cell_of(const node *cell) {
  json_t *pins = json_object();
  json_t *states = json_array();
  for (const node *n = cell->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "pin") == 0) {
      json_object_set_new(pins, n->args,
                          json_pack("{s:o, s:o, s:o, s:o}", "direction", text_of(n, "direction"),
                                    "capacitance", number_of(n, "capacitance"), "function",
                                    text_of(n, "function"), "three_state",
                                    text_of(n, "three_state")));
    } else if (is_state(n->name)) {
      json_array_append_new(states, state_of(n));
    }
  }
  return json_pack("{s:o, s:o, s:o, s:o, s:o}", "area", number_of(cell, "area"), "footprint",
                   text_of(cell, "cell_footprint"), "leakage",
                   number_of(cell, "cell_leakage_power"), "state", states, "pins", pins);
}

static int print_cells(const node *library) {
  json_t *cells = json_object();
  for (const node *n = library->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "cell") == 0 && n->args != NULL) {
      json_object_set_new(cells, n->args, cell_of(n));
    }
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
  derivation how = {NULL, NULL, NULL};
  text_program = "liberty";
  for (int option; (option = getopt(argc, argv, "d:k:s:")) != -1;) {
    switch (option) {
    case 'd':
      how.delay = optarg;
      break;
    case 'k':
      how.leakage = optarg;
      break;
    case 's':
      how.suffix = optarg;
      break;
    default:
      return 2;
    }
  }
  bool all = how.delay != NULL && how.leakage != NULL && how.suffix != NULL;
  bool none = how.delay == NULL && how.leakage == NULL && how.suffix == NULL;
  if (optind + 1 != argc || !(all || none)) {
    fputs("usage: liberty [-d DELAY -k LEAKAGE -s SUFFIX] FILE.lib\n", stderr);
    return 2;
  }
  text_file = argv[optind];
  char *text = text_read("give a plain Liberty file");
  char *origin = tree_copy(text, strlen(text));
  node *top = tree_read(text);
  const node *library = tree_child(top, "library");
  int status = 0;
  if (all) {
    derive(text, origin, library, &how);
  } else {
    status = print_cells(library);
  }
  tree_free(top);
  free(origin);
  free(text);
  return status;
}
