/* SPDX-License-Identifier: MIT */
/* fill.c - first stocks: boxes, shapes and meshes, against points of them. */
#include "unit/stock/grids.h"

static const double box[2][3] = {{-3, -3, -3}, {3, 3, 3}};

static sepax__stock *empty_stock(sepax__stock_bound bound, double cell) {
  sepax__stock *s;
  assert_works(sepax__stock_new(&s, bound, box, cell, &fault));
  return s;
}

CASE(boxes_fill_whole_cells) {
  for (int n = 0; n < 200; n++) {
    sepax__stock_bound bound = n % 2 == 0 ? SEPAX__STOCK_OUTER : SEPAX__STOCK_INNER;
    double cell = 0.2 + 0.5 * fabs(random_unit());
    sepax__stock *s = empty_stock(bound, cell);
    double part[2][3];
    bool aligned = n % 3 == 0;
    for (int i = 0; i < 3; i++) {
      double low = 3 * random_unit();
      part[0][i] = aligned ? -3 + cell * random_below(4) : low;
      part[1][i] = part[0][i] + (aligned ? cell * (1 + random_below(4)) : fabs(2 * random_unit()));
    }
    assert_works(sepax__stock_fill_box(s, part, &fault));
    sepax__stock_facts f = sepax__stock_look(s);
    uint64_t cells = 0;
    for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
      double p[2][3];
      bool inside = true;
      bool meets = true;
      cell_point(&f, at, (const double[]){0, 0, 0}, p[0]);
      cell_point(&f, at, (const double[]){1, 1, 1}, p[1]);
      for (int i = 0; i < 3; i++) {
        double spare = 0x1p-19 * cell;
        inside = inside && p[0][i] > part[0][i] - spare && p[1][i] < part[1][i] + spare;
        meets = meets && p[1][i] > part[0][i] + spare && p[0][i] < part[1][i] - spare;
      }
      bool has = has_cell(s, &f, at);
      cells += has;
      assert_true(has == (bound == SEPAX__STOCK_OUTER ? meets : inside));
    }
    assert_true(cells == f.cells);
    sepax__stock_free(s);
  }
}

/* Points of a shape are in the outer bound; cells of the inner bound have their corners in it. */
static void check_shape(int kind, double cell) {
  tool t = make_tool(kind, 0.01);
  sepax_pose pose = turned_and_moved(1);
  const double still[3] = {0, 0, 0};
  sepax__stock *outer = empty_stock(SEPAX__STOCK_OUTER, cell);
  sepax__stock *inner = empty_stock(SEPAX__STOCK_INNER, cell);
  assert_works(sepax__stock_fill_shape(outer, &t.shape[1], &pose, &fault));
  assert_works(sepax__stock_fill_shape(inner, &t.shape[0], &pose, &fault));
  sepax__stock_facts f = sepax__stock_look(outer);
  for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
    double p[3];
    int in = 0;
    for (int n = 0; n < 8; n++) {
      cell_point(&f, at, (const double[]){n & 1, n >> 1 & 1, n >> 2}, p);
      in += beyond_posed(&t.solid, &pose, still, 0, p) <= 0;
    }
    cell_point(&f, at, (const double[]){0.5, 0.5, 0.5}, p);
    long double middle = beyond_posed(&t.solid, &pose, still, 0, p);
    assert_true(has_cell(outer, &f, at) || in == 0);
    assert_true(!has_cell(inner, &f, at) || in == 8);
    assert_true(has_cell(inner, &f, at) || in < 8 || middle > -cell - 0.01);
    assert_true(!has_cell(outer, &f, at) || middle < 1.5 * cell + 0.02);
  }
  sepax__stock_free(outer);
  sepax__stock_free(inner);
}

CASE(shapes_fill_what_they_touch_or_hold) {
  for (int n = 0; n < 16; n += STEP) {
    check_shape(n, 0.1 + 0.02 * n);
  }
}

/* ------------------------------------------------------------------ meshes */

static void add_quad(sepax_soup *m, double v[4][3]) {
  const int corner[6] = {0, 1, 2, 0, 2, 3};
  for (int k = 0; k < 6; k++) {
    memcpy(m->facet[m->count + (size_t)k / 3].v[k % 3], v[corner[k]], 3 * sizeof(double));
  }
  m->count += 2;
}

/* A turned box around the middle of the grid; turned inside out if `sign` is -1. */
static void add_turned_box(sepax_soup *m, const sepax_pose *pose, const double half[3], int sign) {
  m->facet = sepax_resize(m->facet, (m->count + 12) * sizeof *m->facet);
  assert_non_null(m->facet);
  for (int side = 0; side < 6; side++) {
    int axis = side / 2;
    int out = side % 2 == 0 ? 1 : -1;
    double v[4][3];
    for (int k = 0; k < 4; k++) {
      double u[3];
      u[axis] = out * half[axis];
      u[(axis + 1) % 3] = (k == 1 || k == 2 ? 1 : -1) * half[(axis + 1) % 3];
      u[(axis + 2) % 3] = (k >= 2 ? 1 : -1) * out * sign * half[(axis + 2) % 3];
      sepax_pose_apply(pose, u, v[k]);
    }
    add_quad(m, v);
  }
}

