/* SPDX-License-Identifier: MIT */
/* netlist.c - reads a mapped netlist, Yosys' write_json, into all its instances. */
#include "gates.h"
#include "liberty/text.h"
#include "sepax_vectors.h"

#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  json_t *modules;
  const library *lib;
  gates *g;
  int *same; /* of each net: one that it is the same as */
} builder;

/* An instance, and of each bit of its module the net, or -1. */
typedef struct {
  int instance;
  int *net;
  int bits;
} scope;

static int new_net(builder *b) {
  b->same = text_more(b->same, (size_t)b->g->nets, sizeof *b->same);
  b->same[b->g->nets] = b->g->nets;
  return b->g->nets++;
}

static int root_of(const builder *b, int net) {
  while (b->same[net] != net) {
    b->same[net] = b->same[b->same[net]];
    net = b->same[net];
  }
  return net;
}

static void join(builder *b, int net, int other) {
  net = root_of(b, net);
  other = root_of(b, other);
  if (net < 2 && other < 2 && net != other) {
    text_fail("0 and 1 are joined in", b->g->instance[0].module);
  }
  b->same[net < other ? other : net] = net < other ? net : other;
}

/* Place k of a list of bits: their numbers are from 2 on, as in the file, or "0", "1". */
static int *place_of(scope *s, const json_t *bits, size_t k) {
  const json_t *bit = json_array_get(bits, k);
  const char *constant = json_string_value(bit);
  int number = constant == NULL             ? (int)json_integer_value(bit)
               : strcmp(constant, "0") == 0 ? 0
               : strcmp(constant, "1") == 0 ? 1
                                            : -1;
  if (number < 0 || (constant == NULL && number < 2)) {
    text_fail("has a bit that is not understood:", constant == NULL ? "a number" : constant);
  }
  for (; s->bits <= number; s->bits++) {
    s->net = text_more(s->net, (size_t)s->bits, sizeof *s->net);
    s->net[s->bits] = s->bits < 2 ? s->bits : -1;
  }
  return &s->net[number];
}

static int net_of(builder *b, scope *s, const json_t *bits, size_t k) {
  int *net = place_of(s, bits, k);
  *net = *net < 0 ? new_net(b) : *net;
  return *net;
}

static void add_cell(builder *b, const char *name, const json_t *cell, scope *in) {
  const char *type = json_string_value(json_object_get(cell, "type"));
  const lib_cell *of = library_cell(b->lib, type);
  if (of == NULL) {
    text_fail("neither a module nor a cell of the library:", type);
  }
  gates *g = b->g;
  g->cell = text_more(g->cell, (size_t)g->cells, sizeof *g->cell);
  gates_cell *it = &g->cell[g->cells++];
  *it = (gates_cell){.type = of, .name = name, .instance = in->instance};
  memset(it->net, 0xff, sizeof it->net);
  const char *pin_name;
  json_t *bits;
  json_object_foreach(json_object_get(cell, "connections"), pin_name, bits) {
    int pin = lib_pin_index(of, pin_name);
    if (pin < 0 || json_array_size(bits) > 1) {
      text_fail("a pin that the library does not have, of", name);
    }
    if (json_array_size(bits) == 1) {
      it->net[pin] = net_of(b, in, bits, 0);
    }
  }
}

static json_t *module_of(const builder *b, const json_t *cell) {
  return json_object_get(b->modules, json_string_value(json_object_get(cell, "type")));
}

/* Nets of a module's ports are those that its instance is connected to. */
static void connect(builder *b, scope *s, const json_t *ports, json_t *connections, scope *outer) {
  const char *name;
  json_t *bits;
  json_object_foreach(connections, name, bits) {
    const json_t *inside = json_object_get(json_object_get(ports, name), "bits");
    if (json_array_size(bits) != 0 && json_array_size(bits) != json_array_size(inside)) {
      text_fail("a connection that does not fit:", name);
    }
    for (size_t k = 0; k < json_array_size(bits); k++) {
      int net = net_of(b, outer, bits, k);
      int *in = place_of(s, inside, k);
      if (*in < 0) {
        *in = net;
      } else {
        join(b, *in, net);
      }
    }
  }
}

/* All cells of an instance of a module, whose ports are connected. */
static void build(builder *b, const char *path, const char *type, scope *s) {
  gates *g = b->g;
  s->instance = g->instances;
  g->instance = text_more(g->instance, (size_t)g->instances, sizeof *g->instance);
  g->instance[g->instances++] = (gates_instance){path, type};
  const char *cell_name;
  json_t *cell;
  json_object_foreach(json_object_get(json_object_get(b->modules, type), "cells"), cell_name,
                      cell) {
    json_t *module = module_of(b, cell);
    if (module == NULL) {
      add_cell(b, cell_name, cell, s);
      continue;
    }
    scope inner = {0};
    connect(b, &inner, json_object_get(module, "ports"), json_object_get(cell, "connections"), s);
    char *inner_path = text_alloc(strlen(path) + strlen(cell_name) + 2, 1);
    sprintf(inner_path, "%s%s/", path, cell_name);
    build(b, inner_path, json_string_value(json_object_get(cell, "type")), &inner);
    free(inner.net);
  }
}

