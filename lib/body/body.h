/* SPDX-License-Identifier: MIT */
/* body.h - a body's tree (private). */
#ifndef SEPAX_BODY_H
#define SEPAX_BODY_H

#include "sepax.h"

/* Three vertices: v[vertex][axis]. */
typedef double facet_points[3][3];

enum { BODY_WIDE = 8 };
#define BODY_TRIANGLE UINT32_C(0x80000000)
#define BODY_NONE UINT32_C(0xffffffff)

/* AABBs of up to eight children: centre and half sides, counted from the body's centre in units of
 * its scale, rounded outwards. A lane without a child has half sides that no box meets. */
typedef struct {
  float centre[3][BODY_WIDE], half[3][BODY_WIDE];
  uint32_t child[BODY_WIDE]; /* number of a node, or BODY_TRIANGLE + place of a triangle */
  uint32_t children;
} body_node;

/* Oriented boxes of the same children, which are tighter than AABBs. Child k lies within centre +
 * sum of u_i axis[i], |u_i| <= half[i]. A lane without a child has BODY_NONE. */
typedef struct {
  float centre[3][BODY_WIDE], half[3][BODY_WIDE];
  float axis[3][3][BODY_WIDE]; /* axis[i][coordinate] */
  uint32_t child[BODY_WIDE];
} body_boxes;

/* The oriented box of a node in doubles, about 2^29 times as exact as in body_boxes: where many
 * triangles are nearly equally far, single precision could not tell them apart. The node's
 * triangles are within centre + sum of u_i axis[i], |u_i| <= half[i], from the body's centre in
 * units of its scale. Lengths and right angles of the axes are right to 2^-48. */
typedef struct {
  double axis[3][3], centre[3], half[3];
  double aabb[2]
             [3]; /* least and greatest coordinates of the triangles, in the file's units; exact */
} body_frame;

struct sepax_body {
  size_t count;
  double centre[3];
  double radius;          /* greatest distance of a vertex from the centre */
  double scale;           /* a power of two; centre +- scale holds all triangles */
  facet_points *triangle; /* triangles in the order of the tree */
  uint32_t *number;       /* number of each triangle in the mesh */
  body_node *node;        /* node[0] is the root */
  size_t nodes;
  body_boxes *boxes; /* boxes of each node, then the root's own box; aligned to cache lines */
  void *memory;      /* memory that holds the boxes */
  body_frame *frame; /* one for each node */
  float *foot;       /* of each triangle, in the order of the tree: its box stands on an edge, and
                        the third vertex is that far along axis 0 from the centre, on the side to
                        which axis 1 points; infinite if that is not known */
};

/* The child in box `at`. Boxes are numbered BODY_WIDE * node + lane. */
static inline uint32_t child_at(const sepax_body *b, uint32_t at) {
  return b->boxes[at / BODY_WIDE].child[at % BODY_WIDE];
}

/* The sum of a box's half sides. */
static inline float size_at(const sepax_body *b, uint32_t at) {
  const body_boxes *boxes = &b->boxes[at / BODY_WIDE];
  uint32_t lane = at % BODY_WIDE;
  return boxes->half[0][lane] + boxes->half[1][lane] + boxes->half[2][lane];
}

/* Of which body is the node opened in a pair of boxes? Of the one with the larger box, unless that
 * box is a triangle's. ratio: the scale of body 1 in units of body 0's. */
static inline int opened_body(const sepax_body *const body[2], const uint32_t at[2], float ratio) {
  const uint32_t child[2] = {child_at(body[0], at[0]), child_at(body[1], at[1])};
  if (((child[0] | child[1]) & BODY_TRIANGLE) != 0) {
    return (child[0] & BODY_TRIANGLE) != 0;
  }
  return size_at(body[1], at[1]) * ratio > size_at(body[0], at[0]);
}

/* Fill in `boxes`, `frame` and `foot`. False without memory. */
bool sepax__body_fit(sepax_body *body, size_t threads);

#endif
