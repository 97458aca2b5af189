/* SPDX-License-Identifier: MIT */
/* outlines.c - the checks that prove meshes of solids of revolution see what is wrong; profiles and
 * options that are refused. */
#include "harness.h"
#include "mesh/outline.h"

#include <math.h>

static outline of_spots(const spot *spots, size_t count) {
  outline o = {0};
  for (size_t n = 0; n < count; n++) {
    assert_true(sepax__outline_add(&o, spots[n].z, spots[n].r));
  }
  return o;
}

#define OUTLINE(...) \
  of_spots((const spot[]){__VA_ARGS__}, sizeof((const spot[]){__VA_ARGS__}) / sizeof(spot))

static void assert_apart(outline a, outline b, double distance, bool expected) {
  assert_int_equal(sepax__outline_apart(&a, &b, distance), expected);
  sepax__outline_free(&a);
  sepax__outline_free(&b);
}

CASE(test_apart) {
  assert_apart(OUTLINE({-0.1, 5.1}, {10.1, 5.1}), OUTLINE({0, 5}, {10, 5}), 0.099, true);
  assert_apart(OUTLINE({-0.1, 5.1}, {10.1, 5.1}), OUTLINE({0, 5}, {10, 5}), 0.101, false);
  assert_apart(OUTLINE({-0.01, 5.1}, {10.1, 5.1}), OUTLINE({0, 5}, {10, 5}), 0.02, false);
  assert_apart(OUTLINE({-0.1, 5.1}, {10.01, 5.1}), OUTLINE({0, 5}, {10, 5}), 0.02, false);
  assert_apart(OUTLINE({-0.1, 6}, {10.1, 4}), OUTLINE({0, 5}, {10, 5}), 0, false);
  assert_apart(OUTLINE({1, 0}, {9, 0}), OUTLINE({0, 5}, {10, 5}), 10, true);
}

static void assert_covered(outline a, outline b, double depth, bool expected) {
  assert_int_equal(sepax__outline_covered(&a, &b, depth), expected);
  sepax__outline_free(&a);
  sepax__outline_free(&b);
}

CASE(test_covered) {
  assert_covered(OUTLINE({1, 4}, {9, 4}), OUTLINE({0, 5}, {10, 5}), 1.001, true);
  assert_covered(OUTLINE({1, 4}, {9, 4}), OUTLINE({0, 5}, {10, 5}), 0.999, false);
  assert_covered(OUTLINE({1, 4}, {9, 3.9}), OUTLINE({0, 5}, {10, 5}), 1.05, false);
  assert_covered(OUTLINE({1.1, 4}, {9, 4}), OUTLINE({0, 5}, {10, 5}), 1.05, false);
  assert_covered(OUTLINE({1, 4}, {8.9, 4}), OUTLINE({0, 5}, {10, 5}), 1.05, false);
  /* the ends are near the boundary, the middle is not */
  assert_covered(OUTLINE({1, 8}, {9, 8}), OUTLINE({0, 8}, {5, 20}, {10, 8}), 1.05, false);
  /* on a step only the point next to the axis counts */
  assert_covered(OUTLINE({1, 4}, {5, 4}, {5, 30}, {5, 4}, {9, 4}), OUTLINE({0, 5}, {10, 5}), 1.001,
                 true);
}

static void assert_reaches(outline a, outline b, double gap, bool expected) {
  assert_int_equal(sepax__outline_reaches(&a, false, &b, false, gap), expected);
  sepax__outline_free(&a);
  sepax__outline_free(&b);
}

CASE(test_reaches) {
  assert_reaches(OUTLINE({0, 5}, {10, 5}), OUTLINE({0.1, 4.9}, {9.9, 4.9}), 0.15, true);
  assert_reaches(OUTLINE({0, 5}, {10, 5}), OUTLINE({0.1, 4.9}, {9.9, 4.9}), 0.14, false);
  assert_reaches(OUTLINE({0, 5}, {10, 5}), OUTLINE({0.1, 4.9}, {9, 4.9}), 0.15, false);
  assert_reaches(OUTLINE({0, 5}, {10, 5}), OUTLINE({0.1, 4.9}, {5, 3}, {9.9, 4.9}), 0.15, false);
  assert_reaches(OUTLINE({0, 0.01}, {10, 0.01}), OUTLINE({0, 0}, {10, 0}), 1, false);
  assert_reaches(OUTLINE({0, 0.01}, {10, 0.01}), (outline){0}, 1, false);
  assert_reaches((outline){0}, (outline){0}, 1, true);
}

