/* shapes.c - meshes of all formats, polyhedra around spheres and cylinders, polygons. */
#include "files.h"

#include <math.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

static const sepax_pose at_origin = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static sepax_soup mesh_of(const format_shape *shape) {
  sepax_soup mesh;
  assert_works(format_shape_mesh(&mesh, shape, &fault));
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
        mesh_of(&(format_shape){.kind = FORMAT_SPHERE, .size = {r}, .origin = at_origin});
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
      mesh_of(&(format_shape){.kind = FORMAT_CYLINDER, .size = {0.3, 4}, .origin = at_origin});
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

/* Turned by a quarter about z, then moved. */
CASE(test_box_in_its_place) {
  sepax_soup mesh =
      mesh_of(&(format_shape){.kind = FORMAT_BOX,
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

/* ------------------------------------------------------------------------- formats */

static void expect_mesh(const char *name, const char *text, size_t facets) {
  sepax_soup mesh;
  assert_works(format_mesh_read(&mesh, put_file(name, text), &fault));
  assert_int_equal(mesh.count, facets);
  static const double first[3][3] = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  assert_memory_equal(mesh.facet[0].v, first, sizeof first);
  sepax_soup_free(&mesh);
}

#define PLY(vertices, faces, rest)                                                               \
  "ply\nformat ascii 1.0\nelement vertex " vertices "\nproperty float x\nproperty float y\n"     \
  "property float z\nelement face " faces "\nproperty list uchar int vertex_indices\nend_header" \
  "\n" rest
#define CORNERS "0 0 0\n1 0 0\n0 0.5 0\n1 0.5 0\n"

#define DAE(up, unit, matrix)                                                                      \
  "<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' "            \
  "version='1.4.1'><asset><unit name='u' meter='" unit "'/><up_axis>" up "</up_axis></asset>"      \
  "<library_geometries><geometry id='g'><mesh><source id='p'><float_array id='f' count='9'>"       \
  "0 0 0 1 0 0 0 0.5 0</float_array><technique_common><accessor source='#f' count='3' stride='3'>" \
  "<param name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/>"     \
  "</accessor></technique_common></source><vertices id='v'><input semantic='POSITION' "            \
  "source='#p'/></vertices><triangles count='1'><input semantic='VERTEX' source='#v' offset='0'/>" \
  "<p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>"         \
  "<visual_scene id='s'><node id='n'><matrix>" matrix "</matrix><instance_geometry url='#g'/>"     \
  "</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>" \
  "</COLLADA>"

CASE(test_formats) {
  expect_mesh("p.obj", "v 0 0 0\nv 1 0 0\nv 0 0.5 0\nv 1 0.5 0\nf 1 2 3\nf 2 4 3\n", 2);
  expect_mesh("p.OBJ", "v 0 0 0\nv 1 0 0\nv 0 0.5 0\nf 1 2 3\n", 1);
  expect_mesh("p.ply", PLY("4", "2", CORNERS "3 0 1 2\n3 1 3 2\n"), 2);
  expect_mesh("p.dae", DAE("Y_UP", "1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"), 1);
  expect_mesh("p.dae", DAE("Z_UP", "1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"), 1);
  expect_mesh("p.dae", DAE("Z_UP", "0.5", "2 0 0 0 0 2 0 0 0 0 2 0 0 0 0 1"), 1);
  expect_mesh("p.stl",
              "solid x\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
              "vertex 0 .5 0\nendloop\nendfacet\nendsolid x\n",
              1);
}

/* A node's transformation moves what is in it. */
CASE(test_nodes) {
  sepax_soup mesh;
  assert_works(format_mesh_read(
      &mesh, put_file("p.dae", DAE("Z_UP", "1", "0 -1 0 10 1 0 0 20 0 0 1 30 0 0 0 1")), &fault));
  static const double first[3][3] = {{10, 20, 30}, {10, 21, 30}, {9.5, 20, 30}};
  assert_memory_equal(mesh.facet[0].v, first, sizeof first);
  sepax_soup_free(&mesh);
}

static void refuse_mesh(const char *name, const char *text, const char *part) {
  sepax_soup mesh;
  assert_fault(format_mesh_read(&mesh, put_file(name, text), &fault), part);
  assert_message(name);
  assert_null(mesh.facet);
}

CASE(test_meshes_refused) {
  sepax_soup mesh;
  assert_fault(format_mesh_read(&mesh, in_folder("none.obj"), &fault), "none.obj: No such file");
  refuse_mesh("p.txt", "v 0 0 0\n", "give STL, OBJ, PLY, 3MF or DAE");
  refuse_mesh("p.obj", "", "empty");
  refuse_mesh("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n", "p.obj: ");
  refuse_mesh("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "p.obj: ");
  refuse_mesh("p.obj", "v 0 0 0\nv 1 0 nan\nv 0 1 0\nf 1 2 3\n", "p.obj: ");
  refuse_mesh("p.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\n", "points or lines");
  refuse_mesh("p.ply", "ply\nformat ascii 1.0\n", "p.ply: ");
  refuse_mesh("p.ply", PLY("4", "2", CORNERS "3 0 1 2\n"), "truncated: 5 lines");
  refuse_mesh("p.ply", PLY("4", "2", CORNERS), "truncated: 4 lines");
  refuse_mesh("p.ply", PLY("4", "2", "0 0 0\n1 0 0\n"), "truncated: 2 lines");
  refuse_mesh("p.ply", PLY("4", "99999999999", CORNERS), "no head of a PLY file");
  refuse_mesh("p.3mf", "PK\x03\x04 no archive", "p.3mf: ");
  refuse_mesh("p.dae", "<COLLADA>", "p.dae: ");
  static const char *const units[] = {"0", "-1", "nan", "1e-40", "inf", "x", ""};
  for (size_t n = 0; n < sizeof units / sizeof units[0]; n++) {
    char text[2000];
    snprintf(text, sizeof text, DAE("Z_UP", "%s", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"), units[n]);
    refuse_mesh("p.dae", text, "p.dae:1: <unit meter=");
  }
  refuse_mesh("p.dae", DAE("<unit meter='2'/>Z_UP", "1", "1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1"),
              "a second <unit>, of 2 m after one of 1 m");
  refuse_mesh("p.dae", "<!DOCTYPE x [<!ENTITY a 'aa'><!ENTITY b '&a;&a;'>]><COLLADA>&b;</COLLADA>",
              "it has a document type (<!DOCTYPE>); take it out");
  refuse_mesh("p.stl", "solid x\nfacet", "p.stl: ");
}

/* Limits hold before anything is read. */
CASE(test_long_meshes) {
  sepax_soup mesh;
  const char *at = put_file("p.stl", "solid x\n");
  assert_int_equal(truncate(at, ((off_t)1 << 30) + 1), 0);
  assert_fault(format_mesh_read(&mesh, at, &fault), "p.stl: longer than 1 GiB");
  unsigned char head[84] = {0};
  for (int n = 0; n < 4; n++) {
    head[80 + n] = (unsigned char)((FORMAT_FACETS_MOST + 1) >> 8 * n & 0xff);
  }
  at = put_bytes("p.stl", (const char *)head, sizeof head);
  assert_int_equal(truncate(at, 84 + 50 * ((off_t)FORMAT_FACETS_MOST + 1)), 0);
  assert_fault(format_mesh_read(&mesh, at, &fault),
               "p.stl: 20000001 triangles, more than 20000000");
  at = in_folder("pipe.stl");
  assert_int_equal(mkfifo(at, 0600), 0);
  assert_fault(format_mesh_read(&mesh, at, &fault), "pipe.stl: no file, or empty");
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
  assert_true(format_distinct(&mesh));
  static const int order[] = {0, 1, 3, 4, 5};
  assert_int_equal(mesh.count, 5);
  for (size_t n = 0; n < 4; n++) {
    assert_memory_equal(mesh.facet[n].v, triangle[order[n]], sizeof *triangle);
  }
  assert_true(mesh.facet[4].v[2][2] == 3);
  for (size_t n = 0; n < 5; n++) {
    mesh.facet[n].v[0][0] += (double)n;
  }
  assert_true(format_distinct(&mesh));
  assert_int_equal(mesh.count, 5);
  sepax_soup_free(&mesh);
}

/* ------------------------------------------------------------------------ polygons */

CASE(test_polygons) {
  static const double square[4][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
  static const double arrow[4][3] = {{0, 0, 0}, {2, 1, 0}, {0, 2, 0}, {1, 1, 0}};
  static const double comb[8][3] = {{0, 0, 0}, {5, 0, 0}, {5, 3, 0}, {4, 3, 0},
                                    {4, 1, 0}, {1, 1, 0}, {1, 3, 0}, {0, 3, 0}};
  size_t triangle[6][3];
  assert_true(format_polygon_divide(square, 4, triangle));
  assert_int_equal(triangle[0][0], 0);
  assert_true(format_polygon_divide(arrow, 4, triangle));
  assert_int_equal(triangle[0][0] % 2, 1); /* not along the side that is hollow */
  assert_false(format_polygon_divide(comb, 8, triangle));
}
