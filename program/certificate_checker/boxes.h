/* SPDX-License-Identifier: MIT */
/* boxes.h - a tree of boxes, each turned as its triangles lie, over the triangles of a body. */
#ifndef CERTIFICATE_BOXES_H
#define CERTIFICATE_BOXES_H

#include "surface.h"

typedef struct {
  vec middle;
  vec axis[3];      /* of length 1, at right angles, but for rounding */
  double half[3];   /* no vertex is farther from the middle along the axis */
  double radius;    /* from the middle */
  int first, count; /* triangles of a leaf; else count is 0, and first, first + 1 are below */
} box;

typedef struct {
  box *box; /* box[0] holds all */
  int boxes;
  triangle *triangle;
} box_tree;

box_tree boxes_of(const surface *s);

#endif
