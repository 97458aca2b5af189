/* SPDX-License-Identifier: MIT */
/* effort.c - the units of work that searches for distances take: what takes more costs time, and no
 * answer shows it. And what a search with a limit of work says of pairs that it gave up. */
#define sepax_bodies_distance bodies_distance_of_test
#include "distance/closest.c" /* NOLINT(bugprone-suspicious-include): compiled once more */

#include "harness.h"
#include "sepax_models.h"
#include "unit/body/draws.h"

/* -------------------------------------------------------------------- pairs given up */

/* More pairs than fit may be the nearest. The bound that is left is not above any of them, in
 * whatever order they come. */
CASE(pairs_given_up) {
  enum { PAIRS = KEPT + 8 };
  for (uint32_t lowest = 0; lowest < PAIRS; lowest++) {
    sepax_distance_result best = {.min_distance = INFINITY};
    nearest_pairs n = {.limit = INFINITY, .best = &best};
    search s = {.context = &n, .limit = INFINITY, .open = INFINITY, .best_first = true};
    for (uint32_t k = 0; k < PAIRS; k++) {
      const uint32_t at[2] = {k, k};
      keep(&s, at, k == lowest ? 0.75 : 0.875, 1);
    }
    assert_true(n.given_up);
    assert_true(least_of(&s, &n) <= 0.75);
  }
}

/* ---------------------------------------------------------------------------- effort */

static sepax_body *sample(const char *shape, size_t count, double size) {
  const double origin[3] = {0, 0, 0};
  sepax_soup mesh;
  sepax_body *body;
  assert_works(sepax_sample(&mesh, shape, count, origin, size, &fault));
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
  sepax_soup_free(&mesh);
  return body;
}

/* A plate of side 1, two triangles a cell. */
static sepax_body *plate(size_t side) {
  sepax_soup mesh = {.facet = calloc(2 * side * side, sizeof(sepax_facet)),
                     .count = 2 * side * side};
  assert_non_null(mesh.facet);
  static const size_t corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
  for (size_t n = 0; n < mesh.count; n++) {
    const size_t cell[2] = {n / 2 % side, n / 2 / side};
    for (int k = 0; k < 3; k++) {
      double *v = mesh.facet[n].v[k];
      for (int i = 0; i < 2; i++) {
        v[i] = (double)(cell[i] + corner[n % 2][k][i]) / (double)side;
      }
    }
  }
  sepax_body *body;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
  free(mesh.facet);
  return body;
}

/* The mean units of distances in some poses of B along a way, without vector instructions, so that
 * they are the same on every computer. */
static double effort(const sepax_body *a, const sepax_body *b, const double way[3], bool is_turned,
                     double relative) {
  enum { POSES = 20 };
  uint64_t sum = 0;
  for (int n = 0; n < POSES; n++) {
    sepax_pose pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    if (is_turned) {
      pose = turned(1, 0.11 * n, 0.07 * n, 0.3);
    }
    for (int i = 0; i < 3; i++) {
      pose.translation[i] = way[i] * (1 + 0.1 * n);
    }
    const sepax_distance_request request = {
        .size = sizeof request, .relative = relative, .simd = SEPAX_SIMD_PORTABLE};
    sepax_distance_result found;
    assert_works(sepax_bodies_distance(a, NULL, b, &pose, &request, &found, &fault));
    sum += found.work;
  }
  return (double)sum / POSES;
}

/* Bounds are 5 % above what the search takes. */
CASE(effort_of_distances) {
  enum { SPHERE, BOX, POCKET, TOOL, PLATE, SMALL_PLATE, TINY, BODIES };
  sepax_body *const body[BODIES] = {sample("sphere", 4000, 1),
                                    sample("box", 500, 1),
                                    sample("pocket", 3000, 1),
                                    sample("ball-end", 1000, 0.2),
                                    plate(64),
                                    plate(9),
                                    sample("sphere", 1000, 1e-6)};
  static const struct {
    const char *name;
    int a, b;
    double way[3];
    bool is_turned;
    double relative;
    double most; /* mean units */
  } scenes[] = {{"spheres", SPHERE, SPHERE, {0, 0, 3}, true, 0, 627},
                {"sphere and box", SPHERE, BOX, {0, 0, 3}, true, 0, 366},
                {"box and sphere", BOX, SPHERE, {0, 0, 3}, true, 0, 1203},
                {"pocket and tool", POCKET, TOOL, {0, 0, 2}, true, 1e-6, 976},
                {"pocket and its copy", POCKET, POCKET, {0.7, 0.3, 0.5}, false, 0, 164},
                {"plates", PLATE, SMALL_PLATE, {0.1, 0, 0.01}, false, 0, 140},
                {"edge of a plate", PLATE, SPHERE, {2, 0.5, 0.4}, true, 0, 771},
                {"tiny and far", TINY, TINY, {0.6, 0.2, 0.3}, true, 0, 25472},
                {"plate and tool", PLATE, TOOL, {0.3, 0.5, 0.3}, true, 1e-3, 598}};
  for (size_t n = 0; n < LENGTH(scenes); n++) {
    double units = effort(body[scenes[n].a], body[scenes[n].b], scenes[n].way, scenes[n].is_turned,
                          scenes[n].relative);
    if (!(units <= scenes[n].most)) {
      fail_msg("%s: %.1f units of work, not %.1f or less", scenes[n].name, units, scenes[n].most);
    }
  }
  for (int n = 0; n < BODIES; n++) {
    sepax_body_free(body[n]);
  }
}
