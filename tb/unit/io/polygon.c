/* SPDX-License-Identifier: MIT */
/* polygon.c - polygons of known shapes, divided. */
#include "polygon_oracle.h"
#include "body/orient.h"

#include <time.h>

/* ------------------------------------------------------------------------- shapes */

/* Between two functions of x: of whole numbers; of numbers of all sizes; nearly straight. */
static void make_monotone(flat *p, int kind) {
  size_t count = 3 + (size_t)random_below(14);
  double x[40];
  double low = kind == 1 ? 0x1p-200 : 0;
  p->count = 0;
  for (size_t n = 0; n < count; n++) {
    x[n] = (double)n * (kind == 1 ? ldexp(1, 3 * (int)n - 20) : 3) + low;
  }
  for (int way = -1; way <= 1; way += 2) {
    for (size_t n = 0; n + 1 < count; n++) {
      double y = 1 + random_below(6);
      y = kind == 1 ? ldexp(y, random_below(120) - 60) : kind == 2 ? 1 + ldexp(y, -52) : y;
      size_t m = way < 0 ? n : count - 1 - n;
      add(p, x[m], n == 0 ? 0 : way * y);
    }
  }
}

/* Round the origin: whole numbers in the order of their angles, each angle once. */
static int half_of(const double v[2]) { return v[1] > 0 || (v[1] >= 0 && v[0] > 0) ? 0 : 1; }
static int by_angle(const void *p, const void *q) {
  const double *a = p;
  const double *b = q;
  double turn = a[0] * b[1] - a[1] * b[0];
  int order = half_of(a) - half_of(b);
  return order != 0 ? order : (turn < 0) - (turn > 0);
}

static void make_star(flat *p) {
  static const double cross[4][2] = {{9, 0}, {0, 9}, {-9, 0}, {0, -9}};
  size_t count = 4 + (size_t)random_below(12);
  size_t kept = 1;
  p->count = 0;
  for (size_t n = 0; n < count; n++) {
    double x = n < 4 ? cross[n][0] : random_below(101) - 50;
    double y = n < 4 ? cross[n][1] : random_below(101) - 50;
    if (x < 0 || x > 0 || y < 0 || y > 0) {
      add(p, x, y);
    }
  }
  qsort(p->at, p->count, sizeof *p->at, by_angle);
  for (size_t n = 1; n < p->count; n++) {
    if (by_angle(p->at[kept - 1], p->at[n]) != 0) {
      memmove(p->at[kept++], p->at[n], sizeof *p->at);
    }
  }
  p->count = kept;
}

static void make_comb(flat *p, size_t teeth) {
  p->count = 0;
  add(p, 4 * (double)teeth, -5);
  for (size_t n = teeth; n > 0; n--) {
    double x = 4 * (double)n - 4;
    add(p, x + 3, 10 + random_below(3));
    add(p, x + 1, 10 + random_below(3));
    add(p, x, 1 - random_below(3));
  }
  add(p, -1, -5);
}

/* Round and round inwards, and back at a distance of 1. */
static void make_spiral(flat *p, size_t turns) {
  double half = 4 * (double)turns;
  p->count = 0;
  for (size_t n = 0; n < 4 * turns; n++) {
    double r = half - (double)n / 1.5;
    add(p, n % 4 == 0 || n % 4 == 3 ? r : -r, n % 4 < 2 ? r : -r);
  }
  for (size_t n = 4 * turns; n > 0; n--) {
    double r = half - (double)(n - 1) / 1.5 - 1;
    add(p, (n - 1) % 4 == 0 || (n - 1) % 4 == 3 ? r : -r, (n - 1) % 4 < 2 ? r : -r);
  }
}

/* A hole at the end of a bridge from the left, as wide as it is high; another one behind it. */
static void add_hole(flat *p, double x, double y, size_t more) {
  bool straight = random_below(2) != 0;
  add(p, x, y);
  if (straight) {
    add(p, x + 1, y + 1);
  } else {
    add(p, x, y + 1);
    add(p, x + 2, y + 1);
  }
  add(p, x + 2, y);
  if (more > 0) {
    double way = random_below(2);
    if (way > 0) {
      add(p, x + 3, y + 0.5); /* a bend of the bridge */
    }
    add_hole(p, x + 4, y, more - 1);
    if (way > 0) {
      add(p, x + 3, y + 0.5);
    }
    add(p, x + 2, y);
  }
  add(p, x + 1, y - 1);
  add(p, x, y);
}

