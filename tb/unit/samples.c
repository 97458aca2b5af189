/* SPDX-License-Identifier: MIT */
/* samples.c - the sample objects. */
#include "oracle/geometry.h"
#include "harness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static point at_corner(const sepax_soup *mesh, size_t facet, size_t k) {
  const double *v = mesh->facet[facet].v[k % 3];
  return (point){{v[0], v[1], v[2]}};
}

static point normal_of(const sepax_soup *mesh, size_t facet) {
  point v = at_corner(mesh, facet, 0);
  return outer(minus(at_corner(mesh, facet, 1), v), minus(at_corner(mesh, facet, 2), v));
}

static point written_normal(const sepax_soup *mesh, size_t facet) {
  const double *n = mesh->normal[facet];
  return (point){{n[0], n[1], n[2]}};
}

/* An edge is two points. */
static int compare_numbers(const double *p, const double *q, int count) {
  for (int i = 0; i < count; i++) {
    if (p[i] < q[i] || p[i] > q[i]) {
      return p[i] < q[i] ? -1 : 1;
    }
  }
  return 0;
}

static int compare_edges(const void *a, const void *b) { return compare_numbers(a, b, 6); }

/* Each directed edge once, and once its opposite; as many corners as a surface of
 * the topology of the sphere has. */
static void assert_closed(const sepax_soup *mesh) {
  size_t edges = 3 * mesh->count;
  size_t corners = 0;
  point(*way)[2] = calloc(edges, sizeof *way);
  assert_non_null(way);
  for (size_t i = 0; i < edges; i++) {
    way[i][0] = at_corner(mesh, i / 3, i % 3);
    way[i][1] = at_corner(mesh, i / 3, i % 3 + 1);
  }
  qsort(way, edges, sizeof *way, compare_edges);
  for (size_t i = 0; i < edges; i++) {
    const point opposite[2] = {way[i][1], way[i][0]};
    corners += i == 0 || compare_numbers(way[i][0].c, way[i - 1][0].c, 3) != 0;
    assert_true(i == 0 || compare_edges(way[i], way[i - 1]) != 0);
    assert_non_null(bsearch(opposite, way, edges, sizeof *way, compare_edges));
  }
  assert_int_equal(2 * corners, mesh->count + 4);
  free(way);
}

/* The normals of the file are those of the corners, and of unit length. */
static void assert_normals(const sepax_soup *mesh) {
  for (size_t i = 0; i < mesh->count; i++) {
    point n = normal_of(mesh, i);
    point written = written_normal(mesh, i);
    assert_true(fabs(inner(written, written) - 1) < 1e-14);
    assert_true(fabs(inner(written, n) / sqrt(inner(n, n)) - 1) < 1e-12);
  }
}

static double volume(const sepax_soup *mesh, point origin) {
  double sum = 0;
  for (size_t i = 0; i < mesh->count; i++) {
    sum += inner(minus(at_corner(mesh, i, 0), origin), normal_of(mesh, i)) / 6;
  }
  return sum;
}

/* A point of the axis or the centre sees every facet of a convex body from inside. */
static void assert_seen_from(const sepax_soup *mesh, point inside) {
  for (size_t i = 0; i < mesh->count; i++) {
    assert_true(inner(minus(at_corner(mesh, i, 0), inside), written_normal(mesh, i)) > 0);
  }
}

static sepax_soup sample(const char *shape, size_t triangles, point at, double size) {
  sepax_soup mesh = {0};
  assert_works(sepax_sample(&mesh, shape, triangles, at.c, size, &fault));
  assert_int_equal(mesh.count, triangles);
  return mesh;
}

static const point origin = {{0, 0, 0}};

CASE(test_sample_meshes) {
  const point at = {{3, -40, 0.5}};
  for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
    size_t least = sepax_sample_least(i);
    const size_t counts[] = {least,      least + 2,  least + 4, least + 6, least + 8,
                             least + 10, least + 40, 500,       1000,      20000};
    for (size_t k = 0; k < LENGTH(counts); k++) {
      sepax_soup mesh = sample(sepax_sample_name(i), counts[k], at, k % 2 == 0 ? 0 : 7);
      assert_closed(&mesh);
      assert_normals(&mesh);
      assert_true(volume(&mesh, at) > 0);
      sepax_soup_free(&mesh);
    }
  }
}

/* z above the centre of the end, r from the axis, for a cutter of radius 1. */
static bool on_cutter(double z, double r, bool ball) {
  const double eps = 1e-13;
  bool end = ball ? z < eps && fabs(sqrt(z * z + r * r) - 1) < eps : fabs(z) < eps && r < 1 + eps;
  bool shank = z > -eps && z < 6 + eps && fabs(r - 1) < eps;
  bool top = fabs(z - 6) < eps && r < 1 + eps;
  return end || shank || top;
}

static void assert_cutter(bool ball, size_t triangles) {
  const point at = {{1, 2, 3}};
  sepax_soup mesh = sample(ball ? "ball-end" : "flat-end", triangles, at, 0);
  double lowest = INFINITY;
  for (size_t i = 0; i < 3 * mesh.count; i++) {
    point v = minus(at_corner(&mesh, i / 3, i % 3), at);
    assert_true(on_cutter(v.c[2] / 10 - (ball ? 1 : 0), hypot(v.c[0], v.c[1]) / 10, ball));
    lowest = fmin(lowest, v.c[2]);
  }
  assert_true(lowest == 0);
  assert_seen_from(&mesh, along(at, 20, (point){{0, 0, 1}}));
  double solid = PI * 1000 * (6 + (ball ? 2.0 / 3 : 0));
  double filled = volume(&mesh, at) / solid;
  assert_true(filled < 1 && filled > 1 - 30.0 / (double)triangles);
  sepax_soup_free(&mesh);
}

