/* SPDX-License-Identifier: MIT */
/* weld.c - torn, doubled and shaken meshes, welded. */
#include "harness.h"
#include "unit/body/solid_meshes.h"

#include <math.h>
#include <time.h>

static const double lowest[3] = {-3, -1, 2};
static const double highest[3] = {1, 7, 4};

static bool is_closed(const sepax_soup *m, bool *consistent) {
  sepax_body *body;
  sepax_shell shell;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(m), NULL, &fault));
  assert_works(sepax_shell_find(&shell, body, &fault));
  bool closed = shell.closed;
  *consistent = shell.consistent;
  sepax_shell_free(&shell);
  sepax_body_free(body);
  return closed;
}

static sepax_soup copy_of(const sepax_soup *m) {
  sepax_soup c = {.facet = malloc(m->count * sizeof *m->facet), .count = m->count};
  assert_non_null(c.facet);
  memcpy(c.facet, m->facet, m->count * sizeof *m->facet);
  return c;
}

/* ------------------------------------------------------------ sets of triangles */

static int compare_points(const void *p, const void *q) {
  const double *a = p;
  const double *b = q;
  for (int i = 0; i < 3; i++) {
    if (a[i] < b[i] || a[i] > b[i]) {
      return a[i] < b[i] ? -1 : 1;
    }
  }
  return 0;
}

static int compare_facets(const void *p, const void *q) {
  const sepax_facet *a = p;
  const sepax_facet *b = q;
  for (int k = 0; k < 3; k++) {
    int order = compare_points(a->v[k], b->v[k]);
    if (order != 0) {
      return order;
    }
  }
  return 0;
}

/* The corners of each triangle in their order, then the triangles. */
static void sort_soup(sepax_soup *m) {
  for (size_t n = 0; n < m->count; n++) {
    qsort(m->facet[n].v, 3, sizeof m->facet[n].v[0], compare_points);
  }
  qsort(m->facet, m->count, sizeof *m->facet, compare_facets);
}

static void shuffle(sepax_soup *m) {
  for (size_t n = m->count; n > 0; n--) {
    size_t k = (size_t)random_below((int)n);
    sepax_facet one = m->facet[n - 1];
    m->facet[n - 1] = m->facet[k];
    m->facet[k] = one;
    for (int turns = random_below(3); turns > 0; turns--) {
      sepax_facet f = m->facet[n - 1];
      for (int i = 0; i < 3; i++) {
        memcpy(m->facet[n - 1].v[i], f.v[(i + 1) % 3], sizeof f.v[0]);
      }
    }
    if (random_below(2) != 0) {
      turn_round(&m->facet[n - 1]);
    }
  }
}

/* --------------------------------------------------------------------- what is wrong */

static void shake(sepax_soup *m, double by) {
  for (size_t n = 0; n < 9 * m->count; n++) {
    m->facet[n / 9].v[n / 3 % 3][n % 3] += by * random_unit();
  }
}

static void draw(sepax_soup *m, bool tears) {
  const double c[3] = {9, 9, 9};
  add_cells(m, lowest, highest, 1 + random_below(2));
  if (random_below(2) != 0) {
    add_octahedron(m, c, 2);
  }
  for (int n = random_below(8); n > 0 && tears; n--) {
    tear_edge(m);
  }
}

/* --------------------------------------------------------------------------- cases */

CASE(torn_boxes_close) {
  for (int n = 0; n < FEWER(2000); n++) {
    sepax_soup m = {0};
    sepax_weld said;
    bool consistent;
    double by = ldexp(1, -10 - n % 30);
    draw(&m, true);
    size_t count = m.count;
    shake(&m, by);
    assert_false(is_closed(&m, &consistent));
    assert_works(sepax_soup_weld(&m, 8 * by, &said, &fault));
    assert_true(is_closed(&m, &consistent));
    assert_true(consistent);
    assert_true(m.count >= count && said.moved > 0 && said.farthest <= 4 * by);
    assert_int_equal(said.degenerate, 0);
    assert_true(m.count >= count + said.divided);
    /* Nothing is left to do. */
    sepax_soup again = copy_of(&m);
    assert_works(sepax_soup_weld(&again, 4 * by, &said, &fault));
    assert_int_equal(said.moved + said.degenerate + said.duplicates + said.divided, 0);
    assert_int_equal(again.count, m.count);
    sepax_soup_free(&m);
    sepax_soup_free(&again);
  }
}

