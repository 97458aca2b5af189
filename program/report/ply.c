/* SPDX-License-Identifier: MIT */
/* ply.c - bodies as a PLY file. */
#include "report/ply.h"
#include "util/bytes.h"
#include "util/write_file.h"

#include <stdio.h>
#include <string.h>

/* Write a word in little-endian bytes. */
static bool put(FILE *out, uint64_t word, int bytes) {
  bool ok = true;
  for (int i = 0; i < bytes && ok; i++) {
    ok = putc((int)(word >> (8 * i) & 0xff), out) != EOF;
  }
  return ok;
}

static bool put_vertex(FILE *out, const sepax_pose *p, const double v[3]) {
  double at[3] = {v[0], v[1], v[2]};
  uint8_t bytes[sizeof at];
  if (p != NULL) {
    sepax_pose_apply(p, v, at);
  }
  for (size_t i = 0; i < 3; i++) {
    uint64_t bits;
    memcpy(&bits, &at[i], sizeof bits);
    bytes_put64(bytes + sizeof bits * i, bits);
  }
  return fwrite(bytes, sizeof bytes, 1, out) == 1;
}

static bool put_colour(FILE *out, const uint8_t colour[3]) {
  return put(out, colour[0], 1) && put(out, colour[1], 1) && put(out, colour[2], 1);
}

static bool write_head(FILE *out, const report_ply *p) {
  size_t faces = 0;
  for (size_t n = 0; n < p->bodies; n++) {
    faces += p->body[n].mesh->count;
  }
  return fputs("ply\nformat binary_little_endian 1.0\n", out) != EOF &&
         p->print_comments(out, p->context) &&
         fprintf(out,
                 "element vertex %zu\nproperty double x\nproperty double y\nproperty double z\n"
                 "element face %zu\nproperty list uchar uint vertex_indices\n"
                 "property uchar red\nproperty uchar green\nproperty uchar blue\n%send_header\n",
                 3 * faces, faces, p->numbered ? "property uint body\n" : "") > 0;
}

static bool write_all(FILE *out, const void *context) {
  const report_ply *p = context;
  bool ok = write_head(out, p);
  for (size_t n = 0; n < p->bodies; n++) {
    const report_ply_body *b = &p->body[n];
    for (size_t k = 0; k < 3 * b->mesh->count && ok; k++) {
      ok = put_vertex(out, b->pose, b->mesh->facet[k / 3].v[k % 3]);
    }
  }
  uint64_t vertex = 0;
  for (size_t n = 0; n < p->bodies; n++) {
    const report_ply_body *b = &p->body[n];
    for (size_t k = 0; k < b->mesh->count && ok; k++, vertex += 3) {
      bool marked = b->marked != NULL && b->marked[k];
      ok = put(out, 3, 1) && put(out, vertex, 4) && put(out, vertex + 1, 4) &&
           put(out, vertex + 2, 4) && put_colour(out, marked ? b->marked_colour : b->colour) &&
           (!p->numbered || put(out, n, 4));
    }
  }
  return ok;
}

bool report_ply_write(const report_ply *ply, const char *path, sepax_error *error) {
  return sepax_write_file(path, write_all, ply, error);
}
