/* SPDX-License-Identifier: MIT */
/* candidates.h - the designs that a request allows, and their cycles in a pose (private). */
#ifndef SEPAX_CANDIDATES_H
#define SEPAX_CANDIDATES_H

#include "sepax_design.h"

/* The work of a tree engine in a pose, which does not depend on II and cores, and the cycles of the
 * fastest tree engine. */
typedef struct {
  uint64_t near, least;
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
} candidates;

/* How designs with one engine are found and tried. */
typedef struct {
  /* Add all designs that the request allows, each with cycles that no pose can beat. NULL: designs
   * with this engine are not considered. */
  bool (*add)(candidates *all, sepax_error *error);
  size_t (*poses)(const candidates *all); /* number of poses to try; 0: the work is not known */
  /* The cycles of a pair in a pose. `steps` has space for the candidates of the pose. NULL: they
   * are not known. */
  bool (*cycles)(uint64_t *cycles, const sepax_size *size, const sepax_config *config, size_t pose,
                 const sepax_size_request *request, uint64_t *steps, sepax_error *error);
  bool waits; /* the engine also takes candidates.job and candidates.list cycles */
} candidate_kind;

/* The kind of a design, by its engine. */
const candidate_kind *sepax__candidate_kind(const sepax_config *config);

/* List all designs that the request allows. After false *all can be freed. */
bool sepax__candidates_find(candidates *all, sepax_error *error);
void sepax__candidates_free(candidates *all);

/* True if the pair is not asked in this pose. */
static inline bool sepax__is_absent(const sepax_size *size, size_t pose) {
  return size->absent != NULL && size->absent[pose] != 0;
}

/* Passes of the pair in this pose; 0 if workloads were not computed. */
static inline uint64_t sepax__candidates_of(const sepax_size *size, size_t pose) {
  return pose < size->workloads ? size->workload[pose].candidates : 0;
}

#endif