static bool in_box(const sepax_pose *pose, const double half[3], const double p[3], double more) {
  bool in = true;
  for (int i = 0; i < 3; i++) {
    double q = 0;
    for (int j = 0; j < 3; j++) {
      q += pose->rotation[j][i] * (p[j] - pose->translation[j]);
    }
    in = in && fabs(q) <= half[i] + more;
  }
  return in;
}

/* A turned box with a turned cavity; the grid may end within it. */
CASE(meshes_fill_what_they_touch_or_hold) {
  for (int n = 0; n < 16; n += STEP) {
    double cell = 0.2 + 0.01 * n;
    sepax__stock *s[2] = {empty_stock(SEPAX__STOCK_OUTER, cell),
                          empty_stock(SEPAX__STOCK_INNER, cell)};
    sepax_soup mesh = {0};
    sepax_pose pose = turned_and_moved(n % 4 == 3 ? 2 : 0.3);
    if (n % 8 == 0) {
      pose = (sepax_pose){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    }
    const double half[2][3] = {{1.4, 1.2, 1.6}, {0.6, 0.5, 0.55}};
    int sign = n % 3 == 0 ? -1 : 1;
    add_turned_box(&mesh, &pose, half[0], sign);
    add_turned_box(&mesh, &pose, half[1], -sign);
    assert_works(sepax__stock_fill_mesh(s[0], &mesh, NULL, &fault));
    assert_works(sepax__stock_fill_mesh(s[1], &mesh, NULL, &fault));
    sepax__stock_facts f = sepax__stock_look(s[0]);
    for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
      int in = 0;
      for (int k = 0; k < 28; k++) {
        const double part[3] = {k % 3 / 2.0, k / 3 % 3 / 2.0, k / 9 % 3 / 2.0};
        double p[3];
        cell_point(&f, at, part, p);
        in += k < 27 && in_box(&pose, half[0], p, 0) && !in_box(&pose, half[1], p, 0);
      }
      double p[3];
      cell_point(&f, at, (const double[]){0.5, 0.5, 0.5}, p);
      assert_true(has_cell(s[0], &f, at) || in == 0);
      assert_true(!has_cell(s[1], &f, at) || in == 27);
      double more = sqrt(3) / 2 * cell * 1.001;
      assert_true(!has_cell(s[0], &f, at) ||
                  (in_box(&pose, half[0], p, more) && !in_box(&pose, half[1], p, -more)));
      assert_true(has_cell(s[1], &f, at) || !in_box(&pose, half[0], p, -more) ||
                  in_box(&pose, half[1], p, more));
    }
    sepax_soup_free(&mesh);
    sepax__stock_free(s[0]);
    sepax__stock_free(s[1]);
  }
}

CASE(open_meshes_are_refused) {
  const sepax_pose pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.1, 0.2, 0.3}};
  sepax__stock *s = empty_stock(SEPAX__STOCK_OUTER, 0.3);
  sepax_soup mesh = {0};
  add_turned_box(&mesh, &pose, (const double[]){1, 1, 1}, 1);
  mesh.count--;
  assert_fault(sepax__stock_fill_mesh(s, &mesh, NULL, &fault), "it is open");
  mesh.count++;
  mesh.facet[0].v[1][2] = NAN;
  assert_fault(sepax__stock_fill_mesh(s, &mesh, NULL, &fault), "triangle 0");
  sepax_soup_free(&mesh);
  sepax__stock_free(s);
}

CASE(stocks_of_no_size_are_refused) {
  sepax__stock *s;
  assert_fault(sepax__stock_new(&s, SEPAX__STOCK_OUTER, box, 0, &fault), "above 0");
  assert_fault(sepax__stock_new(&s, SEPAX__STOCK_OUTER, box, NAN, &fault), "above 0");
  assert_fault(sepax__stock_new(&s, SEPAX__STOCK_OUTER, box, 1e-5, &fault), "too small");
  assert_fault(sepax__stock_new(&s, SEPAX__STOCK_OUTER,
                                (const double[2][3]){{1e9, 0, 0}, {1e9 + 1, 1, 1}}, 0.1, &fault),
               "too small");
  assert_fault(sepax__stock_new(&s, SEPAX__STOCK_OUTER, (const double[2][3]){{0, 0, 0}, {1, 0, 1}},
                                0.1, &fault),
               "volume");
  assert_null(s);
}
