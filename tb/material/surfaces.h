/* SPDX-License-Identifier: MIT */
/* surfaces.h - does any closed surface that triangles can form enclose a point? By linear algebra.
 *
 * A closed surface is a vector z of factors, one for each triangle, with B z = 0. B has a row for
 * each elementary segment of each line on which edges lie, and a column for each triangle; an
 * entry is the direction in which the triangle runs along the segment. The functional w has, for
 * each triangle, the signed crossing of a ray from the point: w z is how often the surface winds
 * round the point. Some integer surface encloses the point if and only if w z is not 0 for some z
 * with B z = 0, that is, if w is no combination of rows of B over the rational numbers. Modulo 2
 * the same holds over the field of two numbers.
 *
 * Rational numbers are replaced by numbers modulo the prime 2^61 - 1. That differs only if the
 * prime divides a minor of a matrix with entries 0 and 1, whose minors here are tiny. */
#ifndef MATERIAL_SURFACES_H
#define MATERIAL_SURFACES_H

#include "soup.h"

enum { WORDS = (MOST + 63) / 64 };

typedef struct {
  const soup *s;
  uint64_t (*row)[MOST];       /* row[c] has its first number other than 0, which is 1, at c */
  uint64_t (*row_of_2)[WORDS]; /* the same modulo 2, a bit for each triangle */
  bool has_row[MOST], has_row_of_2[MOST];
  bool closed;          /* every segment has an even number of triangle edges */
  bool consistent;      /* on every segment the directions differ in number by at most 1 */
  bool used[MOST];      /* the triangle is in some closed surface */
  size_t block[MOST];   /* triangles that are used and run along one segment belong to one block;
                           its number is that of one of its triangles */
  bool signed_in[MOST]; /* of a block: on every segment, directions cancel */
  point low, high;      /* the box of all segments with an odd number of edges, if not closed */
} surfaces;

/* How a point lies to the closed surfaces. */
typedef struct {
  int8_t crossing[MOST]; /* 1 if a ray leaves through the triangle, -1 if it enters, else 0 */
  bool enclosed;         /* by an integer surface */
  bool enclosed_of_2;    /* by a surface modulo 2 */
} enclosure;

void find_surfaces(surfaces *f, const soup *s);
void free_surfaces(surfaces *f);

/* The point must lie on no triangle. Only triangles of one block count, or all if block is MOST. */
void find_crossings(enclosure *e, const soup *s, point p, generator *g);
void find_enclosure(enclosure *e, const surfaces *f, size_t block);

#endif
