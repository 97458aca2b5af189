/* SPDX-License-Identifier: MIT */
/* read.c - the door of the mesh readers: the format by content, units, limits, options. */
#include "unit/formats/files.h"
#include "sepax_io.h"

#include <math.h>

#define FACET                                                                    \
  "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0.1\n" \
  "endloop\nendfacet\n"
static const char stl[] = "solid a\n" FACET FACET "endsolid\n";
static const char obj[] = "v 0 0 0\nv 1 0 0\nv 0 1 0.1\nf 1 2 3\n";
static const char ply[] = "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\n"
                          "property double y\nproperty double z\nelement face 1\n"
                          "property list uchar int vertex_indices\nend_header\n"
                          "0 0 0\n1 0 0\n0 1 0.1\n3 0 1 2\n";

static void assert_format(const char *name, const char *text, const char *format,
                          size_t triangles) {
  sepax_soup soup;
  sepax_mesh_account account;
  assert_works(sepax_mesh_read(&soup, &account, put_file(name, text), NULL, &fault));
  assert_string_equal(account.format, format);
  assert_int_equal(account.triangles, triangles);
  assert_int_equal(soup.count, triangles);
  assert_int_equal(account.faces, triangles);
  assert_null(soup.normal);
  assert_true(soup.facet[0].v[2][2] == 0.1);
  sepax_soup_free(&soup);
}

CASE(the_content_says_which_format_it_is) {
  static const char *const names[] = {"a.stl", "a.obj", "a.ply", "a.3mf", "a.dae", "a"};
  for (int n = 0; n < 6; n++) {
    assert_format(names[n], stl, "STL", 2);
    assert_format(names[n], ply, "PLY", 1);
  }
  assert_format("a.obj", obj, "OBJ", 1);
  assert_format("A.OBJ", obj, "OBJ", 1);
}

static void assert_refused(const char *name, const char *text, const sepax_mesh_reading *how,
                           sepax_code code, const char *words) {
  sepax_soup soup = {.count = 7};
  sepax_mesh_account account = {.faces = 7};
  assert_fault(sepax_mesh_read(&soup, &account, put_file(name, text), how, &fault), words);
  assert_int_equal(fault.code, code);
  assert_true(soup.facet == NULL && soup.count == 0 && account.faces == 0);
}

CASE(what_no_format_knows) {
  assert_refused("a.txt", "hello\n", NULL, SEPAX_ERROR_FORMAT,
                 "a.txt: not a mesh that can be read; give PLY, 3MF, DAE, STL or OBJ");
  assert_refused("a.txt", "", NULL, SEPAX_ERROR_FORMAT, "a.txt: ");
  sepax_soup soup;
  assert_fault(sepax_mesh_read(&soup, NULL, in_folder("none.stl"), NULL, &fault),
               "none.stl: No such");
  assert_int_equal(fault.code, SEPAX_ERROR_FILE);
}

CASE(units) {
  sepax_soup soup;
  const char *file = put_file("a.stl", stl);
  const sepax_mesh_reading ways[] = {
      SEPAX_STRUCT(sepax_mesh_reading, .unit_mm = 0),
      SEPAX_STRUCT(sepax_mesh_reading, .result_mm = 1000),
      SEPAX_STRUCT(sepax_mesh_reading, .unit_mm = 25.4),
      SEPAX_STRUCT(sepax_mesh_reading, .unit_mm = 25.4, .result_mm = 1),
      SEPAX_STRUCT(sepax_mesh_reading, .unit_mm = 1, .result_mm = 1000),
  };
  static const double factor[] = {1, 1, 1, 25.4, 1e-3};
  for (int n = 0; n < 5; n++) {
    assert_works(sepax_mesh_read(&soup, NULL, file, &ways[n], &fault));
    assert_true(soup.facet[1].v[2][2] == 0.1 * factor[n]);
    assert_true(soup.facet[1].v[1][0] == factor[n]);
    sepax_soup_free(&soup);
  }
  const sepax_mesh_reading wrong[] = {
      SEPAX_STRUCT(sepax_mesh_reading, .unit_mm = -1),
      SEPAX_STRUCT(sepax_mesh_reading, .result_mm = NAN),
      SEPAX_STRUCT(sepax_mesh_reading, .unit_mm = INFINITY),
  };
  for (int n = 0; n < 3; n++) {
    assert_refused("a.stl", stl, &wrong[n], SEPAX_ERROR_ARGUMENT, "give lengths of 0 ... 1e12 mm");
  }
}

CASE(limits) {
  assert_refused("a.stl", stl, &SEPAX_STRUCT(sepax_mesh_reading, .most = 1), SEPAX_ERROR_LIMIT,
                 "more than 1 triangles; simplify the mesh");
  assert_refused("a.stl",
                 "solid a\nfacet normal 0 0 1\nouter loop\nvertex 1e301 1e302 0\nvertex 1 0 0\n"
                 "vertex 0 1 0\nendloop\nendfacet\nendsolid\n",
                 NULL, SEPAX_ERROR_FORMAT, "2^1000");
}

CASE(normals) {
  sepax_soup soup;
  const sepax_mesh_reading how = SEPAX_STRUCT(sepax_mesh_reading, .normals = true);
  assert_works(sepax_mesh_read(&soup, NULL, put_file("a.stl", stl), &how, &fault));
  assert_true(soup.normal != NULL && soup.normal[1][2] == 1);
  sepax_soup_free(&soup);
  assert_refused("a.ply", ply, &how, SEPAX_ERROR_FORMAT,
                 "normals of facets are read from STL alone");
}
