/* SPDX-License-Identifier: MIT */
/* blocks.h - which blocks of a body hold a point. */
#ifndef MATERIAL_BLOCKS_H
#define MATERIAL_BLOCKS_H

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
  size_t below;    /* so many have a sum below 0 */
} standing;

/* The result is valid until the next call. */
void stand(standing *at, const surfaces *f, point p, generator *g);

#endif
