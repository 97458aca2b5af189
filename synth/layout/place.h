/* SPDX-License-Identifier: MIT */
/* place.h - where things go: the die, the ports; cells by a placer that reads Bookshelf. */
#ifndef SEPAX_LAYOUT_PLACE_H
#define SEPAX_LAYOUT_PLACE_H

#include "layout/files/design.h"

/* Make the die of rows as square as can be, of which cells take the share `use`, and put the
 * ports on its four sides, in their order. */
void place_floor(design *d, double use);

/* DIR/design.aux and the files that it names, for a placer. */
void place_write(const design *d, const char *dir);

/* What the placer found. */
void place_read(design *d, const char *path);

/* Put each cell on the site to its left. Cells that do not overlap still do not: their widths are
 * whole sites. */
void place_snap(design *d);

/* Fill what is left of the rows with cells that are called FILL... */
void place_fill(design *d);

/* Faults, a line each on standard error: cells that are not in a row, on a site, upright, or that
 * overlap. Returns their number. */
int place_check(const design *d);

/* Drive the pins of a net, a clock, by a balanced tree of buffers: groups of at most `most` pins
 * that are near each other, each of a buffer, four buffers of another, and so on. */
void place_tree(design *d, const char *clock, const lef_macro *buffer, int most);

#endif
