/* ply.c - two meshes with their colliding triangles in colour, for any mesh viewer. */
#include "util/error.h"
#include "util/write_file.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  const sepax_scene *scene;
  const bool *hit[2];
} picture;

enum { VERTEX_BYTES = 12, FACE_BYTES = 16 };

static void store32(uint8_t *to, uint32_t value) {
  for (int i = 0; i < 4; i++) {
    to[i] = (uint8_t)(value >> (8 * i));
  }
}

static void store_real(uint8_t *to, double value) {
  float real = (float)value;
  uint32_t bits;
  memcpy(&bits, &real, sizeof bits);
  store32(to, bits);
}

static bool write_vertices(FILE *out, const sepax_scene *scene) {
  const sepax_grid *g = &scene->grid;
  bool ok = true;
  for (int i = 0; i < 2; i++) {
    for (size_t n = 0; n < 3 * scene->count[i] && ok; n++) {
      const sepax_vec *v = &scene->tri[i][n / 3].v[n % 3];
      uint8_t bytes[VERTEX_BYTES];
      store_real(bytes, g->offset[0] + g->resolution * v->x);
      store_real(bytes + 4, g->offset[1] + g->resolution * v->y);
      store_real(bytes + 8, g->offset[2] + g->resolution * v->z);
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
    for (size_t n = 0; n < p->scene->count[i] && ok; n++) {
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
  size_t faces = p->scene->count[0] + p->scene->count[1];
  return fprintf(out,
                 "ply\nformat binary_little_endian 1.0\n"
                 "comment sepax: triangles of A that collide are red, of B orange\n"
                 "element vertex %zu\nproperty float x\nproperty float y\nproperty float z\n"
                 "element face %zu\nproperty list uchar uint vertex_indices\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n",
                 3 * faces, faces) > 0 &&
         write_vertices(out, p->scene) && write_faces(out, p);
}

bool sepax_ply_write(const sepax_scene *scene, const sepax_pairs *pairs, const char *path,
                     sepax_error *error) {
  bool *hit[2] = {calloc(scene->count[0] + 1, sizeof(bool)),
                  calloc(scene->count[1] + 1, sizeof(bool))};
  bool ok = false;
  if (hit[0] != NULL && hit[1] != NULL) {
    for (size_t n = 0; n < pairs->count; n++) {
      hit[0][pairs->pair[n][0]] = true;
      hit[1][pairs->pair[n][1]] = true;
    }
    picture p = {scene, {hit[0], hit[1]}};
    ok = sepax_write_file(path, write_picture, &p, error);
  } else {
    sepax_fail(error, "no memory for the colours of %zu triangles",
               scene->count[0] + scene->count[1]);
  }
  free(hit[0]);
  free(hit[1]);
  return ok;
}
