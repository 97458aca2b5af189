/* SPDX-License-Identifier: MIT */
/* sepax_io.h - libsepax-io: read meshes from files of the formats STL, OBJ, PLY, 3MF and DAE.
 *
 * The conventions are those of sepax.h. The reader either gives the whole surface that the file
 * describes or refuses the file:
 *   - An element with a surface becomes triangles. An element of a known kind without a surface
 *     (normals, colours, lines, names ...) is counted in the account. Any other element is an
 * error, and the text says where the element is. docs/reference/meshes.md lists all known kinds.
 *   - Coordinates are doubles. A decimal number is rounded once, to the nearest double. A binary
 *     number is exact. If a file places its meshes by matrices (3MF, DAE), then the products and
 *     sums are rounded; equal vertices remain equal.
 *   - Independent code counts the faces of the file. The reader fails if the two counts differ.
 *   - A file has at most 1 GiB, and an archive unpacks to at most 1 GiB. The reader never uses the
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

/* A kind of element without a surface, for example "vertex normals", and how many the file has. */
typedef struct {
  char what[60];
  size_t count;
} sepax_mesh_other;

/* Objects that have a surface of which one may expect something else: what they are and what the
 * reader did, for example "meshes inside out, which are turned". */
typedef struct {
  char what[60];
  char which[160]; /* names of the first of them: "object 3, object 5, ..." */
  size_t count;
} sepax_mesh_remark;

enum { SEPAX_MESH_OTHERS_MOST = 32, SEPAX_MESH_REMARKS_MOST = 8 };

/* What a file has and what became of it. */
typedef struct {
  const char *format; /* "STL", "OBJ", "PLY", "3MF" or "DAE" */
  char unit[24];      /* name of the file's unit of length; "" if the file names none */
  double unit_mm;     /* length of that unit in mm; 0 if the file names none */
  size_t faces;       /* elements with a surface: triangles, polygons, strips, fans */
  size_t triangles;   /* triangles of the result; a face that is placed twice counts twice */
  size_t divided;     /* polygons of more than three corners that were divided into triangles */
  size_t bent;        /* divided polygons whose corners do not lie in one plane */
  size_t fans;        /* divided polygons that cross themselves; see sepax_mesh_reading.fans */
  size_t unplaced;    /* faces of meshes that are in the file but placed nowhere (3MF, DAE) */
  sepax_mesh_other other[SEPAX_MESH_OTHERS_MOST]; /* in the order of the file */
  size_t others;                                  /* number of entries of `other` */
  sepax_mesh_remark remark[SEPAX_MESH_REMARKS_MOST];
  size_t remarks; /* number of entries of `remark` */
} sepax_mesh_account;

/* Options of sepax_mesh_read. */
typedef struct {
  size_t size;
  size_t most;      /* a file with more triangles is refused; 0: 20,000,000 */
  bool normals;     /* also fill soup->normal; a file that is not STL is then refused */
  double unit_mm;   /* length in mm of the file's unit, in place of what the file says, 0 ... 1e12;
                       0: as the file says */
  double result_mm; /* length in mm of the result's unit, 0 ... 1e12. Coordinates are multiplied by
                       (unit of the file) / (unit of the result) and rounded. 0, or a file without a
                       unit: coordinates stay */
  bool fans; /* divide a polygon that crosses itself into a fan of triangles about its first corner,
                as many programs do, and count it in the account; false: refuse the file */
} sepax_mesh_reading;

/* Read the mesh of a file into `soup`. Free the soup with sepax_soup_free. The content of the file
 * decides the format; the ending of its name counts only if the content is unclear. `account` and
 * `how` may be NULL. Time and memory grow with the length of the file. A polygon that is not a fan
 * around its first corner takes time with the square of its corners (at most 20,000).
 * Errors: ARGUMENT if a length is not in 0 ... 1e12; FILE; FORMAT, with the line, element or offset
 * and the cure, also for a format whose library this build lacks; LIMIT if the file is too long or
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
