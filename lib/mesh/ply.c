/* ply.c - two meshes with their colliding triangles in colour, for any mesh viewer. */
#include "util/error.h"
#include "util/write_file.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  const sepax_mesh *mesh;
  const bool *hit[2];
} picture;

enum { VERTEX_BYTES = 24, FACE_BYTES = 16 };

static void store32(uint8_t *to, uint32_t value) {
  for (int i = 0; i < 4; i++) {
    to[i] = (uint8_t)(value >> (8 * i));
  }
}

static void store_real(uint8_t *to, double value) {
  uint64_t bits;
  memcpy(&bits, &value, sizeof bits);
  store32(to, (uint32_t)bits);
  store32(to + 4, (uint32_t)(bits >> 32));
}

static bool write_vertices(FILE *out, const sepax_mesh mesh[2]) {
  bool ok = true;
  for (int i = 0; i < 2; i++) {
    for (size_t n = 0; n < 3 * mesh[i].count && ok; n++) {
      uint8_t bytes[VERTEX_BYTES];
      for (int axis = 0; axis < 3; axis++) {
        store_real(bytes + 8 * axis, mesh[i].facet[n / 3].v[n % 3][axis]);
      }
      ok = fwrite(bytes, sizeof bytes, 1, out) == 1;
    }
  }
  return ok;
}

static bool write_faces(FILE *out, const picture *p) {
  static const uint8_t colour[2][2][3] = {{{170, 190, 215}, {215, 40, 40}},
                                          {{200, 200, 190}, {240, 150, 30}}};
  uint32_t vertex = 0;
  bool ok = true;
  for (int i = 0; i < 2; i++) {
    for (size_t n = 0; n < p->mesh[i].count && ok; n++) {
      uint8_t bytes[FACE_BYTES] = {3};
      for (int k = 0; k < 3; k++) {
        store32(bytes + 1 + 4 * k, vertex++);
      }
      memcpy(bytes + 13, colour[i][p->hit[i][n]], 3);
      ok = fwrite(bytes, sizeof bytes, 1, out) == 1;
    }
  }
  return ok;
}

static bool write_picture(FILE *out, const void *context) {
  const picture *p = context;
  size_t faces = p->mesh[0].count + p->mesh[1].count;
  return fprintf(out,
                 "ply\nformat binary_little_endian 1.0\n"
                 "comment sepax: triangles of A that collide are red, of B orange\n"
                 "element vertex %zu\nproperty double x\nproperty double y\nproperty double z\n"
                 "element face %zu\nproperty list uchar uint vertex_indices\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
                 3 * faces, faces) > 0 &&
         write_vertices(out, p->mesh) && write_faces(out, p);
}

bool sepax_ply_write(const sepax_mesh mesh[2], const sepax_pairs *pairs, const char *path,
                     sepax_error *error) {
  bool *hit[2] = {calloc(mesh[0].count + 1, sizeof(bool)), calloc(mesh[1].count + 1, sizeof(bool))};
  bool ok = false;
  if (hit[0] != NULL && hit[1] != NULL) {
    for (size_t n = 0; n < pairs->count; n++) {
      hit[0][pairs->pair[n][0]] = true;
      hit[1][pairs->pair[n][1]] = true;
    }
    picture p = {mesh, {hit[0], hit[1]}};
    ok = sepax_write_file(path, write_picture, &p, error);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the colours of %zu triangles",
               mesh[0].count + mesh[1].count);
  }
  free(hit[0]);
  free(hit[1]);
  return ok;
}
