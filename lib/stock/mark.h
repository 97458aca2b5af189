/* SPDX-License-Identifier: MIT */
/* mark.h - the cells that the triangles of a mesh may touch (private). */
#ifndef SEPAX_STOCK_MARK_H
#define SEPAX_STOCK_MARK_H

#include "stock/bricks.h"

/* The middle of a cube of `cells` cells along each side, of a brick; its first cell is `in`. */
static inline void cells_middle(const sepax__stock *s, const size_t at[3], const size_t in[3],
                                double cells, double p[3]) {
  for (int i = 0; i < 3; i++) {
    p[i] = s->origin[i] + ((double)(at[i] * BRICK + in[i]) + cells / 2) * s->cell;
  }
}

/* Add all cells that a triangle may touch: all that touch one, and some that are nearer to one than
 * 2^-20 of a cell. `watch` may be NULL; it is shown shares up to `most`. Errors: ARGUMENT if a
 * coordinate is not finite; MEMORY. */
bool sepax__stock_mark(sepax__stock *marked, const sepax_soup *mesh,
                       const sepax__stock_watch *watch, double most, sepax_error *error);

#endif