/* A rectangle with holes, in one line; some of them touch its side. */
static void make_keyhole(flat *p, size_t rows) {
  p->count = 0;
  add(p, 0, -2);
  add(p, 40, -2);
  add(p, 40, 4 * (double)rows);
  add(p, 0, 4 * (double)rows);
  for (size_t n = rows; n > 0; n--) {
    double y = 4 * (double)(n - 1);
    bool bridge = random_below(3) != 0;
    add(p, 0, y);
    add_hole(p, bridge ? 2 : 0, y, (size_t)random_below(6));
    if (bridge) {
      add(p, 0, y);
    }
  }
}

/* Some corners there twice, some edges divided, spikes to the inside and outside of corners. */
static void spoil(flat *p) {
  static flat q;
  q = *p;
  p->count = 0;
  for (size_t n = 0; n < q.count; n++) {
    const double *a = q.at[n];
    const double *b = q.at[(n + 1) % q.count];
    add(p, a[0], a[1]);
    switch (random_below(4)) {
    case 0:
      add(p, a[0], a[1]);
      break;
    case 1:
      add(p, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2);
      break;
    case 2: /* on, and back along the same edge */
      add(p, a[0] + (b[0] - a[0]) / 2, a[1] + (b[1] - a[1]) / 2);
      add(p, a[0] + (b[0] - a[0]) / 4, a[1] + (b[1] - a[1]) / 4);
      break;
    default:
      break;
    }
  }
}

/* --------------------------------------------------------------------------- cases */

CASE(simple_polygons) {
  static flat p;
  begin();
  for (size_t n = 0; n < FEWER(40000); n++) {
    int kind = (int)(n % 4);
    if (kind < 3) {
      make_monotone(&p, kind);
    } else {
      make_star(&p);
    }
    size_t lost = assert_right(&p, kind == 0 || kind == 3);
    assert_int_equal(lost, 0);
  }
  for (size_t n = 0; n < FEWER(400); n++) {
    make_comb(&p, 1 + n % 60);
    assert_int_equal(assert_right(&p, true), 0);
    make_spiral(&p, 1 + n % 12);
    assert_right(&p, false);
  }
  end();
}

CASE(polygons_that_touch_themselves) {
  static flat p;
  begin();
  for (size_t n = 0; n < FEWER(8000); n++) {
    make_keyhole(&p, 1 + n % 7);
    assert_right(&p, n % 2 != 0);
    spoil(&p);
    assert_right(&p, n % 2 != 0);
    make_star(&p);
    spoil(&p);
    assert_right(&p, true);
  }
  end();
}

/* Whole numbers in a small square, in any order: most cross. What is divided is divided rightly;
 * what crosses nowhere is divided. */
