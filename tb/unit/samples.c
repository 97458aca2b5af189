/* samples.c - the sample objects. */
#include "harness.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  double p[3];
} point;

static int compare_points(const void *a, const void *b) {
  const point *p = a;
  const point *q = b;
  for (int i = 0; i < 3; i++) {
    if (p->p[i] < q->p[i] || p->p[i] > q->p[i]) {
      return p->p[i] < q->p[i] ? -1 : 1;
    }
  }
  return 0;
}

static int compare_edges(const void *a, const void *b) {
  const size_t *e = a;
  const size_t *f = b;
  for (int i = 0; i < 2; i++) {
    if (e[i] != f[i]) {
      return e[i] < f[i] ? -1 : 1;
    }
  }
  return 0;
}

/* The distinct corners of the mesh in ascending order; their number is returned. */
static size_t find_corners(point **corners, const sepax_mesh *mesh) {
  size_t count = 0;
  point *all = malloc(3 * mesh->count * sizeof *all);
  assert_non_null(all);
  for (size_t i = 0; i < 3 * mesh->count; i++) {
    memcpy(all[i].p, mesh->facet[i / 3].v[i % 3], sizeof all[i].p);
  }
  qsort(all, 3 * mesh->count, sizeof *all, compare_points);
  for (size_t i = 0; i < 3 * mesh->count; i++) {
    if (count == 0 || compare_points(&all[i], &all[count - 1]) != 0) {
      all[count++] = all[i];
    }
  }
  *corners = all;
  return count;
}

/* Each directed edge once, and once its opposite; as many corners as a surface of
 * the topology of the sphere has. */
static void assert_closed(const sepax_mesh *mesh) {
  point *corners = NULL;
  size_t count = find_corners(&corners, mesh);
  assert_int_equal(2 * count, mesh->count + 4);
  size_t edges = 3 * mesh->count;
  size_t(*edge)[2] = malloc(edges * sizeof *edge);
  assert_non_null(edge);
  for (size_t i = 0; i < edges; i++) {
    for (size_t k = 0; k < 2; k++) {
      const double *v = mesh->facet[i / 3].v[(i % 3 + k) % 3];
      const point *found = bsearch(v, corners, count, sizeof *corners, compare_points);
      assert_non_null(found);
      edge[i][k] = (size_t)(found - corners);
    }
  }
  qsort(edge, edges, sizeof *edge, compare_edges);
  for (size_t i = 0; i < edges; i++) {
    const size_t opposite[2] = {edge[i][1], edge[i][0]};
    assert_true(i == 0 || compare_edges(edge[i], edge[i - 1]) != 0);
    assert_non_null(bsearch(opposite, edge, edges, sizeof *edge, compare_edges));
  }
  free(edge);
  free(corners);
}

