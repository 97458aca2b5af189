/* meshes.h - how commands read meshes: options that they share. */
#ifndef SEPAX_CLI_MESHES_H
#define SEPAX_CLI_MESHES_H

#include "cli/cli.h"
#include "report/bands.h"
#include "report/mesh.h"

#include "sepax_models.h"

/* --unit and --weld. The input of this argp child is a cli_meshes, of which `unit` says in which
 * unit lengths are: CLI_MILLIMETRES or CLI_METRES. */
typedef struct {
  int unit;
  report_limit own;  /* a unit of every file, whatever it says; text NULL: as it says */
  report_limit weld; /* text NULL: nothing is welded */
} cli_meshes;
extern const struct argp cli_meshes_argp;

/* Read a mesh, in mm, welded if that is asked for. Files without a unit are in mm. `rules` and
 * `said` may be NULL. */
bool cli_mesh_read(sepax_soup *mesh, report_mesh *said, const char *path, const cli_meshes *rules,
                   sepax_error *error);

/* Two meshes on a grid, with the normals of their files if the grid's options say so. `said` may be
 * NULL. */
bool cli_scene_load(sepax_scene *scene, report_mesh said[2], const char *const path[2],
                    const cli_meshes *rules, const cli_grid *grid, sepax_error *error);

/* Weld a mesh that was read, if that is asked for. */
bool cli_mesh_weld(sepax_soup *mesh, report_mesh *said, const char *path, const cli_meshes *rules,
                   sepax_error *error);

#endif
