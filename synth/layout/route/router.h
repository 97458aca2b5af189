/* SPDX-License-Identifier: MIT */
/* router.h - what the steps of the router share.
 *
 * A node of the grid is where a vertical and a horizontal track cross, in one layer. What a net has
 * at a node is of a kind: wire, the pad of a via to the layer below, or to the one above. For each
 * kind a table, made of the LEF's widths, pads and distances, has what another net must not have at
 * which nodes around it. `claims` counts for each node and kind how many such bans there are; a net
 * may be there where it is 0. */
#ifndef SEPAX_LAYOUT_ROUTER_H
#define SEPAX_LAYOUT_ROUTER_H

#include "layout/route/access.h"

#include <stddef.h>

/* What a net has at a node. */
typedef struct {
  uint32_t node;
  uint8_t kind;
} use;

/* The route of a net. */
typedef struct {
  use *use;
  int uses;
  uint32_t *wire;  /* pairs of nodes that are next to each other on a track */
  int wires;       /* twice the number of pairs */
  access *landing; /* of each pin, once it is reached */
  bool *reached;
} path;

typedef struct {
  uint64_t *item; /* cost, node: the least first */
  size_t count;
} heap;

typedef struct {
  design *d;
  grid g;
  path *path;          /* of each net */
  access_list *access; /* of all nets' pins */
  int *first;          /* of each net: the first of its pins there */
  uint16_t *claims[KINDS];
  uint16_t *history; /* what a node costs more, since nets have met there */
  int price;         /* of a ban */
  /* of the search: what belongs to another has another stamp */
  uint32_t *cost, *stamp, *goal, stamps;
  uint8_t *from;
  heap queue;
  uint32_t *cuts; /* a net's number + 1 where none of its vias may be, beside another of its own */
} router;

/* The tracks between which a net's pins are, `margin` beyond. */
typedef struct {
  int i0, j0, i1, j1;
} box;
box router_box(const router *r, const access_list *pin, int pins, int margin);

/* Add a piece of wire between two nodes. */
void path_wire(path *p, uint32_t a, uint32_t b);

/* Count the bans of a route once more, or (by = -1) once less. */
void claim_path(router *r, const path *p, int by);

/* Whether a route, whose own bans are not counted, has something where it is banned: those nodes
 * become dearer. */
bool claim_clash(router *r, const path *p);

/* Whether vias of one route have cuts too near each other: their nodes become dearer. */
bool claim_own_clash(router *r, const path *p);

/* Seek all of a net anew, whose bans are not counted, within `margin` tracks of its pins. */
void search_net(router *r, int id, int margin);

#endif
