/* SPDX-License-Identifier: MIT */
/* cells.h - single cells of a stock, for its tests. */
#ifndef STOCK_CELLS_H
#define STOCK_CELLS_H

#include "stock/stock.h"

#include <math.h>

/* The point of a cell at `in`, 0 ... 1 along each side. */
static inline void cell_point(const sepax__stock_facts *f, const int cell[3], const double in[3],
                              double p[3]) {
  for (int i = 0; i < 3; i++) {
    p[i] = f->box[0][i] + (cell[i] + in[i]) * f->cell;
  }
}

static inline int cells_along(const sepax__stock_facts *f, int axis) {
  return (int)lround((f->box[1][axis] - f->box[0][axis]) / f->cell);
}

static inline bool has_cell(const sepax__stock *s, const sepax__stock_facts *f, const int cell[3]) {
  double p[3];
  cell_point(f, cell, (const double[]){0.5, 0.5, 0.5}, p);
  return sepax__stock_has(s, p);
}

/* Has the cell a neighbour that is there if it is not, or that is not if it is? */
static inline bool is_border(const sepax__stock *s, const sepax__stock_facts *f,
                             const int cell[3]) {
  bool here = has_cell(s, f, cell);
  for (int n = 0; n < 6; n++) {
    int to[3] = {cell[0], cell[1], cell[2]};
    to[n / 2] += n % 2 == 0 ? 1 : -1;
    if (to[n / 2] >= 0 && to[n / 2] < cells_along(f, n / 2) && has_cell(s, f, to) != here) {
      return true;
    }
  }
  return false;
}

#endif
