/* SPDX-License-Identifier: MIT */
/* scarcity.c - the stock without memory: each allocation refused in turn. */
#include "unit/memory/scarce.h"
#include "unit/stock/grids.h"

typedef struct {
  tool cutter;
  move way;
  sepax_soup surface;
} job;

/* A stock from a mesh, cut, written and read again, and its surface. */
static bool work_stock(void *context) {
  job *j = context;
  const double box[2][3] = {{-2, -2, -2}, {2, 2, 2}};
  const double more[2][3] = {{-1.95, -1.95, -1.95}, {-1.7, 1, 1}};
  sepax__stock *s[2] = {NULL, NULL};
  sepax_soup surface = {0};
  bool works = sepax__stock_new(&s[0], SEPAX__STOCK_OUTER, box, 0.2, &fault) &&
               sepax__stock_fill_mesh(s[0], &j->surface, NULL, &fault) &&
               sepax__stock_fill_box(s[0], more, &fault) &&
               sepax__stock_fill_shape(s[0], &j->cutter.shape[1],
                                       &(sepax_pose){.rotation = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
                                       &fault) &&
               sepax__stock_cut(s[0], &j->cutter.shape[0], 1, WAY(&j->way), 0, &fault) &&
               sepax__stock_write(s[0], path, &fault) && sepax__stock_read(&s[1], path, &fault) &&
               sepax__stock_mesh(s[1], 1000000, &surface, &fault);
  assert_true(!works || surface.count > 0);
  sepax_soup_free(&surface);
  sepax__stock_free(s[0]);
  sepax__stock_free(s[1]);
  return works;
}

CASE(stocks) {
  const double box[2][3] = {{-2, -2, -2}, {2, 2, 2}};
  job j = {.cutter = make_tool(0, 0.05)};
  j.way = draw_move(true, reach_of(&j.cutter));
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 0.9);
  assert_works(sepax__stock_mesh(s, 100000, &j.surface, &fault));
  sepax__stock_free(s);
  assert_true(assert_scarce(work_stock, &j) > 12);
  sepax_soup_free(&j.surface);
}

static bool work_shapes(void *context) {
  sepax__stock_shapes shapes[2];
  const bool joined[2] = {false, false};
  bool works = sepax__stock_shapes_make(context, joined, 0.01, &shapes[0], &shapes[1], &fault);
  if (works) {
    assert_true(shapes[0].count == 2 && shapes[1].count == 2);
    sepax__stock_shapes_free(&shapes[0]);
    sepax__stock_shapes_free(&shapes[1]);
  }
  return works;
}

CASE(shapes_of_profiles) {
  turned_point point[5] = {{0, 0, 0}, {1, 1, 1}, {2, 1, 0}, {2, 3, 0}, {4, 3, 0}};
  turned_profile turned_tool = {point, 5};
  assert_true(assert_scarce(work_shapes, &turned_tool) > 3);
}