static double side(const double *a, const double *b, const double *c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

static bool meet(const double *a, const double *b, const double *c, const double *d) {
  if (fmax(a[0], b[0]) < fmin(c[0], d[0]) || fmax(c[0], d[0]) < fmin(a[0], b[0]) ||
      fmax(a[1], b[1]) < fmin(c[1], d[1]) || fmax(c[1], d[1]) < fmin(a[1], b[1])) {
    return false;
  }
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

static bool is_simple(const flat *p) {
  size_t n = p->count;
  for (size_t i = 0; i < n; i++) {
    const double *a = p->at[i];
    const double *b = p->at[(i + 1) % n];
    const double *c = p->at[(i + 2) % n];
    bool back = side(a, b, c) * side(a, b, c) <= 0 &&
                (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) <= 0;
    for (size_t j = i + 2; j < n && !back; j++) {
      back = (j + 1) % n != i && meet(a, b, p->at[j], p->at[(j + 1) % n]);
    }
    if (back) {
      return false;
    }
  }
  return true;
}

CASE(random_corners) {
  static flat p;
  static double corner[MOST][3];
  size_t t[16][3];
  size_t seen[2] = {0};
  begin();
  for (size_t n = 0; n < FEWER(200000); n++) {
    int most = 3 + random_below(8);
    p.count = 0;
    for (size_t k = 0; k < 4 + n % 5; k++) {
      add(&p, random_below(most), random_below(most));
    }
    bool simple = is_simple(&p);
    bool bent;
    place(corner, &p, false);
    polygon_result result = sepax__polygon_divide((const double(*)[3])corner, p.count, t, &bent);
    assert_true(result == POLYGON_DIVIDED || !simple);
    if (result == POLYGON_DIVIDED) {
      int axis = area_axis((const double(*)[3])corner, p.count);
      assert_edges(p.count, t);
      size_t lost = assert_divided((const double(*)[3])corner, p.count, t, axis);
      assert_true(lost == 0 || !simple);
    }
    seen[simple]++;
  }
  assert_true(seen[0] > 0 && seen[1] > FEWER(10000));
  end();
}

/* -------------------------------------------------------------------- single polygons */

#define DIVIDE(corner, t, bent) \
  sepax__polygon_divide((const double(*)[3])(corner), LENGTH(corner), t, bent)

CASE(known_polygons) {
  size_t t[16][3];
  bool bent;
  const double square[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  assert_int_equal(DIVIDE(square, t, &bent), POLYGON_DIVIDED);
  assert_false(bent);
  assert_memory_equal(t, ((size_t[2][3]){{0, 1, 2}, {0, 2, 3}}), sizeof t[0] * 2);
  const double arrow[4][3] = {{0, 0, 0}, {2, 1, 0}, {0, 9, 0}, {-9, 0, 0}};
  const double dart[4][3] = {{9, 0, 0}, {2, 1, 0}, {0, 9, 0}, {0, 0, 0}};
  assert_int_equal(DIVIDE(arrow, t, &bent), POLYGON_DIVIDED);
  assert_int_equal(DIVIDE(dart, t, &bent), POLYGON_DIVIDED);
  assert_memory_equal(t[0], ((size_t[3]){3, 0, 1}), sizeof t[0]);
  const double bow[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  assert_int_equal(DIVIDE(bow, t, &bent), POLYGON_CROSSES);
  const double uneven_bow[4][3] = {{0, 0, 0}, {4, 0, 0}, {0, 1, 0}, {1, 1, 0}};
  assert_int_equal(DIVIDE(uneven_bow, t, &bent), POLYGON_CROSSES);
  const double pentagram[5][3] = {{0, 10, 0}, {6, -8, 0}, {-9, 3, 0}, {9, 3, 0}, {-6, -8, 0}};
  assert_int_equal(DIVIDE(pentagram, t, &bent), POLYGON_CROSSES);
  const double line[5][3] = {{0, 0, 0}, {3, 3, 3}, {1, 1, 1}, {2, 2, 2}, {1, 1, 1}};
  assert_int_equal(DIVIDE(line, t, &bent), POLYGON_DIVIDED);
  assert_false(bent);
  const double there_and_back[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0},
                                       {2, 5, 0}, {1, 1, 0}, {1, 0, 0}};
  assert_int_equal(DIVIDE(there_and_back, t, &bent), POLYGON_DIVIDED);
}

/* A hole that is bridged to the far corner, touches the first corner with its tip, and leaves the
 * first corner's triangle across the cut, without a corner in it. */
CASE(hole_at_a_corner) {
  static flat p;
  static const double at[11][2] = {{0, 0}, {2, 0}, {30, -10}, {30, 30},  {9, 8}, {0, 0},
                                   {8, 9}, {9, 8}, {30, 30},  {-10, 30}, {0, 2}};
  begin();
  for (int n = 0; n < 100; n++) {
    p.count = 0;
    for (int k = 0; k < 11; k++) {
      add(&p, at[k][0], at[k][1]);
    }
    assert_right(&p, n % 2 != 0);
  }
  end();
}

/* Two squares and the bent line that joins them, which has no inside on either side. */
CASE(islands) {
  static flat p;
  static const double at[12][2] = {{0, 0},  {4, 0},   {4, 4},  {6, 4}, {6, 8}, {8, 8},
                                   {12, 8}, {12, 12}, {8, 12}, {8, 8}, {6, 8}, {6, 4}};
  begin();
  for (int n = 0; n < 100; n++) {
    p.count = 0;
    for (int k = 0; k < 12; k++) {
      add(&p, at[k][0], n % 3 == 0 ? -at[k][1] : at[k][1]);
    }
    add(&p, 4, n % 3 == 0 ? -4 : 4);
    add(&p, 0, n % 3 == 0 ? -4 : 4);
    assert_right(&p, n % 2 != 0);
  }
  end();
}

/* The last bit of a coordinate decides, at the ends of the range, too. */
CASE(bent_polygons) {
  size_t t[4][3];
  bool bent;
  for (int e = -1060; e <= 990; e += 50) {
    double one = ldexp(1, e);
    double quad[4][3] = {{one, 0, one}, {0, one, one}, {-one, 0, -one}, {0, -one, -one}};
    assert_int_equal(DIVIDE(quad, t, &bent), POLYGON_DIVIDED);
    assert_false(bent);
    quad[2][2] = nextafter(-one, 0);
    assert_int_equal(DIVIDE(quad, t, &bent), POLYGON_DIVIDED);
    assert_true(bent);
    quad[2][2] = -one;
    quad[0][0] = ldexp(1, -1074);
    assert_int_equal(DIVIDE(quad, t, &bent), POLYGON_DIVIDED);
    assert_true(bent);
  }
  const double saddle[4][3] = {{0, 0, 0}, {1, 0, 1}, {1, 1, 0}, {0, 1, 1}};
  assert_int_equal(DIVIDE(saddle, t, &bent), POLYGON_DIVIDED);
  assert_true(bent);
  /* Seen along z it crosses, along x and y it does not. */
  const double hidden[5][3] = {{0, 0, 0}, {10, 10, 0}, {10, 0, 3}, {0, 11, 6}, {-1, 5, 3}};
  assert_int_equal(DIVIDE(hidden, t, &bent), POLYGON_DIVIDED);
  /* A face of the duck that shows what COLLADA can do: along each axis it crosses. */
  const double duck[4][3] = {{82.8336, 116.065, -0.2435},
                             {82.8751, 115.658, -0.544518},
                             {81.6235, 116.026, -5.37269},
                             {82.3865, 115.792, -3.39975}};
  assert_int_equal(DIVIDE(duck, t, &bent), POLYGON_DIVIDED);
  assert_true(bent);
  assert_memory_equal(t, ((size_t[2][3]){{0, 1, 2}, {0, 2, 3}}), sizeof t[0] * 2);
}

/* Signs of all sizes of numbers against rational ones. */
CASE(signs) {
  begin();
  for (size_t n = 0; n < FEWER(200000); n++) {
    double v[4][3];
    for (int k = 0; k < 12; k++) {
      int e = n % 3 == 0 ? random_below(2000) - 1030 : random_below(3) - 20;
      v[k / 3][k % 3] = ldexp(random_below(5) - 2, e);
    }
    if (n % 2 != 0) { /* nearly on the line, nearly in the plane */
      for (int i = 0; i < 3; i++) {
        v[2][i] = v[0][i] + 0.5 * (v[1][i] - v[0][i]);
        v[3][i] = v[0][i] + (v[1][i] - v[0][i]) / 3;
      }
    }
    if (n % 7 == 0) { /* products that are rounded to one double */
      for (int i = 0; i < 2; i++) {
        v[0][i] = 0;
        v[1][i] = 0x1p50 + random_below(9);
        v[2][i] = v[1][i] + 1;
      }
    }
    mpq_t area;
    mpq_t volume;
    mpq_t origin;
    mpq_t height;
    mpq_inits(area, volume, origin, height, NULL);
    add_area(area, v[0], v[1], v[2], 2);
    assert_int_equal(sepax__orient2d(v[0], v[1], v[2]), mpq_sgn(area));
    for (int i = 0; i < 3; i++) {
      mpq_set_ui(area, 0, 1);
      add_area(area, v[0], v[1], v[2], i);
      mpq_set_d(height, v[3][i]);
      mpq_set_d(origin, v[0][i]);
      mpq_sub(height, height, origin);
      mpq_mul(height, height, area);
      mpq_add(volume, volume, height);
    }
    assert_int_equal(sepax__orient3d(v[0], v[1], v[2], v[3]), mpq_sgn(volume));
    mpq_clears(area, volume, origin, height, NULL);
  }
  end();
}

/* 100,000 corners: a convex one takes no time; one that is not is refused. 20,000 in a comb, all
 * crossing, or on one line take seconds at most. */
CASE(long_polygons) {
  enum { LONG = 100000 };
  double(*corner)[3] = calloc(LONG, sizeof *corner);
  size_t(*t)[3] = calloc(LONG, sizeof *t);
  bool bent;
  for (size_t n = 0; n < LONG; n++) {
    corner[n][0] = (double)n;
    corner[n][1] = (double)n * (double)n;
  }
  assert_int_equal(sepax__polygon_divide((const double(*)[3])corner, LONG, t, &bent),
                   POLYGON_DIVIDED);
  corner[7][1] += 100;
  assert_int_equal(sepax__polygon_divide((const double(*)[3])corner, LONG, t, &bent), POLYGON_LONG);
  for (int kind = 0; kind < 4; kind++) {
    size_t count = kind == 1 ? 2000 : POLYGON_CORNERS_MOST;
    for (size_t n = 0; n < count; n++) {
      double up = n % 2 == 0 ? 0 : 1000;
      corner[n][0] = kind == 1 ? (double)(n * 7919 % 1009) : (double)n;
      corner[n][1] = kind == 0   ? up
                     : kind == 1 ? (double)(n * 104729 % 997)
                     : kind == 2 ? 0
                                 : up + (double)(n * 7919 % 1009);
    }
    corner[count - 1][1] = kind == 2 ? 0 : -1000;
    corner[0][1] = kind == 2 ? 0 : -1000;
    double start = (double)clock();
    assert_int_equal(sepax__polygon_divide((const double(*)[3])corner, count, t, &bent),
                     kind == 1 ? POLYGON_CROSSES : POLYGON_DIVIDED);
    double took = ((double)clock() - start) / CLOCKS_PER_SEC;
    print_message("kind %d: %zu corners in %.2f s\n", kind, count, took);
  }
  free(corner);
  free(t);
}
