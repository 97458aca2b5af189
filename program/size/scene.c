/* SPDX-License-Identifier: MIT */
/* scene.c - measures the pairs of a machine in each line of a path. docs/reference/size.md. */
#include "size/workloads.h"
#include "size/parts.h"
#include "mechanism/steps.h"
#include "util/error.h"

#include <stdlib.h>

void size_scene_free(size_answer *answer) {
  free(answer->absent);
  path_engine_free(&answer->engine);
  path_scene_free(&answer->scene);
  free(answer->each);
}

const path_pair *size_pair_of(const size_answer *answer, size_t n) {
  return &answer->scene.pair[answer->engine.pair[n]];
}

/* Measure two bodies as two meshes of which one moves, for a core without an engine and for object
 * engines. */
static bool measure_pair(sepax_size *size, const size_answer *answer, size_t n,
                         sepax_error *error) {
  const path_scene *scene = &answer->scene;
  const format_motion *motion = &scene->motion;
  const path_pair *pair = size_pair_of(answer, n);
  sepax_poses path = {calloc(motion->lines + 1, sizeof *path.pose), motion->lines};
  if (path.pose == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu poses", motion->lines);
  }
  for (size_t line = 0; line < motion->lines; line++) {
    sepax_pose pose[2];
    sepax_chain_poses(&pair->chain, &scene->robot.mechanism, &motion->value[line * motion->joints],
                      pose);
    path.pose[line] = sepax__pose_seen(&pose[0], &pose[1]);
  }
  const sepax_space space = {.resolution = answer->engine.resolution,
                             .path = &path,
                             .limited = true,
                             .clearance = answer->engine.clearance,
                             .warning = answer->engine.warning};
  sepax_error inner = {0};
  bool ok =
      sepax_size_scene(size, &scene->body[pair->body[0]].mesh, &scene->body[pair->body[1]].mesh,
                       &space, &inner) ||
      sepax_fail(error, inner.code, "%.60s, %.60s: %.400s", path_body_name(scene, pair->body[0]),
                 path_body_name(scene, pair->body[1]), inner.text);
  sepax_poses_free(&path);
  return ok;
}

/* Take the trees of the list of jobs, which a tree engine reads. */
static bool share_trees(sepax_size *size, const size_answer *answer, size_t n, sepax_error *error) {
  const path_engine *e = &answer->engine;
  const size_t *body = size_pair_of(answer, n)->body;
  struct sepax_size_trees *trees = calloc(1, sizeof *trees);
  if (trees == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for trees");
  }
  *trees = (struct sepax_size_trees){.tree = {e->tree[body[0]], e->tree[body[1]]},
                                     .pose = e->pose[n],
                                     .poses = answer->scene.motion.lines,
                                     .word = e->word,
                                     .shared = true};
  sepax__size_trees_free(size->trees);
  size->trees = trees;
  return true;
}

/* Measure all pairs. If there are more pairs of triangles than 64 lanes can compare in time, then
 * workloads are not computed. */
static bool measure_pairs(size_answer *answer, double cycles, sepax_error *error) {
  const path_scene *scene = &answer->scene;
  const path_engine *e = &answer->engine;
  double triangles = 0;
  for (size_t n = 0; n < e->pairs; n++) {
    const size_t *body = size_pair_of(answer, n)->body;
    triangles += (double)scene->body[body[0]].triangles * (double)scene->body[body[1]].triangles;
  }
  size_t lines = scene->motion.lines;
  answer->size = calloc(e->pairs + 1, sizeof *answer->size);
  answer->absent = calloc(e->pairs * lines + 1, 1);
  if (answer->size == NULL || answer->absent == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu pairs", e->pairs);
  }
  bool ok = true;
  cli_progress progress = cli_progress_begin("pairs", e->pairs);
  for (size_t n = 0; n < e->pairs && ok; n++) {
    sepax_size *size = &answer->size[answer->pairs++];
    const size_t *body = size_pair_of(answer, n)->body;
    for (size_t line = 0; line < lines; line++) {
      answer->absent[n * lines + line] = !path_line_asked(scene, size_pair_of(answer, n), line);
    }
    *size = (sepax_size){.grid = {.resolution = e->resolution, .word = e->word},
                         .count = {scene->body[body[0]].triangles, scene->body[body[1]].triangles},
                         .path = scene->motion.lines,
                         .limited = true,
                         .clearance = e->clearance,
                         .warning = e->warning};
    cli_progress_show(&progress, n);
    ok = (triangles > cycles * SEPAX_LANES_MAX || measure_pair(size, answer, n, error)) &&
         share_trees(size, answer, n, error);
    size->absent = &answer->absent[n * lines];
  }
  cli_progress_end(&progress);
  return ok;
}

bool size_scene_read(size_answer *answer, const size_options *o, sepax_error *error) {
  double cycles = o->request.seconds / (o->clock.clock_ps * 1e-12);
  return report_bands_agree(&o->scene.bands, error) &&
         path_scene_load(&answer->scene, &o->scene, error) &&
         path_engine_make(&answer->engine, &answer->scene, &o->scene, error) &&
         measure_pairs(answer, cycles, error);
}

bool size_scene_tell(size_answer *answer, const size_options *o, sepax_error *error) {
  size_t lines = answer->scene.motion.lines;
  answer->each = calloc(answer->pairs, sizeof *answer->each);
  if (answer->each == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu pairs", answer->pairs);
  }
  for (size_t n = 0; n < answer->pairs; n++) {
    size_pair *p = &answer->each[n];
    size_t asked = 0;
    for (size_t line = 0; line < lines; line++) {
      uint64_t cycles;
      if (answer->size[n].absent[line] != 0) {
        continue;
      }
      if (!sepax_size_cycles(&cycles, &answer->size[n], &answer->best->config, line, &o->request,
                             error)) {
        return false;
      }
      p->line = asked++ == 0 || cycles > p->worst ? line : p->line;
      p->worst = cycles > p->worst ? cycles : p->worst;
      p->mean += (double)cycles;
    }
    p->mean /= (double)asked;
  }
  return true;
}
