/* mesh_format_table.h - the list of mesh formats (private). CONTRIBUTING.md says how one is added.
 */
#ifndef SEPAX_MESH_FORMAT_TABLE_H
#define SEPAX_MESH_FORMAT_TABLE_H

#include "formats/libraries.h"

/* A row for each format: its name, the endings of its files, its reader, the libraries that the
 * reader needs. A reader that needs a library runs in a process of its own (confined.h). */
#define MESH_FORMATS(ROW)                            \
  ROW("STL", ".stl .stlb", mesh_read_stl, 0)         \
  ROW("OBJ", ".obj", mesh_read_assimp, NEEDS_ASSIMP) \
  ROW("PLY", ".ply", mesh_read_ply, NEEDS_ASSIMP)    \
  ROW("3MF", ".3mf", mesh_read_assimp, NEEDS_ASSIMP) \
  ROW("DAE", ".dae", mesh_read_dae, NEEDS_ASSIMP | NEEDS_LIBXML2)

/* Fill *mesh, which the caller frees. On failure *mesh may hold some triangles. */
typedef bool mesh_reader(sepax_soup *mesh, const char *path, sepax_error *error);

#define MESH_READER_DECLARED(name, endings, reader, libraries) mesh_reader reader;
MESH_FORMATS(MESH_READER_DECLARED)
#undef MESH_READER_DECLARED

#endif
