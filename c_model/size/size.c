/* SPDX-License-Identifier: MIT */
/* size.c - finds the design with the fewest gates that judges a scene in time.
 * docs/reference/size.md. */
#include "design/engine_table.h"
#include "size/gates.h"
#include "size/workloads.h"
#include "util/error.h"

#include <stdio.h>
#include <stdlib.h>

/* The initiation intervals of the designs to which the gates were fitted. */
static const int intervals[] = {1, 2, 3, 4, 6, 9, 18};
enum { INTERVALS = sizeof intervals / sizeof intervals[0] };

/* Cycles of a tree engine between a job and the next, without the latency of its memory. */
enum { BETWEEN = 40 };

/* The work of a tree engine in a pose, which does not depend on II and cores, and the cycles of the
 * fastest tree engine. */
typedef struct {
  uint64_t passes, least;
} tree_work;

typedef struct {
  const sepax_size *size; /* one for each pair */
  size_t pairs;
  uint64_t job, list; /* for engines that work on a list of jobs: cycles of each pair in a pose, and
                         of all of them, beyond those of their triangles */
  int word;           /* longest word of all pairs, for designs without a tree */
  int tree_word;
  size_t tree_poses;
  int64_t extent[2];
  size_t largest[2]; /* most triangles of a body A and of a body B */
  const sepax_size_request *request;
  sepax_sized_design *design; /* all designs of the request, with lower bounds of their cycles */
  size_t count;
  uint64_t *steps; /* sepax__workload_cycles */
  size_t busiest;  /* the pose with the most work for designs without a tree */
  tree_work *work; /* one for each pose; NULL: no tree engine is considered */
} choice;

/* How designs with one engine are found and tried. */
typedef struct {
  /* Add all designs that the request names, each with cycles that no pose can beat. NULL: designs
   * with this engine are not considered. */
  bool (*add)(choice *all, sepax_error *error);
  size_t (*poses)(const choice *all); /* number of poses to try; 0: the work is not known */
  /* The cycles of a pair in a pose. `steps` has space for the passes of the pose. NULL: they are
   * not known. */
  bool (*cycles)(uint64_t *cycles, const sepax_size *size, const sepax_config *config, size_t pose,
                 const sepax_size_request *request, uint64_t *steps, sepax_error *error);
  bool waits; /* the engine also takes choice.job and choice.list cycles */
} sizing;

static const sizing sizings[SEPAX_ENGINE_COUNT];

static const sizing *sizing_of(const sepax_config *config) {
  return &sizings[sepax__config_engine(config)];
}

static uint64_t larger(uint64_t a, uint64_t b) { return a > b ? a : b; }

static bool is_absent(const sepax_size *size, size_t pose) {
  return size->absent != NULL && size->absent[pose] != 0;
}

static bool add_design(choice *all, const sepax_config *config, uint64_t least,
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

static uint64_t most_passes(const sepax_size *size) {
  uint64_t passes = 0;
  for (size_t n = 0; n < size->workloads; n++) {
    passes = larger(passes, size->workload[n].passes);
  }
  return passes;
}

static uint64_t passes_of(const sepax_size *size, size_t pose) {
  return pose < size->workloads ? size->workload[pose].passes : 0;
}

/* The pose with the most pairs of triangles; of several, the one with the most passes. */
static size_t busiest_pose(const choice *all) {
  size_t poses = all->size->path > 0 ? all->size->path : all->size->workloads;
  size_t best = 0;
  double most[2] = {-1, -1};
  for (size_t n = 0; n < poses; n++) {
    double pairs = 0;
    double passes = 0;
    for (size_t k = 0; k < all->pairs; k++) {
      const sepax_size *size = &all->size[k];
      if (!is_absent(size, n)) {
        pairs += (double)size->count[0] * (double)size->count[1];
        passes += (double)passes_of(size, n);
      }
    }
    if (pairs > most[0] || (pairs == most[0] && passes > most[1])) {
      most[0] = pairs;
      most[1] = passes;
      best = n;
    }
  }
  return best;
}

/* A lower bound of the cycles of all pairs in the slowest pose: those of one pose. */
static uint64_t least_cycles(const choice *all, const sepax_config *config) {
  uint64_t sum = 0;
  for (size_t n = 0; n < all->pairs; n++) {
    const sepax_size *size = &all->size[n];
    if (!is_absent(size, all->busiest)) {
      sum += sepax__workload_least_cycles(passes_of(size, all->busiest), size->count, config) +
             loading(size, config);
    }
  }
  return sum;
}

/* Add designs with extents, if these save bits, and without. */
static bool add_designs(choice *all, int lanes, sepax_error *error) {
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

static bool add_core(choice *all, sepax_error *error) {
  const sepax_size_request *r = all->request;
  return r->lanes_least > 0 || r->lanes_most < 0 || add_designs(all, 0, error);
}

static bool add_object_engines(choice *all, sepax_error *error) {
  const sepax_size_request *r = all->request;
  bool ok = true;
  for (int lanes = r->lanes_least > 0 ? r->lanes_least : 1; lanes <= r->lanes_most && ok; lanes++) {
    ok = add_designs(all, lanes, error);
  }
  return ok;
}

static size_t poses_of_workloads(const choice *all) { return all->size->workloads; }

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

static sepax_config tree_engine(const choice *all, int ii, int cores) {
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
static bool find_work(choice *all, sepax_error *error) {
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
      if (is_absent(&all->size[k], n)) {
        continue;
      }
      if (!sepax__size_trees_walk(all->size[k].trees, &fastest, n, all->request, &run, error)) {
        return false;
      }
      all->work[n].passes += run.passes;
      all->work[n].least += run.cycles + all->job;
    }
  }
  return true;
}

static bool add_tree_engines(choice *all, sepax_error *error) {
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
      uint64_t busy = all->work[k].passes /
                      (uint64_t)cores; /* after the last pass of a pair no II is waited for */
      busy = busy > all->pairs ? (busy - all->pairs) * (uint64_t)config.ii : 0;
      least = larger(least, larger(busy, all->work[k].least));
    }
    if (!add_design(all, &config, least, error)) {
      return false;
    }
  }
  return true;
}

