/* SPDX-License-Identifier: MIT */
/* quantise.c - the quantiser and the fit of a grid. */
#include "harness.h"

#include <float.h>
#include <gmp.h>
#include <inttypes.h>
#include <math.h>
#include <string.h>

enum { RANDOM_VALUES = 200000 };

/* ------------------------------------------------------------------ quantiser */

/* A mesh of one facet: a point, and x in every coordinate. */
static sepax_facet facet_at(double x) {
  return (sepax_facet){.v = {{x, x, x}, {x, x, x}, {x, x, x}}};
}

static bool quantised(int32_t *q, double x, const sepax_grid *grid) {
  sepax_facet facet = facet_at(x);
  const sepax_soup mesh = {.facet = &facet, .count = 1};
  sepax_tri tri = {{{7, 7, 7}, {7, 7, 7}, {7, 7, 7}}};
  bool ok = sepax_quantise(SEPAX_SOUP_MESH(&mesh), grid, &tri, &fault);
  *q = tri.v[2].z;
  return ok;
}

static void assert_quantised(double x, double resolution, double offset, int word,
                             int32_t expected) {
  sepax_grid grid = {resolution, {offset, offset, offset}, word};
  int32_t q = 0;
  if (!quantised(&q, x, &grid) || q != expected) {
    fail_msg("(%a - %a) / %a: %" PRId32 ", not %" PRId32 "; %s", x, offset, resolution, q, expected,
             fault.text);
  }
}

static void refuse_value(double x, sepax_grid grid, const char *part) {
  int32_t q = 0;
  assert_fault(quantised(&q, x, &grid), part);
  assert_int_equal(q, 0);
}

CASE(test_rounding) {
  assert_quantised(0.5, 1, 0, 18, 1);
  assert_quantised(-0.5, 1, 0, 18, -1);
  assert_quantised(2.5, 1, 0, 18, 3);
  assert_quantised(-2.5, 1, 0, 18, -3);
  assert_quantised(stepped(0.5, -1), 1, 0, 18, 0);
  assert_quantised(stepped(-0.5, 1), 1, 0, 18, 0);
  assert_quantised(-0.0, 1, 0, 4, 0);
  assert_quantised(0.125, 0.25, 0, 18, 1);
  assert_quantised(1, 2, 2, 18, -1);
  assert_quantised(0x1p-1074, 0x1p-1074, 0, 18, 1);
  assert_quantised(0x3p-1074, 0x1p-1073, 0, 18, 2);
  assert_quantised(0x1p999, 0x1p997, -0x1p999, 18, 8);
  /* 1e16 + 0.5 as x - offset is no double; only an exact difference sees the half. */
  assert_quantised(1e16, 1e16, -0.5, 18, 1);
  assert_quantised(0x1p53, 0x1p54, -0x1p-60, 18, 1);
  assert_quantised(0x1p53, 0x1p54, 0x1p-60, 18, 0);
  /* 0.009 / 0.002 and 0.25 / 0.1 give 4.5 and 2.5 in double; exactly they are less. */
  assert_quantised(0.009, 0.002, 0, 18, 4);
  assert_quantised(-0.25, 0.1, 0, 18, -2);
  assert_quantised(0.001, 0.002, 0, 18, 1);
}

CASE(test_extremes) {
  for (int word = 4; word <= 32; word++) {
    double half = ldexp(1, word - 1);
    sepax_grid grid = {1, {0, 0, 0}, word};
    assert_quantised(stepped(half - 0.5, -1), 1, 0, word, sepax_word_max(word));
    assert_quantised(stepped(-half - 0.5, 1), 1, 0, word, sepax_word_min(word));
    refuse_value(half - 0.5, grid, "does not fit");
    refuse_value(-half - 0.5, grid, "does not fit");
  }
  sepax_grid grid = {0.002, {0, 0, 0}, 18};
  refuse_value(300, grid,
               "facet 0, vertex 0: x = 300 does not fit 18 bits at 0.002 per LSB from 0; raise");
  refuse_value(1e308, grid, "does not fit");
  refuse_value(-INFINITY, grid, "does not fit");
  refuse_value(NAN, grid, "does not fit");
  refuse_value(0x1p1001, (sepax_grid){0x1p999, {0, 0, 0}, 18}, "does not fit");
}

