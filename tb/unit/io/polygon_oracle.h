/* SPDX-License-Identifier: MIT */
/* polygon_oracle.h - is a polygon divided rightly? Areas and edges in rational numbers: triangles
 * that all turn the polygon's way, whose edges match, are a division of a polygon that is simple.
 */
#ifndef POLYGON_ORACLE_H
#define POLYGON_ORACLE_H

#include "reader/polygon.h"
#include "harness.h"

#include <gmp.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

typedef struct {
  size_t count;
  double at[MOST][2];
} flat;

static inline void add(flat *p, double x, double y) {
  assert_true(p->count < MOST);
  p->at[p->count][0] = x;
  p->at[p->count++][1] = y;
}

static mpq_t term[4];

/* r += (a - o) x (b - o), seen along the axis. */
static inline void add_area(mpq_t r, const double o[3], const double a[3], const double b[3],
                            int axis) {
  int x = (axis + 1) % 3;
  int y = (axis + 2) % 3;
  const double *from[4] = {a, b, a, b};
  const int which[4] = {x, y, y, x};
  mpq_t origin;
  mpq_init(origin);
  for (int k = 0; k < 4; k++) {
    mpq_set_d(term[k], from[k][which[k]]);
    mpq_set_d(origin, o[which[k]]);
    mpq_sub(term[k], term[k], origin);
  }
  mpq_mul(term[0], term[0], term[1]);
  mpq_mul(term[2], term[2], term[3]);
  mpq_sub(term[0], term[0], term[2]);
  mpq_add(r, r, term[0]);
  mpq_clear(origin);
}

static inline int compare(const void *p, const void *q) {
  uint64_t a = *(const uint64_t *)p;
  uint64_t b = *(const uint64_t *)q;
  return (a > b) - (a < b);
}

/* Each edge of the polygon is one of one triangle, in its direction; the others come in pairs, one
 * in each direction. */
static inline void assert_edges(size_t count, size_t (*t)[3]) {
  static uint64_t run[4 * MOST];
  size_t edges = 0;
  for (size_t n = 0; n < count; n++) {
    run[edges++] = (uint64_t)((n + 1) % count) << 32 | n; /* backwards */
  }
  for (size_t n = 0; n + 2 < count; n++) {
    for (int k = 0; k < 3; k++) {
      assert_true(t[n][k] < count && t[n][k] != t[n][(k + 1) % 3]);
      run[edges++] = (uint64_t)t[n][k] << 32 | t[n][(k + 1) % 3];
    }
  }
  qsort(run, edges, sizeof *run, compare);
  for (size_t n = 0; n < edges; n++) {
    uint64_t back = run[n] << 32 | run[n] >> 32;
    assert_true(n == 0 || run[n] != run[n - 1]);
    assert_non_null(bsearch(&back, run, edges, sizeof *run, compare));
  }
}

/* How many triangles have no area. All others turn the polygon's way along an axis. */
static inline size_t assert_divided(const double (*corner)[3], size_t count, size_t (*t)[3],
                                    int axis) {
  mpq_t whole;
  mpq_t sum;
  mpq_t one;
  size_t lost = 0;
  mpq_inits(whole, sum, one, NULL);
  for (size_t n = 1; n + 1 < count; n++) {
    add_area(whole, corner[0], corner[n], corner[n + 1], axis);
  }
  for (size_t n = 0; n + 2 < count; n++) {
    mpq_set_ui(one, 0, 1);
    add_area(one, corner[t[n][0]], corner[t[n][1]], corner[t[n][2]], axis);
    mpq_add(sum, sum, one);
    if (mpq_sgn(one) * mpq_sgn(whole) < 0) {
      fail_msg("triangle %zu of %zu corners is turned round", n, count);
    }
    lost += mpq_sgn(one) == 0;
  }
  assert_int_equal(mpq_cmp(whole, sum), 0);
  mpq_clears(whole, sum, one, NULL);
  return lost;
}

/* The polygon in space: in a plane across an axis, or in one across none, in both senses, from each
 * of its corners on. */
static inline void place(double (*corner)[3], const flat *p, bool tilt) {
  int axis = random_below(3);
  bool back = random_below(2) != 0;
  size_t first = (size_t)random_below((int)p->count);
  const double height[3] = {random_below(5) - 2, random_below(5) - 2, 7};
  for (size_t n = 0; n < p->count; n++) {
    size_t m = (first + (back ? p->count - n : n)) % p->count;
    double x = p->at[m][0];
    double y = p->at[m][1];
    double z = tilt ? height[0] * x + height[1] * y + height[2] : 0;
    corner[n][(axis + 1) % 3] = x;
    corner[n][(axis + 2) % 3] = y;
    corner[n][axis] = z;
  }
}

static inline int area_axis(const double (*corner)[3], size_t count) {
  mpq_t area[3];
  int best = 0;
  for (int i = 0; i < 3; i++) {
    mpq_init(area[i]);
    for (size_t n = 1; n + 1 < count; n++) {
      add_area(area[i], corner[0], corner[n], corner[n + 1], i);
    }
    mpq_abs(area[i], area[i]);
    best = mpq_cmp(area[i], area[best]) > 0 ? i : best;
  }
  for (int i = 0; i < 3; i++) {
    mpq_clear(area[i]);
  }
  return best;
}

/* Divided as it should be; how many triangles have no area. */
static inline size_t assert_right(const flat *p, bool tilt) {
  static double corner[MOST][3];
  static size_t t[MOST][3];
  bool bent = true;
  place(corner, p, tilt);
  polygon_result result = sepax__polygon_divide((const double(*)[3])corner, p->count, t, &bent);
  if (result != POLYGON_DIVIDED) {
    for (size_t n = 0; n < p->count && p->count < 40; n++) {
      print_message("  %a %a\n", p->at[n][0], p->at[n][1]);
    }
    fail_msg("%zu corners: result %d", p->count, (int)result);
  }
  assert_false(bent);
  assert_edges(p->count, t);
  return assert_divided((const double(*)[3])corner, p->count, t,
                        area_axis((const double(*)[3])corner, p->count));
}

static inline void begin(void) {
  for (int k = 0; k < 4; k++) {
    mpq_init(term[k]);
  }
}

static inline void end(void) {
  for (int k = 0; k < 4; k++) {
    mpq_clear(term[k]);
  }
}

#endif
