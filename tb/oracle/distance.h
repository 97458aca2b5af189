/* SPDX-License-Identifier: MIT */
/* distance.h - the distance of two triangles, without separating axes.
 *
 * Triangles of int32 coordinates, also segments and points. No state. */
#ifndef DISTANCE_H
#define DISTANCE_H

#include "sepax_models.h"

#include <gmp.h>

/* True iff the distance of the closed triangles is at most `limit` >= 0 (Euclid): rational
 * arithmetic without rounding. Where a plane between the nearest points, found in doubles,
 * proves in integers that it is greater, that is the answer at once, and *quick, if
 * not NULL, is incremented. limit is below 2^31. */
bool distance_within(const sepax_tri *a, const sepax_tri *b, int64_t limit, size_t *quick);

/* The same by rational arithmetic alone. */
bool distance_within_exact(const sepax_tri *a, const sepax_tri *b, int64_t limit);

/* The same of triangles of doubles in poses (NULL: as they are), each double the number it is. */
bool distance_within_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                           const sepax_pose *pose_b, double limit);

/* The square of a distance: over / under * 2^exponent, a rational number. */
typedef struct {
  mpz_t over, under;
  long exponent;
} exact_square;

void exact_square_init(exact_square *s);
void exact_square_clear(exact_square *s);

/* The square of the distance of two triangles in poses (NULL: as they are), without rounding. */
void distance_square_posed(exact_square *r, const double a[3][3], const sepax_pose *pose_a,
                           const double b[3][3], const sepax_pose *pose_b);

/* The sign of p - q. */
int exact_square_compare(const exact_square *p, const exact_square *q);

/* The sign of the distance less a length, a finite number of 0 or more. */
int exact_square_compare_length(const exact_square *s, double length);

/* The greatest double that is not above the distance. */
double exact_square_root(const exact_square *s);

/* The distance in doubles, of triangles that do not meet, and the vector from the nearest point
 * of A to that of B. */
double distance_rounded(const sepax_tri *a, const sepax_tri *b, double way[3]);
double distance_rounded_real(const double a[3][3], const double b[3][3], double way[3]);

#endif