CASE(any_order) {
  for (int n = 0; n < FEWER(2000); n++) {
    sepax_soup m = {0};
    sepax_weld said[2];
    draw(&m, true);
    for (int more = random_below(4); more > 0; more--) {
      const double(*v)[3] = m.facet[random_below((int)m.count)].v;
      double p[3][3];
      memcpy(p, v, sizeof p);
      add_triangle(&m, p[0], p[1], p[2]);
    }
    if (random_below(2) != 0) {
      add_segment(&m);
    }
    shake(&m, 0.01);
    double length = 0.02 * (1 + random_below(6));
    sepax_soup other = copy_of(&m);
    shuffle(&other);
    bool ok = sepax_soup_weld(&m, length, &said[0], &fault);
    assert_int_equal(sepax_soup_weld(&other, length, &said[1], &fault), ok);
    sort_soup(&m);
    sort_soup(&other);
    assert_int_equal(m.count, other.count);
    if (ok) {
      assert_memory_equal(m.facet, other.facet, m.count * sizeof *m.facet);
    }
    assert_memory_equal(&said[0], &said[1], sizeof said[0]);
    sepax_soup_free(&m);
    sepax_soup_free(&other);
  }
}

/* Copies: of one facet, of all, three, in both senses; two sheets that lie on each other stay. */
CASE(copies) {
  sepax_weld said;
  bool consistent;
  for (int kind = 0; kind < 4; kind++) {
    sepax_soup m = {0};
    add_cells(&m, lowest, highest, 2);
    size_t count = m.count;
    for (size_t n = 0; n < (kind == 0 ? 1 : kind == 1 ? 5 : count); n++) {
      for (int k = 0; k < (kind == 3 ? 2 : 1); k++) {
        double p[3][3];
        memcpy(p, m.facet[n].v, sizeof p);
        add_triangle(&m, p[k], p[k + 1], p[(k + 2) % 3]);
      }
    }
    size_t more = m.count - count;
    assert_int_equal(is_closed(&m, &consistent), kind >= 2);
    assert_works(sepax_soup_weld(&m, 0, &said, &fault));
    assert_int_equal(m.count, count);
    assert_int_equal(said.duplicates, more);
    assert_true(is_closed(&m, &consistent) && consistent);
    sepax_soup_free(&m);
  }
  sepax_soup m = {0};
  const double p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  add_triangle(&m, p[0], p[1], p[2]);
  add_triangle(&m, p[2], p[1], p[0]);
  add_triangle(&m, p[1], p[2], p[3]);
  add_triangle(&m, p[3], p[2], p[1]);
  assert_works(sepax_soup_weld(&m, 0, &said, &fault));
  assert_int_equal(m.count, 4);
  assert_true(is_closed(&m, &consistent) && consistent);
  sepax_soup_free(&m);
}

/* Segments and points go where they are held, stay where they are alone. */
CASE(segments_and_points) {
  sepax_soup m = {0};
  sepax_weld said;
  const double away[2][3] = {{50, 0, 0}, {60, 0, 0}};
  add_cells(&m, lowest, highest, 1);
  size_t count = m.count;
  double p[3][3];
  memcpy(p, m.facet[3].v, sizeof p);
  add_triangle(&m, p[0], p[1], p[1]);
  add_triangle(&m, p[2], p[2], p[2]);
  add_triangle(&m, away[0], away[1], away[0]);
  add_triangle(&m, away[0], away[0], away[0]);
  assert_works(sepax_soup_weld(&m, 0, &said, &fault));
  assert_int_equal(said.degenerate, 2);
  assert_int_equal(m.count, count + 2);
  sepax_soup_free(&m);
}

