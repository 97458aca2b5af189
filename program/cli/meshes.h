/* SPDX-License-Identifier: MIT */
/* meshes.h - reads and welds meshes for the commands, by --unit, --weld and --polygons. */
#ifndef SEPAX_CLI_MESHES_H
#define SEPAX_CLI_MESHES_H

#include "cli/cli.h"
#include "report/bands.h"
#include "report/mesh.h"

#include "sepax_models.h"

/* The input of the argp child for --unit, --weld and --polygons. `unit` is the unit of lengths:
 * CLI_MILLIMETRES or CLI_METRES. */
typedef struct {
  int unit;
  report_limit own;  /* --unit; its text is NULL if each file's own unit is used */
  report_limit weld; /* --weld; its text is NULL if nothing is welded */
  bool fans;         /* --polygons=fan */
} cli_meshes;
extern const struct argp cli_meshes_argp;

/* Read a mesh in mm and weld it if --weld was given. A file without a unit is in mm. `rules` and
 * `said` may be NULL. */
bool cli_mesh_read(sepax_soup *mesh, report_mesh *said, const char *path, const cli_meshes *rules,
                   sepax_error *error);

/* Read two meshes and put them on a grid, with the normals of the files if --normals=file was
 * given. `said` may be NULL. */
bool cli_scene_load(sepax_scene *scene, report_mesh said[2], const char *const path[2],
                    const cli_meshes *rules, const cli_grid *grid, sepax_error *error);

/* Weld a mesh if --weld was given. */
bool cli_mesh_weld(sepax_soup *mesh, report_mesh *said, const char *path, const cli_meshes *rules,
                   sepax_error *error);

#endif
