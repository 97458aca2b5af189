/* SPDX-License-Identifier: MIT */
/* shapes.c - polyhedra around spheres, cylinders and capsules; places; triangles that are there
 * twice. */
#include "files.h"
#include "robot/robot.h"

#include <math.h>

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static sepax_soup mesh_of(const sepax_shape *shape) {
  sepax_soup mesh;
  report_mesh said;
  static const cli_meshes rules = {.unit = CLI_METRES};
  assert_works(format_shape_mesh(&mesh, &said, shape, &rules, &fault));
  return mesh;
}

/* Closed, consistent, turned outward. */
static void assert_solid(const sepax_soup *mesh, double volume, double tolerance) {
  sepax_body *body;
  sepax_shell shell;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(mesh), NULL, &fault));
  assert_works(sepax_shell_find(&shell, body, &fault));
  assert_true(shell.closed);
  assert_true(shell.consistent);
  assert_int_equal(shell.parts, 1);
  double sum = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    const double(*v)[3] = mesh->facet[n].v;
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      sum += v[0][i] * (v[1][j] * v[2][k] - v[1][k] * v[2][j]) / 6;
    }
  }
  assert_true(fabs(sum - volume) <= tolerance * volume);
  sepax_shell_free(&shell);
  sepax_body_free(body);
}

static double plane_height(const double v[3][3]) {
  double normal[3];
  double above = 0;
  double square = 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    normal[i] =
        (v[1][j] - v[0][j]) * (v[2][k] - v[0][k]) - (v[1][k] - v[0][k]) * (v[2][j] - v[0][j]);
    above += normal[i] * v[0][i];
    square += normal[i] * normal[i];
  }
  return fabs(above) / sqrt(square);
}

CASE(test_sphere) {
  static const double radii[] = {1, 0.05, 1e-6, 777.7};
  for (size_t n = 0; n < LENGTH(radii); n++) {
    double r = radii[n];
    sepax_soup mesh =
        mesh_of(&(sepax_shape){.kind = SEPAX_SHAPE_SPHERE, .size = {r}, .origin = at_origin});
    assert_solid(&mesh, 4.0 / 3 * PI * r * r * r, 0.005);
    for (size_t k = 0; k < mesh.count; k++) {
      assert_true(plane_height(mesh.facet[k].v) >= r);
      for (int i = 0; i < 3; i++) {
        const double *v = mesh.facet[k].v[i];
        assert_true(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]) <= 1.0025 * r);
      }
    }
    sepax_soup_free(&mesh);
  }
}

CASE(test_cylinder) {
  sepax_soup mesh =
      mesh_of(&(sepax_shape){.kind = SEPAX_SHAPE_CYLINDER, .size = {0.3, 4}, .origin = at_origin});
  assert_solid(&mesh, PI * 0.09 * 4, 0.002);
  for (size_t k = 0; k < mesh.count; k++) {
    const double(*v)[3] = mesh.facet[k].v;
    bool cap = v[0][2] == v[1][2] && v[1][2] == v[2][2];
    assert_true(plane_height(v) >= (cap ? 2 : 0.3));
    for (int i = 0; i < 3; i++) {
      assert_true(sqrt(v[i][0] * v[i][0] + v[i][1] * v[i][1]) <= 1.0013 * 0.3);
      assert_true(fabs(v[i][2]) == 2);
    }
  }
  sepax_soup_free(&mesh);
}

/* Points of a capsule of radius r, whose axis goes from -half to half: none is outside the facets
 * that it is behind, seen from the nearest point of the axis; corners are near the surface. */
static void check_capsule(double r, double length) {
  sepax_soup mesh = mesh_of(
      &(sepax_shape){.kind = SEPAX_SHAPE_CAPSULE, .size = {r, length}, .origin = at_origin});
  double half = length / 2;
  assert_solid(&mesh, PI * r * r * length + 4.0 / 3 * PI * r * r * r, 0.005);
  for (size_t k = 0; k < mesh.count; k++) {
    double v[3][3];
    memcpy(v, mesh.facet[k].v, sizeof v);
    bool above = v[0][2] + v[1][2] + v[2][2] > 0;
    bool side = v[0][2] * v[1][2] < 0 || v[1][2] * v[2][2] < 0;
    for (int i = 0; i < 3; i++) {
      double z = fmax(fabs(v[i][2]) - half, 0);
      double out = sqrt(v[i][0] * v[i][0] + v[i][1] * v[i][1] + z * z);
      assert_true(out >= r && out <= 1.0025 * r + 1e-9 * length);
      assert_true(!side || fabs(v[i][2]) >= half);
      v[i][2] -= side ? 0 : above ? half : -half;
    }
    assert_true(plane_height((const double(*)[3])v) >= r * (1 - 1e-9));
  }
  sepax_soup_free(&mesh);
}

CASE(test_capsule) {
  check_capsule(0.1, 1);
  check_capsule(3, 0.01);
  check_capsule(777, 1e4);
  sepax_soup ball =
      mesh_of(&(sepax_shape){.kind = SEPAX_SHAPE_CAPSULE, .size = {2, 0}, .origin = at_origin});
  sepax_soup sphere =
      mesh_of(&(sepax_shape){.kind = SEPAX_SHAPE_SPHERE, .size = {2}, .origin = at_origin});
  assert_int_equal(ball.count, sphere.count);
  assert_memory_equal(ball.facet, sphere.facet, ball.count * sizeof *ball.facet);
  sepax_soup_free(&ball);
  sepax_soup_free(&sphere);
}

