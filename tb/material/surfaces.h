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
 * Numbers modulo the prime 2^61 - 1 stand for rational numbers. The answer differs only if the
 * prime divides one of the few minors that elimination meets, in a matrix with small entries. */
#ifndef MATERIAL_SURFACES_H
#define MATERIAL_SURFACES_H

#include "soup.h"

enum { WORDS = (MOST + 63) / 64 };

typedef struct {
  const soup *s;
  uint64_t (*row)[MOST];       /* row[c] has its first number other than 0, which is 1, at c */
  uint64_t (*row_of_2)[WORDS]; /* the same modulo 2, a bit for each triangle */
  bool has_row[MOST], has_row_of_2[MOST];
  bool closed;     /* every segment has an even number of triangle edges */
  bool consistent; /* on every segment the directions differ in number by at most 1 */
  point low, high; /* the box of all segments with an odd number of edges, if not closed */
} surfaces;

void find_surfaces(surfaces *f, const soup *s);
void free_surfaces(surfaces *f);

/* Draw a closed surface modulo 2: the triangles that it has. False if there is only the empty one.
 */
bool draw_surface(const surfaces *f, bool *in, generator *g);

/* Find how a ray from a point, in a direction in which it meets no edge, crosses each triangle: 1
 * if it leaves on the outer side, -1 if it enters there, else 0. The point must lie on no triangle.
 */
void find_crossings(int8_t *crossing, const soup *s, point p, generator *g);

/* Does a closed surface, of integer factors or modulo 2, enclose the point with these crossings? */
bool is_enclosed(const surfaces *f, const int8_t *crossing);

#endif
