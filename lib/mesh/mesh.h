/* SPDX-License-Identifier: MIT */
/* mesh.h - the triangles of a caller's mesh (private). */
#ifndef SEPAX_MESH_H
#define SEPAX_MESH_H

#include "sepax.h"

#include <string.h>

/* A caller's mesh that was checked: strides are not 0, and each index is below `vertices`. */
typedef struct {
  const char *vertex, *index; /* index is NULL if the mesh has none */
  size_t vertex_stride, index_stride;
  size_t count; /* number of triangles */
  bool single;  /* coordinates are floats */
  bool packed;  /* vertex is an array of double[3][3] */
} triangles;

/* Check a mesh. Fails if the struct has no size, if vertices are missing, if a stride is too short,
 * or if an index is beyond the vertices. */
bool sepax__triangles_of(triangles *t, const sepax_mesh *mesh, sepax_error *error);

static inline uint32_t triangles_index(const triangles *t, size_t n, int corner) {
  uint32_t index;
  memcpy(&index, t->index + n * t->index_stride + (size_t)corner * sizeof index, sizeof index);
  return index;
}

/* The vertices of triangle n: in place, or converted into `space`. */
static inline const double (*triangle_at(const triangles *t, size_t n, double space[3][3]))[3] {
  if (t->packed) {
    return (const double(*)[3])(const void *)(t->vertex + n * sizeof(double[3][3]));
  }
  for (int k = 0; k < 3; k++) {
    size_t number = t->index == NULL ? 3 * n + (size_t)k : triangles_index(t, n, k);
    const char *from = t->vertex + number * t->vertex_stride;
    if (t->single) {
      float x[3];
      memcpy(x, from, sizeof x);
      for (int i = 0; i < 3; i++) {
        space[k][i] = (double)x[i];
      }
    } else {
      memcpy(space[k], from, sizeof space[k]);
    }
  }
  return (const double(*)[3])space;
}

#endif
