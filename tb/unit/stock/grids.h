/* SPDX-License-Identifier: MIT */
/* grids.h - small stocks and ways for tests of cutting and testing. */
#ifndef GRIDS_H
#define GRIDS_H

#include "stock/cells.h"
#include "stock/moves.h"
#include "unit/stock/solids.h"

typedef struct {
  profile solid;
  sepax__stock_shape shape[2]; /* inside, outside */
} tool;

static inline tool make_tool(int kind, double error_most) {
  tool t = {.solid = draw_profile(kind)};
  assert_works(sepax__stock_shape_make(t.solid.corner, t.solid.count, error_most, &t.shape[0],
                                       &t.shape[1], &fault));
  return t;
}

static inline sepax__stock *full_stock(sepax__stock_bound bound, const double box[2][3],
                                       double cell) {
  sepax__stock *s;
  assert_works(sepax__stock_new(&s, bound, box, cell, &fault));
  assert_works(sepax__stock_fill_box(s, box, &fault));
  return s;
}

/* A way through the middle of things, turning if `turns`. */
static inline move draw_move(bool turns, double reach) {
  move m = {.reach = reach, .from = {.a = random_unit(), .c = 3 * random_unit()}};
  m.to = m.from;
  for (int i = 0; i < 3; i++) {
    m.from.tip[i] = 2 * random_unit();
    m.to.tip[i] = m.from.tip[i] + 1.5 * random_unit();
  }
  if (turns) {
    m.to.a += 0.2 * random_unit();
    m.to.c += 0.2 * random_unit();
  }
  return m;
}

static inline double reach_of(const tool *t) {
  double z = fmax(fabs(t->shape[0].low), fabs(t->shape[0].high));
  return hypot(t->shape[0].radius, z);
}

/* The least `beyond` of a point on the way of a move, by stands at small steps and a finer search
 * around the best, until it is at most `until`: an upper bound of the true one. */
static inline double beyond_move(const profile *p, const move *m, const double point[3],
                                 double until) {
  enum { STEPS = 30, FINER = 40 };
  const double still[3] = {0, 0, 0};
  double best = INFINITY;
  double at = 0;
  for (int n = 0; n <= STEPS && best > until; n++) {
    stand s = stand_between(m, (double)n / STEPS);
    sepax_pose pose = pose_of(&s);
    double beyond = (double)beyond_posed(p, &pose, still, 0, point);
    at = beyond < best ? (double)n / STEPS : at;
    best = fmin(best, beyond);
  }
  double step = 1.0 / STEPS;
  for (int n = 0; n < FINER && best > until; n++) {
    for (int sign = -1; sign <= 1; sign += 2) {
      double to = fmin(1, fmax(0, at + sign * step));
      stand s = stand_between(m, to);
      sepax_pose pose = pose_of(&s);
      double beyond = (double)beyond_posed(p, &pose, still, 0, point);
      at = beyond < best ? to : at;
      best = fmin(best, beyond);
    }
    step *= 0.6;
  }
  return best;
}

/* From a cell of the grid to the next; after the last there is none. */
static inline bool is_cell(const sepax__stock_facts *f, const int cell[3]) {
  return cell[2] < cells_along(f, 2);
}

static inline void next_cell(const sepax__stock_facts *f, int cell[3]) {
  for (int i = 0; i < 3; i++) {
    if (++cell[i] < cells_along(f, i) || i == 2) {
      return;
    }
    cell[i] = 0;
  }
}

#endif
