/* SPDX-License-Identifier: MIT */
/* workloads.h - the work that one pose of a scene gives a design, and its cycles (private). */
#ifndef SEPAX_WORKLOADS_H
#define SEPAX_WORKLOADS_H

#include "sepax_tree.h"
#include "util/aabb.h"

/* Two quantised bodies, with the AABBs of their triangles. */
typedef struct {
  sepax_tri *tri[2];
  aabb *bounds[2];
  size_t count[2]; /* below 2^32 */
  bool limited;    /* the core has a clearance; then: */
  int64_t margin;  /* AABBs are enlarged by this margin */
} workload_bodies;

/* Find the workload of two bodies. Fails only without memory. */
bool sepax__workload_find(sepax_workload *workload, const workload_bodies *bodies,
                          sepax_error *error);

/* The cycles of a workload of count[0] x count[1] triangles, without loading and without the
 * latency of the core. With lanes the golden model of the engine predicts them. Without an engine
 * they are II for each pair. `steps` has space for workload->candidates numbers. */
uint64_t sepax__workload_cycles(const sepax_workload *workload, const size_t count[2],
                                const sepax_config *config, uint64_t *steps);

/* A lower bound of the cycles of any workload with this number of candidates. */
uint64_t sepax__workload_least_cycles(uint64_t candidates, const size_t count[2],
                                      const sepax_config *config);

/* Cycles to load the vertices of the turned B, and those of A that did not stay in memory. For
 * designs with lanes. */
uint64_t sepax__workload_loading(const size_t count[2], const sepax_config *config);

/* --------------------------------------------------------------------- on a path */

/* The bodies of a path as input of a tree engine. */
struct sepax_size_trees {
  sepax_tree *tree[2];
  sepax_tree_pose *pose;
  size_t poses;
  int word;    /* bits of both trees, 4 ... 21 */
  bool shared; /* trees and poses belong to somebody else */
};

/* Make trees and poses from quantised bodies, for designs with the clearances of `space`. The two
 * grids may differ in offset and word. Errors: as for sepax_tree_new and sepax_tree_pose_make. */
bool sepax__size_trees_new(struct sepax_size_trees **trees, const workload_bodies *bodies,
                           const sepax_grid grid[2], const sepax_space *space, sepax_error *error);
void sepax__size_trees_free(struct sepax_size_trees *trees);

/* Put the clearances into a configuration. */
void sepax__size_limit(sepax_config *config, bool limited, int clearance, int warning);

/* Run a tree engine with this configuration in a pose. */
bool sepax__size_trees_walk(const struct sepax_size_trees *trees, const sepax_config *config,
                            size_t pose, const sepax_size_request *request, sepax_tree_run *run,
                            sepax_error *error);

#endif
