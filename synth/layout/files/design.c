/* SPDX-License-Identifier: MIT */
/* design.c - see design.h. */
#include "layout/files/design.h"
#include "liberty/text.h"

#include <ctype.h>
#include <err.h>
#include <jansson.h>
#include <search.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const orientation_name[] = {"N", "S", "FN", "FS"};

int design_add_cell(design *d, const char *name, const lef_macro *macro) {
  d->cell = text_more(d->cell, (size_t)d->cells, sizeof *d->cell);
  d->cell[d->cells] = (component){.name = name, .macro = macro};
  return d->cells++;
}

int design_add_net(design *d, const char *name) {
  d->net = text_more(d->net, (size_t)d->nets, sizeof *d->net);
  d->net[d->nets] = (net){.name = name};
  return d->nets++;
}

void design_add_pin(net *n, int cell, int pin) {
  n->pin = text_more(n->pin, (size_t)n->pins, sizeof *n->pin);
  n->pin[n->pins++] = (terminal){cell, pin};
}

lef_rect design_rect(const component *c, const lef_rect *r) {
  lef_rect it = *r;
  if (c->orient == AS_FN || c->orient == AS_S) {
    it.x0 = c->macro->width - r->x1, it.x1 = c->macro->width - r->x0;
  }
  if (c->orient == AS_FS || c->orient == AS_S) {
    it.y0 = c->macro->height - r->y1, it.y1 = c->macro->height - r->y0;
  }
  it.x0 += c->x, it.x1 += c->x, it.y0 += c->y, it.y1 += c->y;
  return it;
}

static const lef_pin *pin_of(const design *d, terminal t) {
  return &d->cell[t.component].macro->pin[t.pin];
}

bool design_is_rail(const design *d, terminal t) {
  return t.component >= 0 && (pin_of(d, t)->use == LEF_POWER || pin_of(d, t)->use == LEF_GROUND);
}

bool design_drives(const design *d, terminal t) {
  return t.component < 0 ? !d->port[t.pin].output : pin_of(d, t)->output || design_is_rail(d, t);
}

lef_rect design_terminal(const design *d, terminal t) {
  if (t.component < 0) {
    return d->port[t.pin].shape;
  }
  const lef_shapes *s = &pin_of(d, t)->shape;
  if (s->rects == 0) {
    return (lef_rect){0};
  }
  return design_rect(&d->cell[t.component], s->rect);
}

/* ---------------------------------------------------------------------- netlist */

/* A name of letters, digits and "_"; the text's own where it has others. */
static char *plain_name(const char *text, const char *more) {
  char *name = text_alloc(strlen(text) + strlen(more) + 1, 1);
  strcat(strcpy(name, text), more);
  for (char *c = name; *c != '\0'; c++) {
    *c = isalnum((unsigned char)*c) ? *c : '_';
  }
  return name;
}

static int by_name(const void *a, const void *b) { return strcmp(a, b); }

/* No two nets or cells have one name: the later one gets a number. */
static void make_unique(const char **name, void **seen) {
  const char *first = *name;
  for (int number = 1; tfind(*name, seen, by_name) != NULL; number++) {
    char text[16];
    snprintf(text, sizeof text, "_%d", number);
    *name = plain_name(first, text);
  }
  if (tsearch(*name, seen, by_name) == NULL) {
    text_fail("out of", "memory");
  }
}

typedef struct {
  design *d;
  int *net; /* of each of Yosys' numbers: the net + 1 */
  int numbers;
} numbering;

/* The net of a bit; of "0" and "1" those of the rails. */
static int net_of(numbering *n, const json_t *bit) {
  const char *constant = json_string_value(bit);
  int number = constant == NULL             ? (int)json_integer_value(bit)
               : strcmp(constant, "0") == 0 ? 0
               : strcmp(constant, "1") == 0 ? 1
                                            : -1;
  if (number < 0) {
    text_fail("has a bit that is not understood:", constant);
  }
  for (; n->numbers <= number; n->numbers++) {
    n->net = text_more(n->net, (size_t)n->numbers, sizeof *n->net);
    n->net[n->numbers] = 0;
  }
  if (n->net[number] == 0) {
    n->net[number] = design_add_net(n->d, NULL) + 1;
  }
  return n->net[number] - 1;
}

