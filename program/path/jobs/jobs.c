/* SPDX-License-Identifier: MIT */
/* jobs.c - writes lists of jobs for the tree engine: one list, or one for each tool of the path.
 * docs/reference/path-engine.md. */
#include "path/jobs/engine.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What one list holds: some pairs of the engine, and some lines of the path. */
typedef struct {
  const path_engine *engine;
  const path_scene *scene;
  const size_t *pair; /* of the engine */
  size_t pairs;
  const size_t *line;
  size_t lines;
} choice;

/* The arrays of a sepax_job_scene. */
typedef struct {
  const sepax_tree **tree;
  const char **name;
  size_t *number; /* of each body of the scene that is in the list */
  sepax_job_pair *pair;
  sepax_tree_pose *pose;
  uint32_t *line;
} arrays;

static bool allocate(arrays *a, const choice *c) {
  size_t bodies = c->engine->bodies;
  a->tree = calloc(bodies + 1, sizeof *a->tree);
  a->name = calloc(bodies + 1, sizeof *a->name);
  a->number = calloc(bodies + 1, sizeof *a->number);
  a->pair = calloc(c->pairs + 1, sizeof *a->pair);
  a->pose = calloc(c->pairs * c->lines + 1, sizeof *a->pose);
  a->line = calloc(c->lines + 1, sizeof *a->line);
  return a->tree != NULL && a->name != NULL && a->number != NULL && a->pair != NULL &&
         a->pose != NULL && a->line != NULL;
}

static void release(arrays *a) {
  free(a->tree);
  free(a->name);
  free(a->number);
  free(a->pair);
  free(a->pose);
  free(a->line);
}

static const size_t *bodies_of(const choice *c, size_t n) {
  return c->scene->pair[c->engine->pair[c->pair[n]]].body;
}

/* Number the bodies of the list, in the order of the scene. */
static size_t number_bodies(arrays *a, const choice *c) {
  size_t bodies = 0;
  for (size_t n = 0; n < c->pairs; n++) {
    for (int side = 0; side < 2; side++) {
      size_t body = bodies_of(c, n)[side];
      a->tree[body] = c->engine->tree[body];
    }
  }
  for (size_t n = 0; n < c->engine->bodies; n++) {
    if (a->tree[n] != NULL) {
      a->number[n] = bodies;
      a->name[bodies] = path_body_name(c->scene, n);
      a->tree[bodies++] = a->tree[n];
    }
  }
  return bodies;
}

static void fill(arrays *a, const choice *c) {
  for (size_t n = 0; n < c->pairs; n++) {
    sepax_tree_pose *pose = &a->pose[n * c->lines];
    for (size_t k = 0; k < c->lines; k++) {
      pose[k] = c->engine->pose[c->pair[n]][c->line[k]];
    }
    const size_t *body = bodies_of(c, n);
    a->pair[n] = (sepax_job_pair){{a->number[body[0]], a->number[body[1]]}, pose};
  }
  for (size_t n = 0; n < c->lines; n++) {
    a->line[n] = (uint32_t)c->scene->motion.line[c->line[n]];
  }
}

static bool make_list(sepax_job_list *list, const choice *c, sepax_error *error) {
  arrays a = {.tree = NULL};
  bool ok = allocate(&a, c);
  if (ok) {
    size_t bodies = number_bodies(&a, c);
    fill(&a, c);
    const sepax_job_scene jobs = {.tree = a.tree,
                                  .name = a.name,
                                  .bodies = bodies,
                                  .pair = a.pair,
                                  .pairs = c->pairs,
                                  .line = a.line,
                                  .poses = c->lines,
                                  .modes = SEPAX_TREE_FIRST | SEPAX_TREE_AGAIN,
                                  .word = c->engine->word,
                                  .clearance = c->engine->clearance,
                                  .warning = c->engine->warning};
    ok = sepax_job_list_make(list, &jobs, error);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for jobs");
  }
  release(&a);
  return ok;
}

/* --------------------------------------------------------------------------- tools */

/* The tool of each line, as a number of a name. */
static size_t tool_of(const path_scene *scene, size_t line) {
  const format_motion *motion = &scene->motion;
  return scene->tool_link == SIZE_MAX ? FORMAT_NO_NAME : motion->step[line].tool;
}

/* Is the tool in the spindle in a motion that ends or begins in the line? */
static bool is_there(const path_scene *scene, size_t tool, size_t line) {
  return tool_of(scene, line) == tool ||
         (format_motion_goes_on(&scene->motion, line) && tool_of(scene, line + 1) == tool);
}

