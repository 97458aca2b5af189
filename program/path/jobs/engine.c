/* SPDX-License-Identifier: MIT */
/* engine.c - turns the bodies and lines into input of the tree engine: trees and poses in fixed
 * point. docs/reference/path-engine.md. */
#include "path/jobs/engine.h"
#include "util/error.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A turned vertex of a near pair lies within A's half size + B's longest edge + the outer clearance
 * + this number of LSB: 4 LSB for rounding, and at most 7 LSB that a tree engine adds to its
 * margin. */
static const double spare = 11;
static const double margin_most = 8191;

/* ------------------------------------------------------------------- word and LSB */

static double half_size(const path_body *b) {
  double half = 0;
  for (int i = 0; i < 3; i++) {
    half = fmax(half, (b->most[i] - b->least[i]) / 2);
  }
  return half * (1 + 8 * DBL_EPSILON);
}

static double longest_edge(const sepax_soup *mesh) {
  double longest = 0;
  for (size_t n = 0; n < 3 * mesh->count; n++) {
    const double *p = mesh->facet[n / 3].v[n % 3];
    const double *q = mesh->facet[n / 3].v[(n + 1) % 3];
    longest = fmax(longest, hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]));
  }
  return longest * (1 + 8 * DBL_EPSILON);
}

static double outer_of(const path_question *q) {
  return fmax(q->bands.clearance.length, q->bands.warning.length);
}

/* The length that must fit into half of the word, and the pair that needs it. */
static double find_reach(const path_engine *e, const path_scene *scene, const path_question *q,
                         const path_pair **of) {
  double most = 0;
  *of = &scene->pair[e->pair[0]];
  for (size_t n = 0; n < e->pairs; n++) {
    const path_pair *pair = &scene->pair[e->pair[n]];
    const path_body *a = &scene->body[pair->body[0]];
    const path_body *b = &scene->body[pair->body[1]];
    double reach = fmax(half_size(a) + longest_edge(&b->mesh) + outer_of(q), half_size(b));
    if (reach > most) {
      most = reach;
      *of = pair;
    }
  }
  return most;
}

/* Steps from the middle of a word to its end that a body may use. */
static double steps_of(int word) { return (double)sepax_word_max(word) - spare; }

/* Round up to three significant digits. */
static double round_up(double x) {
  double unit = pow(10, floor(log10(x)) - 2);
  return ceil(x / unit) * unit;
}

static bool choose_grid(path_engine *e, const path_scene *scene, const path_question *q,
                        sepax_error *error) {
  const path_pair *of;
  double reach = find_reach(e, scene, q, &of);
  e->word = q->word;
  e->resolution = q->lsb.length;
  if (e->word != 0 && e->resolution == 0) {
    e->resolution = round_up(fmax(reach / steps_of(e->word), outer_of(q) / (margin_most - spare)));
  }
  int least = PATH_WORD_MIN;
  while (least <= SEPAX_TREE_WORD_MAX && steps_of(least) * e->resolution < reach) {
    least++;
  }
  e->word = e->word != 0 ? e->word : least;
  if (least <= e->word && least <= SEPAX_TREE_WORD_MAX) {
    return true;
  }
  int most = e->word <= SEPAX_TREE_WORD_MAX ? e->word : SEPAX_TREE_WORD_MAX;
  return sepax_fail(
      error, SEPAX_ERROR_ARGUMENT,
      "word: %.60s and %.60s need more than %d bits at an LSB of %.60s; give an LSB of %.3gmm or "
      "more%s",
      path_body_name(scene, of->body[0]), path_body_name(scene, of->body[1]), most, q->lsb.text,
      1e3 * round_up(reach / steps_of(most)),
      most < SEPAX_TREE_WORD_MAX ? ", or a longer word" : "");
}

/* The least number of LSB that is not shorter than the length. */
static int steps_up(double length, double resolution) {
  double steps = fmin(ceil(length / resolution), 0x1p20);
  while (steps > 0 && fma(steps - 1, resolution, -length) >= 0) {
    steps--;
  }
  while (fma(steps, resolution, -length) < 0 && steps < 0x1p20) {
    steps++;
  }
  return (int)steps;
}

/* Choose the design that the list is made for. Any II and any number of cores will do. */
static bool choose_bands(path_engine *e, const path_question *q, sepax_design *design,
                         sepax_error *error) {
  e->clearance = steps_up(q->bands.clearance.length, e->resolution);
  if (q->bands.warning.text != NULL) {
    e->warning = steps_up(q->bands.warning.length, e->resolution);
    e->warning = e->warning > e->clearance ? e->warning : e->clearance + 1;
  }
  sepax_config config = sepax_config_default();
  config.tree = true;
  config.word = e->word;
  config.clearance = e->clearance;
  config.warning = e->warning;
  sepax_error inner = {0};
  return sepax_design_init(design, &config, &inner) ||
         sepax_fail(error, inner.code, "an LSB of %.3g mm: %.400s", 1e3 * e->resolution,
                    inner.text);
}

