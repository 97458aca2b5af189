/* SPDX-License-Identifier: MIT */
/* design.h - what is laid out: cells, nets, ports, rows; read from a netlist or a DEF file. */
#ifndef SEPAX_LAYOUT_DESIGN_H
#define SEPAX_LAYOUT_DESIGN_H

#include "layout/files/lef.h"

#include <stdio.h>

/* N: as in the library; S: turned by half a turn; F: seen in a mirror, left for right, before. */
typedef enum { AS_N, AS_S, AS_FN, AS_FS } orientation;
extern const char *const orientation_name[];

typedef struct {
  const char *name;
  const lef_macro *macro;
  bool placed;
  int x, y; /* of the lower left corner */
  orientation orient;
} component;

typedef struct {
  const char *name;
  int net; /* or -1 */
  bool output;
  bool placed;
  lef_rect shape; /* on the die */
} port;

/* A pin of a component, or, where that is -1, a port. */
typedef struct {
  int component, pin;
} terminal;

/* A piece of wire, or a via at (x0, y0). */
typedef struct {
  int layer; /* of the wire; of a via its lowest metal */
  int x0, y0, x1, y1;
  const lef_via *via; /* or NULL */
} segment;

typedef struct {
  const char *name;
  terminal *pin; /* the driver first */
  int pins;
  bool power; /* from a rail to a pin that is a constant */
  segment *route;
  int segments;
} net;

/* A row of sites, from its lower left corner. */
typedef struct {
  int x, y, sites;
  orientation orient;
} row;

typedef struct {
  const lef *lib;
  const char *name;
  component *cell;
  port *port;
  net *net;
  row *row;
  int cells, ports, nets, rows;
  int width, height; /* of the die */
} design;

/* Add one; the index of the new one. */
int design_add_cell(design *d, const char *name, const lef_macro *macro);
int design_add_net(design *d, const char *name);
void design_add_pin(net *n, int cell, int pin);

/* A rectangle of a cell's macro, on the die. */
lef_rect design_rect(const component *c, const lef_rect *r);

/* The layer and middle of a terminal: of its first shape, on the die. */
lef_rect design_terminal(const design *d, terminal t);

/* Of a terminal: whether it is a rail of its cell; whether it drives its net. */
bool design_is_rail(const design *d, terminal t);
bool design_drives(const design *d, terminal t);

/* Put the driver of each net first; a message and exit status 2 where it has none, or two. */
void design_order(design *d);

/* Read the one module of Yosys' write_json after flatten; names are made of letters, digits and
 * "_". Exits with status 2 and a message on a cell or pin that the library does not have, and on
 * what no cell drives. */
void design_read_netlist(design *d, const lef *lib, const char *path);

/* DEF, as here written or by a router; the same refusals. */
void design_read_def(design *d, const lef *lib, const char *path);
void design_write_def(const design *d, FILE *out);

/* The same netlist as Verilog, flat. */
void design_write_verilog(const design *d, FILE *out);

#endif
