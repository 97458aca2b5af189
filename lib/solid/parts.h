/* parts.h - the parts of a body, and which of them overlap (private). */
#ifndef SEPAX_PARTS_H
#define SEPAX_PARTS_H

#include "sepax.h"

typedef struct {
  double vertex[3];       /* one of it */
  double low[3], high[3]; /* its box */
  bool consistent;
  bool open;      /* an edge of it is */
  uint32_t piece; /* of parts that have points in common */
} solid_part;

struct sepax_parts {
  solid_part *part;  /* the parts of a piece in a row */
  uint32_t *of;      /* the part of each triangle, in the tree's order */
  double open[2][3]; /* the box of all parts that are open, least and greatest; else empty */
};

/* Which of two numbers, or sets of numbers, is whose: parent[n] == n for one of each set. */
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

/* Fill parts, pieces and `own` of a shell; parent: sets of triangles that are parts; turned, open:
 * at an edge that is not consistent, or is open, one of its triangles. False without memory. */
bool sepax__find_parts(sepax_shell *shell, uint32_t *parent, const bool *turned, const bool *open);
void sepax__free_parts(struct sepax_parts *parts);

/* Join the parts, as sets of numbers, that have a point in common. False without memory. */
bool sepax__join_pieces(const sepax_body *body, const uint32_t *part_of, uint32_t *piece,
                        size_t parts);

#endif
