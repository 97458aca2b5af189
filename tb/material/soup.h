/* SPDX-License-Identifier: MIT */
/* soup.h - the triangles of a random body, and shapes and faults that are added to them. */
#ifndef MATERIAL_SOUP_H
#define MATERIAL_SOUP_H

#include "space.h"

enum { MOST = 640 }; /* triangles of a body */

typedef struct {
  point v[3];
} triangle;
typedef struct {
  triangle t[MOST];
  size_t count;
} soup;

/* Add a triangle. A full soup stays as it is: then `full` says so, and the body is not used. */
void add(soup *s, point a, point b, point c);
bool full(const soup *s);

/* Add four points' faces: the boundary of a tetrahedron as it is ordered, turned if `turned`. It is
 * closed even if the points lie in one plane. */
void add_simplex(soup *s, const point p[4], bool turned);

/* Add the same with all faces wound outwards, or inwards. False if the points lie in one plane. */
bool add_tetrahedron(soup *s, const point p[4], bool inwards);

/* Add a box. Each face has one of its two diagonals. */
void add_box(soup *s, point low, point high, bool inwards, generator *g);

/* Add a face a, b, c, d (a parallelogram): by a diagonal, a fan, or strips; all triangles wound
 * as the corners are. The corners differ by multiples of 12. */
void add_face(soup *s, const point corner[4], generator *g);

/* Corner k of a box, whose bit i chooses low or high on axis i. Face `face` of a box, seen from
 * outside. */
point box_corner(point low, point high, int k);
void box_face(point low, point high, int face, point corner[4]);

void turn(triangle *t);

/* Divide triangle i at a point of the lattice on one of its edges, if one is there: a T-junction
 * for the neighbour. */
bool divide(soup *s, size_t i, generator *g);

/* Divide triangle i along edge e into several at once. */
void divide_row(soup *s, size_t i, int e, int pieces);

/* Triangles with the same corners in opposite directions, or in any directions, go in pairs. */
void cancel(soup *s, bool in_any_direction);

void remove_triangle(soup *s, size_t i);
void shuffle(soup *s, generator *g);

/* The greatest common divisor; not negative. */
int64_t common_factor(int64_t a, int64_t b);

#endif