/* The module that no other has an instance of. */
static const char *top_of(json_t *modules) {
  json_t *left = json_copy(modules);
  const char *name;
  json_t *module;
  json_object_foreach(modules, name, module) {
    const char *cell_name;
    json_t *cell;
    json_object_foreach(json_object_get(module, "cells"), cell_name, cell) {
      json_object_del(left, json_string_value(json_object_get(cell, "type")));
    }
  }
  if (json_object_size(left) != 1) {
    text_fail("has not one", "top module");
  }
  name = json_object_iter_key(json_object_iter(left));
  name = json_object_iter_key(json_object_iter_at(modules, name));
  json_decref(left);
  return name;
}

static void add_ports(builder *b, json_t *top, scope *s) {
  gates *g = b->g;
  const char *name;
  json_t *of;
  json_object_foreach(json_object_get(top, "ports"), name, of) {
    const json_t *bits = json_object_get(of, "bits");
    const char *direction = json_string_value(json_object_get(of, "direction"));
    g->port = text_more(g->port, (size_t)g->ports, sizeof *g->port);
    gates_port *port = &g->port[g->ports++];
    *port = (gates_port){.name = name,
                         .output = direction != NULL && strcmp(direction, "output") == 0,
                         .bits = (int)json_array_size(bits),
                         .net = text_alloc(json_array_size(bits), sizeof *port->net)};
    for (int k = 0; k < port->bits; k++) {
      port->net[k] = root_of(b, net_of(b, s, bits, (size_t)k));
    }
  }
}

/* ------------------------------------------------------------------------ order */

enum { UNDRIVEN = 0, FROM_OUTSIDE = -1 }; /* else the cell's number + 1 */

/* The driver of each net, one at most. */
static int *find_drivers(const gates *g) {
  int *driver = text_alloc((size_t)g->nets, sizeof *driver);
  driver[0] = driver[1] = FROM_OUTSIDE;
  for (int k = 0; k < g->ports; k++) {
    for (int bit = 0; bit < g->port[k].bits && !g->port[k].output; bit++) {
      driver[g->port[k].net[bit]] = FROM_OUTSIDE;
    }
  }
  for (int c = 0; c < g->cells; c++) {
    const lib_cell *type = g->cell[c].type;
    for (int p = 0; p < type->pins; p++) {
      int net = g->cell[c].net[p];
      if (!type->pin[p].output || net < 0) {
        continue;
      }
      if (!type->pin[p].known) {
        text_fail("the library has no function of", type->name);
      }
      if (driver[net] != UNDRIVEN) {
        text_fail("a net has two drivers, one of them", g->cell[c].name);
      }
      driver[net] = c + 1;
    }
  }
  return driver;
}

typedef struct {
  const gates *g;
  int *driver;
  enum { NEW, UNDER_WAY, DONE } * progress; /* of each cell */
  gates_cell *cell;                         /* in order */
  int cells;
} sorter;

/* What drives the net, or NULL: a cell is. */
static const gates_cell *driver_of(const sorter *s, int net) {
  return net < 0 || s->driver[net] <= 0 ? NULL : &s->g->cell[s->driver[net] - 1];
}

/* 1: with the clock, -1: against it, 0: neither. */
static int net_phase(const sorter *s, int net) {
  const gates_cell *by = driver_of(s, net);
  return net == s->g->clock ? 1 : by == NULL ? 0 : by->phase;
}

/* A clock gate made of a latch and an AND: 0 while the clock is low, else what latches say. */
static bool is_latch_gate(const sorter *s, const gates_cell *cell) {
  const lib_cell *type = cell->type;
  int clocks = 0;
  int out = 0;
  uint64_t low = ~UINT64_C(0);
  for (int p = 0; p < type->pins; p++) {
    const gates_cell *by = driver_of(s, cell->net[p]);
    if (type->pin[p].output) {
      out = p;
    } else if (cell->net[p] == s->g->clock) {
      clocks++;
      low = ~type->pin[p].rows;
    } else if (by == NULL || !by->type->latch) {
      return false;
    }
  }
  return clocks == 1 && type->inputs > 1 && (type->pin[out].rows & low) == 0;
}

/* Of a cell's outputs, by those of its drivers. Of cells with several inputs a clock gate alone
 * makes a clock. */
