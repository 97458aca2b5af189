/* SPDX-License-Identifier: MIT */
/* cutting_finer.c - a closer look at what a tool touches: a small stock with finer cells. */
#include "path/stock/cutting_state.h"

/* Closer looks at most, and the cells on a side of what they look at. */
enum { LOOKS_MOST = 200, CLOSE_MOST = 200 };

/* Cut a stock by all that the path has cut before the part `from` of the motion at hand. */
static bool replay(path_cutting *c, sepax__stock *stock, double from, sepax_error *error) {
  size_t line = c->line;
  bool alone = c->alone;
  bool ok = true;
  c->alone = false;
  for (c->line = 1; c->line <= line && ok; c->line++) {
    double to = c->line < line ? 1 : from;
    if (!format_motion_goes_on(&c->scene->motion, c->line - 1) || !path_cutting_find_pairs(c) ||
        !path_cutting_cuts(c) || to == 0) {
      continue;
    }
    const path_pair *flutes = c->of[NC_FLUTES];
    const path_cutter *shapes = path_cutting_cutter(c, flutes);
    sepax__stock_way way = path_cutting_way(c, flutes, 0, to);
    ok = sepax__stock_cut(stock, shapes->inside.shape, shapes->inside.count, &way,
                          path_cutting_tolerance(c), error);
  }
  c->line = line;
  c->alone = alone;
  path_cutting_find_pairs(c);
  return ok;
}

/* A box around the cells that were touched, with cells of a quarter of the side around it. */
static bool make_close(path_cutting *c, sepax__stock **stock, const double touched[2][3],
                       sepax_error *error) {
  const path_body *b = &c->scene->body[c->scene->stock.body];
  double cell = c->scene->stock.cell;
  double box[2][3];
  for (int i = 0; i < 3; i++) {
    box[0][i] = touched[0][i] - cell / 8;
    box[1][i] = touched[1][i] + cell / 8;
    if (box[1][i] - box[0][i] > CLOSE_MOST * cell) {
      *stock = NULL;
      return true;
    }
  }
  return sepax__stock_new(stock, SEPAX__STOCK_OUTER, box, cell / 4, error) &&
         sepax__stock_fill_mesh(*stock, &b->mesh, NULL, error);
}

bool path_cutting_look_closer(path_cutting *c, path_pair *pair, double from, double to,
                              double shrink, double tolerance, bool *is_free, sepax_error *error) {
  const path_cutter *shapes = path_cutting_cutter(c, pair);
  sepax__stock_touch found;
  sepax__stock *close = NULL;
  if (c->looks == LOOKS_MOST || c->q->first != NULL) {
    return true;
  }
  c->looks++;
  sepax__stock_way way = path_cutting_way(c, pair, from, to);
  bool ok = sepax__stock_test(c->outer, shapes->outside.shape, shapes->outside.count, &way, shrink,
                              tolerance, true, &found, error) &&
            make_close(c, &close, (const double(*)[3])found.box, error);
  if (ok && close != NULL) {
    ok = replay(c, close, from, error);
    way = path_cutting_way(c, pair, from, to);
    ok = ok && sepax__stock_test(close, shapes->outside.shape, shapes->outside.count, &way, shrink,
                                 tolerance, false, &found, error);
    *is_free = ok && found.free;
  }
  sepax__stock_free(close);
  return ok;
}
