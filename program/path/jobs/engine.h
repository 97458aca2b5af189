/* SPDX-License-Identifier: MIT */
/* engine.h - the bodies and lines of a path as input of a tree engine, for sepax path --jobs and
 * for sepax size. */
#ifndef SEPAX_PATH_ENGINE_H
#define SEPAX_PATH_ENGINE_H

#include "path/common/parts.h"
#include "sepax_tree.h"

typedef struct {
  double resolution;            /* length of 1 LSB in metres, the same for all trees */
  int word, clearance, warning; /* bits; LSB; LSB, 0 without a warning */
  sepax_tree **tree; /* the tree of each body, with the origin in its middle; NULL if the body is in
                        no pair */
  size_t bodies;
  /* The pairs that are asked in a line at least: their numbers in the scene, and their poses,
   * pose[pair][line]. */
  size_t *pair;
  sepax_tree_pose **pose;
  size_t pairs;
} path_engine;

/* Make the input of a tree engine from a scene that has kept its meshes. q->lsb and q->word are
 * used if they are given. Without an LSB the finest one is taken, and without a word the shortest
 * one that holds every vertex of a near pair. The clearances are those of q, rounded up; without
 * any, the clearance 0. */
bool path_engine_make(path_engine *engine, const path_scene *scene, const path_question *q,
                      sepax_error *error);
void path_engine_free(path_engine *engine);

#endif