static double dot(const double a[3], const double b[3]) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross_edges(double n[3], const sepax_facet *facet) {
  double e[2][3];
  for (int i = 0; i < 3; i++) {
    e[0][i] = facet->v[1][i] - facet->v[0][i];
    e[1][i] = facet->v[2][i] - facet->v[0][i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    n[i] = e[0][j] * e[1][k] - e[0][k] * e[1][j];
  }
}

/* The normals of the file are those of the corners, and of unit length. */
static void assert_normals(const sepax_mesh *mesh) {
  for (size_t i = 0; i < mesh->count; i++) {
    const sepax_facet *facet = &mesh->facet[i];
    double n[3];
    cross_edges(n, facet);
    assert_true(fabs(dot(facet->normal, facet->normal) - 1) < 1e-14);
    assert_true(fabs(dot(facet->normal, n) / sqrt(dot(n, n)) - 1) < 1e-12);
  }
}

static double volume(const sepax_mesh *mesh, const double origin[3]) {
  double sum = 0;
  for (size_t i = 0; i < mesh->count; i++) {
    const sepax_facet *facet = &mesh->facet[i];
    double n[3];
    double v[3];
    cross_edges(n, facet);
    for (int k = 0; k < 3; k++) {
      v[k] = facet->v[0][k] - origin[k];
    }
    sum += dot(v, n) / 6;
  }
  return sum;
}

/* A point of the axis or the centre sees every facet of a convex body from inside. */
static void assert_seen_from(const sepax_mesh *mesh, const double inside[3]) {
  for (size_t i = 0; i < mesh->count; i++) {
    double v[3];
    for (int k = 0; k < 3; k++) {
      v[k] = mesh->facet[i].v[0][k] - inside[k];
    }
    assert_true(dot(v, mesh->facet[i].normal) > 0);
  }
}

static sepax_mesh sample(const char *shape, size_t triangles, const double at[3], double size) {
  sepax_mesh mesh = {0};
  if (!sepax_sample(&mesh, shape, triangles, at, size, &fault)) {
    fail_msg("%s", fault.text);
  }
  assert_int_equal(mesh.count, triangles);
  return mesh;
}

static const double origin[3] = {0, 0, 0};

CASE(test_sample_meshes) {
  const double at[3] = {3, -40, 0.5};
  for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
    size_t least = sepax_sample_least(i);
    const size_t counts[] = {least,      least + 2,  least + 4, least + 6, least + 8,
                             least + 10, least + 40, 500,       1000,      20000};
    for (size_t k = 0; k < LENGTH(counts); k++) {
      sepax_mesh mesh = sample(sepax_sample_name(i), counts[k], at, k % 2 == 0 ? 0 : 7);
      assert_closed(&mesh);
      assert_normals(&mesh);
      assert_true(volume(&mesh, at) > 0);
      sepax_mesh_free(&mesh);
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
  const double at[3] = {1, 2, 3};
  const double inside[3] = {1, 2, 3 + 20};
  sepax_mesh mesh = sample(ball ? "ball-end" : "flat-end", triangles, at, 0);
  double lowest = INFINITY;
  for (size_t i = 0; i < 3 * mesh.count; i++) {
    const double *v = mesh.facet[i / 3].v[i % 3];
    double r = sqrt((v[0] - 1) * (v[0] - 1) + (v[1] - 2) * (v[1] - 2)) / 10;
    assert_true(on_cutter((v[2] - 3) / 10 - (ball ? 1 : 0), r, ball));
    lowest = fmin(lowest, v[2]);
  }
  assert_true(lowest == 3);
  assert_seen_from(&mesh, inside);
  double solid = PI * 1000 * (6 + (ball ? 2.0 / 3 : 0));
  double filled = volume(&mesh, at) / solid;
  assert_true(filled < 1 && filled > 1 - 30.0 / (double)triangles);
  sepax_mesh_free(&mesh);
}

CASE(test_cutters) {
  for (size_t triangles = 100; triangles < 30000; triangles = triangles * 3 + 2) {
    assert_cutter(true, triangles);
    assert_cutter(false, triangles);
  }
}

CASE(test_sphere) {
  for (size_t triangles = 8; triangles < 30000; triangles = triangles * 2 + 2) {
    sepax_mesh mesh = sample("sphere", triangles, origin, 2);
    for (size_t i = 0; i < 3 * mesh.count; i++) {
      const double *v = mesh.facet[i / 3].v[i % 3];
      assert_true(fabs(dot(v, v) - 1) < 1e-14);
    }
    assert_seen_from(&mesh, origin);
    double filled = volume(&mesh, origin) / (PI * 4 / 3);
    assert_true(filled < 1 && filled > 1 - 14.0 / (double)triangles);
    sepax_mesh_free(&mesh);
  }
}

/* The boxes of the mesh: low and high by axis. */
static void assert_box(const sepax_mesh *mesh, const double low[3], const double high[3]) {
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
  const double at[3] = {100, 0, -8};
  sepax_mesh mesh = sample("box", 5000, at, 60);
  assert_box(&mesh, (double[3]){70, -20, -18}, (double[3]){130, 20, 2});
  assert_seen_from(&mesh, at);
  assert_true(fabs(volume(&mesh, at) / 48000 - 1) < 1e-12);
  sepax_mesh_free(&mesh);
  mesh = sample("pocket", 5000, at, 0);
  assert_box(&mesh, (double[3]){40, -40, -48}, (double[3]){160, 40, -8});
  assert_true(fabs(volume(&mesh, at) / (384000 - 80 * 40 * 25) - 1) < 1e-12);
  sepax_mesh_free(&mesh);
}

CASE(test_sample_again) {
  sepax_mesh once = sample("ball-end", 4000, origin, 0);
  sepax_mesh twice = sample("ball-end", 4000, origin, 20);
  assert_memory_equal(once.facet, twice.facet, once.count * sizeof *once.facet);
  sepax_mesh_free(&once);
  sepax_mesh_free(&twice);
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

static void refuse_sample(const char *shape, size_t triangles, const double at[3], double size,
                          const char *part) {
  sepax_mesh mesh = {.count = 77};
  assert_false(sepax_sample(&mesh, shape, triangles, at, size, &fault));
  assert_message(part);
  assert_null(mesh.facet);
  assert_int_equal(mesh.count, 77);
}

CASE(test_sample_errors) {
  const double far[3] = {0, 0, -1e17};
  const double nowhere[3] = {0, NAN, 0};
  refuse_sample("torus", 100, origin, 0,
                "shape: 'torus' is none of: ball-end, flat-end, pocket, sphere, box");
  refuse_sample("box", 101, origin, 0, "101 triangles close no mesh; ask for an even");
  refuse_sample("box", 10, origin, 0, "box: 10 triangles are not in 12 ...");
  refuse_sample("box", 0, origin, 0, "not in 12 ...");
  refuse_sample("box", SIZE_MAX - 1, origin, 0, "not in 12 ...");
  refuse_sample("box", 100, origin, -1, "size: -1 is not a length");
  refuse_sample("box", 100, origin, NAN, "size: nan is not a length");
  refuse_sample("box", 100, origin, INFINITY, "size: inf is not a length");
  refuse_sample("box", 100, nowhere, 0, "at: y = nan");
  refuse_sample("box", 100, far, 0, "at: z = -1e+17 is too far away for an object of 120 mm");
  refuse_sample("box", 100, origin, 1e-170, "triangles of no area");
  refuse_sample("box", 100, origin, 1e200, "triangles of no area");
}

/* A sample survives the file, binary32 included, and the finest grid of 18 bits. */
CASE(test_sample_to_grid) {
  for (size_t i = 0; sepax_sample_name(i) != NULL; i++) {
    sepax_mesh mesh = sample(sepax_sample_name(i), 2000, origin, 0);
    assert_true(sepax_stl_write(&mesh, path, false, &fault));
    sepax_mesh back = read_mesh();
    assert_closed(&back);
    assert_fit((const sepax_mesh *const[]){&mesh, &back}, 2, 18);
    sepax_mesh_free(&back);
    sepax_mesh_free(&mesh);
    remove(path);
  }
}
