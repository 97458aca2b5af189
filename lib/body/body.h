/* body.h - a body's tree (private). */
#ifndef SEPAX_BODY_H
#define SEPAX_BODY_H

#include "sepax.h"

/* Three vertices: v[vertex][axis]. */
typedef double facet_points[3][3];

enum { BODY_WIDE = 8 };
#define BODY_TRIANGLE UINT32_C(0x80000000)
#define BODY_NONE UINT32_C(0xffffffff)

/* Boxes of up to eight children as centre and half sides, in units of the body's scale from its
 * centre, rounded outwards. A lane without a child has half sides that nothing meets. */
typedef struct {
  float centre[3][BODY_WIDE], half[3][BODY_WIDE];
  uint32_t child[BODY_WIDE]; /* a node, or BODY_TRIANGLE + place of a triangle */
  uint32_t children;
} body_node;

/* The same children in boxes of any direction, which are tighter: child k is within
 * centre + sum of u_i axis[i], |u_i| <= half[i]. A lane without a child has BODY_NONE. */
typedef struct {
  float centre[3][BODY_WIDE], half[3][BODY_WIDE];
  float axis[3][3][BODY_WIDE]; /* axis[i][coordinate] */
  uint32_t child[BODY_WIDE];
} body_boxes;

struct sepax_body {
  size_t count;
  double centre[3];
  double radius;          /* of all vertices from the centre, at most */
  double scale;           /* a power of two; centre +- scale holds all triangles */
  facet_points *triangle; /* in the tree's order */
  uint32_t *number;       /* in the mesh */
  body_node *node;        /* node[0] is the root */
  size_t nodes;
  body_boxes *boxes; /* of each node; behind them the root's own box; on a cache line */
  void *memory;      /* in which they are */
};

/* What is in a box, numbered BODY_WIDE * node + lane. */
static inline uint32_t child_at(const sepax_body *b, uint32_t at) {
  return b->boxes[at / BODY_WIDE].child[at % BODY_WIDE];
}

/* Fill `boxes`; false without memory. */
bool sepax__body_fit(sepax_body *body, size_t threads);

#endif
