/* SPDX-License-Identifier: MIT */
/* mesh.h - polygons of a mesh file: STL, OBJ, PLY, 3MF, DAE.
 *
 * Whatever a reader does not know is refused (cannot), unless the format says that it has no
 * surface. The readers are written from the formats' specifications. */
#ifndef CERTIFICATE_MESH_H
#define CERTIFICATE_MESH_H

#include "vector.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct {
  const char *file; /* for messages */
  const char *format;
  long double unit_mm; /* 0 if the file has no unit */
  bool fans;     /* polygons that cross themselves are fans of their first corners; else refused */
  size_t fanned; /* how many */
  bool turned;   /* polygons that are added now are turned round: their placement mirrors */
  point *corner; /* corners of all polygons, in units of the file */
  size_t corners;
  size_t *end; /* end[n]: one past the last corner of polygon n */
  size_t polygons;
  size_t faces;     /* elements of the file that have a surface */
  size_t triangles; /* triangles that the polygons make: each two less than its corners */
} mesh;

/* Read a mesh. Its content decides the format. */
mesh mesh_read(const char *file, const char *bytes, size_t length);
void mesh_free(mesh *m);

/* Add a polygon of three corners or more. */
void mesh_polygon(mesh *m, const point *corner, size_t count);

/* Of a strip of triangles, each second one turned, or a fan; returns false if it has less than
 * three corners. */
bool mesh_strip(mesh *m, const point *corner, size_t count);
bool mesh_fan(mesh *m, const point *corner, size_t count);

/* The readers; `bytes` end with a 0 that `length` does not count. */
void mesh_stl(mesh *m, const char *bytes, size_t length);
void mesh_obj(mesh *m, const char *bytes, size_t length);
void mesh_ply(mesh *m, const char *bytes, size_t length);
void mesh_3mf(mesh *m, const char *bytes, size_t length);
void mesh_dae(mesh *m, const char *bytes, size_t length);

/* A placement: point p becomes row . p + shift. */
typedef struct {
  point row[3], shift;
} placement;
static const placement PLACEMENT_NONE = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};

static inline point placement_apply(const placement *a, point p) {
  return point_plus(
      (point){point_dot(a->row[0], p), point_dot(a->row[1], p), point_dot(a->row[2], p)}, a->shift);
}
/* Does it mirror? Then polygons must be turned round, or their outer sides would come inside. */
static inline bool placement_mirrors(const placement *a) {
  return point_dot(point_cross(a->row[0], a->row[1]), a->row[2]) < 0;
}
/* The placement that applies b first, then a. */
placement placement_product(const placement *a, const placement *b);

/* A number at *text, behind blanks; refused unless it is finite and a blank, a 0 or `stop` is
 * behind it. */
long double mesh_number(const mesh *m, const char **text, char stop, long line);

#endif
