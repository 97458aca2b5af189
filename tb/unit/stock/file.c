/* SPDX-License-Identifier: MIT */
/* file.c - stocks in files, and their surface. */
#include "unit/stock/grids.h"

#include <unistd.h>

static const double box[2][3] = {{-4, -3, -2}, {4, 3, 2.5}};

static sepax__stock *draw_cells(int n, double cell) {
  sepax__stock *s = full_stock(n % 2 == 0 ? SEPAX__STOCK_OUTER : SEPAX__STOCK_INNER, box, cell);
  for (int k = 0; k < 3; k++) {
    tool t = make_tool(n + k, 0.01);
    move m = draw_move(k == 0, reach_of(&t));
    assert_works(sepax__stock_cut(s, &t.shape[n % 2], 1, WAY(&m), 0, &fault));
  }
  return s;
}

static sepax__stock *draw_stock(int n) { return draw_cells(n, 0.21); }

static uint8_t *read_bytes(size_t *count) {
  FILE *in = fopen(path, "rb");
  assert_non_null(in);
  uint8_t *bytes = malloc(1 << 20);
  assert_non_null(bytes);
  *count = fread(bytes, 1, 1 << 20, in);
  fclose(in);
  return bytes;
}

static void write_bytes(const uint8_t *bytes, size_t count) {
  FILE *out = fopen(path, "wb");
  assert_non_null(out);
  assert_true(fwrite(bytes, 1, count, out) == count);
  assert_true(fclose(out) == 0);
}

CASE(a_stock_comes_back) {
  for (int n = 0; n < 6; n++) {
    sepax__stock *s = draw_stock(n);
    sepax__stock *back;
    assert_works(sepax__stock_write(s, path, &fault));
    assert_works(sepax__stock_read(&back, path, &fault));
    sepax__stock_facts f = sepax__stock_look(s);
    sepax__stock_facts g = sepax__stock_look(back);
    assert_true(f.bound == g.bound && f.cell == g.cell && f.cells == g.cells && f.cells > 0);
    assert_memory_equal(f.box, g.box, sizeof f.box);
    for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
      assert_true(has_cell(s, &f, at) == has_cell(back, &g, at));
    }
    /* and goes on as the first one */
    tool t = make_tool(n + 3, 0.01);
    move m = draw_move(true, reach_of(&t));
    assert_works(sepax__stock_cut(s, &t.shape[n % 2], 1, WAY(&m), 0, &fault));
    assert_works(sepax__stock_cut(back, &t.shape[n % 2], 1, WAY(&m), 0, &fault));
    assert_true(sepax__stock_look(s).cells == sepax__stock_look(back).cells);
    sepax__stock_free(s);
    sepax__stock_free(back);
  }
}

/* The head as the document says, byte by byte. */
CASE(the_format_is_the_documented_one) {
  const double part[2][3] = {{0, 0, 0}, {0.5, 0.5, 0.5}};
  sepax__stock *s;
  assert_works(sepax__stock_new(&s, SEPAX__STOCK_INNER, (const double[2][3]){{0, 0, 0}, {8, 4, 4}},
                                0.5, &fault));
  assert_works(sepax__stock_fill_box(s, part, &fault));
  assert_works(sepax__stock_write(s, path, &fault));
  size_t count;
  uint8_t *bytes = read_bytes(&count);
  uint8_t head[72 + 1 + 64 + 1] = "sepaxSTK\1\0\0\0\1\0\0\0\0\0\0\0\0\0\xe0\x3f";
  head[48] = 2;
  head[56] = head[64] = 1;
  head[72] = 2; /* the first brick has one cell, the second none */
  head[73] = 1;
  assert_true(count == sizeof head + 8);
  assert_memory_equal(bytes, head, sizeof head);
  free(bytes);
  sepax__stock_free(s);
}

static void refuse(const uint8_t *bytes, size_t count, const char *why) {
  sepax__stock *s;
  write_bytes(bytes, count);
  assert_fault(sepax__stock_read(&s, path, &fault), why);
  assert_non_null(strstr(fault.text, path));
  assert_null(s);
}

CASE(files_that_are_no_stock_are_refused) {
  sepax__stock *s = draw_stock(0);
  size_t count;
  assert_works(sepax__stock_write(s, path, &fault));
  sepax__stock_free(s);
  uint8_t *bytes = read_bytes(&count);
  for (size_t n = 0; n < count; n += n < 80 || n + 80 > count ? 1 : 97) {
    refuse(bytes, n, "truncated");
  }
  bytes[count] = 0;
  refuse(bytes, count + 1, "after its end");
  for (size_t n = 0; n < count; n += n < 80 || n + 80 > count ? 1 : 97) {
    bytes[n] ^= 0x40;
    refuse(bytes, count, "");
    bytes[n] ^= 0x40;
  }
  bytes[8] = 2;
  refuse(bytes, count, "version 2");
  bytes[8] = 1;
  bytes[12] = 2;
  refuse(bytes, count, "impossible size");
  bytes[12] = 0;
  bytes[55] = 0x7f;
  refuse(bytes, count, "impossible size");
  bytes[55] = 0;
  bytes[48] = 0;
  refuse(bytes, count, "impossible size");
  free(bytes);
  unlink(path);
  assert_fault(sepax__stock_read(&s, path, &fault), path);
}

