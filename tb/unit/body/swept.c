/* SPDX-License-Identifier: MIT */
/* swept.c - bodies while one of them moves: what is proved holds at every time, by exact distances
 * of the triangles where they are then; bodies that slide along each other are proved apart. */
#include "distance/swept.h"
#include "draws.h"

enum { MOST = 40, TIMES = 33, WORK = 100000 };

/* A few triangles about a place. */
static sepax_body *drawn(sepax_facet *facet, size_t *count, double size, const double middle[3]) {
  sepax_soup soup = {.facet = facet, .count = (size_t)(1 + random_below(MOST))};
  sepax_body *body = NULL;
  for (size_t n = 0; n < soup.count; n++) {
    double about[3];
    double edge = size * (random_below(4) == 0 ? 1 : 0.1);
    for (int i = 0; i < 3; i++) {
      about[i] = middle[i] + size * random_unit();
    }
    for (int k = 0; k < 9; k++) {
      facet[n].v[k / 3][k % 3] = about[k % 3] + edge * random_unit();
    }
  }
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&soup), NULL, &fault));
  *count = soup.count;
  return body;
}

/* The least distance at some times, by bodies that are made of the triangles as they are then. */
static double least_of(const sepax_facet *facet, size_t count, const sepax_pose pose[2],
                       const sepax_body *b) {
  static sepax_facet moved[MOST];
  double least = INFINITY;
  for (int time = 0; time < TIMES; time++) {
    double part = (double)time / (TIMES - 1);
    sepax_soup soup = {.facet = moved, .count = count};
    sepax_body *a = NULL;
    sepax_distance_result r;
    for (size_t n = 0; n < 3 * count; n++) {
      double at[2][3];
      for (int end = 0; end < 2; end++) {
        sepax_pose_apply(&pose[end], facet[n / 3].v[n % 3], at[end]);
      }
      for (int i = 0; i < 3; i++) {
        moved[n / 3].v[n % 3][i] = at[0][i] + part * (at[1][i] - at[0][i]);
      }
    }
    assert_works(sepax_body_new(&a, SEPAX_SOUP_MESH(&soup), NULL, &fault));
    assert_works(sepax_bodies_distance(a, NULL, b, NULL, NULL, &r, &fault));
    least = fmin(least, r.min_distance);
    sepax_body_free(a);
  }
  return least;
}

CASE(never_nearer_than_proved) {
  size_t found[2] = {0, 0};
  for (int n = 0; n < FEWER(2000); n++) {
    static sepax_facet facet[2][MOST];
    size_t count[2];
    double size = pow(10, 2 * random_unit());
    double place[2][3];
    double shift[2][3];
    for (int i = 0; i < 3; i++) {
      place[0][i] = size * random_unit();
      place[1][i] = size * (2 * random_unit() + (i == n % 3 ? 3 : 0));
      shift[0][i] = size * random_unit() * (random_below(2) == 0 ? 3 : 0.01);
      shift[1][i] = shift[0][i] + size * random_unit() * (random_below(2) == 0 ? 3 : 0.01);
    }
    sepax_body *a = drawn(facet[0], &count[0], size, place[0]);
    sepax_body *b = drawn(facet[1], &count[1], size, place[1]);
    double turn = random_below(2) == 0 ? 0.1 : 0;
    double way[4] = {random_unit(), random_unit(), random_unit(), random_unit()};
    sepax_pose pose[2] = {turned(way[0], way[1], way[2], way[3]),
                          turned(way[0] + turn, way[1], way[2], way[3])};
    memcpy(pose[0].translation, shift[0], sizeof shift[0]);
    memcpy(pose[1].translation, shift[1], sizeof shift[1]);
    double least = least_of(facet[0], count[0], pose, b);
    assert_false(sepax__swept_apart(a, &pose[0], &pose[1], b, least * (1 + 1e-12), WORK));
    found[0] += least > 0;
    found[1] += least > 0 && sepax__swept_apart(a, &pose[0], &pose[1], b, least * 0.7, WORK);
    sepax_body_free(a);
    sepax_body_free(b);
  }
  print_message("%zu of %zu at 0.7 of the least distance found\n", found[1], found[0]);
  assert_true(found[0] > FEWER(300) && found[1] > found[0] / 3);
}

/* A plate of squares at a height, each of two triangles. */
static sepax_body *plate(double height, double from) {
  enum { SIDE = 40 };
  static sepax_facet facet[2 * SIDE * SIDE];
  sepax_soup soup = {.facet = facet, .count = LENGTH(facet)};
  sepax_body *body = NULL;
  for (size_t n = 0; n < soup.count; n++) {
    size_t row = n / 2 / SIDE;
    size_t column = n / 2 % SIDE;
    double x = from + (double)column;
    double y = (double)row;
    const double corner[4][2] = {{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}};
    for (size_t k = 0; k < 3; k++) {
      size_t at = n % 2 == 0 || k == 0 ? k : k + 1;
      facet[n].v[k][0] = corner[at % 4][0];
      facet[n].v[k][1] = corner[at % 4][1];
      facet[n].v[k][2] = height;
    }
  }
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&soup), NULL, &fault));
  return body;
}

/* Over its whole length, at a millionth of it. */
CASE(plates_that_slide) {
  sepax_body *low = plate(0, 0);
  sepax_body *high = plate(4e-5, -40);
  sepax_pose pose[2] = {turned(1, 0, 0, 0), turned(1, 0, 0, 0)};
  pose[1].translation[0] = 80;
  assert_true(sepax__swept_apart(high, &pose[0], &pose[1], low, 3.99e-5, WORK));
  assert_false(sepax__swept_apart(high, &pose[0], &pose[1], low, 4.01e-5, WORK));
  assert_true(sepax__swept_apart(high, &pose[0], &pose[1], low, 3.99e-5, 40));
  sepax_body_free(low);
  sepax_body_free(high);
}