CASE(test_bad_grids) {
  const double bad[] = {0, -0.0, -1, NAN, INFINITY, DBL_MAX};
  for (size_t i = 0; i < LENGTH(bad); i++) {
    refuse_value(1, (sepax_grid){bad[i], {0, 0, 0}, 18}, "resolution: ");
  }
  refuse_value(1, (sepax_grid){1, {0, NAN, 0}, 18}, "offset: y = nan");
  refuse_value(1, (sepax_grid){1, {0, 0, -INFINITY}, 18}, "offset: z = -inf");
  refuse_value(1, (sepax_grid){1, {0, 0, 0}, 3}, "word: 3 is not in 4 ... 32");
  refuse_value(1, (sepax_grid){1, {0, 0, 0}, 33}, "word: 33 is not in 4 ... 32");
}

/* floor(|x - offset| / resolution + 1/2) with its sign, in rationals. */
static void slow_quantise(mpz_t q, double x, double offset, double resolution) {
  mpq_t value;
  mpq_t other;
  mpq_inits(value, other, NULL);
  mpq_set_d(value, x);
  mpq_set_d(other, offset);
  mpq_sub(value, value, other);
  mpq_set_d(other, resolution);
  mpq_div(value, value, other);
  int sign = mpq_sgn(value);
  mpq_abs(value, value);
  mpq_set_ui(other, 1, 2);
  mpq_add(value, value, other);
  mpz_fdiv_q(q, mpq_numref(value), mpq_denref(value));
  if (sign < 0) {
    mpz_neg(q, q);
  }
  mpq_clears(value, other, NULL);
}

typedef struct {
  int values, fitting, below; /* below: rounded to the border's lower side */
} rounded;

/* x at grid point q + 1/2, or near it. */
static void compare_with_rationals(rounded *r, double x, double q, double step, double offset,
                                   int word) {
  mpz_t expected;
  mpz_init(expected);
  slow_quantise(expected, x, offset, step);
  r->values++;
  r->below += mpz_cmp_d(expected, q) == 0;
  if (mpz_cmp_si(expected, sepax_word_min(word)) >= 0 &&
      mpz_cmp_si(expected, sepax_word_max(word)) <= 0) {
    assert_quantised(x, step, offset, word, (int32_t)mpz_get_si(expected));
    r->fitting++;
  } else {
    refuse_value(x, (sepax_grid){step, {offset, offset, offset}, word}, "does not fit");
  }
  mpz_clear(expected);
}

static void assert_balanced(const rounded *r) {
  print_message("%d values against rationals, %d fit, %d below a border\n", r->values, r->fitting,
                r->below);
  assert_true(r->fitting > r->values / 2 && r->fitting < r->values);
  assert_true(r->below > r->values / 4 && r->below < r->values * 3 / 4);
}

/* Most values lie within a few units in the last place of a border. */
CASE(test_against_rationals) {
  const double resolutions[] = {0.002, 0.1, 1.0 / 3, 1e-3, 7e-7, 1, 0.0254, 1e30, 0x1p-1070, PI};
  rounded r = {0};
  for (int i = 0; i < RANDOM_VALUES; i++) {
    double step = resolutions[random_below((int)LENGTH(resolutions))];
    int word = 4 + random_below(29);
    double offset = random_below(3) == 0 ? 0 : random_unit() * step * 1e4;
    double q = floor(random_unit() * ldexp(1.0001, word - 1));
    double x = stepped((q + 0.5) * step + offset, random_below(5) - 2);
    x = random_below(8) == 0 ? x + random_unit() * step : x;
    compare_with_rationals(&r, x, q, step, offset, word);
  }
  assert_balanced(&r);
}

