/* SPDX-License-Identifier: MIT */
/* rounds.h - seeded bodies, poses and jobs in memory. */
#ifndef SEPAX_BATCH_ROUNDS_H
#define SEPAX_BATCH_ROUNDS_H

#include "bench.h"
#include "sepax_vectors.h"

enum { JOBS_MOST = 4 };

typedef struct {
  sepax_tree *tree[2];
  size_t job[JOBS_MOST], pose[JOBS_MOST], poses[JOBS_MOST]; /* where they are */
  size_t body[2], bytes[2];
  sepax_vec vertex[2]; /* one of each body */
  uint32_t shift[2];   /* of the numbers of nodes, but for the roots */
  bench_batch batch;
} scene;

void some_scene(scene *s);
void free_scene(scene *s);

/* One job of so many poses, without modes and a budget; of bodies of up to 40 triangles, or any. */
void simple_scene(scene *s, uint32_t poses, bool of_small);

/* Memory and host that do what they must not, or the worst that they may. */
void partners(uint64_t seed);

/* What the engine refuses, its settings and interrupts. */
void refusals(void);

/* Put a body there of which all but the root is far behind in the image, and whose triangles have
 * great numbers, as in bodies of millions: its record; returns the shift. */
uint32_t scattered_tree(const sepax_tree *tree, bool of_b, sepax_random *rng,
                        uint8_t record[SEPAX_TREE_BODY_BYTES]);

#endif