static size_t poses_of_walks(const choice *all) { return all->tree_poses; }

static bool cycles_of_walk(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                           size_t pose, const sepax_size_request *request, uint64_t *steps,
                           sepax_error *error) {
  sepax_tree_run run;
  (void)steps;
  bool ok = sepax__size_trees_walk(size->trees, config, pose, request, &run, error);
  *cycles = ok ? run.cycles : 0;
  return ok;
}

static const sizing sizings[SEPAX_ENGINE_COUNT] = {
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

/* ------------------------------------------------------------------------- choosing */

bool sepax_size_cycles(uint64_t *cycles, const sepax_size *size, const sepax_config *config,
                       size_t pose, const sepax_size_request *request, sepax_error *error) {
  const sizing *of = sizing_of(config);
  if (of->cycles == NULL) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "cycles: they are not known for %s; choose another design",
                      sepax__engine_of(config)->name);
  }
  if (is_absent(size, pose)) {
    *cycles = 0;
    return true;
  }
  size_t passes = (size_t)passes_of(size, pose);
  uint64_t *steps = malloc((passes + 1) * sizeof *steps);
  bool ok = steps != NULL
                ? of->cycles(cycles, size, config, pose, request, steps, error)
                : sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu candidates", passes);
  free(steps);
  return ok;
}

/* The cycles of all pairs in a pose. The sum stops above the limit. */
static bool cycles_in_pose(const choice *all, const sepax_config *config, size_t pose,
                           uint64_t limit, uint64_t *cycles, sepax_error *error) {
  const sizing *of = sizing_of(config);
  *cycles = of->waits ? all->list : 0;
  for (size_t n = 0; n < all->pairs && *cycles <= limit; n++) {
    uint64_t one;
    if (is_absent(&all->size[n], pose)) {
      continue;
    }
    if (!of->cycles(&one, &all->size[n], config, pose, all->request, all->steps, error)) {
      return false;
    }
    *cycles += one + (of->waits ? all->job : 0);
  }
  return true;
}

/* Find the slowest pose of a design, or any pose that takes more than `limit`. m->worst is the pose
 * to try first and becomes the slowest one. */
static bool try_poses(const choice *all, sepax_sized_design *m, uint64_t limit,
                      sepax_error *error) {
  const sizing *of = sizing_of(&m->config);
  size_t poses = of->poses(all);
  size_t begin = m->worst;
  double sum = 0;
  m->cycles = 0;
  for (size_t n = 0; n < poses && m->cycles <= limit; n++) {
    size_t at = (begin + n) % poses;
    uint64_t cycles;
    if (!cycles_in_pose(all, &m->config, at, limit, &cycles, error)) {
      return false;
    }
    m->worst = n == 0 || cycles > m->cycles ? at : m->worst;
    m->cycles = larger(m->cycles, cycles);
    sum += (double)cycles;
  }
  m->mean = sum / (double)poses;
  return true;
}

static int by_gates(const void *p, const void *q) {
  const sepax_sized_design *a = p;
  const sepax_sized_design *b = q;
  return a->gates != b->gates ? (a->gates > b->gates) - (a->gates < b->gates)
                              : (a->cycles > b->cycles) - (a->cycles < b->cycles);
}

/* Sort by the bound of the cycles. Of equal bounds the design with more gates comes first, because
 * it is likely to be faster. */
static int by_cycles(const void *p, const void *q) {
  const sepax_sized_design *a = p;
  const sepax_sized_design *b = q;
  return a->cycles != b->cycles ? (a->cycles > b->cycles) - (a->cycles < b->cycles)
                                : by_gates(q, p);
}

/* The smallest design that takes at most `limit` cycles in every pose. If there is none, then
 * best->config.word is 0. Poses that were slow before are tried first. */