/* The same near the ends of the doubles, with offsets from far below a step to far above. */
CASE(test_extreme_grids) {
  const int exponents[] = {-1073, -1050, -1022, -1000, -999, 0, 900, 950};
  rounded r = {0};
  for (int i = 0; i < RANDOM_VALUES / 4; i++) {
    double step = ldexp(1 + fabs(random_unit()), exponents[random_below((int)LENGTH(exponents))]);
    int word = 4 + random_below(29);
    double offset = ldexp(random_unit() * step, random_below(90) - 70);
    offset = random_below(4) == 0 ? step * random_below(9) : offset;
    double q = floor(random_unit() * ldexp(1.0001, word - 1));
    double x = stepped((q + 0.5) * step + offset, random_below(5) - 2);
    compare_with_rationals(&r, x, q, step, offset, word);
  }
  assert_balanced(&r);
}

/* The nine coordinates of each facet of a mesh, settled or not, go where they belong. */
CASE(test_places) {
  enum { FACETS = 1000 };
  const sepax_grid grid = {0.25, {0.125, -3, 17}, 18};
  static sepax_facet facet[FACETS];
  static sepax_tri tri[FACETS];
  for (int i = 0; i < 9 * FACETS; i++) {
    facet[i / 9].v[i / 3 % 3][i % 3] = (random_below(20000) - 10000) * 0.0625;
  }
  const sepax_soup mesh = {.facet = facet, .count = FACETS};
  assert_true(sepax_quantise(SEPAX_SOUP_MESH(&mesh), &grid, tri, &fault));
  for (int i = 0; i < 9 * FACETS; i++) {
    double steps = (facet[i / 9].v[i / 3 % 3][i % 3] - grid.offset[i % 3]) / grid.resolution;
    const sepax_vec *v = &tri[i / 9].v[i / 3 % 3];
    const int32_t q[3] = {v->x, v->y, v->z};
    assert_true(q[i % 3] == round(steps)); /* all exact */
  }
  for (int i = 0; i < 9; i++) {
    double *x = &facet[FACETS - 2].v[i / 3][i % 3];
    double good = *x;
    *x = NAN;
    assert_fault(sepax_quantise(SEPAX_SOUP_MESH(&mesh), &grid, tri, &fault), "facet 998, vertex ");
    *x = good;
  }
}

CASE(test_normals) {
  const struct {
    double normal[3];
    int word;
    sepax_vec expected;
  } cases[] = {
      {{0, 0, 0}, 18, {0, 0, 0}},
      {{0, -0.0, 1}, 18, {0, 0, 131071}},
      {{-7, 0, 0}, 32, {-2147483647, 0, 0}},
      {{3e-320, 0, 4e-320}, 18, {78643, 0, 104857}},
      {{1e308, 1e308, -1e308}, 18, {75674, 75674, -75674}},
      {{1, 1, 1}, 4, {4, 4, 4}},
      {{0.5, 0.5, 0x1.6a09e667f3bcdp-1}, 8, {64, 64, 90}},
  };
  for (size_t i = 0; i < LENGTH(cases); i++) {
    double given[3];
    memcpy(given, cases[i].normal, sizeof given);
    const sepax_soup soup = {.normal = &given, .count = 1};
    sepax_vec normal;
    assert_works(sepax_quantise_normals(&soup, cases[i].word, &normal, &fault));
    assert_memory_equal(&normal, &cases[i].expected, sizeof normal);
  }
  double flawed[1][3] = {{0, NAN, 0}};
  sepax_soup soup = {.normal = flawed, .count = 1};
  sepax_vec normal;
  assert_fault(sepax_quantise_normals(&soup, 18, &normal, &fault),
               "facet 0: the normal has y = nan");
  soup.normal = NULL;
  assert_fault(sepax_quantise_normals(&soup, 18, &normal, &fault), "the mesh has no normals");
}

CASE(nothing_is_left_of_a_failure) {
  sepax_facet facet[2] = {facet_at(1), facet_at(100)};
  const sepax_soup mesh = {.facet = facet, .count = 2};
  sepax_tri tri[2] = {{{{7, 7, 7}}}};
  const sepax_grid grid = {1, {0, 0, 0}, 4};
  assert_fault(sepax_quantise(SEPAX_SOUP_MESH(&mesh), &grid, tri, &fault),
               "facet 1, vertex 0: x = 100 does not fit 4 bits");
  assert_int_equal(tri[0].v[0].x, 0);
}

