/* SPDX-License-Identifier: MIT */
/* scene.c - six bodies of a machine tool, of which three move along a path: the pairs that may meet
 * are jobs of one list, so that the engine takes the whole path without the host. Each pose is
 * compared with the golden model. */
#include "bench.h"
#include "sepax_vectors.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { STAND = 3, MOVE = 3, BODIES = STAND + MOVE };

typedef struct {
  const char *name, *shape;
  size_t triangles;
  double at[3], size; /* mm */
} part;

/* The tool's tip is the origin of what moves. The fixture holds the workpiece from below; tool,
 * holder and spindle are one on the other. What touches by its making is no pair. */
static const part parts[BODIES] = {
    {"table", "box", 400, {0, 0, -150}, 400},      {"fixture", "box", 2000, {0, 0, -60}, 170},
    {"workpiece", "pocket", 4000, {0, 0, 0}, 120}, {"spindle", "flat-end", 2000, {0, 0, 120}, 80},
    {"holder", "flat-end", 2000, {0, 0, 30}, 30},  {"tool", "ball-end", 4000, {0, 0, 0}, 10},
};

static const double lsb = 0.004; /* mm */

static sepax_tree *tree_of(const part *p, const sepax_grid *grid) {
  sepax_error error = {0};
  sepax_soup mesh;
  stop_on(!sepax_sample(&mesh, p->shape, p->triangles, p->at, p->size, &error), error.text);
  sepax_tri *tri = malloc(mesh.count * sizeof *tri);
  stop_on(tri == NULL, "out of memory");
  sepax_tree *tree = NULL;
  stop_on(!sepax_quantise(SEPAX_SOUP_MESH(&mesh), grid, tri, &error) ||
              !sepax_tree_new(&tree, tri, mesh.count, grid, &error),
          error.text);
  free(tri);
  sepax_soup_free(&mesh);
  return tree;
}

/* Down into the pocket, to and fro in it while the tool tilts, now and then into its wall; at the
 * end up again, tilted so far that the holder comes near to what stands. */
static sepax_pose on_path(double u) {
  double down = u < 0.1 ? 1 - u / 0.1 : 0;
  double up = u > 0.9 ? (u - 0.9) / 0.1 : 0;
  double wave = sin(300 * u);
  bool gouges = sin(40 * u) > 0.97;
  double a = 0.2 * sin(23 * u) + 0.9 * up;
  double b = 0.25 * cos(31 * u) * (1 - down);
  double x = (gouges ? 38 : 30) * wave;
  double y = 10 * sin(17 * u);
  double z = -19 + 3 * sin(11 * u) + 60 * down + 25 * up;
  return (sepax_pose){{{cos(b), sin(b) * sin(a), sin(b) * cos(a)},
                       {0, cos(a), -sin(a)},
                       {-sin(b), cos(b) * sin(a), cos(b) * cos(a)}},
                      {x, y, z}};
}

/* The queue of poses; all that move have the same. */
static size_t queue_of(sepax_tree *const tree[BODIES], size_t poses) {
  sepax_error error = {0};
  size_t at = bench_space(SEPAX_TREE_POSE_STRIDE * poses, SEPAX_TREE_POSE_STRIDE);
  for (size_t n = 0; n < poses; n++) {
    sepax_tree_pose fixed;
    sepax_pose pose = on_path(poses > 1 ? (double)n / (double)(poses - 1) : 0);
    stop_on(
        !sepax_tree_pose_make(&fixed, tree[0], NULL, tree[STAND], &pose, design.margin[1], &error),
        error.text);
    sepax_tree_pose_pack(&fixed, bench_at(at + SEPAX_TREE_POSE_STRIDE * n));
  }
  return at;
}