/* Choose the lines of a tool, and the pairs that the rules ask in each of these lines. */
static void choose(const path_engine *e, const path_scene *scene, size_t tool, size_t *pair,
                   size_t *line, choice *c) {
  *c = (choice){.engine = e, .scene = scene, .pair = pair, .line = line};
  for (size_t n = 0; n < scene->motion.lines; n++) {
    if (is_there(scene, tool, n)) {
      line[c->lines++] = n;
    }
  }
  for (size_t k = 0; k < e->pairs; k++) {
    const path_pair *asked = &scene->pair[e->pair[k]];
    size_t n = 0;
    while (n < c->lines && path_line_asked(scene, asked, line[n])) {
      n++;
    }
    if (n == c->lines && (asked->tool == FORMAT_NO_NAME || asked->tool == tool)) {
      pair[c->pairs++] = k;
    }
  }
}

/* The name of a tool's list: "path.sxj" becomes "path.T3.sxj". */
static char *name_of(const path_scene *scene, const char *file, size_t tool) {
  const char *base = strrchr(file, '/');
  const char *end = strrchr(base != NULL ? base : file, '.');
  const char *number = tool != FORMAT_NO_NAME ? scene->motion.name[tool] : "0";
  size_t before = end != NULL ? (size_t)(end - file) : strlen(file);
  size_t length = strlen(file) + strlen(number) + 3;
  char *name = malloc(length);
  if (name != NULL) {
    snprintf(name, length, "%.*s.T%s%s", (int)before, file, number, file + before);
  }
  return name;
}

static bool add_list(path_scene *scene, const path_question *q, const choice *c, size_t tool,
                     sepax_error *error) {
  path_jobs *jobs = &scene->jobs[scene->job_lists];
  sepax_job_list list = {.byte = NULL};
  bool tools = scene->tool_link != SIZE_MAX;
  *jobs = (path_jobs){.file = tools ? name_of(scene, q->jobs, tool) : strdup(q->jobs),
                      .jobs = c->pairs,
                      .poses = c->lines,
                      .resolution = c->engine->resolution,
                      .config = sepax_config_default()};
  bool ok = jobs->file != NULL ||
            sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the name of a list");
  ok = ok && make_list(&list, c, error) && sepax_job_list_write(&list, jobs->file, error);
  if (ok) {
    jobs->bodies = list.bodies;
    jobs->bytes = list.bytes;
    sepax_job_list_config(&list, &jobs->config);
    scene->job_lists++;
  } else {
    free(jobs->file);
  }
  sepax_job_list_free(&list);
  return ok;
}

static bool is_done(const path_scene *scene, size_t line) {
  size_t n = 0;
  while (n < line && tool_of(scene, n) != tool_of(scene, line)) {
    n++;
  }
  return n < line;
}

/* What write_all works with. */
typedef struct {
  size_t *pair, *line;
  bool *listed; /* of each pair of the scene */
} room;

static bool make_room(room *r, path_scene *scene, const path_engine *e, sepax_error *error) {
  r->pair = calloc(e->pairs + 1, sizeof *r->pair);
  r->line = calloc(scene->motion.lines + 1, sizeof *r->line);
  r->listed = calloc(scene->pairs + 1, sizeof *r->listed);
  scene->jobs = calloc(scene->motion.names + 2, sizeof *scene->jobs);
  if (r->pair != NULL && r->line != NULL && r->listed != NULL && scene->jobs != NULL) {
    return true;
  }
  sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for jobs");
  return false;
}

/* Write a list for each tool. */
static bool write_lists(path_scene *scene, const path_question *q, const path_engine *e,
                        const room *r, sepax_error *error) {
  for (size_t n = 0; n < scene->motion.lines; n++) {
    choice c;
    size_t tool = tool_of(scene, n);
    if (is_done(scene, n)) {
      continue;
    }
    choose(e, scene, tool, r->pair, r->line, &c);
    if (c.pairs > 0 && !add_list(scene, q, &c, tool, error)) {
      return false;
    }
    for (size_t k = 0; k < c.pairs; k++) {
      r->listed[e->pair[r->pair[k]]] = true;
    }
  }
  return true;
}

/* The same; pairs that are in no list are counted. */
static bool write_all(path_scene *scene, const path_question *q, const path_engine *e,
                      sepax_error *error) {
  room r;
  bool ok = make_room(&r, scene, e, error);
  if (ok) {
    ok = write_lists(scene, q, e, &r, error);
    for (size_t n = 0; n < scene->pairs; n++) {
      scene->jobs_left_out += !r.listed[n];
    }
    for (size_t n = 0; !ok && n < scene->job_lists; n++) { /* no partial output */
      unlink(scene->jobs[n].file);
    }
  }
  free(r.pair);
  free(r.line);
  free(r.listed);
  return ok;
}

bool path_write_jobs(path_scene *scene, const path_question *q, sepax_error *error) {
  path_engine engine;
  sepax_error inner = {0};
  if (!path_engine_make(&engine, scene, q, &inner)) {
    return sepax_fail(error, inner.code, "jobs: %.500s", inner.text);
  }
  bool ok = write_all(scene, q, &engine, error) &&
            (scene->job_lists > 0 ||
             sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "jobs: no pair is asked in all lines of a tool; leave --rules out"));
  path_engine_free(&engine);
  return ok;
}
