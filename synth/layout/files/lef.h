/* SPDX-License-Identifier: MIT */
/* lef.h - layers, vias and cells of LEF files, in units of words.h. */
#ifndef SEPAX_LAYOUT_LEF_H
#define SEPAX_LAYOUT_LEF_H

#include <stdbool.h>

enum { LEF_PINS = 16 }; /* of a cell, at most */

typedef struct {
  int layer; /* of lef.layer */
  int x0, y0, x1, y1;
} lef_rect;

typedef struct {
  lef_rect *rect;
  int rects;
} lef_shapes;

/* A layer of metal, or of cuts, from the lowest up. */
typedef struct {
  const char *name;
  bool metal, vertical;
  int width, spacing, pitch, offset;
  int wide; /* from which width on distances are longer; 0: none */
  double ohm_per_square;
  double ohm_per_cut;
  double farad; /* of a micrometre of wire of this width: to the ground and of both edges */
} lef_layer;

typedef struct {
  const char *name;
  lef_shapes shape;
} lef_via;

typedef enum { LEF_SIGNAL, LEF_CLOCK, LEF_POWER, LEF_GROUND } lef_use;

typedef struct {
  const char *name;
  bool output;
  lef_use use;
  lef_shapes shape;
} lef_pin;

typedef struct {
  const char *name;
  bool core; /* of a row */
  int width, height;
  lef_pin *pin;
  int pins;
  lef_shapes obstruction;
} lef_macro;

typedef struct {
  lef_layer *layer;
  lef_via *via;
  lef_macro *macro;
  int layers, vias, macros;
  const char *site; /* of the rows */
  int site_width, site_height;
} lef;

/* Add what a file says; exits with status 2 and a message where it is not understood. */
void lef_read(lef *l, const char *path);

/* By name: the index, or -1. */
int lef_layer_index(const lef *l, const char *name);
const lef_macro *lef_find(const lef *l, const char *name); /* or NULL */
int lef_pin_index(const lef_macro *macro, const char *name);

#endif
