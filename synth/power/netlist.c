/* netlist.c - reads a mapped netlist, Yosys' write_json, into all its instances. */
#include "gates.h"
#include "liberty/text.h"

#include <jansson.h>
#include <stdlib.h>
#include <string.h>

/* Nets of a module have numbers from 2 on, as in the file; 0 and 1 are the constants. */
typedef struct {
  json_t *modules;
  const library *lib;
  gates *g;
  int *same; /* of each net: one that it is the same as */
} builder;

/* Space for one more of `count` elements. */
static void *more(void *list, int count, size_t size) {
  if (count > 0 && (count & (count - 1)) != 0) {
    return list;
  }
  list = realloc(list, (count == 0 ? 1 : 2 * (size_t)count) * size);
  if (list == NULL) {
    text_fail("out of", "memory");
  }
  return list;
}

static int new_net(builder *b) {
  b->same = more(b->same, b->g->nets, sizeof *b->same);
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

/* The number of bit k in a list of a module of so many nets. */
static int net_of(const json_t *bits, size_t k, int nets) {
  const json_t *bit = json_array_get(bits, k);
  const char *constant = json_string_value(bit);
  int net = constant == NULL             ? (int)json_integer_value(bit)
            : strcmp(constant, "0") == 0 ? 0
            : strcmp(constant, "1") == 0 ? 1
                                         : -1;
  if (net < 0 || (constant == NULL && net < 2) || net >= nets) {
    text_fail("has a bit that is not understood:", constant == NULL ? "a number" : constant);
  }
  return net;
}

static int nets_of(json_t *module) {
  int nets = 2;
  const char *name;
  json_t *of;
  json_object_foreach(json_object_get(module, "netnames"), name, of) {
    const json_t *bits = json_object_get(of, "bits");
    for (size_t k = 0; k < json_array_size(bits); k++) {
      int bit = (int)json_integer_value(json_array_get(bits, k));
      nets = bit >= nets ? bit + 1 : nets;
    }
  }
  return nets;
}

static void add_cell(builder *b, const char *name, json_t *cell, const int *net, int nets,
                     int instance) {
  const char *type = json_string_value(json_object_get(cell, "type"));
  const lib_cell *of = library_cell(b->lib, type);
  if (of == NULL) {
    text_fail("neither a module nor a cell of the library:", type);
  }
  gates *g = b->g;
  g->cell = more(g->cell, g->cells, sizeof *g->cell);
  gates_cell *it = &g->cell[g->cells++];
  *it = (gates_cell){.type = of, .name = name, .instance = instance};
  for (int k = 0; k < LIB_PINS; k++) {
    it->net[k] = -1;
  }
  const char *pin_name;
  json_t *bits;
  json_object_foreach(json_object_get(cell, "connections"), pin_name, bits) {
    int pin = lib_pin_index(of, pin_name);
    if (pin < 0 || json_array_size(bits) > 1) {
      text_fail("a pin that the library does not have, of", name);
    }
    if (json_array_size(bits) == 1) {
      it->net[pin] = net[net_of(bits, 0, nets)];
    }
  }
}

static void build(builder *b, const char *type, const char *name, int parent, int *net, int nets);

/* An instance of a module: its ports' nets are those that they are connected to. */
static void add_instance(builder *b, const char *name, json_t *cell, const int *net, int nets,
                         int parent) {
  const char *type = json_string_value(json_object_get(cell, "type"));
  json_t *of = json_object_get(b->modules, type);
  int inner_nets = nets_of(of);
  int *inner = text_alloc((size_t)inner_nets, sizeof *inner);
  memset(inner, 0xff, (size_t)inner_nets * sizeof *inner);
  inner[0] = 0;
  inner[1] = 1;
  const char *port_name;
  json_t *bits;
  json_object_foreach(json_object_get(cell, "connections"), port_name, bits) {
    const json_t *port = json_object_get(json_object_get(of, "ports"), port_name);
    const json_t *inside = json_object_get(port, "bits");
    if (json_array_size(bits) != 0 && json_array_size(bits) != json_array_size(inside)) {
      text_fail("a connection that does not fit:", port_name);
    }
    for (size_t k = 0; k < json_array_size(bits); k++) {
      int outer = net[net_of(bits, k, nets)];
      int *in = &inner[net_of(inside, k, inner_nets)];
      if (*in < 0) {
        *in = outer;
      } else {
        join(b, *in, outer);
      }
    }
  }
  build(b, type, name, parent, inner, inner_nets);
  free(inner);
}

static void build(builder *b, const char *type, const char *name, int parent, int *net, int nets) {
  gates *g = b->g;
  g->instance = more(g->instance, g->instances, sizeof *g->instance);
  int instance = g->instances++;
  g->instance[instance] = (gates_instance){name, type, parent};
  for (int k = 0; k < nets; k++) {
    net[k] = net[k] >= 0 ? net[k] : new_net(b);
  }
  const char *cell_name;
  json_t *cell;
  json_object_foreach(json_object_get(json_object_get(b->modules, type), "cells"), cell_name,
                      cell) {
    const json_t *of = json_object_get(cell, "type");
    if (json_object_get(b->modules, json_string_value(of)) != NULL) {
      add_instance(b, cell_name, cell, net, nets, instance);
    } else {
      add_cell(b, cell_name, cell, net, nets, instance);
    }
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

static void add_ports(builder *b, json_t *top, const int *net, int nets) {
  gates *g = b->g;
  const char *name;
  json_t *port;
  json_object_foreach(json_object_get(top, "ports"), name, port) {
    const json_t *bits = json_object_get(port, "bits");
    const char *direction = json_string_value(json_object_get(port, "direction"));
    for (size_t k = 0; k < json_array_size(bits); k++) {
      char full[320];
      snprintf(full, sizeof full, json_array_size(bits) > 1 ? "%s[%zu]" : "%s", name, k);
      g->port = more(g->port, g->ports, sizeof *g->port);
      g->port[g->ports++] = (gates_port){strdup(full), root_of(b, net[net_of(bits, k, nets)]),
                                         direction != NULL && strcmp(direction, "output") == 0};
    }
  }
}

/* ------------------------------------------------------------------------ order */

enum { UNDRIVEN = 0, FROM_OUTSIDE = -1 }; /* else the cell's number + 1 */

static int *find_drivers(const gates *g) {
  int *driver = text_alloc((size_t)g->nets, sizeof *driver);
  driver[0] = driver[1] = FROM_OUTSIDE;
  for (int k = 0; k < g->ports; k++) {
    if (!g->port[k].output) {
      driver[g->port[k].net] = FROM_OUTSIDE;
    }
  }
  for (int c = 0; c < g->cells; c++) {
    const lib_cell *type = g->cell[c].type;
    for (int p = 0; p < type->pins; p++) {
      int net = g->cell[c].net[p];
      if (!type->pin[p].output || net < 0) {
        continue;
      }
      if (type->pin[p].function.count == 0) {
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

/* Does this input of a combinational cell wait for another one? */
static bool waits_for(const gates *g, int c, int p, const int *driver) {
  const lib_cell *type = g->cell[c].type;
  int net = g->cell[c].net[p];
  if (type->pin[p].output) {
    return false;
  }
  if (net < 0 || driver[net] == UNDRIVEN) {
    text_fail("nothing drives an input of", g->cell[c].name);
  }
  if (type->register_ && p == type->clock && net != g->clock) {
    text_fail("another clock than clk, at", g->cell[c].name);
  }
  return !type->register_ && driver[net] > 0 && !g->cell[driver[net] - 1].type->register_;
}

/* Every net has one driver; combinational cells stand behind theirs. */
static void put_in_order(gates *g) {
  int *driver = find_drivers(g);
  int *waits = text_alloc((size_t)g->cells, sizeof *waits);
  /* Readers of each net, as a list through the pins. */
  int *first = text_alloc((size_t)g->nets, sizeof *first);
  int *next = text_alloc((size_t)g->cells * LIB_PINS, sizeof *next);
  g->order = text_alloc((size_t)g->cells, sizeof *g->order);
  int registers = 0;
  for (int c = 0; c < g->cells; c++) {
    for (int p = 0; p < g->cell[c].type->pins; p++) {
      if (waits_for(g, c, p, driver)) {
        waits[c]++;
        next[c * LIB_PINS + p] = first[g->cell[c].net[p]];
        first[g->cell[c].net[p]] = c * LIB_PINS + p + 1;
      }
    }
    registers += g->cell[c].type->register_;
    if (!g->cell[c].type->register_ && waits[c] == 0) {
      g->order[g->ordered++] = c;
    }
  }
  for (int k = 0; k < g->ordered; k++) {
    const gates_cell *cell = &g->cell[g->order[k]];
    for (int p = 0; p < cell->type->pins; p++) {
      if (!cell->type->pin[p].output || cell->net[p] < 0) {
        continue;
      }
      for (int at = first[cell->net[p]]; at != 0; at = next[at - 1]) {
        int reads = (at - 1) / LIB_PINS;
        if (--waits[reads] == 0) {
          g->order[g->ordered++] = reads;
        }
      }
    }
  }
  if (g->ordered + registers != g->cells) {
    text_fail("has a loop without", "registers");
  }
  free(driver);
  free(waits);
  free(first);
  free(next);
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
  json_t *module = json_object_get(modules, top);
  int nets = nets_of(module);
  int *net = text_alloc((size_t)nets, sizeof *net);
  memset(net, 0xff, (size_t)nets * sizeof *net);
  net[0] = 0;
  net[1] = 1;
  build(&b, top, top, -1, net, nets);
  add_ports(&b, module, net, nets);
  for (int c = 0; c < g->cells; c++) {
    for (int p = 0; p < LIB_PINS; p++) {
      if (g->cell[c].net[p] >= 0) {
        g->cell[c].net[p] = root_of(&b, g->cell[c].net[p]);
      }
    }
  }
  g->clock = gates_find(g, "clk", -1);
  put_in_order(g);
  free(net);
  free(b.same);
  g->value = text_alloc((size_t)g->nets, sizeof *g->value);
  g->before = text_alloc((size_t)g->nets, sizeof *g->before);
  g->toggles = text_alloc((size_t)g->nets, sizeof *g->toggles);
  g->ones = text_alloc((size_t)g->nets, sizeof *g->ones);
  g->value[1] = ~UINT64_C(0);
}
