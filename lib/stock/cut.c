/* SPDX-License-Identifier: MIT */
/* cut.c - cells go that the cutter takes.
 *
 * Outer: a cell goes if its eight corners lie in one sweep. The sweep of a convex shape that does
 * not turn is convex, so the cell lies in it. The shape is shrunk by the tolerance and by the
 * deviation: if a ball of that radius around a point lies in the shape at its place in the piece,
 * then the point lies in the shape wherever the tool truly is at that time. Inner: a cell goes
 * unless the sweep of the shape, made larger by both, is proved to miss it. */
#include "stock/walk.h"

#include "util/error.h"

#include <math.h>

typedef struct {
  sepax__stock *s;
  const sepax__stock_shape *shape;
  size_t shapes;
  double tolerance, extent;
  sweep made;
  sepax_error *error;
  bool failed;
} cutting;

static void row_start(const sepax__stock *s, const size_t at[3], int y, int z, double by,
                      double p[3]) {
  const double in[3] = {by, y + by, z + by};
  for (int i = 0; i < 3; i++) {
    p[i] = s->origin[i] + ((double)(at[i] * BRICK) + in[i]) * s->cell;
  }
}

/* Of the cells that may go, which go on by the corners of row (y, z)? Corner n of the row belongs
 * to the cells n - 1 and n of up to four rows of cells. */
static void ask_corners(const cutting *c, const size_t at[3], int y, int z,
                        uint8_t may[BRICK][BRICK]) {
  unsigned any = 0;
  for (int n = 0; n < 4; n++) {
    int row = y - (n & 1);
    int in = z - n / 2;
    any |= row >= 0 && row < BRICK && in >= 0 && in < BRICK ? may[in][row] : 0;
  }
  if (any == 0) {
    return;
  }
  double p[3];
  row_start(c->s, at, y, z, 0, p);
  sweep_row row = row_of(&c->made, p, c->s->cell);
  unsigned inside = sepax__row_mask(&c->made, &row, any | any << 1, 0, c->s->cell, true);
  for (int n = 0; n < 4; n++) {
    int of = y - (n & 1);
    int in = z - n / 2;
    if (of >= 0 && of < BRICK && in >= 0 && in < BRICK) {
      may[in][of] &= (uint8_t)(inside & inside >> 1);
    }
  }
}

/* Cells between eight corners that are inside go. Rows of corners with y and z even are asked
 * first: each cell has two corners in one of them, so most cells that stay need no other row. */
static void take_inside(const cutting *c, const size_t at[3], uint64_t layer[BRICK]) {
  uint8_t may[BRICK][BRICK];
  for (int n = 0; n < BRICK * BRICK; n++) {
    may[n / BRICK][n % BRICK] = layer[n / BRICK] >> (BRICK * (n % BRICK)) & 0xff;
  }
  for (int turn = 0; turn < 4; turn++) {
    int first_y = turn == 1 || turn == 3; /* (0, 0), (1, 1), (0, 1), (1, 0) */
    int first_z = turn == 1 || turn == 2;
    for (int z = first_z; z <= BRICK; z += 2) {
      for (int y = first_y; y <= BRICK; y += 2) {
        ask_corners(c, at, y, z, may);
      }
    }
  }
  for (int n = 0; n < BRICK * BRICK; n++) {
    layer[n / BRICK] &= ~((uint64_t)may[n / BRICK][n % BRICK] << (BRICK * (n % BRICK)));
  }
}

/* Cells that the sweep may touch go. */
static void take_touched(const cutting *c, const size_t at[3], uint64_t layer[BRICK]) {
  for (int z = 0; z < BRICK; z++) {
    for (int y = 0; y < BRICK; y++) {
      unsigned there = layer[z] >> (BRICK * y) & 0xff;
      if (there != 0) {
        double p[3];
        row_start(c->s, at, y, z, 0.5, p);
        sweep_row row = row_of(&c->made, p, c->s->cell);
        uint64_t left = sepax__row_mask(&c->made, &row, there, c->s->cell / 2, c->s->cell, false);
        layer[z] &= left << (BRICK * y) | ~((uint64_t)0xff << (BRICK * y));
      }
    }
  }
}

/* All of the brick lies in the sweep if a ball around its middle does, or its eight corners. */
static bool takes_all(const cutting *c, const size_t at[3]) {
  const size_t first[3] = {at[0] * BRICK, at[1] * BRICK, at[2] * BRICK};
  double p[3];
  double q[3];
  double reach;
  cube_middle(c->s, first, BRICK, p);
  sweep_point(&c->made, p, q);
  sweep_side middle = sepax__sweep_locate(&c->made, q, 0, &reach);
  if (middle != SWEEP_INSIDE || reach > BRICK * 0.8661 * c->s->cell) {
    return middle == SWEEP_INSIDE;
  }
  for (int n = 0; n < 8; n++) {
    double corner[3];
    for (int i = 0; i < 3; i++) {
      corner[i] = c->s->origin[i] + (double)((at[i] + (n >> i & 1)) * BRICK) * c->s->cell;
    }
    sweep_point(&c->made, corner, q);
    if (sepax__sweep_locate(&c->made, q, 0, &reach) != SWEEP_INSIDE) {
      return false;
    }
  }
  return true;
}

static bool cut_brick(void *context, const size_t at[3]) {
  cutting *c = context;
  uint64_t layer[BRICK] = {0};
  if (!takes_all(c, at)) {
    sepax__brick_get(c->s, at, layer);
    if (c->s->bound == SEPAX__STOCK_OUTER) {
      take_inside(c, at, layer);
    } else {
      take_touched(c, at, layer);
    }
  }
  c->failed = !sepax__brick_put(c->s, at, layer) && !sepax__stock_no_memory(c->error);
  return !c->failed;
}

static bool cut_piece(void *context, const sepax__stock_piece *piece, bool last) {
  cutting *c = context;
  if (!last || c->failed) {
    return c->failed;
  }
  int sure = c->s->bound == SEPAX__STOCK_OUTER ? -1 : 1;
  for (size_t n = 0; n < c->shapes && !c->failed; n++) {
    double grow = sure * (c->tolerance + piece->deviation);
    c->failed = !sepax__sweep_make(&c->made, &c->shape[n], piece, grow, sure, c->extent,
                                   0x1p-8 * c->s->cell, c->error) ||
                !sepax__stock_walk(c->s, &c->made, false, cut_brick, c);
  }
  return true;
}

bool sepax__stock_cut(sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                      const sepax__stock_way *way, double tolerance, sepax_error *error) {
  if (!isfinite(tolerance) || tolerance < 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "the tolerance of a cut must be 0 or more");
  }
  cutting c = {.s = stock,
               .shape = shape,
               .shapes = shapes,
               .tolerance = tolerance,
               .extent = sepax__stock_extent(stock),
               .error = error};
  sepax__stock_pieces(way, sepax__stock_fine(stock, tolerance), cut_piece, &c);
  return !c.failed;
}
