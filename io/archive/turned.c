/* SPDX-License-Identifier: MIT */
/* turned.c - finds meshes of a 3MF that are inside out.
 *
 * 3MF wants the corners of a triangle to run anticlockwise as seen from outside. Of a mesh whose
 * triangles all run the other way the standard says that it has no material. A file that builds
 * such a mesh means a body, so the reader turns the triangles round.
 *
 * The signed volume of the whole mesh decides, so an outer shell with cavities stays as it is. The
 * volume means something only if the surface is closed. So a mesh stays as it is
 *   - if its edges do not cancel: each edge must be run through as often in one direction as in the
 *     other. An open mesh fails here, and a mesh of which some triangles are turned.
 *   - if the volume is 0 but for rounding, such as that of a mesh with both sides of each face. */
#include "archive/model.h"
#include "util/hash.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const double *vertex_of(const model *m, const model_object *o, size_t triangle, int k) {
  return m->vertex[o->vertex + m->triangle[o->first + triangle][k]];
}

/* Two directions of an edge have hashes that add to 0. */
static uint64_t directed_hash(const double p[3], const double q[3]) {
  uint64_t end[2];
  for (int k = 0; k < 2; k++) {
    const double *v = k == 0 ? p : q;
    const double at[3] = {v[0] + 0.0, v[1] + 0.0, v[2] + 0.0}; /* -0 becomes 0 */
    end[k] = hash_doubles(at, 3);
  }
  return hash_add(hash_add(0, end[0]), end[1]) - hash_add(hash_add(0, end[1]), end[0]);
}

/* The hashes of all edges add to 0: this is so if the edges cancel, and by chance in one of 2^64
 * other meshes. */
static bool edges_cancel(const model *m, const model_object *o) {
  uint64_t sum = 0;
  for (size_t n = 0; n < o->count; n++) {
    for (int k = 0; k < 3; k++) {
      sum += directed_hash(vertex_of(m, o, n, k), vertex_of(m, o, n, (k + 1) % 3));
    }
  }
  return sum == 0;
}

/* The volume is a sum over the triangles of products of three coordinates, taken from the first
 * vertex. Rounding changes a term by less than 8 units of its size in the last place, and adding it
 * by one of the sum of all sizes. A sum that is infinite or not a number is not below the bound. */
static bool volume_is_negative(const model *m, const model_object *o) {
  const double *base = vertex_of(m, o, 0, 0);
  double sum = 0;
  double size = 0;
  for (size_t n = 0; n < o->count; n++) {
    double v[3][3];
    for (int k = 0; k < 9; k++) {
      v[k / 3][k % 3] = vertex_of(m, o, n, k / 3)[k % 3] - base[k % 3];
    }
    for (int i = 0; i < 3; i++) {
      double ahead = v[1][(i + 1) % 3] * v[2][(i + 2) % 3];
      double back = v[1][(i + 2) % 3] * v[2][(i + 1) % 3];
      sum += v[0][i] * (ahead - back);
      size += fabs(v[0][i]) * (fabs(ahead) + fabs(back));
    }
  }
  return sum < -DBL_EPSILON * (8 + (double)o->count * 3) * size;
}

bool sepax__model_inside_out(const model *m, const model_object *o) {
  return o->count > 0 && volume_is_negative(m, o) && edges_cancel(m, o);
}
