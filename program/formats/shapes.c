/* SPDX-License-Identifier: MIT */
/* shapes.c - makes triangles from collision geometry, by the options of meshes. */
#include "formats/formats.h"
#include "robot/robot.h"

bool format_shape_mesh(sepax_soup *mesh, report_mesh *said, const sepax_shape *shape,
                       const cli_meshes *rules, sepax_error *error) {
  static const double metre = 1000; /* mm */
  const sepax_shape_reading how = {.size = sizeof how,
                                   .unit = rules->own.text != NULL ? rules->own.length : 0,
                                   .unplaced = true,
                                   .fans = rules->fans};
  *said = (report_mesh){.unit = rules->unit};
  if (!sepax_shape_mesh(mesh, &said->account, shape, &how, error)) {
    return false;
  }
  if (shape->kind == SEPAX_SHAPE_MESH) {
    said->unit_mm = metre * rules->own.length;
    if (!cli_mesh_weld(mesh, said, shape->path, rules, error)) {
      sepax_soup_free(mesh);
      return false;
    }
  }
  sepax__place_mesh(mesh, &shape->origin);
  return true;
}
