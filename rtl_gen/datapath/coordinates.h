/* SPDX-License-Identifier: MIT */
/* coordinates.h - the registers of the 18 coordinates. A pair stands in the first registers for one
 * II window and moves on to holding registers, window by window, as long as it is read. Where 3
 * divides II the three vertices of each triangle rotate by one place a cycle (binding.h). */
#ifndef SEPAX_COORDINATES_H
#define SEPAX_COORDINATES_H

#include "advance.h"
#include "emit/emit.h"

enum { COORDINATES_BANKS = 40 };

/* Registers of one axis: x, y or z. */
typedef struct {
  int start[COORDINATES_BANKS]; /* first cycle of each bank; each holds for II cycles */
  int banks;
  int end[6]; /* of a vertex: the cycle behind its last read; 0: it is never read */
} coordinates_axis;

typedef struct {
  int ii;
  bool rotate; /* 3 divides ii */
  coordinates_axis axis[3];
} coordinates;

/* Vertex v is read in this cycle; axis 0 ... 2 are x, y, z. */
void coordinates_need(coordinates *c, int axis, int v, int cycle);

/* All needs are known: lay out the banks. z's first change is in cycle `z_change` where that
 * costs no bank more: then no reader of z_change ... z_change + II - 1 has two sources. */
void coordinates_store(coordinates *c, int z_change);

/* Registers, of the bits of a coordinate each. coordinates_store has been called. */
int coordinates_count(const coordinates *c);

/* The register in which vertex v stands in this cycle. */
gen_line coordinates_source(const coordinates *c, int axis, int v, int cycle);

/* Declarations, then the clocked assignments, with their enables. */
void coordinates_declare(const coordinates *c, emit_text *out);
void coordinates_clock(const coordinates *c, advance *a, emit_text *out);

#endif
