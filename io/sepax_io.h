/* sepax_io.h - libsepax-io: meshes from files, STL, OBJ, PLY, 3MF and DAE.
 *
 * The conventions are those of sepax.h. What is read is what the file says, or else the file is
 * refused:
 *   - Each element of a file becomes triangles, or is of a kind that has no surface (normals,
 *     colours, lines, names ...) and is counted by name in the account, or the reading fails and
 *     says where the element is. What docs/meshes.md does not list is refused.
 *   - Coordinates are doubles. A decimal number is rounded once, to the nearest double; a binary
 *     one is exact. Where a file places its meshes by matrices (3MF, DAE), products and sums are
 *     rounded, equal vertices remain equal.
 *   - The number of faces is checked against a count that other code makes of the file.
 *   - A file is at most 1 GiB long, what it unpacks to at most 1 GiB, too; nothing is fetched.
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

/* What a file has. */
typedef struct {
  const char *format; /* "STL", "OBJ", "PLY", "3MF" or "DAE", as its content says */
  char unit[24];      /* the name of its unit; "" where it has none */
  double unit_mm;     /* its length in mm; 0: the file has none */
  size_t faces;       /* elements with a surface: triangles, polygons, strips, fans */
  size_t triangles;   /* that were made of them, as often as the file places them */
  size_t divided;     /* polygons of more than three corners */
  size_t bent;        /* those of them whose corners are in no common plane */
  size_t unplaced;    /* faces of meshes that the file has, but places nowhere (3MF, DAE) */
  sepax_mesh_other other[SEPAX_MESH_OTHERS_MOST]; /* by name, in the order of the file */
  size_t others;
} sepax_mesh_account;

/* How a mesh is read. */
typedef struct {
  size_t size;
  size_t most;      /* triangles; a file that makes more is refused. 0: 20,000,000 */
  bool normals;     /* with the normals of the facets, which only STL has; others are refused */
  double unit_mm;   /* the length in mm of a unit of the file, whatever it says; 0: as it says */
  double result_mm; /* the length in mm of a unit of the result: coordinates are multiplied by the
                       quotient of both, rounded. A file without a unit is taken to be in it. 0: the
                       file's own numbers */
} sepax_mesh_reading;

/* Read the mesh of a file. The format is that of the content, not of the name.
 * `account` may be NULL. Errors: ARGUMENT on lengths that are negative or not finite; FILE; FORMAT,
 * naming line, element or offset, and the cure; LIMIT on a file that is too long or makes too many
 * triangles; MEMORY. */
bool sepax_mesh_read(sepax_soup *soup, sepax_mesh_account *account, const char *path,
                     const sepax_mesh_reading *how, sepax_error *error);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif
#ifdef __cplusplus
}
#endif
#endif
