/* SPDX-License-Identifier: MIT */
/* meshes.c - reads and welds meshes for the commands, by --unit, --weld and --polygons. */
#include "cli/meshes.h"
#include "cli/question.h"
#include "util/error.h"

#include <string.h>

enum { KEY_UNIT = 0x680, KEY_WELD, KEY_POLYGONS };

static const struct argp_option options[] = {
    {"unit", KEY_UNIT, "LENGTH", 0,
     "length of one unit of the mesh files, for example 1mm, 25.4mm or 1m; it overrides the unit "
     "that a 3MF or DAE file names",
     0},
    {"weld", KEY_WELD, "LENGTH", 0,
     "close small gaps first: merge vertices within LENGTH of each other, leave out triangles "
     "that lose their area or are copies, and insert vertices into open edges within LENGTH. The "
     "results hold for the welded bodies, not for the bodies as they are in the files",
     0},
    {"polygons", KEY_POLYGONS, "WAY", 0,
     "polygons of mesh files that cross themselves: refuse the file (default), or fan: divide them "
     "into triangles from their first corner, as many programs do",
     0},
    {0}};

static error_t parse(int key, char *text, struct argp_state *state) {
  cli_meshes *rules = state->input;
  switch (key) {
  case KEY_UNIT:
    rules->own = cli_limit(state, "unit", text, rules->unit);
    if (!(rules->own.length > 0 && rules->own.length <= 1e9)) {
      argp_error(state, "unit: %s is not above 0 and at most 1e9 %s", text,
                 rules->unit == CLI_METRES ? "m" : "mm");
    }
    return 0;
  case KEY_WELD:
    rules->weld = cli_limit(state, "weld", text, rules->unit);
    return 0;
  case KEY_POLYGONS:
    rules->fans = strcmp(text, "fan") == 0;
    if (!rules->fans && strcmp(text, "refuse") != 0) {
      argp_error(state, "polygons: '%s' is neither refuse nor fan", text);
    }
    return 0;
  default:
    return ARGP_ERR_UNKNOWN;
  }
}

const struct argp cli_meshes_argp = {options, parse, NULL, NULL, NULL, NULL, NULL};

bool cli_mesh_weld(sepax_soup *mesh, report_mesh *said, const char *path, const cli_meshes *rules,
                   sepax_error *error) {
  said->welded = rules->weld.text != NULL;
  said->unit = rules->unit;
  sepax_error inner = {0};
  return !said->welded || sepax_soup_weld(mesh, rules->weld.length, &said->weld, &inner) ||
         sepax_fail(error, inner.code, "%.200s: %.300s", path, inner.text);
}

static bool read_mesh(sepax_soup *mesh, report_mesh *said, const char *path,
                      const cli_meshes *rules, bool normals, sepax_error *error) {
  static const cli_meshes none = {.unit = CLI_MILLIMETRES};
  report_mesh unused = {.unit = 0};
  said = said != NULL ? said : &unused;
  rules = rules != NULL ? rules : &none;
  *said = (report_mesh){.unit_mm = rules->own.length};
  const sepax_mesh_reading how = {.size = sizeof how,
                                  .normals = normals,
                                  .unit_mm = rules->own.length,
                                  .result_mm = 1,
                                  .fans = rules->fans};
  bool ok = sepax_mesh_read(mesh, &said->account, path, &how, error);
  if (ok && !cli_mesh_weld(mesh, said, path, rules, error)) {
    sepax_soup_free(mesh);
    ok = false;
  }
  return ok;
}

bool cli_mesh_read(sepax_soup *mesh, report_mesh *said, const char *path, const cli_meshes *rules,
                   sepax_error *error) {
  return read_mesh(mesh, said, path, rules, false, error);
}

bool cli_scene_load(sepax_scene *scene, report_mesh said[2], const char *const path[2],
                    const cli_meshes *rules, const cli_grid *grid, sepax_error *error) {
  sepax_soup soup[2] = {{0}, {0}};
  bool ok = true;
  *scene = (sepax_scene){.grid = grid->grid};
  for (int i = 0; i < 2 && ok; i++) {
    ok = read_mesh(&soup[i], said != NULL ? &said[i] : NULL, path[i], rules, grid->file_normals,
                   error);
  }
  ok = ok && sepax_scene_make(scene, soup, path, &grid->grid, grid->file_normals, error);
  sepax_soup_free(&soup[0]);
  sepax_soup_free(&soup[1]);
  return ok;
}
