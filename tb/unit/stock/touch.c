/* SPDX-License-Identifier: MIT */
/* touch.c - what tests of a way say: free is never wrong, depths are bracketed, hits are true. */
#include "unit/stock/grids.h"

static const double box[2][3] = {{-4, -4, -4}, {4, 4, 4}};

static sepax__stock_touch touch(const sepax__stock *s, const sepax__stock_shape *shape,
                                const move *m, double shrink, double tolerance, bool all) {
  sepax__stock_touch found;
  assert_works(sepax__stock_test(s, shape, 1, WAY(m), shrink, tolerance, all, &found, &fault));
  return found;
}

/* A stock with some cuts in it. */
static sepax__stock *draw_stock(sepax__stock_bound bound, double cell) {
  sepax__stock *s = full_stock(bound, box, cell);
  for (int n = 0; n < 6; n++) {
    tool t = make_tool(n, 0.01);
    move m = draw_move(n % 2 == 0, reach_of(&t));
    assert_works(sepax__stock_cut(s, &t.shape[bound == SEPAX__STOCK_INNER], 1, WAY(&m), 0, &fault));
  }
  return s;
}

/* The deepest that a corner or middle of a cell of the surface is in the tool on its way. */
static double deepest_of(const sepax__stock *s, const tool *t, const move *m, double until) {
  sepax__stock_facts f = sepax__stock_look(s);
  double deepest = -INFINITY;
  for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
    for (int n = 0; n < 9 && has_cell(s, &f, at) && is_border(s, &f, at); n++) {
      const double corner[3] = {n & 1, n >> 1 & 1, n >> 2 & 1};
      double p[3];
      cell_point(&f, at, n < 8 ? corner : (const double[]){0.5, 0.5, 0.5}, p);
      deepest = fmax(deepest, -beyond_move(&t->solid, m, p, -until));
    }
  }
  return deepest;
}

/* Away from the stock, then nearer to it, until it is no longer free: at the last free place no
 * point of a cell is deeper than the shrinking and the tolerance allow. */
CASE(what_is_free_is_free) {
  int checked = 0;
  for (int n = 0; n < 12; n += STEP) {
    sepax__stock *s = draw_stock(SEPAX__STOCK_OUTER, 0.5);
    tool t = make_tool(n, 0.01);
    move m = draw_move(n % 2 == 0, reach_of(&t));
    double shrink = n % 3 * 0.15;
    double tolerance = n % 4 * 0.05;
    double off[2] = {20, 0}; /* free, not free */
    move at = m;
    for (int k = 0; k < 12; k++) {
      double middle = off[0] / 2 + off[1] / 2;
      at.from.tip[2] = m.from.tip[2] + middle;
      at.to.tip[2] = m.to.tip[2] + middle;
      off[touch(s, &t.shape[1], &at, shrink, tolerance, false).free ? 0 : 1] = middle;
    }
    at.from.tip[2] = m.from.tip[2] + off[0];
    at.to.tip[2] = m.to.tip[2] + off[0];
    assert_true(touch(s, &t.shape[1], &at, shrink, tolerance, false).free);
    assert_true(deepest_of(s, &t, &at, 1e-9) <= shrink - tolerance + 1e-9);
    /* a little nearer the cells are touched, but for what is proved too carefully */
    at.from.tip[2] -= 1.3;
    at.to.tip[2] -= 1.3;
    checked += deepest_of(s, &t, &at, 2) > shrink - tolerance;
    sepax__stock_free(s);
  }
  assert_true(checked >= 9 / STEP);
}

/* Over a flat face a flat end is judged to the last digit. It rocks around its tip, so that its
 * edge dips by R sin a, and it may be nearer by the tolerance. */
