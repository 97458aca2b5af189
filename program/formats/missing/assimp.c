/* assimp.c - in place of formats/assimp in a build without assimp. */
#include "formats/libraries.h"
#include "formats/mesh_format_table.h"

const bool format_assimp_here = false;

bool mesh_read_assimp(sepax_soup *mesh, const char *path, sepax_error *error) {
  *mesh = (sepax_soup){0};
  return format_has(NEEDS_ASSIMP, path, "mesh of this format", error);
}
