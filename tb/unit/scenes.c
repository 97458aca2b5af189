/* SPDX-License-Identifier: MIT */
/* scenes.c - two STL files on one grid. */
#include "harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char names[2][PATH_BYTES];

/* Two files, of 2 and 3 facets; normals that are none of theirs. */
static void put_files(sepax_soup mesh[2]) {
  for (int i = 0; i < 2; i++) {
    mesh[i] = (sepax_soup){.facet = calloc((size_t)i + 2, sizeof(sepax_facet)),
                           .count = (size_t)i + 2,
                           .normal = calloc((size_t)i + 2, sizeof(double[3]))};
    for (size_t n = 0; mesh[i].facet != NULL && n < mesh[i].count; n++) {
      for (int k = 0; k < 9; k++) {
        mesh[i].facet[n].v[k / 3][k % 3] = 16 * i + 4 * (double)n + (double)(k * k % 11) / 2;
      }
      mesh[i].normal[n][0] = 3;
      mesh[i].normal[n][1] = -4;
    }
    assert_non_null(mesh[i].facet);
    snprintf(names[i], sizeof names[i], "%s/%c.stl", folder, "ab"[i]);
    assert_works(sepax_stl_write(&mesh[i], names[i], i == 0, &fault));
  }
}

static void free_meshes(sepax_soup mesh[2]) {
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
}

/* As the steps do one by one. */
CASE(both_files_are_on_one_grid) {
  sepax_soup mesh[2];
  put_files(mesh);
  const char *const both[2] = {names[0], names[1]};
  for (int way = 0; way < 4; way++) {
    sepax_grid grid = {.resolution = way / 2 == 0 ? 0.5 : 0, .offset = {1, 2, 3}, .word = 12};
    sepax_scene scene;
    assert_works(sepax_scene_load(&scene, both, &grid, way % 2 == 1, &fault));
    if (way / 2 == 1) {
      const sepax_mesh *const meshes[] = {SEPAX_SOUP_MESH(&mesh[0]), SEPAX_SOUP_MESH(&mesh[1])};
      assert_works(sepax_grid_fit(&grid, meshes, 2, 12, &fault));
    }
    assert_true(scene.grid.resolution == grid.resolution && scene.grid.word == 12);
    assert_memory_equal(scene.grid.offset, grid.offset, sizeof grid.offset);
    for (int i = 0; i < 2; i++) {
      sepax_tri tri[3];
      sepax_vec normal[3];
      assert_int_equal(scene.count[i], mesh[i].count);
      assert_works(sepax_quantise(SEPAX_SOUP_MESH(&mesh[i]), &grid, tri, &fault));
      assert_works(sepax_quantise_normals(&mesh[i], grid.word, normal, &fault));
      assert_memory_equal(scene.tri[i], tri, mesh[i].count * sizeof *tri);
      for (size_t n = 0; n < mesh[i].count && way % 2 == 0; n++) {
        normal[n] = sepax_unit_normal(&tri[n], 12);
      }
      assert_memory_equal(scene.normal[i], normal, mesh[i].count * sizeof *normal);
    }
    sepax_pair pair = sepax_scene_pair(&scene, 1, 2);
    assert_memory_equal(&pair.a, &scene.tri[0][1], sizeof pair.a);
    assert_memory_equal(&pair.b, &scene.tri[1][2], sizeof pair.b);
    assert_memory_equal(&pair.na, &scene.normal[0][1], sizeof pair.na);
    assert_memory_equal(&pair.nb, &scene.normal[1][2], sizeof pair.nb);
    sepax_scene_free(&scene);
    assert_true(scene.tri[0] == NULL && scene.normal[1] == NULL && scene.count[1] == 0);
  }
  free_meshes(mesh);
}

/* The message names the file, or both. */
CASE(files_that_do_not_fit) {
  sepax_soup mesh[2];
  put_files(mesh);
  const char *const both[2] = {names[0], names[1]};
  const char *const swapped[2] = {names[1], "no/such.stl"};
  const char *const none[2] = {"no/such.stl", names[1]};
  sepax_grid grid = {.resolution = 0.5, .word = 6};
  sepax_scene scene;
  assert_fault(sepax_scene_load(&scene, both, &grid, false, &fault), "b.stl: facet 0, vertex ");
  assert_true(scene.tri[0] == NULL && scene.count[0] == 0);
  assert_fault(sepax_scene_load(&scene, swapped, &grid, true, &fault), "no/such.stl: ");
  assert_fault(sepax_scene_load(&scene, none, &grid, true, &fault), "no/such.stl: ");
  grid = (sepax_grid){.word = 3};
  assert_fault(sepax_scene_load(&scene, both, &grid, false, &fault), "a.stl, ");
  assert_message("b.stl: ");
  free_meshes(mesh);
}
