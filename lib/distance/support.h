/* SPDX-License-Identifier: MIT */
/* support.h - a proof by one direction that two bodies are apart (private). */
#ifndef SEPAX_DISTANCE_SUPPORT_H
#define SEPAX_DISTANCE_SUPPORT_H

#include "search.h"

/* Prepare proofs by the direction `way`, or else by the normal of a nearest triangle. at[k]: the
 * box of a triangle of body k, of the nearest so far. `need`: the distance to be proved, in file
 * units. False if the nearest triangles themselves prove less. */
bool sepax__proof_begin(search *s, const twofold_vector *way, const uint32_t at[2], twofold need);

/* True only if the gap of two children on the way proves that their distance is at least what is
 * needed; child[k] is a node or a triangle of body k. Where faces are parallel, one such proof does
 * for all their triangles. It ends at the first triangle that leaves less than is needed, and at
 * the latest after four times the work that the search has taken, or all that is left. *by receives
 * the box of that triangle in the body that it names. */
typedef struct {
  int body; /* -1: there is none */
  uint32_t at;
} hindrance;

bool sepax__prove_apart(search *s, const uint32_t child[2], hindrance *by);

#endif
