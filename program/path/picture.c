/* picture.c - all bodies in one pose as a PLY file, for any mesh viewer. */
#include "path/parts.h"
#include "util/error.h"
#include "util/write_file.h"

#include <stdlib.h>
#include <string.h>

typedef struct {
  const path_scene *scene;
  const sepax_pose *pose;   /* of each link */
  const report_verdict *of; /* of each body, there */
  path_moment at;
} picture;

/* Bytes of a little-endian file. */
static bool put(FILE *out, uint64_t word, int bytes) {
  bool ok = true;
  for (int i = 0; i < bytes && ok; i++) {
    ok = putc((int)(word >> (8 * i) & 0xff), out) != EOF;
  }
  return ok;
}

static bool put_vertex(FILE *out, const sepax_pose *p, const double v[3]) {
  bool ok = true;
  for (int i = 0; i < 3 && ok; i++) {
    const double *row = p->rotation[i];
    double x = row[0] * v[0] + row[1] * v[1] + row[2] * v[2] + p->translation[i];
    uint64_t bits;
    memcpy(&bits, &x, sizeof bits);
    ok = put(out, bits, 8);
  }
  return ok;
}

/* Grey and blue where a body is free; yellow, violet, red otherwise. */
static bool put_colour(FILE *out, size_t body, report_verdict verdict) {
  static const uint8_t others[][3] = {{240, 200, 60}, {160, 90, 200}, {215, 40, 40}};
  static const uint8_t plain[][3] = {{170, 190, 215}, {200, 200, 190}, {150, 200, 180}};
  const uint8_t *c = verdict == VERDICT_FREE ? plain[body % 3] : others[verdict - 1];
  return put(out, c[0], 1) && put(out, c[1], 1) && put(out, c[2], 1);
}

static bool write_head(FILE *out, const picture *p) {
  const path_scene *scene = p->scene;
  size_t faces = 0;
  bool ok = fprintf(out, "ply\nformat binary_little_endian 1.0\ncomment sepax path: line %zu",
                    scene->motion.line[p->at.line]) > 0 &&
            (p->at.part == 0 || fprintf(out, " and %.9g of the way to the next", p->at.part) > 0) &&
            fputs(", metres\n", out) != EOF;
  for (size_t n = 0; n < scene->bodies && ok; n++) {
    size_t count = scene->body[n].mesh.count;
    ok = fprintf(out, "comment body %zu: %s, faces %zu ... %zu, %s\n", n, path_body_name(scene, n),
                 faces, faces + count - 1, report_verdict_titles[p->of[n]]) > 0;
    faces += count;
  }
  return ok &&
         fprintf(out,
                 "element vertex %zu\nproperty double x\nproperty double y\n"
                 "property double z\nelement face %zu\n"
                 "property list uchar uint vertex_indices\nproperty uchar red\n"
                 "property uchar green\nproperty uchar blue\nproperty uint body\nend_header\n",
                 3 * faces, faces) > 0;
}

static bool write_all(FILE *out, const void *context) {
  const picture *p = context;
  const path_scene *scene = p->scene;
  bool ok = write_head(out, p);
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    for (size_t k = 0; k < 3 * b->mesh.count && ok; k++) {
      ok = put_vertex(out, &p->pose[b->link], b->mesh.facet[k / 3].v[k % 3]);
    }
  }
  uint64_t vertex = 0;
  for (size_t n = 0; n < scene->bodies; n++) {
    for (size_t k = 0; k < scene->body[n].mesh.count && ok; k++, vertex += 3) {
      ok = put(out, 3, 1) && put(out, vertex, 4) && put(out, vertex + 1, 4) &&
           put(out, vertex + 2, 4) && put_colour(out, n, p->of[n]) && put(out, n, 4);
    }
  }
  return ok;
}

bool path_write_picture(const path_scene *scene, const char *path, sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  path_moment at = path_worst_moment(scene);
  report_verdict worst = path_worst(scene);
  sepax_pose *pose = calloc(m->links, sizeof *pose);
  report_verdict *of = calloc(scene->bodies, sizeof *of);
  double *value = malloc((m->joints + 1) * sizeof *value);
  bool ok = false;
  if (pose != NULL && of != NULL && value != NULL) {
    path_values(&scene->motion, at, value);
    sepax_mechanism_poses(m, value, pose);
    for (size_t n = 0; n < scene->pairs; n++) {
      const path_pair *pair = &scene->pair[n];
      path_moment first = path_first(pair, worst);
      if (first.line == at.line && first.part == at.part) {
        of[pair->body[0]] = worst;
        of[pair->body[1]] = worst;
      }
    }
    const picture p = {scene, pose, of, at};
    ok = sepax_write_file(path, write_all, &p, error);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the picture");
  }
  free(pose);
  free(of);
  free(value);
  return ok;
}
