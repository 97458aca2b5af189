/* SPDX-License-Identifier: MIT */
/* mesh.c - checks a caller's mesh. */
#include "mesh.h"
#include "util/options.h"

static bool check_index(const triangles *t, size_t vertices, sepax_error *error) {
  for (size_t n = 0; n < t->count; n++) {
    for (int k = 0; k < 3; k++) {
      uint32_t index = triangles_index(t, n, k);
      if (index >= vertices) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "triangle %zu: vertex %u is beyond the last of %zu; mend the mesh", n,
                          (unsigned)index, vertices);
      }
    }
  }
  return true;
}

static bool check_strides(const triangles *t, size_t bytes, sepax_error *error) {
  if (t->vertex_stride < bytes || t->index_stride < 3 * sizeof(uint32_t)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a mesh has strides of %zu and %zu bytes; give 0, or %zu and %zu or more",
                      t->vertex_stride, t->index_stride, bytes, 3 * sizeof(uint32_t));
  }
  return true;
}

bool sepax__triangles_of(triangles *t, const sepax_mesh *mesh, sepax_error *error) {
  sepax_mesh m;
  *t = (triangles){0};
  if (mesh == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "no mesh is given");
  }
  if (!sepax__options(&m, sizeof m, mesh, "sepax_mesh", error)) {
    return false;
  }
  if (m.real != SEPAX_DOUBLE && m.real != SEPAX_FLOAT) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a mesh has numbers of a kind %d; give "
                      "SEPAX_DOUBLE or SEPAX_FLOAT",
                      (int)m.real);
  }
  if (m.triangles > 0 && m.vertex == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a mesh of %zu triangles has no vertices",
                      m.triangles);
  }
  size_t bytes = m.real == SEPAX_FLOAT ? sizeof(float[3]) : sizeof(double[3]);
  *t = (triangles){.vertex = m.vertex,
                   .index = (const void *)m.index,
                   .vertex_stride = m.vertex_stride != 0 ? m.vertex_stride : bytes,
                   .index_stride = m.index_stride != 0 ? m.index_stride : 3 * sizeof(uint32_t),
                   .count = m.triangles,
                   .single = m.real == SEPAX_FLOAT};
  t->packed = !t->single && t->index == NULL && t->vertex_stride == bytes &&
              (uintptr_t)m.vertex % _Alignof(double) == 0;
  return check_strides(t, bytes, error) && (t->index == NULL || check_index(t, m.vertices, error));
}
