/* SPDX-License-Identifier: MIT */
/* grid.h - tracks, and what of two nets must not be beside each other on them. */
#ifndef SEPAX_LAYOUT_GRID_H
#define SEPAX_LAYOUT_GRID_H

#include "layout/files/design.h"

#include <stdint.h>

/* What a net has at a node of the grid: wire, the pad of a via to the layer below, or above; in
 * the lowest layer also a pad on the pins' metal that goes beyond its pin. */
enum { WIRE, PAD_BELOW, PAD_ABOVE, PAD_ON_PIN, KINDS, GRID_LAYERS = 8, GRID_BANS = 64 };

/* How a search came to a node. */
enum { FROM_NONE, FROM_LESS, FROM_MORE, FROM_BELOW, FROM_ABOVE };

typedef struct {
  int metal; /* of the LEF */
  bool vertical;
  int stride;         /* every so many tracks of the grid has wires */
  const lef_via *via; /* to the layer above, or NULL */
} grid_layer;

/* Something of `kind`, so many tracks away. */
typedef struct {
  int i, j, kind;
} ban;

typedef struct {
  ban ban[GRID_BANS];
  int count;
} bans;

typedef struct {
  int first_metal; /* of the pins */
  grid_layer layer[GRID_LAYERS];
  int layers;
  int step_x, step_y, offset_x, offset_y; /* of its tracks, in units */
  int columns, rows;
  bans bans[GRID_LAYERS][KINDS]; /* of other nets, around what a net has */
  bans cuts[GRID_LAYERS];        /* of vias upwards, of the same net */
} grid;

typedef struct {
  int layer, i, j;
} place;

/* The grid of a die, from the second metal to the metal `top`: the tracks are those of the second
 * and third metal; a higher one has wires on every second or third of them, as its width asks. */
grid grid_make(const design *d, int top);

static inline uint32_t grid_node(const grid *g, int layer, int i, int j) {
  return (uint32_t)(((int64_t)layer * g->rows + j) * g->columns + i);
}

static inline place grid_place(const grid *g, uint32_t node) {
  uint32_t i = node % (uint32_t)g->columns, rest = node / (uint32_t)g->columns;
  return (place){(int)(rest / (uint32_t)g->rows), (int)i, (int)(rest % (uint32_t)g->rows)};
}

static inline int grid_x(const grid *g, int i) { return g->offset_x + i * g->step_x; }
static inline int grid_y(const grid *g, int j) { return g->offset_y + j * g->step_y; }

/* Whether there are tracks of both layers for a via from `lower` to the next. */
static inline bool grid_crosses(const grid *g, int lower, place at) {
  const grid_layer *a = &g->layer[lower], *b = &g->layer[lower + 1];
  const grid_layer *v = a->vertical ? a : b, *h = a->vertical ? b : a;
  return at.i % v->stride == 0 && at.j % h->stride == 0;
}

/* Whether a via is one down to the pins, not wider across the track than others. */
bool grid_lands(const lef *l, const grid *g, const lef_via *via);

/* Half the width and height of a via's shapes on a layer of the LEF. */
void grid_extent(const lef_via *via, int layer, int *x, int *y);

#endif
