/* SPDX-License-Identifier: MIT */
/* scene.c - two meshes on one integer grid. */
#include "sepax_models.h"
#include "util/error.h"

#include <stdlib.h>

void sepax_scene_free(sepax_scene *scene) {
  for (int i = 0; i < 2; i++) {
    free(scene->tri[i]);
    free(scene->normal[i]);
  }
  *scene = (sepax_scene){.count = {0, 0}};
}

static void compute_normals(sepax_scene *scene, int i) {
  for (size_t k = 0; k < scene->count[i]; k++) {
    scene->normal[i][k] = sepax_unit_normal(&scene->tri[i][k], scene->grid.word);
  }
}

static bool quantise(sepax_scene *scene, int i, const sepax_soup *soup, const char *path,
                     bool file_normals, sepax_error *error) {
  scene->count[i] = soup->count;
  scene->tri[i] = calloc(soup->count, sizeof *scene->tri[i]);
  scene->normal[i] = calloc(soup->count, sizeof *scene->normal[i]);
  if (scene->tri[i] == NULL || scene->normal[i] == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.150s: no memory for %zu triangles", path,
                      soup->count);
  }
  sepax_error inner;
  if (!sepax_quantise(SEPAX_SOUP_MESH(soup), &scene->grid, scene->tri[i], &inner) ||
      (file_normals && !sepax_quantise_normals(soup, scene->grid.word, scene->normal[i], &inner))) {
    return sepax_fail(error, inner.code, "%.150s: %.340s", path, inner.text);
  }
  if (!file_normals) {
    compute_normals(scene, i);
  }
  return true;
}

/* Find the finest grid that holds both meshes. */
static bool fit(sepax_grid *grid, const sepax_soup soup[2], const char *const path[2],
                sepax_error *error) {
  const sepax_mesh *const mesh[] = {SEPAX_SOUP_MESH(&soup[0]), SEPAX_SOUP_MESH(&soup[1])};
  sepax_error inner;
  return sepax_grid_fit(grid, mesh, 2, grid->word, &inner) ||
         sepax_fail(error, inner.code, "%.120s, %.120s: %.250s", path[0], path[1], inner.text);
}

bool sepax_scene_make(sepax_scene *scene, const sepax_soup soup[2], const char *const name[2],
                      const sepax_grid *grid, bool file_normals, sepax_error *error) {
  *scene = (sepax_scene){.grid = *grid};
  bool ok = grid->resolution != 0 || fit(&scene->grid, soup, name, error);
  for (int i = 0; i < 2 && ok; i++) {
    ok = quantise(scene, i, &soup[i], name[i], file_normals, error);
  }
  if (!ok) {
    sepax_scene_free(scene);
  }
  return ok;
}

bool sepax_scene_load(sepax_scene *scene, const char *const path[2], const sepax_grid *grid,
                      bool file_normals, sepax_error *error) {
  sepax_soup soup[2] = {{0}, {0}};
  *scene = (sepax_scene){.grid = *grid};
  bool ok = sepax_stl_read(&soup[0], path[0], file_normals, error) &&
            sepax_stl_read(&soup[1], path[1], file_normals, error) &&
            sepax_scene_make(scene, soup, path, grid, file_normals, error);
  sepax_soup_free(&soup[0]);
  sepax_soup_free(&soup[1]);
  return ok;
}

sepax_pair sepax_scene_pair(const sepax_scene *scene, size_t i, size_t j) {
  return (sepax_pair){scene->tri[0][i], scene->tri[1][j], scene->normal[0][i], scene->normal[1][j]};
}
