/* rounds.h - seeded bodies, poses and jobs in memory. */
#ifndef SEPAX_BATCH_ROUNDS_H
#define SEPAX_BATCH_ROUNDS_H

#include "bench.h"

enum { JOBS_MOST = 4 };

typedef struct {
  sepax_tree *tree[2];
  size_t job[JOBS_MOST], pose[JOBS_MOST], poses[JOBS_MOST]; /* where they are */
  size_t body[2], bytes[2];
  bench_batch batch;
} scene;

void some_scene(scene *s);
void free_scene(scene *s);

/* What the engine refuses, its settings and interrupts. */
void refusals(void);

#endif
