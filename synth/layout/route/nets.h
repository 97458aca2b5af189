/* SPDX-License-Identifier: MIT */
/* route.h - wires between placed cells, on the tracks of a grid. */
#ifndef SEPAX_LAYOUT_NETS_H
#define SEPAX_LAYOUT_NETS_H

#include "layout/files/design.h"

/* Give every net a route on the second to the metal `top`, counted from 1. Wires run on tracks in
 * the direction of their layer; a via goes down to the first metal only onto a pin. Two nets keep
 * the distances of LEF between wires, pads of vias, and cuts; where they do not yet, routes are
 * taken up and sought again at a higher price of such places (negotiated congestion: McMurchie and
 * Ebeling, PathFinder, 1995), at most `rounds` times. Returns how many nets are left that have a
 * pin without a wire or a place too near to another net; each is told on standard error. */
int route_nets(design *d, int top, int rounds);

#endif
