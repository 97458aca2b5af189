/* SPDX-License-Identifier: MIT */
/* cavity.h - which blocks of a body hold a point, and whether the point is in a cavity. */
#ifndef MATERIAL_CAVITY_H
#define MATERIAL_CAVITY_H

#include "surfaces.h"

/* A block that holds a point: some closed surface of its triangles encloses the point. */
typedef struct {
  size_t block;
  int sum; /* how often a ray leaves less how often it enters */
} holder;

typedef struct {
  holder *held;
  size_t holding;  /* so many blocks hold the point */
  bool consistent; /* in each of them, directions cancel on every segment */
  int sum;         /* of all */
  size_t above;    /* so many have a sum above 0 */
} standing;

/* The result is valid until the next call. */
void stand(standing *at, const surfaces *f, point p, generator *g);

/* True if the blocks do not touch each other and are wound outwards, inwards, ... from the
 * outermost one on, an even number of them. */
bool is_cavity(const surfaces *f, const standing *at);

#endif