static bool find_cheapest(choice *all, uint64_t limit, sepax_sized_design *best,
                          sepax_error *error) {
  size_t pose[SEPAX_ENGINE_COUNT] = {0};
  best->config.word = 0;
  qsort(all->design, all->count, sizeof *all->design, by_gates);
  for (size_t n = 0; n < all->count; n++) {
    sepax_sized_design m = all->design[n];
    size_t *worst = &pose[sepax__config_engine(&m.config)];
    if (m.cycles <= limit && sizing_of(&m.config)->poses(all) > 0) {
      m.worst = *worst;
      if (!try_poses(all, &m, limit, error)) {
        return false;
      }
      *worst = m.worst;
      if (m.cycles <= limit) {
        *best = m;
        return true;
      }
    }
  }
  return true;
}

/* The fewest cycles of all designs. If workloads were not computed, then a bound that no design can
 * beat. */
static bool find_fewest(choice *all, uint64_t *fewest, sepax_error *error) {
  size_t pose[SEPAX_ENGINE_COUNT] = {0};
  *fewest = UINT64_MAX;
  qsort(all->design, all->count, sizeof *all->design, by_cycles);
  for (size_t n = 0; n < all->count && all->design[n].cycles < *fewest; n++) {
    sepax_sized_design m = all->design[n];
    size_t *worst = &pose[sepax__config_engine(&m.config)];
    m.worst = *worst;
    if (sizing_of(&m.config)->poses(all) > 0 && !try_poses(all, &m, *fewest, error)) {
      return false;
    }
    *worst = m.worst;
    *fewest = m.cycles < *fewest ? m.cycles : *fewest;
  }
  return true;
}

static bool too_slow(choice *all, double period, sepax_sized_design *sized, sepax_error *error) {
  const sepax_size_request *r = all->request;
  uint64_t fewest;
  char kinds[64] = "tree engine";
  if (r->lanes_least <= r->lanes_most) {
    snprintf(kinds, sizeof kinds, "design of up to %d lanes%s", r->lanes_most,
             all->work != NULL ? " or a tree" : "");
  }
  if (!find_fewest(all, &fewest, error)) {
    return false;
  }
  *sized = (sepax_sized_design){.cycles = fewest, .seconds = (double)fewest * period};
  return sepax_fail(
      error, SEPAX_ERROR_ARGUMENT,
      "time: %.4g ms is too short: at a clock of %g ns the fastest %s takes %.4g ms; allow more "
      "time, or coarsen the meshes",
      1e3 * r->seconds, 1e9 * period, kinds, 1e3 * sized->seconds);
}

static bool choose(choice *all, sepax_sized_design *sized, sepax_error *error) {
  double period = all->request->clock_ps * 1e-12;
  double limit = all->request->seconds / period * (1 + 1e-9);
  sepax_sized_design best;
  if (!find_cheapest(all, limit < 0x1p63 ? (uint64_t)limit : UINT64_MAX, &best, error)) {
    return false;
  }
  if (best.config.word == 0) {
    return too_slow(all, period, sized, error);
  }
  best.seconds = (double)best.cycles * period;
  *sized = best;
  return true;
}

static bool allocate(choice *all, sepax_error *error) {
  const sepax_size_request *r = all->request;
  size_t passes = 0;
  for (size_t n = 0; n < all->pairs; n++) {
    const sepax_size *size = &all->size[n];
    passes = (size_t)larger(passes, most_passes(size));
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
  all->steps = malloc((passes + 1) * sizeof *all->steps);
  return (all->design != NULL && all->steps != NULL) ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu designs and %zu candidates", most,
                    passes);
}

static bool size_all(choice *all, sepax_sized_design *sized, sepax_error *error) {
  *sized = (sepax_sized_design){.cycles = 0};
  bool ok = allocate(all, error);
  all->busiest = busiest_pose(all);
  for (int n = 0; n < SEPAX_ENGINE_COUNT && ok; n++) {
    ok = sizings[n].add == NULL || sizings[n].add(all, error);
  }
  if (ok && all->count == 0) {
    ok = sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "word: a tree engine needs a path of poses and has at most %d bits; give the poses, or "
        "coarsen the resolution",
        SEPAX_TREE_WORD_MAX);
  }
  ok = ok && choose(all, sized, error);
  free(all->design);
  free(all->steps);
  free(all->work);
  return ok;
}

bool sepax_size_design(sepax_sized_design *sized, const sepax_size *size,
                       const sepax_size_request *request, sepax_error *error) {
  choice all = {.size = size, .pairs = 1, .request = request};
  return size_all(&all, sized, error);
}

bool sepax_size_pairs(sepax_sized_design *sized, const sepax_size *size, size_t pairs,
                      const sepax_size_request *request, sepax_error *error) {
  uint64_t latency = (uint64_t)(request->latency > 0 ? request->latency : SEPAX_TREE_LATENCY);
  choice all = {
      .size = size, .pairs = pairs, .job = BETWEEN + latency, .list = latency, .request = request};
  return size_all(&all, sized, error);
}
