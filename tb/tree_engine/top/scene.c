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

enum { STAND = 3, MOVE = 3, BODIES = STAND + MOVE, PAIRS = STAND * MOVE };

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

static sepax_soup mesh_of(const part *p) {
  sepax_error error = {0};
  sepax_soup mesh;
  stop_on(!sepax_sample(&mesh, p->shape, p->triangles, p->at, p->size, &error), error.text);
  return mesh;
}

static sepax_tree *tree_of(const part *p, const sepax_grid *grid) {
  sepax_error error = {0};
  sepax_soup mesh = mesh_of(p);
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

/* To and fro in the pocket along a wall at x = 40, from 0.1 to 3.9 mm off it. The tool tilts only
 * along the wall, so that its radius of 5 mm is what it takes across. */
static sepax_pose at_wall(double u) {
  double a = 0.1 * sin(23 * u);
  double off = 2 - 1.9 * sin(400 * u);
  return (sepax_pose){{{1, 0, 0}, {0, cos(a), -sin(a)}, {0, sin(a), cos(a)}},
                      {35 - off, 8 * sin(17 * u), -16 + 4 * sin(11 * u)}};
}

typedef sepax_pose way(double u);

static sepax_pose on_way(way *along, size_t n, size_t poses) {
  return along(poses > 1 ? (double)n / (double)(poses - 1) : 0);
}

/* How many poses have the tool within so many mm of the workpiece, by the library. */
static size_t within(way *along, size_t poses, double distance) {
  static const sepax_query query = {.size = sizeof query, .only_any = true};
  sepax_error error = {0};
  sepax_body *body[2];
  size_t near = 0;
  for (int i = 0; i < 2; i++) {
    sepax_soup mesh = mesh_of(&parts[i == 0 ? STAND - 1 : BODIES - 1]);
    stop_on(!sepax_body_new(&body[i], SEPAX_SOUP_MESH(&mesh), NULL, &error), error.text);
    sepax_soup_free(&mesh);
  }
  for (size_t n = 0; n < poses; n++) {
    sepax_pose pose = on_way(along, n, poses);
    sepax_pairs found;
    stop_on(!sepax_bodies_near(body[0], NULL, body[1], &pose, distance, &query, &found, &error),
            error.text);
    near += found.count;
    sepax_pairs_free(&found);
  }
  sepax_body_free(body[0]);
  sepax_body_free(body[1]);
  return near;
}

/* The queue of poses; all that move have the same. */
static size_t queue_of(sepax_tree *const tree[BODIES], way *along, size_t poses) {
  sepax_error error = {0};
  size_t at = bench_space(SEPAX_TREE_POSE_STRIDE * poses, SEPAX_TREE_POSE_STRIDE);
  for (size_t n = 0; n < poses; n++) {
    sepax_tree_pose fixed;
    sepax_pose pose = on_way(along, n, poses);
    stop_on(
        !sepax_tree_pose_make(&fixed, tree[0], NULL, tree[STAND], &pose, design.margin[1], &error),
        error.text);
    sepax_tree_pose_pack(&fixed, bench_at(at + SEPAX_TREE_POSE_STRIDE * n));
  }
  return at;
}

/* The nine pairs along the path. The last of them, tool and workpiece, have the most work in their
 * trees; a job behind is theirs at the wall. The offset of the jobs. */
static size_t jobs_of(size_t poses) {
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
                        .poses = bench_address(queue_of(tree, on_path, poses))};
  uint64_t wall = bench_address(queue_of(tree, at_wall, poses));
  size_t list = bench_space(SEPAX_TREE_JOB_BYTES * (PAIRS + 1), SEPAX_TREE_JOB_BYTES);
  for (size_t n = 0; n <= PAIRS; n++) {
    size_t pair = n < PAIRS ? n : PAIRS - 1;
    memcpy(job.body[0], record[pair % STAND], sizeof record[0]);
    memcpy(job.body[1], record[STAND + pair / STAND], sizeof record[0]);
    job.poses = n < PAIRS ? job.poses : wall;
    sepax_tree_job_pack(&job, bench_at(list + SEPAX_TREE_JOB_BYTES * n));
  }
  for (int i = 0; i < BODIES; i++) {
    sepax_tree_free(tree[i]);
  }
  return list;
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

void bench_scene(size_t poses, uint64_t seed) {
  scene_sum sum = {0};
  stop_on(poses > 1000000, "--scene is 1 ... 1000000 poses");
  bench_clear();
  bench_batch pairs = {.list = jobs_of(poses), .jobs = PAIRS, .stop_at = -1};
  bench_batch alone = {
      .list = pairs.list + SEPAX_TREE_JOB_BYTES * (PAIRS - 1), .jobs = 1, .stop_at = -1};
  bench_batch wall = {.list = pairs.list + SEPAX_TREE_JOB_BYTES * PAIRS, .jobs = 1, .stop_at = -1};
  printf("%d pairs of bodies, %zu poses, first collision of each; 500 MHz\n", PAIRS, poses);
  if (seed > 0) {
    bench_troubles(&pairs, poses, seed);
    return;
  }
  with_memories(&pairs, poses, &sum);
  printf("%s and %s alone\n", parts[BODIES - 1].name, parts[STAND - 1].name);
  with_memories(&alone, poses, &sum);
  size_t near = within(at_wall, poses, 2);
  printf("the same at a wall, %zu of %zu poses within 2 mm\n", near, poses);
  expect("half of the poses within 2 mm",
         poses < 1000 || (20 * near > 9 * poses && 20 * near < 11 * poses), 1);
  with_memories(&wall, poses, &sum);
  printf("%zu poses of %d pairs of bodies in 4 memories, %llu mismatches, worst mean %.0f cycles\n",
         poses, PAIRS, (unsigned long long)sum.mismatches, sum.slowest);
}
