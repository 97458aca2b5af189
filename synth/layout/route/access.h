/* SPDX-License-Identifier: MIT */
/* access.h - where wires of the second metal can go down onto a pin. */
#ifndef SEPAX_LAYOUT_ACCESS_H
#define SEPAX_LAYOUT_ACCESS_H

#include "layout/route/grid.h"

/* A node, and the via there; NULL for a port, which is in the node's own layer. Covered: the via's
 * pad lies within the pin. */
typedef struct {
  uint32_t node;
  const lef_via *via;
  bool covered;
} access;

typedef struct {
  access *at;
  int count;
} access_list;

/* Of each pin of each net the nodes where a via's pad lies within the pin, or its cut, and the pad
 * keeps the distance from all other shapes of the first metal. first[] gets the index of
 * each net's first pin. Exits with status 2 and a message on a pin that has none. */
access_list *access_find(const design *d, const grid *g, int first[]);

#endif