static void batch_of(bench_batch *batch, size_t poses) {
  sepax_tree *tree[BODIES];
  uint8_t record[BODIES][SEPAX_TREE_BODY_BYTES];
  const sepax_grid grid = {lsb, {0, 0, 0}, SEPAX_WORD};
  for (int i = 0; i < BODIES; i++) {
    tree[i] = tree_of(&parts[i], &grid);
    bench_tree(tree[i], record[i]);
    printf("%s%s %zu", i > 0 ? ", " : "", parts[i].name, sepax_tree_triangles(tree[i]));
  }
  printf(" triangles\n");
  sepax_tree_job job = {.count = (uint32_t)poses,
                        .modes = SEPAX_TREE_FIRST | SEPAX_TREE_AGAIN,
                        .poses = bench_address(queue_of(tree, poses))};
  batch->jobs = STAND * MOVE;
  batch->list = bench_space(SEPAX_TREE_JOB_BYTES * batch->jobs, SEPAX_TREE_JOB_BYTES);
  for (int n = 0; n < STAND * MOVE; n++) {
    memcpy(job.body[0], record[n % STAND], sizeof record[0]);
    memcpy(job.body[1], record[STAND + n / STAND], sizeof record[0]);
    sepax_tree_job_pack(&job, bench_at(batch->list + SEPAX_TREE_JOB_BYTES * (size_t)n));
  }
  for (int i = 0; i < BODIES; i++) {
    sepax_tree_free(tree[i]);
  }
}

/* What the batches of a scene add up to. */
typedef struct {
  uint64_t mismatches;
  double slowest; /* the most cycles of a pose, on average of a batch */
} scene_sum;

/* Run a batch of so many poses with memories of each kind. */
static void with_memories(const bench_batch *batch, size_t poses, scene_sum *sum) {
  static const struct {
    const char *name;
    memory_options options;
  } memories[] = {{"20", {.latency = 20}},
                  {"100", {.latency = 100}},
                  {"300", {.latency = 300}},
                  {"banks", {.latency = 1, .banked = true}}};
  printf("%8s %14s %16s %10s %10s %10s %10s\n", "latency", "poses/second", "cycles/pose",
         "worst pair", "collide", "near pairs", "mismatches");
  for (size_t k = 0; k < sizeof memories / sizeof *memories; k++) {
    bench_batch one = *batch;
    bench_attach(memories[k].options);
    uint64_t begin = bus_cycles();
    bench_run(&one);
    double cycles = (double)(bus_cycles() - begin) / (double)poses;
    sum->slowest = cycles > sum->slowest ? cycles : sum->slowest;
    printf("%8s %14.0f %16.0f %10llu %10llu %10llu %10llu\n", memories[k].name, 5e8 / cycles,
           cycles, (unsigned long long)one.worst, (unsigned long long)one.hits,
           (unsigned long long)one.near, (unsigned long long)one.mismatches);
    fflush(stdout);
    expect("runs", one.poses, (unsigned long long)poses * batch->jobs);
    sum->mismatches += one.mismatches;
  }
}

void bench_scene(size_t poses) {
  bench_batch batch = {.stop_at = -1};
  scene_sum sum = {0};
  stop_on(poses > 1000000, "--scene is 1 ... 1000000 poses");
  bench_clear();
  batch_of(&batch, poses);
  printf("%d pairs of bodies, %zu poses, first collision of each; 500 MHz\n", STAND * MOVE, poses);
  with_memories(&batch, poses, &sum);
  /* The pair with the most work in its trees is the last one. */
  bench_batch last = batch;
  last.list += SEPAX_TREE_JOB_BYTES * (size_t)(batch.jobs - 1);
  last.jobs = 1;
  printf("%s and %s alone\n", parts[BODIES - 1].name, parts[STAND - 1].name);
  with_memories(&last, poses, &sum);
  printf("%zu poses of %d pairs of bodies in 4 memories, %llu mismatches, worst mean %.0f cycles\n",
         poses, STAND * MOVE, (unsigned long long)sum.mismatches, sum.slowest);
}
