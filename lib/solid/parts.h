/* SPDX-License-Identifier: MIT */
/* parts.h - the parts of a body, and which of them overlap (private). */
#ifndef SEPAX_PARTS_H
#define SEPAX_PARTS_H

#include "surface.h"

typedef struct {
  double vertex[3]; /* one vertex of the part */
  double box[2][3]; /* its AABB: least and greatest coordinates */
  bool consistent;
  bool open;           /* it has an open edge */
  uint32_t piece;      /* number of its piece; parts with common points have the same */
  double tangle[2][3]; /* the AABB of all parts with which it may form closed surfaces, because
                          their edges overlap; its own if none do */
} solid_part;

struct sepax_parts {
  solid_part *part;  /* the parts of a piece follow each other */
  uint32_t *of;      /* the part of each triangle, in the tree's order */
  double open[2][3]; /* AABB of all open parts, least and greatest coordinates; empty if all are
                        closed */
  uint32_t *sheet;   /* of each triangle: one that stands for its sheet */
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

/* Fill in parts, pieces and `own` of a shell from a surface that is judged. `sheet` is taken over
 * and becomes NULL in the surface. False without memory. */
bool sepax__find_parts(sepax_shell *shell, surface *s);
void sepax__free_parts(struct sepax_parts *parts);

/* Join the sets of parts that have a point in common. False without memory. */
bool sepax__join_pieces(const sepax_body *body, const uint32_t *part_of, uint32_t *piece,
                        size_t parts);

#endif
