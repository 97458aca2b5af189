/* SPDX-License-Identifier: MIT */
/* cut.c - which cells go? Against the solid at many stands of the true motion. */
#include "unit/stock/grids.h"

static double box[2][3] = {{-4, -4, -4}, {4, 4, 4}};

/* Every corner of a cell that goes was cut; a cell that stays has a point that is not deep in it.
 */
static void check_outer(const tool *t, const move *m, double tolerance, double cell) {
  sepax__stock *before = full_stock(SEPAX__STOCK_OUTER, box, cell);
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, cell);
  assert_works(sepax__stock_cut(s, &t->shape[0], 1, WAY(m), tolerance, &fault));
  sepax__stock_facts f = sepax__stock_look(s);
  for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
    double p[3];
    if (!has_cell(before, &f, at) || !is_border(s, &f, at)) {
      continue;
    }
    if (has_cell(s, &f, at)) {
      cell_point(&f, at, (const double[]){0.5, 0.5, 0.5}, p);
      double most = sqrt(3) / 2 * cell + cell / 8 + tolerance + 0.002 + cell / 64;
      assert_true(beyond_move(&t->solid, m, p, -most) > -most);
      continue;
    }
    for (int n = 0; n < 8; n++) {
      cell_point(&f, at, (const double[]){n & 1, n >> 1 & 1, n >> 2}, p);
      assert_true(beyond_move(&t->solid, m, p, -tolerance) <= 1e-9 - tolerance);
    }
  }
  sepax__stock_free(before);
  sepax__stock_free(s);
}

/* Every cell of which a point was cut goes. */
static void check_inner(const tool *t, const move *m, double tolerance, double cell) {
  sepax__stock *before = full_stock(SEPAX__STOCK_INNER, box, cell);
  sepax__stock *s = full_stock(SEPAX__STOCK_INNER, box, cell);
  assert_works(sepax__stock_cut(s, &t->shape[1], 1, WAY(m), tolerance, &fault));
  sepax__stock_facts f = sepax__stock_look(s);
  for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
    double p[3];
    if (!has_cell(before, &f, at) || !is_border(s, &f, at)) {
      continue;
    }
    if (has_cell(s, &f, at)) {
      for (int n = 0; n < 9; n++) {
        const double corner[3] = {n & 1, n >> 1 & 1, n >> 2 & 1};
        cell_point(&f, at, n < 8 ? corner : (const double[]){0.5, 0.5, 0.5}, p);
        assert_true(beyond_move(&t->solid, m, p, tolerance - 1e-9) >= tolerance - 1e-9);
      }
      continue;
    }
    cell_point(&f, at, (const double[]){0.5, 0.5, 0.5}, p);
    double most = 1.5 * (sqrt(3) / 2 * cell + cell / 8 + tolerance + 0.006);
    assert_true(beyond_move(&t->solid, m, p, most) <= most);
  }
  sepax__stock_free(before);
  sepax__stock_free(s);
}

CASE(straight_cuts_take_what_the_cutter_takes) {
  for (int n = 0; n < 8; n += STEP) {
    tool t = make_tool(n, 0.002);
    move m = draw_move(false, 0);
    check_outer(&t, &m, n % 2 * 0.03, 0.4);
    check_inner(&t, &m, n % 2 * 0.03, 0.4);
  }
}

/* Ways that turn so much in a cell that their deviation matters. */
CASE(turning_cuts_take_what_the_cutter_takes) {
  for (int n = 0; n < 12; n += STEP) {
    tool t = make_tool(n, 0.002);
    move m = draw_move(true, reach_of(&t));
    check_outer(&t, &m, n % 3 * 0.02, 0.5);
    check_inner(&t, &m, n % 3 * 0.02, 0.5);
  }
}

