/* SPDX-License-Identifier: MIT */
/* walk.h - from a way to its pieces, and from a piece to the bricks that it may reach (private). */
#ifndef SEPAX_STOCK_WALK_H
#define SEPAX_STOCK_WALK_H

#include "stock/bricks.h"
#include "stock/sweep.h"

/* A bound on the coordinates of the cells, in absolute value. */
double sepax__stock_extent(const sepax__stock *s);

/* The middle of a cube of cells: of `cells` cells along each side, the first one `first`. */
static inline void cube_middle(const sepax__stock *s, const size_t first[3], int cells,
                               double p[3]) {
  for (int i = 0; i < 3; i++) {
    p[i] = s->origin[i] + ((double)first[i] + cells / 2.0) * s->cell;
  }
}

/* What is done with a brick: `at` counts bricks. Returns false to end the walk. */
typedef bool brick_visitor(void *context, const size_t at[3]);

/* Visit the bricks that a sweep may reach and that are not empty; with `empty`, the others, too.
 * Bricks that are not visited have no point of a sweep that was made with sure = 1. Returns false
 * if the visitor did. */
bool sepax__stock_walk(const sepax__stock *s, const sweep *reached, bool empty,
                       brick_visitor *visit, void *context);

/* The deviation to which ways are divided, for a tolerance. Both are added, or taken off, together:
 * so they are an eighth of a cell if the tolerance is at most 3 / 32 of a cell. A larger tolerance
 * makes pieces no finer than a 32nd of a cell, because their number grows as they get finer. */
double sepax__stock_fine(const sepax__stock *s, double tolerance);

/* What is done with a piece. Returns false to have it divided, if `last` is false. */
typedef bool piece_visitor(void *context, const sepax__stock_piece *piece, bool last);

/* Visit the pieces of a way in their order. `last` is true if the piece is not to be divided: its
 * deviation is at most `fine`, or halving does not make it smaller. */
void sepax__stock_pieces(const sepax__stock_way *way, double fine, piece_visitor *visit,
                         void *context);

/* Steps along a row of points in the frame of a sweep: point n is row[i] + n * step[i]. */
typedef struct {
  double at[3], step[3];
} sweep_row;

static inline void row_point(const sweep_row *row, int n, double q[3]) {
  for (int i = 0; i < 3; i++) {
    q[i] = row->at[i] + n * row->step[i];
  }
}

/* The row of points along x that begins at p. */
static inline sweep_row row_of(const sweep *s, const double p[3], double cell) {
  sweep_row row;
  sweep_point(s, p, row.at);
  for (int i = 0; i < 3; i++) {
    row.step[i] = s->frame[i][0] * cell;
  }
  return row;
}

/* Of the cubes with their middles at the points of a row, which are OUTSIDE (or, if `inside`,
 * INSIDE)? Bit n is point n; only the bits of `asked`, below 2^9, are looked at and returned. */
unsigned sepax__row_mask(const sweep *s, const sweep_row *row, unsigned asked, double half,
                         double cell, bool inside);

#endif
