/* SPDX-License-Identifier: MIT */
/* fill.c - boxes and convex shapes of revolution as a first stock. */
#include "stock/walk.h"

#include "util/error.h"

#include <math.h>

/* ------------------------------------------------------------------- boxes */

/* Cells from ... to - 1 along axis i between two faces. */
static bool clip_axis(const sepax__stock *s, int i, double low, double high, size_t cells[2]) {
  const double spare = 0x1p-20;
  bool outer = s->bound == SEPAX__STOCK_OUTER;
  double from = (low - s->origin[i]) / s->cell;
  double to = (high - s->origin[i]) / s->cell;
  from = outer ? floor(from + spare) : ceil(from - spare);
  to = outer ? ceil(to - spare) : floor(to + spare);
  from = fmax(from, 0);
  to = fmin(to, (double)(s->bricks[i] * BRICK));
  if (!(from < to)) {
    return false;
  }
  cells[0] = (size_t)from;
  cells[1] = (size_t)to;
  return true;
}

/* Bits of the cells of a brick along one axis. */
static unsigned bits_in(const size_t cells[2], size_t brick) {
  unsigned bits = 0;
  for (size_t n = 0; n < BRICK; n++) {
    size_t cell = brick * BRICK + n;
    bits |= cell >= cells[0] && cell < cells[1] ? 1U << n : 0;
  }
  return bits;
}

static bool fill_brick(sepax__stock *s, size_t cells[3][2], const size_t at[3]) {
  uint64_t layer[BRICK];
  unsigned x = bits_in(cells[0], at[0]);
  unsigned y = bits_in(cells[1], at[1]);
  unsigned z = bits_in(cells[2], at[2]);
  sepax__brick_get(s, at, layer);
  for (unsigned n = 0; n < BRICK * BRICK; n++) {
    bool in = (y >> n % BRICK & 1) != 0 && (z >> n / BRICK & 1) != 0;
    uint64_t row = in ? x : 0;
    layer[n / BRICK] |= row << (BRICK * (n % BRICK));
  }
  return sepax__brick_put(s, at, layer);
}

bool sepax__stock_fill_box(sepax__stock *stock, const double box[2][3], sepax_error *error) {
  size_t cells[3][2];
  bool some = true;
  for (int i = 0; i < 3; i++) {
    if (!isfinite(box[0][i]) || !isfinite(box[1][i])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a box of stock has a number not finite");
    }
    some = some && clip_axis(stock, i, box[0][i], box[1][i], cells[i]);
  }
  if (!some) {
    return true;
  }
  size_t at[3];
  for (at[2] = cells[2][0] / BRICK; at[2] * BRICK < cells[2][1]; at[2]++) {
    for (at[1] = cells[1][0] / BRICK; at[1] * BRICK < cells[1][1]; at[1]++) {
      for (at[0] = cells[0][0] / BRICK; at[0] * BRICK < cells[0][1]; at[0]++) {
        if (!fill_brick(stock, cells, at)) {
          return sepax__stock_no_memory(error);
        }
      }
    }
  }
  return true;
}

/* ------------------------------------------------------------------ shapes */

typedef struct {
  sepax__stock *s;
  sweep made;
  sepax_error *error;
} filling;

/* Cells of a layer whose cube may touch the shape, or whose eight corners are in it. */
static unsigned row_of_cells(const filling *f, const size_t at[3], int y, int z) {
  bool outer = f->s->bound == SEPAX__STOCK_OUTER;
  unsigned cells = 0xff;
  for (int n = 0; n < (outer ? 1 : 4); n++) {
    const double in[3] = {outer ? 0.5 : 0, y + (outer ? 0.5 : n & 1), z + (outer ? 0.5 : n >> 1)};
    double p[3];
    for (int i = 0; i < 3; i++) {
      p[i] = f->s->origin[i] + ((double)(at[i] * BRICK) + in[i]) * f->s->cell;
    }
    sweep_row row = row_of(&f->made, p, f->s->cell);
    if (outer) {
      return ~sepax__row_mask(&f->made, &row, 0xff, f->s->cell / 2, f->s->cell, false) & 0xff;
    }
    unsigned corners = sepax__row_mask(&f->made, &row, 0x1ff, 0, f->s->cell, true);
    cells &= corners & corners >> 1;
  }
  return cells;
}

static bool fill_touched(void *context, const size_t at[3]) {
  filling *f = context;
  uint64_t layer[BRICK];
  const size_t first[3] = {at[0] * BRICK, at[1] * BRICK, at[2] * BRICK};
  double p[3];
  double q[3];
  double reach;
  cube_middle(f->s, first, BRICK, p);
  sweep_point(&f->made, p, q);
  bool all = sepax__sweep_locate(&f->made, q, 0, &reach) == SWEEP_INSIDE &&
             reach > BRICK * 0.8661 * f->s->cell;
  sepax__brick_get(f->s, at, layer);
  for (int n = 0; n < BRICK * BRICK; n++) {
    uint64_t row = all ? 0xff : row_of_cells(f, at, n % BRICK, n / BRICK);
    layer[n / BRICK] |= row << (BRICK * (n % BRICK));
  }
  return sepax__brick_put(f->s, at, layer) || sepax__stock_no_memory(f->error);
}

bool sepax__stock_fill_shape(sepax__stock *stock, const sepax__stock_shape *shape,
                             const sepax_pose *pose, sepax_error *error) {
  filling f = {.s = stock, .error = error};
  sepax__stock_piece still = {.at = *pose};
  return sepax__sweep_make(&f.made, shape, &still, 0, stock->bound == SEPAX__STOCK_OUTER ? 1 : -1,
                           sepax__stock_extent(stock), 0x1p-8 * stock->cell, error) &&
         sepax__stock_walk(stock, &f.made, true, fill_touched, &f);
}
