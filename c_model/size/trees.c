/* SPDX-License-Identifier: MIT */
/* trees.c - makes the input of a tree engine from the bodies of a scene and their path.
 * docs/reference/size.md. */
#include "size/workloads.h"

#include "util/error.h"

#include <stdlib.h>

bool sepax__size_trees_new(struct sepax_size_trees **trees, const workload_bodies *bodies,
                           const sepax_grid grid[2], const sepax_space *space, sepax_error *error) {
  const sepax_poses *path = space->path;
  struct sepax_size_trees *t = calloc(1, sizeof *t);
  sepax_config config = sepax_config_default();
  sepax_design design;
  if (t == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for two trees");
  }
  t->poses = path->count;
  t->word = grid[0].word > grid[1].word ? grid[0].word : grid[1].word;
  t->pose = calloc(path->count, sizeof *t->pose);
  bool ok = t->pose != NULL ||
            sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu poses", path->count);
  config.tree = true;
  config.word = t->word;
  sepax__size_limit(&config, space->limited, space->clearance, space->warning);
  ok = ok && sepax_design_init(&design, &config, error);
  for (int i = 0; i < 2 && ok; i++) {
    ok = sepax_tree_new(&t->tree[i], bodies->tri[i], bodies->count[i], &grid[i], error);
  }
  for (size_t k = 0; k < path->count && ok; k++) {
    ok = sepax_tree_pose_make(&t->pose[k], t->tree[0], NULL, t->tree[1], &path->pose[k],
                              design.margin[1], error);
  }
  if (ok) {
    *trees = t;
  } else {
    sepax__size_trees_free(t);
  }
  return ok;
}

void sepax__size_trees_free(struct sepax_size_trees *trees) {
  if (trees != NULL && !trees->shared) {
    sepax_tree_free(trees->tree[0]);
    sepax_tree_free(trees->tree[1]);
    free(trees->pose);
  }
  free(trees);
}

void sepax__size_limit(sepax_config *config, bool limited, int clearance, int warning) {
  if (limited) {
    config->clearance = clearance;
    config->warning = warning;
  }
}

bool sepax__size_trees_walk(const struct sepax_size_trees *trees, const sepax_config *config,
                            size_t pose, const sepax_size_request *request, sepax_tree_run *run,
                            sepax_error *error) {
  sepax_design design;
  if (!sepax_design_init(&design, config, error)) {
    return false;
  }
  const sepax_tree_walk_options how = {
      .design = &design, .latency = request->latency, .first = request->first};
  return sepax_tree_walk(trees->tree[0], trees->tree[1], &trees->pose[pose], &how, run, error);
}
