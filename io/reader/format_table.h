/* SPDX-License-Identifier: MIT */
/* format_table.h - the list of mesh formats (private). CONTRIBUTING.md says how one is added. */
#ifndef SEPAX_FORMAT_TABLE_H
#define SEPAX_FORMAT_TABLE_H

#include "reader/builder.h"
#include "reader/libraries.h"

/* A row for each format: its name, the ending of its files, and the functions that tell it by its
 * content, read it and count its faces; the libraries that these need. The first row that knows the
 * content reads it. What no row knows, being any text, is read by the row of the ending. */
#define MESH_FORMATS(ROW)                                   \
  ROW("PLY", ".ply", ply, 0)                                \
  ROW("3MF", ".3mf", threemf, NEEDS_LIBXML2 | NEEDS_LIBZIP) \
  ROW("DAE", ".dae", dae, NEEDS_LIBXML2)                    \
  ROW("STL", ".stl", stl, 0)                                \
  ROW("OBJ", ".obj", obj, 0)

/* sepax__X_is: do the bytes begin as a file of the format does?
 * sepax__X_read: into the builder: triangles, and its account but for format, faces, triangles.
 * *faces gets how many faces of the file became triangles, or are unplaced.
 * sepax__X_count: how many faces the file has, by code that shares nothing with the reader.
 */
#define MESH_READER_DECLARED(name, ending, x, libraries)  \
  bool sepax__##x##_is(const char *bytes, size_t size);   \
  bool sepax__##x##_read(mesh_builder *b, size_t *faces); \
  bool sepax__##x##_count(const mesh_builder *b, size_t *faces);
MESH_FORMATS(MESH_READER_DECLARED)
#undef MESH_READER_DECLARED

#endif
