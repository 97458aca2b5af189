/* SPDX-License-Identifier: MIT */
/* local.c - a stock of a small box with smaller cells decides what the whole stock leaves open; and
 * the two bounds never contradict each other. */
#include "unit/stock/grids.h"

static const double box[2][3] = {{0, 0, -8}, {60, 40, 0}};

/* A slot of diameter 10 along x, 4 deep; the first two overlap by 0.1 mm, off the faces of cells.
 */
static move slot_at(double y) {
  move m = {.from = {.tip = {8, y, -4}}, .to = {.tip = {52, y, -4}}};
  return m;
}

static const double slots[2] = {12.13, 22.03};

static void make_flat(sepax__stock_shape shape[2]) {
  const profile flat = {{{0, 0, 0}, {5, 0, 0}, {5, 12, 0}, {0, 12, 0}}, 4};
  assert_works(sepax__stock_shape_make(flat.corner, 4, 1, &shape[0], &shape[1], &fault));
}

static sepax__stock *cut_slots(const double part[2][3], double cell) {
  sepax__stock_shape shape[2];
  make_flat(shape);
  sepax__stock *s;
  assert_works(sepax__stock_new(&s, SEPAX__STOCK_OUTER, part, cell, &fault));
  assert_works(sepax__stock_fill_box(s, box, &fault));
  for (int n = 0; n < 2; n++) {
    move m = slot_at(slots[n]);
    assert_works(sepax__stock_cut(s, &shape[0], 1, WAY(&m), 0, &fault));
  }
  return s;
}

/* A rapid from one slot to the other crosses the seam: a wall of cells that neither slot held. */
CASE(smaller_cells_heal_a_seam) {
  const double cell = 0.5;
  sepax__stock_shape shape[2];
  sepax__stock_touch found;
  make_flat(shape);
  sepax__stock *s = cut_slots(box, cell);
  move m = {.from = {.tip = {20, slots[0], -4}}, .to = {.tip = {20, slots[1], -4}}};
  assert_works(sepax__stock_test(s, &shape[1], 1, WAY(&m), 2 * cell, 0, true, &found, &fault));
  assert_false(found.free);
  sepax__stock *local = cut_slots(found.box, cell / 4);
  assert_true(sepax__stock_look(local).bytes < 1000000);
  double depth[2];
  assert_works(sepax__stock_depth(local, &shape[1], 1, WAY(&m), 0, depth, &fault));
  assert_true(depth[1] <= 2 * cell);
  assert_works(sepax__stock_test(local, &shape[1], 1, WAY(&m), 2 * cell, 0, true, &found, &fault));
  assert_true(found.free);
  /* true material stays: a rapid out of the slots is not free there either */
  m.to.tip[1] = 30;
  assert_works(sepax__stock_test(s, &shape[1], 1, WAY(&m), 2 * cell, 0, true, &found, &fault));
  assert_false(found.free);
  sepax__stock_free(local);
  local = cut_slots(found.box, cell / 4);
  assert_works(sepax__stock_test(local, &shape[1], 1, WAY(&m), 2 * cell, 0, true, &found, &fault));
  assert_false(found.free);
  sepax__stock_free(local);
  sepax__stock_free(s);
}

/* After the same cuts each cell of the inner bound is in the outer one; what hits the inner bound
 * is not free of the outer one. */
CASE(bounds_agree) {
  const double cube[2][3] = {{-4, -4, -4}, {4, 4, 4}};
  int hits = 0;
  for (int n = 0; n < 12; n += STEP) {
    sepax__stock *s[2] = {full_stock(SEPAX__STOCK_OUTER, cube, 0.4),
                          full_stock(SEPAX__STOCK_INNER, cube, 0.4)};
    for (int k = 0; k < 3; k++) {
      tool t = make_tool(n + k, 0.01);
      move m = draw_move(k != 0, reach_of(&t));
      for (int side = 0; side < 2; side++) {
        assert_works(sepax__stock_cut(s[side], &t.shape[side], 1, WAY(&m), 0.01, &fault));
      }
    }
    sepax__stock_facts f = sepax__stock_look(s[0]);
    for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
      assert_true(!has_cell(s[1], &f, at) || has_cell(s[0], &f, at));
    }
    for (int k = 0; k < 20; k++) {
      tool t = make_tool(n + k, 0.01);
      move m = draw_move(k % 2 == 0, reach_of(&t));
      m.from.tip[2] += 3 * random_unit();
      bool hit;
      double at[3];
      sepax__stock_touch found;
      assert_works(sepax__stock_hit(s[1], &t.shape[0], 1, WAY(&m), 0, &hit, at, &fault));
      assert_works(sepax__stock_test(s[0], &t.shape[1], 1, WAY(&m), 0, 0, false, &found, &fault));
      assert_true(!hit || !found.free);
      hits += hit;
    }
    sepax__stock_free(s[0]);
    sepax__stock_free(s[1]);
  }
  assert_true(hits > 10);
}