/* Cells so small that whole bricks go at once. */
CASE(bricks_that_go_at_once_were_cut) {
  memcpy(box, (const double[2][3]){{-1.2, -1.2, -1.2}, {1.2, 1.2, 1.2}}, sizeof box);
  for (int n = 0; n < 24; n += STEP) {
    tool t = make_tool(n, 0.002);
    move m = draw_move(n % 2 == 1, reach_of(&t));
    for (int i = 0; i < 3; i++) {
      m.to.tip[i] = m.from.tip[i] + (m.to.tip[i] - m.from.tip[i]) / 8;
    }
    check_outer(&t, &m, 0, 0.1);
    check_inner(&t, &m, 0, 0.15);
  }
  memcpy(box, (const double[2][3]){{-4, -4, -4}, {4, 4, 4}}, sizeof box);
}

/* Only a way that says nothing of itself but its deviation: it falls no more and is taken off. */
static void vague_piece(const void *context, double from, double to, sepax__stock_piece *piece) {
  sepax__stock_straight(context, from, to, piece);
  piece->deviation = 0.3;
}

CASE(deviation_that_does_not_fall_comes_off_the_cutter) {
  const sepax_pose upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-2, 0, 0}};
  const sepax__stock_piece whole = {.at = upright, .way = {4, 0, 0}};
  const profile flat = {{{0, 0, 0}, {1.3, 0, 0}, {1.3, 6, 0}, {0, 6, 0}}, 4};
  sepax__stock_shape shape[2];
  assert_works(sepax__stock_shape_make(flat.corner, 4, 1, &shape[0], &shape[1], &fault));
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 0.25);
  sepax__stock_way way = {vague_piece, &whole};
  assert_works(sepax__stock_cut(s, &shape[0], 1, &way, 0, &fault));
  assert_true(sepax__stock_has(s, (const double[]){0, 0, 0.26}));  /* 0.3 above the floor: 0.25 */
  assert_false(sepax__stock_has(s, (const double[]){0, 0, 0.51})); /* ... 0.5 */
  assert_false(sepax__stock_has(s, (const double[]){0, 0.74, 1})); /* to 1.0 of the side: 0.75 */
  assert_true(sepax__stock_has(s, (const double[]){0, 0.76, 1}));
  sepax__stock_free(s);
}

/* An exact case: a slot as wide as a whole number of cells, on their faces. */
CASE(a_cut_along_faces_leaves_nothing_and_takes_no_more) {
  const profile flat = {{{0, 0, 0}, {1, 0, 0}, {1, 6, 0}, {0, 6, 0}}, 4};
  sepax__stock_shape shape[2];
  assert_works(sepax__stock_shape_make(flat.corner, 4, 1, &shape[0], &shape[1], &fault));
  const sepax_pose upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {-6, 0, 1}};
  const sepax__stock_piece piece = {.at = upright, .way = {12, 0, 0}};
  sepax__stock_way way = {sepax__stock_straight, &piece};
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 0.26); /* off the faces */
  uint64_t before = sepax__stock_look(s).cells;
  assert_works(sepax__stock_cut(s, &shape[0], 1, &way, 0, &fault));
  sepax__stock_facts f = sepax__stock_look(s);
  assert_true(before - f.cells > 0);
  for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
    double p[2][3];
    bool in = true;
    cell_point(&f, at, (const double[]){0, 0, 0}, p[0]);
    cell_point(&f, at, (const double[]){1, 1, 1}, p[1]);
    in = p[0][1] >= -1 && p[1][1] <= 1 && p[0][2] >= 1;
    bool first = p[1][0] <= 4.2 && p[1][1] <= 4.2 && p[1][2] <= 4.2; /* was there */
    assert_true(!first || has_cell(s, &f, at) == !in);
  }
  sepax__stock_free(s);
}

CASE(cuts_that_are_no_numbers_are_refused) {
  tool t = make_tool(0, 0.01);
  move m = draw_move(false, 0);
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 1);
  assert_fault(sepax__stock_cut(s, &t.shape[0], 1, WAY(&m), -1, &fault), "tolerance");
  assert_fault(sepax__stock_cut(s, &t.shape[0], 1, WAY(&m), NAN, &fault), "tolerance");
  m.from.tip[0] = INFINITY;
  assert_false(sepax__stock_cut(s, &t.shape[0], 1, WAY(&m), 0, &fault));
  sepax__stock_free(s);
}
