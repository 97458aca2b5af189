/* SPDX-License-Identifier: MIT */
/* candidates.c - the designs that a request allows, kind by kind: a core alone, object engines,
 * tree engines. Each gets its gates and a number of cycles that no pose can beat. */
#include "size/candidates.h"
#include "design/engine_table.h"
#include "size/gates.h"
#include "size/workloads.h"
#include "util/error.h"

#include <stdlib.h>

/* The initiation intervals of the designs to which the gates were fitted. */
static const int intervals[] = {1, 2, 3, 4, 6, 9, 18};
enum { INTERVALS = sizeof intervals / sizeof intervals[0] };

static uint64_t larger(uint64_t a, uint64_t b) { return a > b ? a : b; }

static bool add_design(candidates *all, const sepax_config *config, uint64_t least,
                       sepax_error *error) {
  sepax_design design;
  if (!sepax_design_init(&design, config, error)) {
    return false;
  }
  sepax_sized_design *m = &all->design[all->count++];
  *m = (sepax_sized_design){.config = *config, .cycles = least};
  m->gates = sepax_gates(&design, &m->gates_error);
  m->fitted = sepax__gates_fitted(&design);
  return true;
}

/* ------------------------------------------------------- the core alone, and lanes */

static int memory_for(size_t count) {
  int memory = SEPAX_MEMORY_MIN;
  while (memory < SEPAX_MEMORY_MAX && (size_t)memory < count) {
    memory *= 2;
  }
  return memory;
}

/* On a path B is turned in each pose, so its vertices are loaded again. */
static uint64_t loading(const sepax_size *size, const sepax_config *config) {
  return size->path > 0 && config->lanes > 0 ? sepax__workload_loading(size->count, config) : 0;
}

static uint64_t most_candidates(const sepax_size *size) {
  uint64_t most = 0;
  for (size_t n = 0; n < size->workloads; n++) {
    most = larger(most, size->workload[n].candidates);
  }
  return most;
}

/* The pose with the most pairs of triangles; of several, the one with the most candidates. */
static size_t busiest_pose(const candidates *all) {
  size_t poses = all->size->path > 0 ? all->size->path : all->size->workloads;
  size_t best = 0;
  double most[2] = {-1, -1};
  for (size_t n = 0; n < poses; n++) {
    double pairs = 0;
    double near = 0;
    for (size_t k = 0; k < all->pairs; k++) {
      const sepax_size *size = &all->size[k];
      if (!sepax__is_absent(size, n)) {
        pairs += (double)size->count[0] * (double)size->count[1];
        near += (double)sepax__candidates_of(size, n);
      }
    }
    if (pairs > most[0] || (pairs == most[0] && near > most[1])) {
      most[0] = pairs;
      most[1] = near;
      best = n;
    }
  }
  return best;
}

/* A lower bound of the cycles of all pairs in the slowest pose: those of one pose. */
static uint64_t least_cycles(const candidates *all, const sepax_config *config) {
  uint64_t sum = 0;
  for (size_t n = 0; n < all->pairs; n++) {
    const sepax_size *size = &all->size[n];
    if (!sepax__is_absent(size, all->busiest)) {
      sum += sepax__workload_least_cycles(sepax__candidates_of(size, all->busiest), size->count,
                                          config) +
             loading(size, config);
    }
  }
  return sum;
}

/* Add designs with extents, if these save bits, and without. */
static bool add_designs(candidates *all, int lanes, sepax_error *error) {
  sepax_config config = sepax_config_default();
  config.word = all->word;
  config.clock_ps = all->request->clock_ps;
  config.lanes = lanes;
  sepax__size_limit(&config, all->size->limited, all->size->clearance, all->size->warning);
  if (lanes > 0) {
    config.memory_a = memory_for(all->largest[0]);
    config.memory_b = memory_for(all->largest[1]);
  }
  const int kinds = all->pairs == 1 && all->size->core_word < all->word ? 2 : 1;
  for (int extents = 0; extents < kinds; extents++) {
    config.extent_a = extents > 0 ? (int)all->extent[0] : 0;
    config.extent_b = extents > 0 ? (int)all->extent[1] : 0;
    for (int n = 0; n < INTERVALS; n++) {
      config.ii = intervals[n];
      for (config.cores = 1; config.cores <= (lanes > 0 ? SEPAX_CORES_MAX : 1); config.cores++) {
        if (!add_design(all, &config, least_cycles(all, &config), error)) {
          return false;
        }
      }
    }
  }
  return true;
}

static bool add_core(candidates *all, sepax_error *error) {
  const sepax_size_request *r = all->request;
  return r->lanes_least > 0 || r->lanes_most < 0 || add_designs(all, 0, error);
}

static bool add_object_engines(candidates *all, sepax_error *error) {
  const sepax_size_request *r = all->request;
  bool ok = true;
  for (int lanes = r->lanes_least > 0 ? r->lanes_least : 1; lanes <= r->lanes_most && ok; lanes++) {
    ok = add_designs(all, lanes, error);
  }
  return ok;
}

static size_t poses_of_workloads(const candidates *all) { return all->size->workloads; }

static bool cycles_of_workload(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                               size_t pose, const sepax_size_request *request, uint64_t *steps,
                               sepax_error *error) {
  (void)request;
  (void)error;
  *cycles = sepax__workload_cycles(&size->workload[pose], size->count, config, steps) +
            loading(size, config);
  return true;
}

