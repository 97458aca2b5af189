/* library.c - see library.h. */
#include "library.h"
#include "text.h"
#include "tree.h"

#include <stdlib.h>
#include <string.h>

static bool is_pin(const node *n) {
  const char *direction = strcmp(n->name, "pin") == 0 ? tree_value(n, "direction") : NULL;
  return direction != NULL && strcmp(direction, "internal") != 0;
}

static void read_pin_names(lib_cell *cell, const library *lib, const node *n) {
  for (const node *p = n->child; p != NULL; p = p->next) {
    if (!is_pin(p)) {
      continue;
    }
    if (cell->pins == LIB_PINS) {
      text_fail("too many pins in", cell->name);
    }
    lib_pin *pin = &cell->pin[cell->pins++];
    pin->name = tree_copy(p->args, strlen(p->args));
    pin->output = strcmp(tree_value(p, "direction"), "output") == 0;
    pin->capacitance = tree_number(p, "capacitance", 0) * lib->farad;
  }
}

static void read_register(lib_cell *cell, const node *ff, char *state[2]) {
  char *comma = strchr(ff->args, ',');
  if (comma == NULL || tree_value(ff, "next_state") == NULL || tree_child(ff, "clear") != NULL ||
      tree_child(ff, "preset") != NULL) {
    return; /* not one that the netlists have; library_cell's user sees it has no function */
  }
  state[0] = tree_trimmed(ff->args, comma);
  state[1] = tree_trimmed(comma + 1, comma + strlen(comma));
  function_parse(&cell->next, cell, tree_value(ff, "next_state"), state[0], state[1]);
  const char *clock = tree_value(ff, "clocked_on");
  cell->clock = clock == NULL ? -1 : lib_pin_index(cell, clock);
  cell->register_ = cell->clock >= 0;
}

static void read_powers(lib_cell *cell, const node *root, const node *p, int pin, char *state[2]) {
  for (const node *n = p->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "internal_power") != 0) {
      continue;
    }
    cell->power = realloc(cell->power, (size_t)(cell->powers + 1) * sizeof *cell->power);
    if (cell->power == NULL) {
      text_fail("out of", "memory");
    }
    lib_power *power = &cell->power[cell->powers++];
    memset(power, 0, sizeof *power);
    power->pin = pin;
    const char *related = tree_value(n, "related_pin");
    power->related = related == NULL ? -1 : lib_pin_index(cell, related);
    power->when = ~UINT64_C(0);
    if (tree_value(n, "when") != NULL) {
      lib_function when = {0};
      function_parse(&when, cell, tree_value(n, "when"), state[0], state[1]);
      power->when = function_rows(cell, &when);
    }
    table_read(&power->energy[0], root, tree_child(n, "rise_power"));
    table_read(&power->energy[1], root, tree_child(n, "fall_power"));
  }
}

static void read_arcs(lib_cell *cell, const node *root, const node *p, int pin) {
  for (const node *n = p->child; n != NULL; n = n->next) {
    const char *related = strcmp(n->name, "timing") == 0 ? tree_value(n, "related_pin") : NULL;
    const char *sense = related == NULL ? NULL : tree_value(n, "timing_sense");
    const char *type = related == NULL ? NULL : tree_value(n, "timing_type");
    if (related == NULL || tree_child(n, "rise_transition") == NULL) {
      continue;
    }
    cell->arc = realloc(cell->arc, (size_t)(cell->arcs + 1) * sizeof *cell->arc);
    if (cell->arc == NULL) {
      text_fail("out of", "memory");
    }
    lib_arc *arc = &cell->arc[cell->arcs++];
    memset(arc, 0, sizeof *arc);
    arc->to = pin;
    arc->from = lib_pin_index(cell, related);
    arc->clocked = type != NULL && strcmp(type, "rising_edge") == 0;
    arc->on_rise = sense == NULL || strcmp(sense, "negative_unate") != 0;
    arc->on_fall = sense == NULL || strcmp(sense, "positive_unate") != 0;
    table_read(&arc->slope[0], root, tree_child(n, "rise_transition"));
    table_read(&arc->slope[1], root, tree_child(n, "fall_transition"));
  }
}

