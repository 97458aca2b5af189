/* SPDX-License-Identifier: MIT */
/* wires.h - resistance and capacitance of wires, routed or to be routed. */
#ifndef SEPAX_LAYOUT_WIRES_H
#define SEPAX_LAYOUT_WIRES_H

#include "layout/files/design.h"

#include <stdio.h>

typedef struct {
  double millimetres; /* of wire */
  double farad;
  long vias;
  int open; /* pins that no wire leads to from the driver */
} wires_sum;

/* Write SPEF: of each net a tree of resistances from its driver to each pin, the capacitance of a
 * piece in halves at its ends. A net without a route is the shortest tree of straight lines between
 * its pins, along x and y, on layers `like` in equal parts. Pins that are not connected are told on
 * standard error. */
wires_sum wires_write(const design *d, const int like[2], FILE *out);

/* Bounds of the wires that are not yet routed: the sum of half the girths of the nets' boxes. */
double wires_half_girth(const design *d);

#endif