CASE(refused) {
  sepax_soup m = {0};
  sepax_weld said;
  add_cells(&m, lowest, highest, 1);
  assert_fault(sepax_soup_weld(&m, -1, &said, &fault), "a weld length of");
  assert_fault(sepax_soup_weld(&m, NAN, &said, &fault), "a weld length of");
  assert_fault(sepax_soup_weld(&m, INFINITY, &said, &fault), "a weld length of");
  assert_fault(sepax_soup_weld(&m, 0.9, &said, &fault), "a mesh whose longest side is 8");
  assert_int_equal(m.count, 12);
  sepax_soup_free(&m);
  const double flat[3][3] = {{0, 0, 0}, {9, 0, 0}, {0, 0.5, 0}};
  add_triangle(&m, flat[0], flat[1], flat[2]);
  assert_fault(sepax_soup_weld(&m, 0.75, &said, &fault), "no triangle with an area is left");
  sepax_soup_free(&m);
  assert_fault(sepax_soup_weld(&m, 1, &said, &fault), "without triangles");
  for (int n = 0; n < 100; n++) { /* a strip of vertices, each near the next */
    const double p[3][3] = {{n, 0, 0}, {n + 1, 0, 0}, {n, 50, 0}};
    add_triangle(&m, p[0], p[1], p[2]);
  }
  assert_fault(sepax_soup_weld(&m, 1, &said, &fault), "shorter length");
  assert_int_equal(m.count, 100);
  assert_works(sepax_soup_weld(&m, 0.5, &said, &fault));
  sepax_soup_free(&m);
}

/* Coordinates and lengths at the ends of their range. */
CASE(extremes) {
  for (int e = -1060; e <= 990; e += 10) {
    sepax_soup m = {0};
    sepax_weld said;
    bool consistent;
    add_cells(&m, lowest, highest, 2);
    for (size_t n = 0; n < 9 * m.count; n++) {
      double *x = &m.facet[n / 9].v[n / 3 % 3][n % 3];
      *x = ldexp(*x, e);
    }
    m.facet[3].v[1][0] += ldexp(1, e - 6);
    assert_works(sepax_soup_weld(&m, ldexp(1, e - 5), &said, &fault));
    assert_int_equal(said.moved, 1);
    assert_true(is_closed(&m, &consistent) && consistent);
    assert_works(sepax_soup_weld(&m, ldexp(1, -1074), &said, &fault));
    assert_int_equal(said.moved, 0);
    sepax_soup_free(&m);
  }
}

/* A million triangles, each by itself, and as many vertices in one place. */
CASE(large) {
  enum { SIDE = 710 / FEWER_BY };
  sepax_soup m = {.count = (size_t)2 * SIDE * SIDE};
  m.facet = calloc(m.count, sizeof *m.facet);
  assert_non_null(m.facet);
  for (size_t n = 0; n < 3 * m.count; n++) {
    static const int corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
    const int *at = corner[n / 3 % 2][n % 3];
    double *v = m.facet[n / 3].v[n % 3];
    const size_t cell[2] = {n / 6 % SIDE, n / 6 / SIDE};
    v[0] = (double)cell[0] + at[0] + 1e-7 * random_unit();
    v[1] = (double)cell[1] + at[1] + 1e-7 * random_unit();
    v[2] = sin(v[0] / 10);
  }
  sepax_weld said;
  clock_t start = clock();
  assert_works(sepax_soup_weld(&m, 1e-6, &said, &fault));
  print_message("%zu triangles: %zu moved, %.2f s\n", m.count, said.moved,
                (double)(clock() - start) / CLOCKS_PER_SEC);
  assert_int_equal(said.divided, 0);
  for (size_t n = 0; n < 9 * m.count; n++) {
    m.facet[n / 9].v[n / 3 % 3][n % 3] = random_unit();
  }
  m.facet[0].v[0][0] = 30; /* so that the length is not too long for the box */
  start = clock();
  assert_fault(sepax_soup_weld(&m, 1, &said, &fault), "weld by a shorter length");
  print_message("in one place: refused in %.2f s\n", (double)(clock() - start) / CLOCKS_PER_SEC);
  sepax_soup_free(&m);
}
