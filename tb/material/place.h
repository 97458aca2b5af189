/* SPDX-License-Identifier: MIT */
/* place.h - where a body and its probe lie in space: linear maps, offsets, scales and poses. All
 * are exact, so none of them changes what is inside. */
#ifndef MATERIAL_PLACE_H
#define MATERIAL_PLACE_H

#include "kinds.h"
#include "sepax.h"

enum { FINE = 1024 }; /* steps of the lattice of probes between two points of bodies' lattice */

typedef struct {
  int exponent; /* the library's coordinates are integers times this power of two */
  point offset;
  point away[2];             /* of the body, and of the probe: the translation of its pose */
  int from[2][3], way[2][3]; /* row i of its rotation has way[i] at from[i] */
  sepax_pose pose[2];
  const sepax_pose *given[2]; /* &pose[k], or NULL */
  bool minus_zero;            /* a coordinate 0 is written as -0 */
} placing;

/* Refine the lattice and map the body linearly. The outer sides of a known body stay outer sides.
 * False if the body is too large then. */
bool map_body(body *b, bool plainly, generator *g);

/* Draw a place. A plain one changes nothing. */
void draw_place(placing *p, bool plainly, generator *g);

/* Put triangles where body 0 or 1 has them. */
void place(const placing *p, int which, const triangle *t, size_t count, sepax_facet *to);

#endif