/* Points of the surface of a long and thin capsule, whose coordinates are rounded most, are inside
 * its polyhedron. */
CASE(test_capsule_holds) {
  static const double sizes[][2] = {{1e-6, 1e6}, {1, 1e6}, {1e3, 1e-6}, {0.1, 1}};
  for (size_t n = 0; n < LENGTH(sizes); n++) {
    double r = sizes[n][0];
    double half = sizes[n][1] / 2;
    sepax_soup mesh = mesh_of(
        &(sepax_shape){.kind = SEPAX_SHAPE_CAPSULE, .size = {r, sizes[n][1]}, .origin = at_origin});
    double top = -INFINITY;
    double rim = INFINITY;
    for (size_t k = 0; k < 3 * mesh.count; k++) {
      const double *v = mesh.facet[k / 3].v[k % 3];
      top = fmax(top, v[2]);
      if (fabs(v[0]) < 1e-3 * r || fabs(v[1]) < 1e-3 * r) {
        double z = fabs(v[2]) - half;
        rim = fmin(rim, z);
      }
    }
    assert_true(top >= half + r * (1 - 0x1p-30) && rim > 0);
    sepax_soup_free(&mesh);
  }
}

/* Turned by a quarter about z, then moved. */
CASE(test_box_in_its_place) {
  sepax_soup mesh =
      mesh_of(&(sepax_shape){.kind = SEPAX_SHAPE_BOX,
                             .size = {2, 4, 6},
                             .origin = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}, {10, 0, 0}}});
  double least[3] = {INFINITY, INFINITY, INFINITY};
  double most[3] = {-INFINITY, -INFINITY, -INFINITY};
  assert_solid(&mesh, 48, 1e-15);
  for (size_t k = 0; k < 9 * mesh.count; k++) {
    double x = mesh.facet[k / 9].v[k % 9 / 3][k % 3];
    least[k % 3] = fmin(least[k % 3], x);
    most[k % 3] = fmax(most[k % 3], x);
  }
  assert_true(least[0] == 8 && most[0] == 12 && least[1] == -1 && most[1] == 1);
  assert_true(least[2] == -3 && most[2] == 3);
  sepax_soup_free(&mesh);
}

/* Each face anticlockwise, as seen from outside. */
#define BOX_OBJ                                                                                    \
  "v 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nv 0 0 3\nv 1 0 3\nv 1 2 3\nv 0 2 3\nf 4 3 2 1\nf 5 6 7 8\n" \
  "f 1 2 6 5\nf 2 3 7 6\nf 3 4 8 7\nf 4 1 5 8\n"

/* A scale that mirrors leaves outer sides outside. */
CASE(test_mirrored_meshes) {
  char file[400];
  snprintf(file, sizeof file, "%s", put_file("box.obj", BOX_OBJ));
  for (int n = 0; n < 8; n++) {
    const sepax_shape shape = {
        .kind = SEPAX_SHAPE_MESH,
        .path = file,
        .size = {(n & 1) != 0 ? -1 : 1, (n & 2) != 0 ? -2 : 2, (n & 4) != 0 ? -0.5 : 0.5},
        .origin = at_origin};
    sepax_soup mesh = mesh_of(&shape);
    assert_solid(&mesh, 6, 1e-15);
    sepax_soup_free(&mesh);
  }
}

/* Many triangles in one place: one of each three corners stays, in whatever order they are. */
CASE(test_distinct) {
  enum { COUNT = 300000 };
  static const double triangle[6][3][3] = {
      {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}},       {{2, 2, 2}, {2, 2, 2}, {2, 2, 2}},
      {{0, 1, 0}, {-0.0, 0, 0}, {1, 0, -0.0}}, {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}},
      {{1, 0, 0}, {0, 0, 0}, {1, 0, 0}},       {{1, 0, 0}, {0, 0, 0}, {0, 0, 0}}};
  sepax_soup mesh = {.facet = calloc(COUNT, sizeof *mesh.facet), .count = COUNT};
  assert_non_null(mesh.facet);
  for (size_t n = 0; n < COUNT; n++) {
    memcpy(mesh.facet[n].v, triangle[n % 6], sizeof *triangle);
  }
  mesh.facet[COUNT - 1].v[2][2] = 3;
  assert_true(sepax__distinct(&mesh));
  static const int order[] = {0, 1, 3, 4, 5};
  assert_int_equal(mesh.count, 5);
  for (size_t n = 0; n < 4; n++) {
    assert_memory_equal(mesh.facet[n].v, triangle[order[n]], sizeof *triangle);
  }
  assert_true(mesh.facet[4].v[2][2] == 3);
  for (size_t n = 0; n < 5; n++) {
    mesh.facet[n].v[0][0] += (double)n;
  }
  assert_true(sepax__distinct(&mesh));
  assert_int_equal(mesh.count, 5);
  sepax_soup_free(&mesh);
}