/* -------------------------------------------------------------------- tree engines */

static sepax_config tree_engine(const candidates *all, int ii, int cores) {
  sepax_config config = sepax_config_default();
  config.word = all->tree_word;
  config.clock_ps = all->request->clock_ps;
  config.tree = true;
  config.ii = ii;
  config.cores = cores;
  sepax__size_limit(&config, all->size->limited, all->size->clearance, all->size->warning);
  return config;
}

/* Find the work of a tree engine in each pose. No design takes fewer cycles. */
static bool find_work(candidates *all, sepax_error *error) {
  const sepax_config fastest = tree_engine(all, 1, SEPAX_CORES_MAX);
  size_t poses = all->tree_poses;
  all->work = calloc(poses + 1, sizeof *all->work);
  if (all->work == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu poses", poses);
  }
  for (size_t n = 0; n < poses; n++) {
    all->work[n].least = all->list;
    for (size_t k = 0; k < all->pairs; k++) {
      sepax_tree_run run;
      if (sepax__is_absent(&all->size[k], n)) {
        continue;
      }
      if (!sepax__size_trees_walk(all->size[k].trees, &fastest, n, all->request, &run, error)) {
        return false;
      }
      all->work[n].near += run.near;
      all->work[n].least += run.cycles + all->job;
    }
  }
  return true;
}

static bool add_tree_engines(candidates *all, sepax_error *error) {
  if (!all->request->tree || all->size->trees == NULL) {
    return true;
  }
  if (!find_work(all, error)) {
    return false;
  }
  for (size_t n = 0; n < INTERVALS * SEPAX_CORES_MAX; n++) {
    int cores = 1 + (int)n % SEPAX_CORES_MAX;
    sepax_config config = tree_engine(all, intervals[n / SEPAX_CORES_MAX], cores);
    uint64_t least = 0;
    for (size_t k = 0; k < all->tree_poses; k++) {
      uint64_t busy =
          all->work[k].near / (uint64_t)cores; /* after the last pair no II is waited for */
      busy = busy > all->pairs ? (busy - all->pairs) * (uint64_t)config.ii : 0;
      least = larger(least, larger(busy, all->work[k].least));
    }
    if (!add_design(all, &config, least, error)) {
      return false;
    }
  }
  return true;
}

static size_t poses_of_walks(const candidates *all) { return all->tree_poses; }

static bool cycles_of_walk(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                           size_t pose, const sepax_size_request *request, uint64_t *steps,
                           sepax_error *error) {
  sepax_tree_run run;
  (void)steps;
  bool ok = sepax__size_trees_walk(size->trees, config, pose, request, &run, error);
  *cycles = ok ? run.cycles : 0;
  return ok;
}

static const candidate_kind kinds[SEPAX_ENGINE_COUNT] = {
    [SEPAX_ENGINE_NONE] = {.add = add_core,
                           .poses = poses_of_workloads,
                           .cycles = cycles_of_workload},
    [SEPAX_ENGINE_OBJECT] = {.add = add_object_engines,
                             .poses = poses_of_workloads,
                             .cycles = cycles_of_workload},
    [SEPAX_ENGINE_TREE] = {.add = add_tree_engines,
                           .poses = poses_of_walks,
                           .cycles = cycles_of_walk,
                           .waits = true},
};

/* ------------------------------------------------------------------------------ all kinds */

const candidate_kind *sepax__candidate_kind(const sepax_config *config) {
  return &kinds[sepax__config_engine(config)];
}

static bool allocate(candidates *all, sepax_error *error) {
  const sepax_size_request *r = all->request;
  size_t near = 0;
  for (size_t n = 0; n < all->pairs; n++) {
    const sepax_size *size = &all->size[n];
    near = (size_t)larger(near, most_candidates(size));
    int of_trees = size->trees != NULL ? size->trees->word : 0;
    all->tree_poses = size->trees != NULL ? size->trees->poses : 0;
    all->word = size->grid.word > all->word ? size->grid.word : all->word;
    all->tree_word = of_trees > all->tree_word ? of_trees : all->tree_word;
    for (int i = 0; i < 2; i++) {
      all->extent[i] = size->extent[i] > all->extent[i] ? size->extent[i] : all->extent[i];
      all->largest[i] = size->count[i] > all->largest[i] ? size->count[i] : all->largest[i];
    }
  }
  size_t lanes = r->lanes_least <= r->lanes_most ? (size_t)(r->lanes_most - r->lanes_least + 1) : 0;
  size_t most = (2 * lanes + 1) * INTERVALS * SEPAX_CORES_MAX;
  all->design = malloc(most * sizeof *all->design);
  all->steps = malloc((near + 1) * sizeof *all->steps);
  return (all->design != NULL && all->steps != NULL) ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu designs and %zu candidates", most,
                    near);
}

bool sepax__candidates_find(candidates *all, sepax_error *error) {
  if (!allocate(all, error)) {
    return false;
  }
  all->busiest = busiest_pose(all);
  for (int n = 0; n < SEPAX_ENGINE_COUNT; n++) {
    if (kinds[n].add != NULL && !kinds[n].add(all, error)) {
      return false;
    }
  }
  return all->count > 0 ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "word: a tree engine needs a path of poses and has at most %d bits; give the "
                    "poses, or coarsen the resolution",
                    SEPAX_TREE_WORD_MAX);
}

void sepax__candidates_free(candidates *all) {
  free(all->design);
  free(all->steps);
  free(all->work);
}
