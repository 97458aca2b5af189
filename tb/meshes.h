/* SPDX-License-Identifier: MIT */
/* meshes.h - mesh files of every format for test benches. */
#ifndef MESHES_H
#define MESHES_H

#include "sepax_io.h"
#include "sepax_models.h"

#include <stdio.h>
#include <string.h>

/* A mesh in mm. */
static inline bool mesh_file_read(sepax_soup *mesh, const char *path, bool normals,
                                  sepax_error *error) {
  sepax_mesh_reading how;
  memset(&how, 0, sizeof how);
  how.size = sizeof how;
  how.normals = normals;
  how.result_mm = 1;
  return sepax_mesh_read(mesh, NULL, path, &how, error);
}

/* Two of them on a grid. */
static inline bool mesh_files_scene(sepax_scene *scene, const char *const path[2],
                                    const sepax_grid *grid, bool normals, sepax_error *error) {
  sepax_soup soup[2];
  memset(soup, 0, sizeof soup);
  bool ok = mesh_file_read(&soup[0], path[0], normals, error) &&
            mesh_file_read(&soup[1], path[1], normals, error) &&
            sepax_scene_make(scene, soup, path, grid, normals, error);
  sepax_soup_free(&soup[0]);
  sepax_soup_free(&soup[1]);
  return ok;
}

/* What a run is of: both files, and the grid that they were rounded to. */
static inline void mesh_files_print(const sepax_scene *scene, const char *const path[2]) {
  const double *offset = scene->grid.offset;
  for (int i = 0; i < 2; i++) {
    printf("%s: %zu triangles\n", path[i], scene->count[i]);
  }
  printf("grid: %.9g mm per LSB, W = %d, 0 at (%.9g, %.9g, %.9g) mm\n", scene->grid.resolution,
         scene->grid.word, offset[0], offset[1], offset[2]);
}

#endif