CASE(test_cutters) {
  for (size_t triangles = 100; triangles < 30000; triangles = triangles * 3 + 2) {
    assert_cutter(true, triangles);
    assert_cutter(false, triangles);
  }
}

CASE(test_sphere) {
  for (size_t triangles = 8; triangles < 30000; triangles = triangles * 2 + 2) {
    sepax_soup mesh = sample("sphere", triangles, origin, 2);
    for (size_t i = 0; i < 3 * mesh.count; i++) {
      point v = at_corner(&mesh, i / 3, i % 3);
      assert_true(fabs(inner(v, v) - 1) < 1e-14);
    }
    assert_seen_from(&mesh, origin);
    double filled = volume(&mesh, origin) / (PI * 4 / 3);
    assert_true(filled < 1 && filled > 1 - 14.0 / (double)triangles);
    sepax_soup_free(&mesh);
  }
}

/* The boxes of the mesh: low and high by axis. */
static void assert_box(const sepax_soup *mesh, const double low[3], const double high[3]) {
  for (int axis = 0; axis < 3; axis++) {
    double least = INFINITY;
    double most = -INFINITY;
    for (size_t i = 0; i < 3 * mesh->count; i++) {
      least = fmin(least, mesh->facet[i / 3].v[i % 3][axis]);
      most = fmax(most, mesh->facet[i / 3].v[i % 3][axis]);
    }
    assert_true(least == low[axis] && most == high[axis]);
  }
}

CASE(test_blocks) {
  const point at = {{100, 0, -8}};
  sepax_soup mesh = sample("box", 5000, at, 60);
  assert_box(&mesh, (double[3]){70, -20, -18}, (double[3]){130, 20, 2});
  assert_seen_from(&mesh, at);
  assert_true(fabs(volume(&mesh, at) / 48000 - 1) < 1e-12);
  sepax_soup_free(&mesh);
  mesh = sample("pocket", 5000, at, 0);
  assert_box(&mesh, (double[3]){40, -40, -48}, (double[3]){160, 40, -8});
  assert_true(fabs(volume(&mesh, at) / (384000 - 80 * 40 * 25) - 1) < 1e-12);
  sepax_soup_free(&mesh);
}

CASE(test_sample_again) {
  sepax_soup once = sample("ball-end", 4000, origin, 0);
  sepax_soup twice = sample("ball-end", 4000, origin, 20);
  assert_memory_equal(once.facet, twice.facet, once.count * sizeof *once.facet);
  sepax_soup_free(&once);
  sepax_soup_free(&twice);
}

CASE(test_sample_list) {
  const char *names[] = {"ball-end", "flat-end", "pocket", "sphere", "box"};
  for (size_t i = 0; i < 5; i++) {
    assert_string_equal(sepax_sample_name(i), names[i]);
    assert_true(strlen(sepax_sample_about(i)) > 10);
    assert_true(sepax_sample_least(i) >= 4 && sepax_sample_least(i) % 2 == 0);
  }
  assert_null(sepax_sample_name(5));
  assert_null(sepax_sample_about(5));
  assert_int_equal(sepax_sample_least(5), 0);
}

CASE(test_sample_errors) {
  static const struct {
    const char *shape;
    size_t triangles;
    point at;
    double size;
    const char *part;
  } row[] = {
      {"torus",
       100,
       {{0}},
       0,
       "shape: 'torus' is none of: ball-end, flat-end, pocket, sphere, box"},
      {"box", 101, {{0}}, 0, "101 triangles cannot form a closed mesh; ask for an even"},
      {"box", 10, {{0}}, 0, "box: 10 triangles are not in 12 ..."},
      {"box", 0, {{0}}, 0, "not in 12 ..."},
      {"box", SIZE_MAX - 1, {{0}}, 0, "not in 12 ..."},
      {"box", 100, {{0}}, -1, "size: -1 is not a length"},
      {"box", 100, {{0}}, NAN, "size: nan is not a length"},
      {"box", 100, {{0}}, INFINITY, "size: inf is not a length"},
      {"box", 100, {{0, NAN, 0}}, 0, "at: y = nan"},
      {"box", 100, {{0, 0, -1e17}}, 0, "at: z = -1e+17 is too far away for an object of 120 mm"},
      {"box", 100, {{0}}, 1e-170, "some triangles have no area"},
      {"box", 100, {{0}}, 1e200, "some triangles have no area"}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    sepax_soup mesh = {.count = 77};
    assert_fault(
        sepax_sample(&mesh, row[i].shape, row[i].triangles, row[i].at.c, row[i].size, &fault),
        row[i].part);
    assert_true(mesh.facet == NULL && mesh.count == 0);
  }
}

/* A sample survives the file, binary32 included, and the finest grid of 18 bits. */
CASE(test_sample_to_grid) {
  for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
    sepax_soup mesh = sample(sepax_sample_name(i), 2000, origin, 0);
    assert_works(sepax_stl_write(&mesh, path, false, &fault));
    sepax_soup back = read_mesh();
    assert_closed(&back);
    assert_fit((const sepax_soup *const[]){&mesh, &back}, 2, 18);
    sepax_soup_free(&back);
    sepax_soup_free(&mesh);
    remove(path);
  }
}
