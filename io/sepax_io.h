/* sepax_io.h - libsepax-io: meshes from files, STL, OBJ, PLY, 3MF and DAE.
 *
 * The conventions are those of sepax.h. What is read is what the file says, or else the file is
 * refused:
 *   - Each element of a file becomes triangles, or is of a kind that has no surface (normals,
 *     colours, lines, names ...) and is counted by name in the account, or the reading fails and
 *     says where the element is. What docs/reference/meshes.md does not list is refused.
 *   - Coordinates are doubles. A decimal number is rounded once, to the nearest double; a binary
 *     one is exact. Where a file places its meshes by matrices (3MF, DAE), products and sums are
 *     rounded; equal vertices remain equal.
 *   - The number of faces is checked against a count that other code makes of the file.
 *   - A file has at most 1 GiB, and an archive unpacks to at most 1 GiB. Nothing is fetched from a
 *     network.
 */
#ifndef SEPAX_IO_H
#define SEPAX_IO_H

#include "sepax.h"

#ifdef __cplusplus
extern "C" {
#endif
#ifdef __GNUC__
#pragma GCC visibility push(default)
#endif

/* A kind of elements without a surface, such as "vertex normals", and how many of them there were.
 */
typedef struct {
  char what[60];
  size_t count;
} sepax_mesh_other;

enum { SEPAX_MESH_OTHERS_MOST = 32 };

/* What a file has, and what became of it. */
typedef struct {
  const char *format; /* "STL", "OBJ", "PLY", "3MF" or "DAE", as its content says */
  char unit[24];      /* the name of its unit; "" where it has none */
  double unit_mm;     /* its length in mm; 0: the file has none */
  size_t faces;       /* elements with a surface: triangles, polygons, strips, fans */
  size_t triangles;   /* of the result: those of each face, as often as the file places it */
  size_t divided;     /* polygons of more than three corners, which became triangles */
  size_t bent;        /* those of them whose corners are in no common plane */
  size_t unplaced;    /* faces of meshes that the file has, but places nowhere (3MF, DAE) */
  sepax_mesh_other other[SEPAX_MESH_OTHERS_MOST]; /* in the order of the file */
  size_t others;                                  /* how many kinds `other` has */
} sepax_mesh_account;

/* How a mesh is read. */
typedef struct {
  size_t size;
  size_t most;      /* triangles; a file that has more is refused. 0: 20,000,000 */
  bool normals;     /* fill soup->normal, too. Only STL has normals of facets; others are refused */
  double unit_mm;   /* the length in mm of a unit of the file, whatever it says; 0: as it says */
  double result_mm; /* the length in mm of a unit of the result. Coordinates are multiplied by the
                       file's unit over this one, rounded; those of a file without a unit stay. 0:
                       all stay */
} sepax_mesh_reading;

/* Read the mesh of a file into `soup`, which sepax_soup_free releases. The format is that of the
 * content, not of the name. `account` and `how` may be NULL; on failure both results are empty.
 * Time and memory grow with the length of the file; a polygon that is no fan of its first corner
 * takes time with the square of its corners (20,000 at most).
 * Errors: ARGUMENT on lengths outside 0 ... 1e12; FILE; FORMAT, with line, element or offset, and
 * the cure, also on a format whose library this build lacks; LIMIT on a file that is too long or
 * has too many triangles; MEMORY. */
bool sepax_mesh_read(sepax_soup *soup, sepax_mesh_account *account, const char *path,
                     const sepax_mesh_reading *how, sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
