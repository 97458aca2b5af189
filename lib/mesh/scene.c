/* scene.c - two meshes on one integer grid. */
#include "util/error.h"

#include <stdlib.h>

void sepax_scene_free(sepax_scene *scene) {
  for (int i = 0; i < 2; i++) {
    free(scene->tri[i]);
    free(scene->normal[i]);
  }
  *scene = (sepax_scene){.count = {0, 0}};
}

static bool name_file(sepax_error *error, const char *path) {
  sepax_error inner = *error;
  return sepax_fail(error, inner.code, "%.150s: %.340s", path, inner.text);
}

static bool name_files(sepax_error *error, const char *const path[2]) {
  sepax_error inner = *error;
  return sepax_fail(error, inner.code, "%.120s, %.120s: %.250s", path[0], path[1], inner.text);
}

static void compute_normals(sepax_scene *scene, int i) {
  for (size_t k = 0; k < scene->count[i]; k++) {
    scene->normal[i][k] = sepax_unit_normal(&scene->tri[i][k], scene->grid.word);
  }
}

static bool quantise(sepax_scene *scene, int i, const sepax_mesh *mesh, const char *path,
                     bool file_normals, sepax_error *error) {
  scene->count[i] = mesh->count;
  scene->tri[i] = calloc(mesh->count, sizeof *scene->tri[i]);
  scene->normal[i] = calloc(mesh->count, sizeof *scene->normal[i]);
  if (scene->tri[i] == NULL || scene->normal[i] == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.150s: no memory for %zu triangles", path,
                      mesh->count);
  }
  if (!sepax_quantise(mesh, &scene->grid, scene->tri[i], file_normals ? scene->normal[i] : NULL,
                      error)) {
    return name_file(error, path);
  }
  if (!file_normals) {
    compute_normals(scene, i);
  }
  return true;
}

bool sepax_scene_load(sepax_scene *scene, const char *const path[2], const sepax_grid *grid,
                      bool file_normals, sepax_error *error) {
  sepax_mesh mesh[2] = {{NULL, 0}, {NULL, 0}};
  *scene = (sepax_scene){.grid = *grid};
  bool ok = sepax_stl_read(&mesh[0], path[0], error) && sepax_stl_read(&mesh[1], path[1], error);
  if (ok && grid->resolution == 0) {
    const sepax_mesh *const both[] = {&mesh[0], &mesh[1]};
    ok = sepax_grid_fit(&scene->grid, both, 2, grid->word, error) || name_files(error, path);
  }
  for (int i = 0; i < 2 && ok; i++) {
    ok = quantise(scene, i, &mesh[i], path[i], file_normals, error);
  }
  sepax_mesh_free(&mesh[0]);
  sepax_mesh_free(&mesh[1]);
  if (!ok) {
    sepax_scene_free(scene);
  }
  return ok;
}

sepax_pair sepax_scene_pair(const sepax_scene *scene, size_t i, size_t j) {
  return (sepax_pair){scene->tri[0][i], scene->tri[1][j], scene->normal[0][i], scene->normal[1][j]};
}