/* ----------------------------------------------------------------- surface */

/* Six times the volume that the triangles enclose. */
static double six_volumes(const sepax_soup *m) {
  double sum = 0;
  for (size_t n = 0; n < m->count; n++) {
    const double(*v)[3] = m->facet[n].v;
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      sum += v[0][i] * (v[1][j] * v[2][k] - v[1][k] * v[2][j]);
    }
  }
  return sum;
}

CASE(the_surface_is_closed_and_holds_the_cells) {
  for (int n = 0; n < 6; n++) {
    sepax__stock *s = draw_stock(n);
    sepax__stock_facts f = sepax__stock_look(s);
    sepax_soup m;
    assert_works(sepax__stock_mesh(s, 1000000, &m, &fault));
    sepax_body *body;
    sepax_shell shell;
    assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&m), NULL, &fault));
    assert_works(sepax_shell_find(&shell, body, &fault));
    assert_true(shell.closed && shell.consistent);
    double volume = (double)f.cells * f.cell * f.cell * f.cell;
    assert_true(fabs(six_volumes(&m) / 6 - volume) < 1e-9 * volume);
    assert_fault(sepax__stock_mesh(s, m.count - 1, &(sepax_soup){0}, &fault), "larger cells");
    sepax_shell_free(&shell);
    sepax_body_free(body);
    /* filled with its own surface a stock is the same, and what is next to it in an outer bound */
    sepax__stock *again;
    assert_works(sepax__stock_new(&again, SEPAX__STOCK_OUTER, box, 0.21, &fault));
    assert_works(sepax__stock_fill_mesh(again, &m, NULL, &fault));
    for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
      assert_true(!has_cell(s, &f, at) || has_cell(again, &f, at));
    }
    sepax__stock_free(again);
    sepax_soup_free(&m);
    sepax__stock_free(s);
  }
}

/* The area of the faces between cells that are there and others, by direction: the cells' own, and
 * that of the triangles, which are all in planes across an axis. */
static void measure_cells(const sepax__stock *s, double area[6]) {
  sepax__stock_facts f = sepax__stock_look(s);
  for (int at[3] = {0, 0, 0}; is_cell(&f, at); next_cell(&f, at)) {
    for (int side = 0; side < 6 && has_cell(s, &f, at); side++) {
      int beside[3] = {at[0], at[1], at[2]};
      beside[side / 2] += side % 2 == 0 ? 1 : -1;
      bool in = beside[side / 2] >= 0 && beside[side / 2] < cells_along(&f, side / 2);
      area[side] += !in || !has_cell(s, &f, beside) ? f.cell * f.cell : 0;
    }
  }
}

static void measure_triangles(const sepax_soup *m, double area[6]) {
  for (size_t n = 0; n < m->count; n++) {
    const double(*v)[3] = m->facet[n].v;
    int across = -1;
    for (int i = 0; i < 3; i++) {
      across = v[0][i] == v[1][i] && v[0][i] == v[2][i] ? i : across;
    }
    assert_true(across >= 0);
    int j = (across + 1) % 3;
    int k = (across + 2) % 3;
    double twice =
        (v[1][j] - v[0][j]) * (v[2][k] - v[0][k]) - (v[1][k] - v[0][k]) * (v[2][j] - v[0][j]);
    area[2 * across + (twice < 0)] += fabs(twice) / 2;
  }
}

/* With cells of 0.1 rows have more than 64 faces. Flat faces take few triangles: at most a third of
 * two for each face of a cell. */
CASE(rectangles_cover_the_faces_of_each_direction) {
  for (int n = 0; n < 6; n++) {
    sepax__stock *s = draw_cells(n, n < 3 ? 0.21 : 0.1);
    sepax_soup m;
    double area[2][6] = {{0}, {0}};
    double all = 0;
    assert_works(sepax__stock_mesh(s, 1000000, &m, &fault));
    measure_cells(s, area[0]);
    measure_triangles(&m, area[1]);
    for (int side = 0; side < 6; side++) {
      assert_true(fabs(area[0][side] - area[1][side]) < 1e-9 * area[0][side]);
      all += area[0][side];
    }
    double cell = sepax__stock_look(s).cell;
    assert_true((double)m.count < 2 * all / (cell * cell) / 3);
    sepax_soup_free(&m);
    sepax__stock_free(s);
  }
  sepax__stock *s = full_stock(SEPAX__STOCK_OUTER, box, 0.1);
  sepax_soup m;
  assert_works(sepax__stock_mesh(s, 12, &m, &fault));
  assert_int_equal(m.count, 12);
  sepax_soup_free(&m);
  sepax__stock_free(s);
}

CASE(no_cells_have_no_surface) {
  sepax__stock *s;
  sepax_soup m;
  assert_works(sepax__stock_new(&s, SEPAX__STOCK_OUTER, box, 0.5, &fault));
  assert_works(sepax__stock_mesh(s, 0, &m, &fault));
  assert_true(m.count == 0 && m.facet == NULL);
  sepax__stock_free(s);
}