/* --------------------------------------------------------------- trees and poses */

static bool add_tree(path_engine *e, const path_scene *scene, size_t body, sepax_error *error) {
  const path_body *b = &scene->body[body];
  sepax_grid grid = {.resolution = e->resolution, .word = e->word};
  for (int i = 0; i < 3; i++) {
    grid.offset[i] = b->least[i] / 2 + b->most[i] / 2;
  }
  sepax_error inner = {0};
  sepax_tri *tri = malloc(b->mesh.count * sizeof *tri);
  bool ok = tri != NULL ||
            sepax_fail(&inner, SEPAX_ERROR_MEMORY, "no memory for %zu triangles", b->mesh.count);
  ok = ok && sepax_quantise(SEPAX_SOUP_MESH(&b->mesh), &grid, tri, &inner) &&
       sepax_tree_new(&e->tree[body], tri, b->mesh.count, &grid, &inner);
  free(tri);
  return ok || sepax_fail(error, inner.code, "link %.60s: %.400s", path_body_name(scene, body),
                          inner.text);
}

static bool add_poses(path_engine *e, const path_scene *scene, const path_question *q, size_t n,
                      int64_t margin, sepax_error *error) {
  const format_motion *motion = &scene->motion;
  const path_pair *pair = &scene->pair[e->pair[n]];
  const sepax_tree *const tree[2] = {e->tree[pair->body[0]], e->tree[pair->body[1]]};
  e->pose[n] = malloc(motion->lines * sizeof *e->pose[n]);
  if (e->pose[n] == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu poses", motion->lines);
  }
  for (size_t line = 0; line < motion->lines; line++) {
    sepax_pose pose[2];
    sepax_error inner = {0};
    sepax_chain_poses(&pair->chain, &scene->robot.mechanism, &motion->value[line * motion->joints],
                      pose);
    if (!sepax_tree_pose_make(&e->pose[n][line], tree[0], &pose[0], tree[1], &pose[1], margin,
                              &inner)) {
      return sepax_fail(error, inner.code, "%.120s:%zu: %.60s, %.60s: an LSB of %.3g mm: %.200s",
                        q->motion, motion->line[line], path_body_name(scene, pair->body[0]),
                        path_body_name(scene, pair->body[1]), 1e3 * e->resolution, inner.text);
    }
  }
  return true;
}

void path_engine_free(path_engine *e) {
  for (size_t n = 0; e->tree != NULL && n < e->bodies; n++) {
    sepax_tree_free(e->tree[n]);
  }
  for (size_t n = 0; e->pose != NULL && n < e->pairs; n++) {
    free(e->pose[n]);
  }
  free(e->tree);
  free(e->pose);
  free(e->pair);
  *e = (path_engine){.tree = NULL};
}

/* Find the pairs that are asked in a line. */
static bool find_pairs(path_engine *e, const path_scene *scene, sepax_error *error) {
  e->pair = calloc(scene->pairs + 1, sizeof *e->pair);
  if (e->pair == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu pairs", scene->pairs);
  }
  for (size_t n = 0; n < scene->pairs; n++) {
    size_t line = 0;
    while (line < scene->motion.lines && !path_line_asked(scene, &scene->pair[n], line)) {
      line++;
    }
    if (line < scene->motion.lines) {
      e->pair[e->pairs++] = n;
    }
  }
  return e->pairs > 0 ||
         sepax_fail(
             error, SEPAX_ERROR_ARGUMENT,
             "no pair is for the engine: rules, or the stock as it is cut, decide all pairs");
}

bool path_engine_make(path_engine *e, const path_scene *scene, const path_question *q,
                      sepax_error *error) {
  sepax_design design;
  *e = (path_engine){.bodies = scene->bodies};
  if (!find_pairs(e, scene, error) || !choose_grid(e, scene, q, error) ||
      !choose_bands(e, q, &design, error)) {
    path_engine_free(e);
    return false;
  }
  e->tree = calloc(e->bodies + 1, sizeof(sepax_tree *));
  e->pose = calloc(e->pairs + 1, sizeof *e->pose);
  if (e->tree == NULL || e->pose == NULL) {
    path_engine_free(e);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for trees");
  }
  bool ok = true;
  for (size_t n = 0; n < e->pairs && ok; n++) {
    for (int side = 0; side < 2 && ok; side++) {
      size_t body = scene->pair[e->pair[n]].body[side];
      ok = e->tree[body] != NULL || add_tree(e, scene, body, error);
    }
    ok = ok && add_poses(e, scene, q, n, design.margin[1], error);
  }
  if (!ok) {
    path_engine_free(e);
  }
  return ok;
}
