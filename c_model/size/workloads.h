/* workloads.h - what one pose of a scene gives a design to do, and how long that takes (private).
 */
#ifndef SEPAX_WORKLOADS_H
#define SEPAX_WORKLOADS_H

#include "sepax_tree.h"
#include "util/aabb.h"

/* Two quantised bodies, with the AABBs of their triangles. */
typedef struct {
  sepax_tri *tri[2];
  aabb *bounds[2];
  size_t count[2]; /* below 2^32 */
  bool limited;    /* the core has a clearance: */
  int64_t margin;  /* by which AABBs are larger; no pair takes two passes */
} workload_bodies;

/* The workload of these bodies. Fails without memory. */
bool sepax__workload_find(sepax_workload *workload, const workload_bodies *bodies,
                          sepax_error *error);

/* The cycles of a workload of count[0] x count[1] triangles, without loading and the core's
 * latency: with lanes as the golden model of the engine says; of a core alone, all pairs and those
 * that take two passes. `steps` has space for workload->passes numbers. */
uint64_t sepax__workload_cycles(const sepax_workload *workload, const size_t count[2],
                                const sepax_config *config, uint64_t *steps);

/* No workload of `passes` passes of candidates takes fewer cycles. */
uint64_t sepax__workload_least_cycles(uint64_t passes, const size_t count[2],
                                      const sepax_config *config);

/* Cycles in which the vertices of a turned B come, and A's where they did not stay: with lanes. */
uint64_t sepax__workload_loading(const size_t count[2], const sepax_config *config);

/* --------------------------------------------------------------------- on a path */

/* The bodies of a path as a tree engine gets them. */
struct sepax_size_trees {
  sepax_tree *tree[2];
  sepax_tree_pose *pose;
  size_t poses;
  int word;    /* of both, 4 ... 21 */
  bool shared; /* trees and poses are another's */
};

/* Of quantised bodies, each on a grid of its own, which differ in offset and word, for designs with
 * the clearances of `space`. Fails as sepax_tree_new and sepax_tree_pose_make do. */
bool sepax__size_trees_new(struct sepax_size_trees **trees, const workload_bodies *bodies,
                           const sepax_grid grid[2], const sepax_space *space, sepax_error *error);
void sepax__size_trees_free(struct sepax_size_trees *trees);

/* The clearances into a configuration. */
void sepax__size_limit(sepax_config *config, bool limited, int clearance, int warning);

/* A tree engine of this configuration in a pose. */
bool sepax__size_trees_walk(const struct sepax_size_trees *trees, const sepax_config *config,
                            size_t pose, const sepax_size_request *request, sepax_tree_run *run,
                            sepax_error *error);

#endif