CASE(turns_and_tolerances_are_added) {
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 0.25);
  const profile flat = {{{0, 0, 0}, {2, 0, 0}, {2, 0.1, 0}, {0, 0.1, 0}}, 4};
  sepax__stock_shape shape[2];
  assert_works(sepax__stock_shape_make(flat.corner, 4, 1, &shape[0], &shape[1], &fault));
  for (int n = 0; n < 40; n++) {
    double a = 0.3 * (1.01 + random_unit());
    double tolerance = 0.05 * (1.01 + random_unit());
    double dip = 2 * sin(a) + tolerance;
    move m = {.reach = hypot(2, 0.1), .from = {.a = -a}, .to = {.a = a}};
    m.from.tip[2] = m.to.tip[2] = 4 + dip * 0.999;
    assert_false(touch(s, &shape[1], &m, 0, tolerance, false).free);
    m.from.tip[2] = m.to.tip[2] = 4 + dip + 0.1;
    assert_true(touch(s, &shape[1], &m, 0, tolerance, false).free);
    m.from.a = m.to.a = 0;
    m.from.tip[2] = m.to.tip[2] = 4 + tolerance * 0.999;
    assert_false(touch(s, &shape[1], &m, 0, tolerance, false).free);
    m.from.tip[2] = m.to.tip[2] = 4 + tolerance * 1.001;
    assert_true(touch(s, &shape[1], &m, 0, tolerance, false).free);
  }
  sepax__stock_free(s);
}

CASE(depth_is_bracketed) {
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 0.25);
  const profile flat = {{{0, 0, 0}, {2, 0, 0}, {2, 6, 0}, {0, 6, 0}}, 4};
  sepax__stock_shape shape[2];
  assert_works(sepax__stock_shape_make(flat.corner, 4, 1, &shape[0], &shape[1], &fault));
  for (int n = 0; n < 20; n++) {
    double deep = 0.95 * fabs(random_unit());
    move m = {.from = {.tip = {-2, 0, 4 - deep}}, .to = {.tip = {2, 0.5, 4 - deep}}};
    double depth[2];
    assert_works(sepax__stock_depth(s, &shape[1], 1, WAY(&m), 0, depth, &fault));
    assert_true(depth[0] <= deep + 0.25 && depth[1] >= deep - 1e-9);
    assert_true(depth[1] - depth[0] <= 0.25 / 4);
    m.from.tip[2] = m.to.tip[2] = 4.001;
    assert_works(sepax__stock_depth(s, &shape[1], 1, WAY(&m), 0, depth, &fault));
    assert_true(depth[0] == -1 && depth[1] == 0);
    m.from.tip[2] = m.to.tip[2] = 2; /* half of the radius or more */
    assert_works(sepax__stock_depth(s, &shape[1], 1, WAY(&m), 0, depth, &fault));
    assert_true(depth[0] >= 0.99 && isinf(depth[1]));
  }
  sepax__stock_free(s);
}

/* All cells that are touched are in the box: with the box taken out, the way is free. */
CASE(the_box_holds_all_that_is_touched) {
  for (int n = 0; n < 8; n += STEP) {
    sepax__stock *s = draw_stock(SEPAX__STOCK_OUTER, 0.4);
    tool t = make_tool(n, 0.01);
    move m = draw_move(n % 2 == 0, reach_of(&t));
    sepax__stock_touch found = touch(s, &t.shape[1], &m, 0.1, 0, true);
    sepax__stock_facts f = sepax__stock_look(s);
    if (found.free) {
      sepax__stock_free(s);
      continue;
    }
    /* the same cells without those in the box */
    sepax__stock *rest;
    assert_works(sepax__stock_new(&rest, SEPAX__STOCK_OUTER, box, 0.4, &fault));
    for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
      double cube[2][3];
      bool in = true;
      cell_point(&f, at, (const double[]){0.01, 0.01, 0.01}, cube[0]);
      cell_point(&f, at, (const double[]){0.99, 0.99, 0.99}, cube[1]);
      for (int i = 0; i < 3; i++) {
        in = in && cube[0][i] > found.box[0][i] && cube[1][i] < found.box[1][i];
      }
      if (has_cell(s, &f, at) && !in) {
        assert_works(sepax__stock_fill_box(rest, cube, &fault));
      }
    }
    assert_true(touch(rest, &t.shape[1], &m, 0.1, 0, false).free);
    sepax__stock_free(rest);
    sepax__stock_free(s);
  }
}

/* A hit is a point of a cell that the tool holds wherever it is within the tolerance. */
CASE(hits_are_true) {
  int hits = 0;
  for (int n = 0; n < 48; n += STEP) {
    sepax__stock *s = draw_stock(SEPAX__STOCK_INNER, 0.4);
    tool t = make_tool(n, 0.01);
    move m = draw_move(n % 2 == 0, reach_of(&t));
    m.from.tip[2] += 3;
    m.to.tip[2] += 3;
    bool hit;
    double at[3];
    double tolerance = n % 3 * 0.1;
    assert_works(sepax__stock_hit(s, &t.shape[0], 1, WAY(&m), tolerance, &hit, at, &fault));
    if (hit) {
      hits++;
      assert_true(sepax__stock_has(s, at));
      assert_true(beyond_move(&t.solid, &m, at, -tolerance) <= -tolerance + 1e-9);
    }
    sepax__stock_free(s);
  }
  assert_true(hits >= 10 / STEP);
}

