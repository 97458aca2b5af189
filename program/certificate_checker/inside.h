/* SPDX-License-Identifier: MIT */
/* inside.h - is a part of one body inside the other? */
#ifndef CERTIFICATE_INSIDE_H
#define CERTIFICATE_INSIDE_H

#include "surface.h"

#include <stdbool.h>

/* Triangles that hang together by edges: a vertex of them, and those that are farthest out along
 * the axes. */
typedef struct {
  vec at[7];
} shell_part;

/* The box of an element, if it has open parts. */
typedef struct {
  bool any;
  vec low, high;
} open_box;

/* Readings of parts that have copies of sheets, as files with both sides of each face have: all of
 * them, one of each, each second one. */
enum { READINGS = 3 };

/* Of a surface: its parts; and which triangles are of closed ones, each of whose edges belongs to
 * an even number of triangles. */
typedef struct {
  const surface *body;
  shell_part *part;
  size_t parts;
  bool *closed;          /* of each triangle */
  size_t *part_of;       /* of each triangle: one that stands for its part */
  bool (*out)[READINGS]; /* of each triangle: left out in that reading */
  bool *turned;          /* of what stands for a part: its edges are not run both ways alike */
  size_t *piece;    /* of what stands for a part: its piece; SIZE_MAX where it is not found yet */
  bool *consistent; /* of each collision element: its closed parts' edges are run both ways alike */
  open_box *open;   /* of each collision element */
} shell;

shell shell_of(const surface *s);

/* Of bodies whose surfaces share no point: is a part of a, in the pose `at`, inside an element of
 * b? Inside is what a ray leaves through an odd number of triangles; where the triangles' sides are
 * consistent, what they wind around. What is inside several parts that cancel each other is inside,
 * too, unless these parts are an even number and proved to share no point: then it is in a cavity.
 * Closed parts of b only. */
bool shell_inside(const shell *a, const shell *b, pose at);

/* Of such bodies: may a part of a be inside what open parts of an element of b enclose? They are
 * open by whole edges, but may be closed by edges that have a vertex in their middle. false is
 * proved: of each part of a, one vertex is outside their box, or is where a ray begins that meets
 * none of the element's triangles. */
bool shell_may_be_inside(const shell *a, const shell *b, pose at);

#endif
