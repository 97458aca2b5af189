/* SPDX-License-Identifier: MIT */
/* picture.c - writes all bodies in one pose as a PLY file, which any mesh viewer shows. */
#include "path/common/parts.h"
#include "report/ply.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  const path_scene *scene;
  const sepax_pose *pose;   /* pose of each link */
  const report_verdict *of; /* verdict of each body in this pose */
  path_moment at;
} picture;

static bool print_comments(FILE *out, const void *context) {
  const picture *p = context;
  const path_scene *scene = p->scene;
  size_t faces = 0;
  bool ok = fprintf(out, "comment sepax path: line %zu", scene->motion.line[p->at.line]) > 0 &&
            (p->at.part == 0 || fprintf(out, " and %.9g of the way to the next", p->at.part) > 0) &&
            fputs(", metres\n", out) != EOF;
  for (size_t n = 0; n < scene->bodies && ok; n++) {
    size_t count = scene->body[n].mesh.count;
    ok = fprintf(out, "comment body %zu: %s, faces %zu ... %zu, %s\n", n, path_body_name(scene, n),
                 faces, faces + count - 1, report_verdict_titles[p->of[n]]) > 0;
    faces += count;
  }
  return ok;
}

/* Colour a body: grey or blue if it is free; yellow for a warning, violet for undecided, red for a
 * collision. */
static void set_body(report_ply_body *body, const picture *p, size_t n) {
  static const uint8_t plain[][3] = {{170, 190, 215}, {200, 200, 190}, {150, 200, 180}};
  static const uint8_t others[VERDICTS][3] = {[VERDICT_WARNING] = {240, 200, 60},
                                              [VERDICT_UNDECIDED] = {160, 90, 200},
                                              [VERDICT_COLLISION] = {215, 40, 40}};
  const path_body *of = &p->scene->body[n];
  *body = (report_ply_body){.mesh = &of->mesh, .pose = &p->pose[of->link]};
  memcpy(body->colour, p->of[n] == VERDICT_FREE ? plain[n % 3] : others[p->of[n]],
         sizeof body->colour);
}

bool path_write_picture(const path_scene *scene, const char *path, sepax_error *error) {
  const sepax_mechanism *m = &scene->robot.mechanism;
  const path_pair *worst_pair = NULL;
  path_moment at = path_worst_moment(scene, &worst_pair);
  report_verdict worst = path_worst(scene);
  sepax_pose *pose = calloc(m->links, sizeof *pose);
  report_verdict *of = calloc(scene->bodies, sizeof *of);
  double *value = malloc((m->joints + 1) * sizeof *value);
  report_ply_body *body = calloc(scene->bodies, sizeof *body);
  bool ok = false;
  if (pose != NULL && of != NULL && value != NULL && body != NULL) {
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
    for (size_t n = 0; n < scene->bodies; n++) {
      set_body(&body[n], &p, n);
    }
    const report_ply ply = {.body = body,
                            .bodies = scene->bodies,
                            .numbered = true,
                            .print_comments = print_comments,
                            .context = &p};
    ok = report_ply_write(&ply, path, error);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the picture");
  }
  free(pose);
  free(of);
  free(value);
  free(body);
  return ok;
}