static void read_ports(numbering *n, json_t *ports) {
  const char *name;
  json_t *of;
  design *d = n->d;
  json_object_foreach(ports, name, of) {
    const char *direction = json_string_value(json_object_get(of, "direction"));
    const json_t *bits = json_object_get(of, "bits");
    for (size_t k = 0; k < json_array_size(bits); k++) {
      char *bit = text_alloc(strlen(name) + 16, 1);
      sprintf(bit, json_array_size(bits) > 1 ? "%s_%zu" : "%s", name, k);
      int to = net_of(n, json_array_get(bits, k));
      d->port = text_more(d->port, (size_t)d->ports, sizeof *d->port);
      d->port[d->ports] = (port){
          .name = bit, .net = to, .output = direction != NULL && strcmp(direction, "output") == 0};
      design_add_pin(&d->net[to], -1, d->ports++);
    }
  }
}

static void read_cells(numbering *n, json_t *cells) {
  const char *name, *pin_name;
  json_t *of, *bits;
  json_object_foreach(cells, name, of) {
    const char *type = json_string_value(json_object_get(of, "type"));
    const lef_macro *macro = lef_find(n->d->lib, type);
    if (macro == NULL) {
      text_fail("the LEF files have no cell", type);
    }
    int cell = design_add_cell(n->d, plain_name(name, ""), macro);
    json_object_foreach(json_object_get(of, "connections"), pin_name, bits) {
      int pin = lef_pin_index(macro, pin_name);
      if (pin < 0 || json_array_size(bits) > 1) {
        text_fail("the LEF files have no such pin of", type);
      }
      if (json_array_size(bits) == 1) {
        int to = net_of(n, json_array_get(bits, 0));
        design_add_pin(&n->d->net[to], cell, pin);
      }
    }
  }
}

/* A net has the name of a port, or else of the first wire in the file. */
static void name_nets(numbering *n, json_t *netnames) {
  const char *name;
  json_t *of;
  design *d = n->d;
  for (int k = 0; k < d->ports; k++) {
    if (d->net[d->port[k].net].name == NULL) {
      d->net[d->port[k].net].name = d->port[k].name;
    }
  }
  json_object_foreach(netnames, name, of) {
    const json_t *bits = json_object_get(of, "bits");
    for (size_t k = 0; k < json_array_size(bits); k++) {
      char text[24] = "";
      if (json_array_size(bits) > 1) {
        snprintf(text, sizeof text, "_%zu", k);
      }
      const char **it = &d->net[net_of(n, json_array_get(bits, k))].name;
      *it = *it == NULL ? plain_name(name, text) : *it;
    }
  }
}

/* A pin that is 0 or 1 has a net of its own, with the rail of its cell. */
static void join_rail(numbering *n, int number, lef_use use) {
  design *d = n->d;
  if (number >= n->numbers || n->net[number] == 0) {
    return;
  }
  int of = n->net[number] - 1;
  for (int p = 0; p < d->net[of].pins; p++) {
    terminal t = d->net[of].pin[p];
    if (t.component < 0) {
      text_fail("a constant output has no cell:", d->port[t.pin].name);
    }
    const lef_macro *macro = d->cell[t.component].macro;
    int rail = 0;
    while (rail < macro->pins && macro->pin[rail].use != use) {
      rail++;
    }
    if (rail == macro->pins) {
      text_fail("the LEF files have no rail of", macro->name);
    }
    int k = design_add_net(d, macro->pin[rail].name);
    d->net[k].power = true;
    design_add_pin(&d->net[k], t.component, rail);
    design_add_pin(&d->net[k], t.component, t.pin);
  }
  d->net[of].pins = 0;
}

void design_order(design *d) {
  for (int k = 0; k < d->nets; k++) {
    net *n = &d->net[k];
    int drivers = 0;
    for (int p = 0; p < n->pins; p++) {
      if (design_drives(d, n->pin[p])) {
        terminal t = n->pin[0];
        n->pin[0] = n->pin[p], n->pin[p] = t;
        drivers++;
      }
    }
    if (drivers != 1 && n->pins > 0) {
      text_fail(drivers == 0 ? "nothing drives" : "more than one pin drives", n->name);
    }
  }
}

