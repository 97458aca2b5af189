/* SPDX-License-Identifier: MIT */
/* parts.h - the parts of a body, and which of them overlap (private). */
#ifndef SEPAX_PARTS_H
#define SEPAX_PARTS_H

#include "sepax.h"

/* A part may have copies of sheets (copies.c). It is then read with all of them, with one of each,
 * and with half of each. */
enum { SOLID_ALL = 1, SOLID_ONE = 2, SOLID_HALF = 4, SOLID_READINGS = 7 };

typedef struct {
  double vertex[3];       /* one vertex of the part */
  double low[3], high[3]; /* its AABB */
  bool consistent;
  bool open;        /* it has an open edge */
  uint8_t readings; /* SOLID_ALL, and of the others those that leave triangles out and in which the
                       part is closed */
  uint32_t piece;   /* number of its piece; parts with common points have the same */
} solid_part;

struct sepax_parts {
  solid_part *part;  /* the parts of a piece follow each other */
  uint32_t *of;      /* the part of each triangle, in the tree's order */
  uint8_t *copy;     /* the readings that leave out the triangle; NULL if all parts have one */
  double open[2][3]; /* AABB of all open parts, least and greatest coordinates; empty if all are
                        closed */
};

/* Union-find: the representative of the set of n. parent[n] == n for one number of each set. */
static inline uint32_t set_of(uint32_t *parent, uint32_t n) {
  while (parent[n] != n) {
    parent[n] = parent[parent[n]];
    n = parent[n];
  }
  return n;
}

static inline void join(uint32_t *parent, uint32_t n, uint32_t m) {
  n = set_of(parent, n);
  m = set_of(parent, m);
  parent[n > m ? n : m] = n > m ? m : n;
}

/* Fill in parts, pieces and `own` of a shell. parent: sets of triangles that are parts. turned,
 * open: for each edge that is not consistent or is open, one of its triangles. broken: for each
 * edge, the readings in which it is open, at one of its triangles. copy: the readings that leave
 * out a triangle. If it is needed, it is taken over, and *copy becomes NULL. False without memory.
 */
bool sepax__find_parts(sepax_shell *shell, uint32_t *parent, const bool *turned, const bool *open,
                       const uint8_t *broken, uint8_t **copy);
void sepax__free_parts(struct sepax_parts *parts);

/* Join the sets of parts that have a point in common. False without memory. */
bool sepax__join_pieces(const sepax_body *body, const uint32_t *part_of, uint32_t *piece,
                        size_t parts);

#endif
