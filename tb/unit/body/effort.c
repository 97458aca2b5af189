/* SPDX-License-Identifier: MIT */
/* effort.c - the units of work that searches for distances take: what takes more costs time, and no
 * answer shows it. And what a search with a limit of work says of pairs that it gave up. */
#define sepax_bodies_distance bodies_distance_of_test
#include "distance/closest.c" /* NOLINT(bugprone-suspicious-include): compiled once more */

#include "harness.h"
#include "sepax_models.h"
#include "unit/body/draws.h"

/* ---------------------------------------------------------------------------- bodies */

static sepax_body *sample(const char *shape, size_t count, double size) {
  const double origin[3] = {0, 0, 0};
  sepax_soup mesh;
  sepax_body *body;
  assert_works(sepax_sample(&mesh, shape, count, origin, size, &fault));
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
  sepax_soup_free(&mesh);
  return body;
}

/* Plates of side 1, two triangles a cell: on axes 0 and 1, then on 1 and 2, and on 2 and 0; then
 * the same opposite, so that six are a cube. */
static sepax_body *plates(size_t side, size_t count) {
  const size_t each = 2 * side * side;
  sepax_soup mesh = {.facet = calloc(count * each, sizeof(sepax_facet)), .count = count * each};
  assert_non_null(mesh.facet);
  static const size_t corner[2][3][2] = {{{0, 0}, {1, 0}, {1, 1}}, {{0, 0}, {1, 1}, {0, 1}}};
  for (size_t n = 0; n < mesh.count; n++) {
    const size_t cell[2] = {n % each / 2 % side, n % each / 2 / side};
    for (int k = 0; k < 3; k++) {
      double *v = mesh.facet[n].v[k];
      for (size_t i = 0; i < 2; i++) {
        v[(n / each + i) % 3] = (double)(cell[i] + corner[n % 2][k][i]) / (double)side;
      }
      v[(n / each + 2) % 3] = n / each < 3 ? 0 : 1;
    }
  }
  sepax_body *body;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
  free(mesh.facet);
  return body;
}

/* -------------------------------------------------------------------- pairs given up */

/* More pairs than fit may be the nearest. The bound that is left is not above any of them, in
 * whatever order they come. */
CASE(pairs_given_up) {
  enum { PAIRS = KEPT + 8 };
  sepax_body *const body = plates(1, 1);
  for (uint32_t lowest = 0; lowest < PAIRS; lowest++) {
    sepax_distance_result best = {.min_distance = INFINITY};
    nearest_pairs n = {.limit = INFINITY, .best = &best};
    search s = {.body = {body, body},
                .context = &n,
                .limit = INFINITY,
                .open = INFINITY,
                .best_first = true};
    for (uint32_t k = 0; k < PAIRS; k++) {
      const uint32_t at[2] = {k, k};
      keep(&s, at, k == lowest ? 0.75 : 0.875, 1);
    }
    assert_true(n.given_up);
    assert_true(least_of(&s, &n) <= 0.75);
  }
  sepax_body_free(body);
}

/* ---------------------------------------------------------------------------- effort */

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
  sepax_body *const body[BODIES] = {
      sample("sphere", 4000, 1),     sample("box", 500, 1), sample("pocket", 3000, 1),
      sample("ball-end", 1000, 0.2), plates(64, 1),         plates(9, 1),
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

/* Faces that doubles cannot tell from touching: thousands of triangles are equally near, and a few
 * exact tests do for all. Bounds are 5 % above what the search takes. */
CASE(effort_in_contact) {
  sepax_body *const body[] = {plates(64, 1), plates(40, 3), plates(40, 6)};
  static const struct {
    const char *name;
    int body;
    double way[3];
    double distance;
    uint64_t most;
  } scenes[] = {{"plates, touching", 0, {0.1, 0.07, 0}, 0, 78},
                {"plates", 0, {0.1, 0.07, 0x1p-56}, 0x1p-56, 84},
                {"plates, aligned", 0, {0, 0, 0x1p-56}, 0x1p-56, 84},
                {"three sides", 1, {0x1p-56, 0x1p-56, 0x1p-56}, 0x1p-56, 12630},
                {"cubes, aligned", 2, {0, 0, 1 + 0x1p-52}, 0x1p-52, 88},
                {"cubes", 2, {0.1, 0.07, 1 + 0x1p-52}, 0x1p-52, 564}};
  for (size_t n = 0; n < LENGTH(scenes); n++) {
    sepax_body *const b = body[scenes[n].body];
    sepax_pose pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    for (int i = 0; i < 3; i++) {
      pose.translation[i] = scenes[n].way[i];
    }
    const sepax_distance_request request = {
        .size = sizeof request, .relative = 1e-6, .simd = SEPAX_SIMD_PORTABLE};
    sepax_distance_result found;
    assert_works(sepax_bodies_distance(b, NULL, b, &pose, &request, &found, &fault));
    assert_true(found.min_distance == scenes[n].distance);
    assert_true(found.least >= scenes[n].distance * (1 - 1e-6));
    if (found.work > scenes[n].most) {
      fail_msg("%s: %lu units of work, not %lu or less", scenes[n].name, (unsigned long)found.work,
               (unsigned long)scenes[n].most);
    }
  }
  for (size_t n = 0; n < LENGTH(body); n++) {
    sepax_body_free(body[n]);
  }
}

/* Parallel faces on three sides that are farther apart than asked by a unit in the last place: a
 * direction of each does for all its triangles. The bound is 5 % above what the search takes. */
CASE(effort_at_the_limit) {
  sepax_body *const b = plates(40, 3);
  const double limit = 0.04;
  const double way = nextafter(limit, 1);
  const sepax_pose pose = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {way, way, way}};
  const sepax_apart_request request = {.size = sizeof request, .simd = SEPAX_SIMD_PORTABLE};
  sepax_apart_result found;
  assert_works(sepax_bodies_apart(b, NULL, b, &pose, limit, &request, &found, &fault));
  assert_int_equal(found.verdict, SEPAX_APART);
  if (found.work > 6460) {
    fail_msg("%lu units of work, not 6460 or less", (unsigned long)found.work);
  }
  assert_works(sepax_bodies_apart(b, NULL, b, &pose, way, &request, &found, &fault));
  assert_int_equal(found.verdict, SEPAX_NEAR);
  sepax_body_free(b);
}