/* The module that has cells; NULL without one. */
static json_t *only_module(json_t *modules, const char **name) {
  json_t *top = NULL;
  for (void *it = json_object_iter(modules); it != NULL; it = json_object_iter_next(modules, it)) {
    json_t *of = json_object_iter_value(it);
    if (json_object_size(json_object_get(of, "cells")) > 0) {
      if (top != NULL) {
        text_fail("has more than one module that is not empty:", json_object_iter_key(it));
      }
      top = of;
      *name = json_object_iter_key(it);
    }
  }
  return top;
}

void design_read_netlist(design *d, const lef *lib, const char *path) {
  json_error_t error;
  text_file = path;
  json_t *root = json_load_file(path, 0, &error); /* stays: names are of it */
  json_t *modules = json_object_get(root, "modules");
  const char *name = NULL;
  json_t *top = only_module(modules, &name);
  if (top == NULL) {
    text_fail("is no netlist of cells:", error.text);
  }
  *d = (design){.lib = lib, .name = name};
  numbering n = {.d = d};
  read_ports(&n, json_object_get(top, "ports"));
  read_cells(&n, json_object_get(top, "cells"));
  join_rail(&n, 0, LEF_GROUND);
  join_rail(&n, 1, LEF_POWER);
  name_nets(&n, json_object_get(top, "netnames"));
  void *seen = NULL;
  for (int k = 0; k < d->nets; k++) {
    if (d->net[k].name == NULL) {
      d->net[k].name = "n";
    }
    make_unique(&d->net[k].name, &seen);
  }
  for (int k = 0; k < d->cells; k++) {
    make_unique(&d->cell[k].name, &seen);
  }
  design_order(d);
  free(n.net);
}

/* ---------------------------------------------------------------------- Verilog */

void design_write_verilog(const design *d, FILE *out) {
  fprintf(out, "module %s (", d->name);
  for (int k = 0; k < d->ports; k++) {
    fprintf(out, "%s\n  %s wire %s", k == 0 ? "" : ",", d->port[k].output ? "output" : "input",
            d->port[k].name);
  }
  fprintf(out, "\n);\n");
  int(*of)[LEF_PINS] = text_alloc((size_t)d->cells, sizeof *of); /* net + 1 */
  for (int k = 0; k < d->nets; k++) {
    const net *n = &d->net[k];
    bool has_port = false;
    for (int p = 0; p < n->pins; p++) {
      if (design_is_rail(d, n->pin[p])) {
        continue;
      }
      if (n->pin[p].component >= 0) {
        of[n->pin[p].component][n->pin[p].pin] = k + 1;
      } else {
        has_port = has_port || strcmp(d->port[n->pin[p].pin].name, n->name) == 0;
      }
    }
    if (n->power && n->pins > 0) {
      fprintf(out, "  supply%d %s;\n", pin_of(d, n->pin[0])->use == LEF_POWER, n->name);
    } else if (!has_port && n->pins > 0) {
      fprintf(out, "  wire %s;\n", n->name);
    }
  }
  for (int c = 0; c < d->cells; c++) {
    const component *it = &d->cell[c];
    const char *gap = "";
    if (strncmp(it->macro->name, "FILL", 4) == 0) {
      continue;
    }
    fprintf(out, "  %s %s (", it->macro->name, it->name);
    for (int p = 0; p < it->macro->pins; p++) {
      if (of[c][p] > 0) {
        fprintf(out, "%s.%s(%s)", gap, it->macro->pin[p].name, d->net[of[c][p] - 1].name);
        gap = ", ";
      }
    }
    fprintf(out, ");\n");
  }
  for (int k = 0; k < d->ports; k++) {
    const net *n = &d->net[d->port[k].net];
    if (strcmp(d->port[k].name, n->name) != 0) {
      fprintf(out, "  assign %s = %s;\n", d->port[k].name, n->name);
    }
  }
  fprintf(out, "endmodule\n");
  free(of);
}
