/* SPDX-License-Identifier: MIT */
/* bodies.h - the distance of two bodies in rational numbers: of every pair of triangles. */
#ifndef ORACLE_BODIES_H
#define ORACLE_BODIES_H

#include "distance.h"

/* The triangles of a body in its pose (NULL: as they are). */
typedef struct {
  const sepax_facet *facet;
  size_t count;
  const sepax_pose *pose;
} oracle_body;

/* The square of the distance of two bodies: the least one of all pairs. A pair is left out only if
 * a gap in extended precision, less a bound on all its roundings, proves that it is farther apart
 * than another pair. */
void oracle_bodies_square(exact_square *least, const oracle_body *a, const oracle_body *b);

#endif