/* ------------------------------------------------------------------------ fit */

CASE(test_fit) {
  for (int i = 0; i < 20000; i++) {
    double scale = ldexp(1, random_below(80) - 40);
    double shift = random_below(2) == 0 ? 0 : random_unit() * 1e6;
    sepax_facet facet[2];
    for (int k = 0; k < 18; k++) {
      facet[k / 9].v[k / 3 % 3][k % 3] = shift + random_unit() * scale;
    }
    facet[1].v[0][0] = stepped(facet[0].v[0][0], 1); /* never a single point */
    const sepax_soup a = {.facet = &facet[0], .count = 1};
    const sepax_soup b = {.facet = &facet[1], .count = 1};
    assert_fit((const sepax_soup *const[]){&a, &b}, 2, 4 + random_below(29));
  }
}

CASE(test_fit_extremes) {
  const double ends[][2] = {{-1, 1},
                            {0, 10},
                            {1, 1 + DBL_EPSILON},
                            {0, 0x1p-1074},
                            {-0x1p1000, 0x1p1000},
                            {-0x1p1000, stepped(-0x1p1000, 1)},
                            {-1e-300, 1e300}};
  for (size_t i = 0; i < LENGTH(ends); i++) {
    sepax_facet facet = facet_at(ends[i][0]);
    facet.v[1][2] = ends[i][1];
    const sepax_soup mesh = {.facet = &facet, .count = 1};
    const sepax_soup *const list[] = {&mesh};
    for (int word = 4; word <= 32; word++) {
      assert_fit(list, 1, word);
    }
  }
  sepax_facet facet = {.v = {{0, 0, 0}, {100, 20, 0}, {0, -40, 30}}};
  const sepax_soup mesh = {.facet = &facet, .count = 1};
  sepax_grid grid = assert_fit((const sepax_soup *const[]){&mesh}, 1, 18);
  assert_true(grid.offset[0] == 50 && grid.offset[1] == -10 && grid.offset[2] == 15);
  assert_true(fabs(grid.resolution * 262143 / 100 - 1) < 1e-15);
}

CASE(test_fit_errors) {
  sepax_facet same = facet_at(5);
  sepax_facet wide = {.v = {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}}};
  sepax_facet huge = {.v = {{0, 0, 0}, {0, -1e305, 0}, {0, 0, 0}}};
  sepax_facet wrong = {.v = {{0, 0, 0}, {0, 0, 0}, {0, NAN, 0}}};
  const sepax_soup empty = {0};
  const sepax_soup point = {.facet = &same, .count = 1};
  const sepax_soup line = {.facet = &wide, .count = 1};
  const sepax_soup large = {.facet = &huge, .count = 1};
  const sepax_soup flawed = {.facet = &wrong, .count = 1};
  const struct {
    const sepax_soup *mesh[2];
    size_t count;
    int word;
    const char *part;
  } row[] = {{{NULL, NULL}, 0, 18, "empty"},
             {{&empty, &empty}, 2, 18, "empty"},
             {{&empty, &point}, 2, 18, "a single point"},
             {{&line, NULL}, 1, 3, "word: 3 is not in 4 ... 32"},
             {{&line, &large}, 2, 18, "mesh 1, facet 0: y = -1e"},
             {{&flawed, NULL}, 1, 18, "mesh 0, facet 0: y = nan"}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    sepax_grid grid = {.word = 77};
    const sepax_soup none = {0};
    const sepax_soup *soup[2] = {&none, &none};
    memcpy(soup, row[i].mesh, row[i].count * sizeof soup[0]);
    const sepax_mesh *const all[2] = {SEPAX_SOUP_MESH(soup[0]), SEPAX_SOUP_MESH(soup[1])};
    assert_fault(sepax_grid_fit(&grid, all, row[i].count, row[i].word, &fault), row[i].part);
    assert_int_equal(grid.word, 0);
  }
}