/* Limits between the parts of one tool stay where they are. */
CASE(shrinking_opens_no_gap_between_joined_parts) {
  const profile flat = {{{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}}, 4};
  const profile shank = {{{0, 2, 0}, {2, 2, 0}, {2, 6, 0}, {0, 6, 0}}, 4};
  sepax__stock_shape part[2][2];
  assert_works(sepax__stock_shape_make(flat.corner, 4, 1, &part[0][0], &part[0][1], &fault));
  assert_works(sepax__stock_shape_make(shank.corner, 4, 1, &part[1][0], &part[1][1], &fault));
  sepax__stock_shape both[2] = {part[0][1], part[1][1]};
  sepax__stock *s =
      full_stock(SEPAX__STOCK_OUTER, (const double[2][3]){{0, 0, 0}, {1, 1, 0.1}}, 0.1);
  const sepax__stock_piece piece = {.at = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.5, 0.5, -1.95}}};
  sepax__stock_way way = {sepax__stock_straight, &piece};
  sepax__stock_touch found; /* the plate lies where flutes and shank meet */
  assert_works(sepax__stock_test(s, both, 2, &way, 0.9, 0, false, &found, &fault));
  assert_true(found.free);
  for (int k = 0; k < both[1].count; k++) {
    both[1].limit[k].joined = both[1].limit[k].b == -1;
  }
  assert_works(sepax__stock_test(s, both, 2, &way, 0.9, 0, false, &found, &fault));
  assert_false(found.free);
  sepax__stock_free(s);
}

CASE(questions_that_prove_nothing_are_refused) {
  tool t = make_tool(2, 0.01);
  move m = draw_move(false, 0);
  sepax__stock *outer = full_stock(SEPAX__STOCK_OUTER, box, 1);
  sepax__stock *inner = full_stock(SEPAX__STOCK_INNER, box, 1);
  sepax__stock_touch found;
  bool hit;
  double at[3];
  double half = t.shape[1].radius / 2;
  assert_fault(sepax__stock_test(outer, &t.shape[1], 1, WAY(&m), half, 0, false, &found, &fault),
               "below half of the radius");
  assert_false(found.free);
  assert_fault(sepax__stock_test(outer, &t.shape[1], 1, WAY(&m), -1, 0, false, &found, &fault),
               "below half of the radius");
  assert_fault(sepax__stock_test(outer, &t.shape[1], 1, WAY(&m), 0, NAN, false, &found, &fault),
               "tolerance");
  assert_fault(sepax__stock_test(inner, &t.shape[1], 1, WAY(&m), 0, 0, false, &found, &fault),
               "outer bound");
  assert_false(found.free);
  assert_fault(sepax__stock_hit(outer, &t.shape[0], 1, WAY(&m), 0, &hit, at, &fault),
               "inner bound");
  m.from.tip[0] = NAN;
  assert_false(sepax__stock_test(outer, &t.shape[1], 1, WAY(&m), 0, 0, false, &found, &fault));
  assert_false(found.free);
  sepax__stock_free(outer);
  sepax__stock_free(inner);
}

/* A plate of 0.05 mm, narrower than a cell, is seen by whatever goes through it. */
CASE(a_thin_wall_is_seen) {
  for (int n = 0; n < 7; n++) {
    double cell = 0.1 + 0.15 * n;
    const double wall[2][3] = {{-3, 0.4, -3}, {3, 0.45, 3}};
    sepax__stock *s;
    assert_works(sepax__stock_new(&s, SEPAX__STOCK_OUTER, box, cell, &fault));
    assert_works(sepax__stock_fill_box(s, wall, &fault));
    tool t = make_tool(2, 0.01);
    move m = {.from = {.tip = {0, -3.5, 0}}, .to = {.tip = {0.3, 3.5, 0}}};
    assert_false(touch(s, &t.shape[1], &m, t.shape[1].radius * 0.499, 0, false).free);
    sepax__stock_free(s);
  }
}