static int phase_of(const sorter *s, const gates_cell *cell) {
  const lib_cell *type = cell->type;
  if (type->gate || is_latch_gate(s, cell)) {
    return 1;
  }
  if (type->register_ || type->latch || type->inputs != 1 || type->pins != 2) {
    return 0;
  }
  int in = type->pin[0].output ? 1 : 0;
  bool inverts = (type->pin[1 - in].rows & 1) != 0;
  return (inverts ? -1 : 1) * net_phase(s, cell->net[in]);
}

/* The clock is the port; that of a register also what a clock gate makes of it, that of a latch
 * what opens it while the port is low. Nothing else reads a clock. */
static void check_clock(const sorter *s, const gates_cell *cell, int p) {
  const lib_cell *type = cell->type;
  int net = cell->net[p];
  int phase = net_phase(s, net);
  const gates_cell *by = driver_of(s, net);
  bool clocked = p == type->clock && (type->register_ || type->latch || type->gate);
  bool right = !clocked          ? phase == 0 || cell->phase != 0
               : type->latch     ? phase == (type->open_low ? 1 : -1)
               : type->register_ ? phase == 1 && (by == NULL || by->type->inputs > 1)
                                 : net == s->g->clock;
  if (!right) {
    text_fail(type->latch && phase != 0 ? "a latch that is open while the clock is high:"
              : clocked                 ? "another clock than the port, at"
                                        : "the clock is an input of",
              cell->name);
  }
}

/* Behind the combinational cells and latches that drive it; all its inputs are driven. */
static void put_in_order(sorter *s, int c) {
  gates_cell *cell = &s->g->cell[c];
  const lib_cell *type = cell->type;
  if (s->progress[c] == UNDER_WAY) {
    text_fail("has a loop without", "registers");
  }
  if (s->progress[c] == DONE) {
    return;
  }
  s->progress[c] = UNDER_WAY;
  for (int p = 0; p < type->pins; p++) {
    int net = cell->net[p];
    if (type->pin[p].output) {
      continue;
    }
    if (net < 0 || s->driver[net] == UNDRIVEN) {
      text_fail("nothing drives an input of", cell->name);
    }
    if (!type->register_ && s->driver[net] > 0) {
      put_in_order(s, s->driver[net] - 1);
    }
  }
  cell->phase = phase_of(s, cell);
  s->progress[c] = DONE;
  s->cell[s->cells++] = *cell;
}

/* Registers, then combinational cells and latches. */
static void sort_cells(gates *g) {
  sorter s = {.g = g,
              .driver = find_drivers(g),
              .progress = text_alloc((size_t)g->cells, sizeof *s.progress),
              .cell = text_alloc((size_t)g->cells, sizeof *s.cell)};
  for (int pass = 0; pass < 2; pass++) {
    for (int c = 0; c < g->cells; c++) {
      if (g->cell[c].type->register_ == (pass == 0)) {
        put_in_order(&s, c);
      }
    }
  }
  for (int c = 0; c < g->cells; c++) {
    for (int p = 0; p < g->cell[c].type->pins; p++) {
      if (!g->cell[c].type->pin[p].output) {
        check_clock(&s, &g->cell[c], p);
      }
    }
  }
  free(s.driver);
  free(s.progress);
  free(g->cell);
  g->cell = s.cell;
}

void gates_read(gates *g, const library *lib, const char *path) {
  json_error_t error;
  text_file = path;
  json_t *root = json_load_file(path, 0, &error); /* stays: instances and cells have its names */
  json_t *modules = json_object_get(root, "modules");
  if (modules == NULL) {
    text_fail("is not a netlist; make one with synth/area/map:", error.text);
  }
  *g = (gates){0};
  builder b = {modules, lib, g, NULL};
  new_net(&b);
  new_net(&b);
  const char *top = top_of(modules);
  scope whole = {0};
  build(&b, "", top, &whole);
  add_ports(&b, json_object_get(modules, top), &whole);
  sepax_random random = {1};
  for (int c = 0; c < g->cells; c++) {
    g->cell[c].state = sepax_random_next(&random);
    for (int p = 0; p < LIB_PINS; p++) {
      if (g->cell[c].net[p] >= 0) {
        g->cell[c].net[p] = root_of(&b, g->cell[c].net[p]);
      }
    }
  }
  g->clock = gates_clock(g);
  sort_cells(g);
  free(whole.net);
  free(b.same);
  uint64_t **const of_nets[] = {&g->value, &g->before};
  for (size_t k = 0; k < sizeof of_nets / sizeof of_nets[0]; k++) {
    *of_nets[k] = text_alloc((size_t)g->nets, sizeof **of_nets[k]);
  }
  g->toggles = text_alloc((size_t)g->nets, sizeof *g->toggles);
  g->ones = text_alloc((size_t)g->nets, sizeof *g->ones);
  g->value[1] = g->value[g->clock] = ~UINT64_C(0);
}
