/* SPDX-License-Identifier: MIT */
/* command.c - sepax size: measures the scene, finds the smallest design and generates it. */
#include "command_table.h"
#include "design/engine_table.h"
#include "estimate.h"
#include "generate.h"
#include "size/parts.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Lengths of a machine's options are in metres, those of two meshes in mm. */
static cli_meshes in_mm(const cli_meshes *metres) {
  cli_meshes mm = *metres;
  mm.unit = CLI_MILLIMETRES;
  mm.own.length *= 1000;
  mm.weld.length *= 1000;
  return mm;
}

static bool read_and_size(const size_options *o, size_answer *answer, sepax_error *error) {
  sepax_soup mesh[2] = {{0}, {0}};
  sepax_poses path = {NULL, 0};
  sepax_space space = o->space;
  const cli_meshes rules = in_mm(&o->scene.meshes);
  double cycles = o->request.seconds / (o->clock.clock_ps * 1e-12);
  bool posed = o->path_file != NULL;
  if (o->is_scene) {
    return size_scene_read(answer, o, error);
  }
  answer->size = calloc(1, sizeof *answer->size);
  if (answer->size == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a scene");
  }
  answer->pairs = 1;
  space.path = posed ? &path : NULL;
  space.pairs_most = cycles < 1e15 ? 1 + (uint64_t)(cycles * SEPAX_LANES_MAX) : 0;
  bool ok = (!posed || sepax_poses_read(&path, o->path_file, error)) &&
            cli_mesh_read(&mesh[0], &answer->file[0], o->path[0], &rules, error) &&
            cli_mesh_read(&mesh[1], &answer->file[1], o->path[1], &rules, error) &&
            sepax_size_scene(answer->size, &mesh[0], &mesh[1], &space, error);
  sepax_soup_free(&mesh[0]);
  sepax_soup_free(&mesh[1]);
  sepax_poses_free(&path);
  return ok;
}

/* The generator's plan of a design that is in time: it may refuse the clock. */
static bool plan(const sepax_design *design, double *gates, double *gates_error,
                 sepax_error *error) {
  sepax_estimate e;
  bool ok = sepax_estimate_design(design, &e, error);
  if (ok && e.gates_known) {
    *gates = e.gates;
    *gates_error = e.gates_error;
  }
  return ok;
}

static bool design_of(sepax_sized_design *best, const size_options *o, const size_answer *answer,
                      const sepax_size_request *request, sepax_error *error) {
  return o->is_scene ? sepax_size_pairs(best, answer->size, answer->pairs, request, error)
                     : sepax_size_design(best, answer->size, request, error);
}

static void release(size_answer *answer) {
  for (size_t n = 0; n < answer->pairs; n++) {
    sepax_size_free(&answer->size[n]);
  }
  free(answer->size);
  size_scene_free(answer);
}

/* Find the best design with each engine, and the best of all. */
static bool choose(const size_options *o, size_answer *answer, sepax_error *error) {
  sepax_error why = {0};
  uint64_t fewest = UINT64_MAX;
  for (int n = 0; n < SEPAX_ENGINE_COUNT; n++) {
    size_best *k = &answer->with[n];
    sepax_size_request request = o->request;
    request.plan = plan;
    k->asked = size_engines[n].name != NULL && size_engines[n].ask(&request, o, answer);
    k->in_time = k->asked && design_of(&k->best, o, answer, &request, error);
    if (k->asked && !k->in_time && k->best.cycles == 0) {
      return false;
    }
    k->refused = k->asked && !k->in_time && error->code == SEPAX_ERROR_ARGUMENT;
    if (k->asked && !k->in_time && k->best.cycles < fewest) {
      fewest = k->best.cycles;
      why = *error;
    }
    if (k->in_time && (answer->best == NULL || k->best.gates < answer->best->gates)) {
      answer->best = &k->best;
    }
  }
  if (answer->best == NULL && why.code == SEPAX_OK) {
    return sepax_fail(
        error, SEPAX_ERROR_LIMIT,
        "tree: the scene needs %d bits of a coordinate, and a tree engine has at most %d; coarsen "
        "the resolution",
        answer->size->grid.word, SEPAX_TREE_WORD_MAX);
  }
  *error = why;
  return answer->best != NULL;
}

/* Fails if an input is one of the files that --gen would write or remove. */
static bool inputs_spared(const size_options *o, sepax_error *error) {
  const char *const inputs[] = {o->path[0], o->path[1], o->path_file, o->scene.srdf};
  for (size_t n = 0; n < sizeof inputs / sizeof inputs[0]; n++) {
    const char *slash = inputs[n] != NULL ? strrchr(inputs[n], '/') : NULL;
    const char *base = slash != NULL ? slash + 1 : inputs[n];
    char output[4096];
    if (base == NULL || o->folder == NULL || strncmp(base, "sepax", 5) != 0) {
      continue;
    }
    int length = snprintf(output, sizeof output, "%s/%s", o->folder, base);
    if (length < (int)sizeof output && cli_same_file(output, inputs[n])) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%.300s: is an input; name another folder to write", output);
    }
  }
  return true;
}

static bool generate(const size_options *o, const sepax_sized_design *m, sepax_error *error) {
  sepax_design design;
  return sepax_design_init(&design, &m->config, error) &&
         sepax_generate(&design, o->folder, &(sepax_output){NULL}, error);
}

int cli_size(int argc, char **argv) {
  size_options o;
  size_parse(&o, argc, argv);
  sepax_error error = {0};
  size_answer answer = {.best = NULL};
  bool ok = (!o.json || size_names_printable(&o, &error)) && sepax_config_check(&o.clock, &error) &&
            inputs_spared(&o, &error) && read_and_size(&o, &answer, &error) &&
            choose(&o, &answer, &error) && (!o.is_scene || size_scene_tell(&answer, &o, &error)) &&
            (!o.generate || generate(&o, answer.best, &error));
  if (ok) {
    (o.json ? size_print_json : size_print_text)(&o, &answer);
  }
  release(&answer);
  return ok ? 0 : cli_fail(argv[0], &error);
}