/* A cylinder with a stretch of the axis above it, as meshes and as profiles. */
CASE(test_axis) {
  outline needle = OUTLINE({0, 5}, {10, 5}, {10, 0}, {20, 0});
  outline around = OUTLINE({0, 5}, {10, 5}, {10, 0.01}, {20, 0.01});
  outline plain = OUTLINE({0, 5}, {10, 5});
  assert_true(sepax__outline_reaches(&around, false, &needle, true, 0.1));
  assert_false(sepax__outline_reaches(&around, false, &needle, false, 0.1));
  assert_true(sepax__outline_reaches(&needle, false, &plain, false, 0.1));
  assert_false(sepax__outline_reaches(&needle, true, &plain, false, 0.1));
  sepax__outline_free(&needle);
  sepax__outline_free(&around);
  sepax__outline_free(&plain);
}

static void refuse(const turned_point *point, size_t points, double gap, double shrink,
                   const char *part) {
  sepax_soup outer;
  sepax_soup inner;
  turned_point copy[300] = {{0}};
  for (size_t n = 0; n < points && n < LENGTH(copy); n++) {
    copy[n] = point[n < 8 ? n : 0];
  }
  turned_profile p = {copy, points};
  revolve_how how = {gap, shrink, false};
  assert_fault(sepax__revolve(&outer, &inner, &p, &how, &fault), part);
  assert_true(outer.facet == NULL && inner.facet == NULL);
}

#define REFUSE(gap, shrink, part, ...)         \
  refuse((const turned_point[8]){__VA_ARGS__}, \
         sizeof((const turned_point[]){__VA_ARGS__}) / sizeof(turned_point), gap, shrink, part)

CASE(test_refused) {
  REFUSE(0.01, 0, "1 points", {0, 5, 0});
  REFUSE(0.01, 0, "without a volume", {0, 5, 0}, {0, 4, 0});
  REFUSE(0.01, 0, "without a volume", {0, 0, 0}, {9, 0, 0});
  REFUSE(0.01, 0, "point 1: its height 8 is below the 9", {9, 5, 0}, {8, 5, 0});
  REFUSE(0.01, 0, "point 0: an arc needs", {0, 5, 1}, {8, 5, 0});
  REFUSE(0.01, 0, "point 1: height", {0, 5, 0}, {8, -5, 0});
  REFUSE(0.01, 0, "point 1: height", {0, 5, 0}, {NAN, 5, 0});
  REFUSE(0.01, 0, "point 1: height", {0, 5, 0}, {8, 2e4, 0});
  REFUSE(0.01, 0, "cannot span 8; give a radius of 4 or more", {0, 5, 0}, {8, 5, 3.9});
  REFUSE(0.01, 0, "without length", {0, 5, 0}, {0, 5, 1}, {8, 5, 0});
  REFUSE(0.01, 0, "goes back down", {0, 3, 0}, {1, 5, 1.2});
  REFUSE(0.01, 0, "goes back down", {0, 5, 0}, {1, 3, -1.2});
  REFUSE(0.01, 0, "crosses the axis", {0, 2, 0}, {8, 2, -4.2});
  REFUSE(0.01, 0, "too thin", {0, 5, 0}, {1e-7, 5, 0});
  REFUSE(0.00009, 0, "a gap of", {0, 5, 0}, {8, 5, 0});
  REFUSE(NAN, 0, "a gap of", {0, 5, 0}, {8, 5, 0});
  REFUSE(0.01, -1, "shrunk by -1", {0, 5, 0}, {8, 5, 0});
  REFUSE(0.01, 1e-6, "shrunk by 1e-06", {0, 5, 0}, {8, 5, 0});
  REFUSE(1e-4, 0, "triangles", {0, 0, 0}, {200, 200, 200});
  const turned_point many[8] = {{0, 5, 0}};
  refuse(many, 257, 0.01, 0, "257 points");
}

/* Nothing is left: no triangles, and no error. */
static void expect_nothing(double radius, double height, double shrink) {
  turned_point point[] = {{0, radius, 0}, {height, radius, 0}};
  turned_profile p = {point, 2};
  revolve_how how = {0.01, shrink, false};
  sepax_soup outer;
  sepax_soup inner;
  assert_works(sepax__revolve(&outer, &inner, &p, &how, &fault));
  assert_true(outer.count == 0 && inner.count == 0);
}

CASE(test_nothing_left) {
  expect_nothing(50, 8, 4.5);
  expect_nothing(5, 80, 5.5);
}

/* A flat end mill of diameter 10 at 5 um. */
CASE(test_count) {
  turned_point point[] = {{0, 5, 0}, {25, 5, 0}};
  turned_profile p = {point, 2};
  revolve_how how = {0.005, 0, false};
  sepax_soup outer;
  assert_works(sepax__revolve(&outer, NULL, &p, &how, &fault));
  assert_int_equal(outer.count, 4 * 104);
  sepax_soup_free(&outer);
}
