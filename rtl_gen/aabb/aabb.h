/* SPDX-License-Identifier: MIT */
/* aabb.h - axis-aligned bounding boxes in the RTL. */
#ifndef SEPAX_GEN_AABB_H
#define SEPAX_GEN_AABB_H

#include "emit/template.h"

/* sepax_bounds: the least and the greatest of three coordinates; once a design. */
void gen_bounds(emitter *e);
/* sepax_disjoint: have two intervals no common point; once a design. */
void gen_disjoint(emitter *e);
/* sepax_thinnest: which side of an AABB is the thinnest; sepax_swap_axes: a triangle with that side
 * as z; once a design. */
void gen_thinnest(emitter *e);

/* What the templates of architecture exact say of the AABB test, with one and without. */
void aabb_holes(emit_holes *h, const sepax_design *design);

/* ns of the longest stage of the AABB test behind its register; 0 without one. */
double aabb_delay(const sepax_design *design);

/* sepax_aabb_test, if the design has an AABB test before the core. */
void gen_aabb_test(emitter *e, const emit_holes *h);

/* Cycles from a pair taken by sepax_top to the narrow phase that it is offered to; 0 without an
 * AABB test. */
int aabb_latency(const sepax_design *design);

#endif