/* All functions first, as a `when` may ask for an output. */
static void read_pins(lib_cell *cell, const node *root, const node *n, char *state[2]) {
  int pin = 0;
  for (const node *p = n->child; p != NULL; p = p->next) {
    if (is_pin(p)) {
      if (tree_child(p, "three_state") == NULL && tree_value(p, "function") != NULL) {
        function_parse(&cell->pin[pin].function, cell, tree_value(p, "function"), state[0],
                       state[1]);
      }
      pin++;
    }
  }
  pin = 0;
  for (const node *p = n->child; p != NULL; p = p->next) {
    if (is_pin(p)) {
      read_powers(cell, root, p, pin, state);
      read_arcs(cell, root, p, pin++);
    }
  }
}

static void read_cell(lib_cell *cell, const library *lib, const node *root, const node *n,
                      double watt) {
  char *state[2] = {NULL, NULL};
  cell->name = tree_copy(n->args, strlen(n->args));
  cell->leakage = tree_number(n, "cell_leakage_power", 0) * watt;
  read_pin_names(cell, lib, n);
  if (tree_child(n, "ff") != NULL) {
    read_register(cell, tree_child(n, "ff"), state);
  }
  if (tree_child(n, "latch") == NULL && tree_child(n, "statetable") == NULL &&
      (tree_child(n, "ff") == NULL || cell->register_) &&
      function_inputs(cell) + cell->register_ <= 6) {
    read_pins(cell, root, n, state);
  }
  free(state[0]);
  free(state[1]);
}

/* The default wire load: a length for a number of loads, linear between, `slope` beyond. */
static void read_wires(library *lib, const node *root) {
  const char *name = tree_value(root, "default_wire_load");
  const node *model = root->child;
  while (model != NULL && (name == NULL || strcmp(model->name, "wire_load") != 0 ||
                           strcmp(model->args, name) != 0)) {
    model = model->next;
  }
  if (model == NULL) {
    return;
  }
  double at = 0;
  double length = 0;
  double slope = 0;
  int next = 1;
  for (const node *n = model->child; n != NULL; n = n->next) {
    double point[2];
    if (strcmp(n->name, "fanout_length") != 0 || table_numbers(n->args, point, 2) != 2) {
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
  text_file = path;
  char *text = text_read("give a plain Liberty file");
  node *top = tree_read(text);
  const node *root = tree_child(top, "library");
  const node *load = tree_child(root, "capacitive_load_unit");
  lib->farad = load == NULL ? 1e-12 : tree_unit(load->args, 1e-12);
  lib->volt = tree_number(root, "nom_voltage", 0);
  double volt_unit = tree_unit(tree_value(root, "voltage_unit"), 1);
  lib->joule = lib->farad * volt_unit * volt_unit;
  double watt = tree_unit(tree_value(root, "leakage_power_unit"), 1e-9);
  read_wires(lib, root);
  for (const node *n = root->child; n != NULL; n = n->next) {
    lib->cells += strcmp(n->name, "cell") == 0;
  }
  lib->cell = text_alloc(lib->cells, sizeof *lib->cell);
  size_t k = 0;
  for (const node *n = root->child; n != NULL; n = n->next) {
    if (strcmp(n->name, "cell") == 0) {
      read_cell(&lib->cell[k++], lib, root, n, watt);
    }
  }
  tree_free(top);
  free(text);
}

const lib_cell *library_cell(const library *lib, const char *name) {
  for (size_t k = 0; k < lib->cells; k++) {
    if (strcmp(lib->cell[k].name, name) == 0) {
      return &lib->cell[k];
    }
  }
  return NULL;
}
