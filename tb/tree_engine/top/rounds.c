/* SPDX-License-Identifier: MIT */
/* rounds.c - seeded bodies, poses and modes of jobs for the tree engine's test bench; bytes that
 * are damaged, memory that answers with errors, resets. */
#include "rounds.h"
#include "tree_engine/format.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static sepax_random rng;
static int64_t range(int64_t lo, int64_t hi) { return sepax_random_range(&rng, lo, hi); }
static double unit(void) { return (double)range(-1000000, 1000000) * 1e-6; }

enum { POSES_MOST = 6, TRIANGLES_MOST = 300 };
#define SCATTERED_BYTES (INT64_C(5) << 29)
static int64_t jobs_most = JOBS_MOST;
static int64_t poses_most = POSES_MOST;
static bool is_small; /* bodies of up to 40 triangles */
static bool is_full;  /* jobs of poses_most poses, not of up to as many */

/* ------------------------------------------------------------------ bodies */

static size_t families(void) {
  size_t count = 0;
  while (sepax_family_name(count) != NULL) {
    count++;
  }
  return count;
}

/* A band of small triangles about the middle, as meshes have them. */
static void some_surface(sepax_tri *tri, size_t count) {
  int64_t most = sepax_word_max(SEPAX_WORD);
  int64_t step = 1 + range(0, most / 16);
  sepax_vec v[3];
  for (int k = 0; k < 3; k++) {
    v[k] = (sepax_vec){(int32_t)range(-step, step), (int32_t)range(-step, step),
                       (int32_t)range(-step, step)};
  }
  for (size_t n = 0; n < count; n++) {
    for (int i = 0; i < 3; i++) {
      tri[n].v[i] = v[i];
    }
    int32_t *c[3] = {&v[n % 3].x, &v[n % 3].y, &v[n % 3].z};
    for (int i = 0; i < 3; i++) {
      int64_t next = *c[i] + range(-step, step);
      *c[i] = (int32_t)(next < -most ? -most : next > most ? most : next);
    }
  }
}

static void some_triangles(sepax_tri *tri, size_t count, bool of_b) {
  size_t all = families();
  size_t family = (size_t)range(0, 2 * (int64_t)all);
  if (family > all) {
    some_surface(tri, count);
    return;
  }
  for (size_t n = 0; n < count; n++) {
    size_t f = family < all ? family : (size_t)range(0, (int64_t)all - 1);
    sepax_pair pair = sepax_family_triangles(f, SEPAX_WORD, &rng);
    tri[n] = of_b ? pair.b : pair.a;
  }
}

static sepax_tree *some_tree(bool of_b, sepax_vec *vertex) {
  static const int64_t most[] = {1, 16, 40, 100, TRIANGLES_MOST};
  sepax_tri *tri = malloc(TRIANGLES_MOST * sizeof *tri);
  if (tri == NULL) {
    stop("out of memory");
  }
  size_t count = (size_t)range(1, most[range(0, is_small ? 2 : 4)]);
  some_triangles(tri, count, of_b);
  const sepax_grid grid = {1, {0, 0, 0}, SEPAX_WORD};
  sepax_tree *tree = NULL;
  sepax_error error = {0};
  stop_on(!sepax_tree_new(&tree, tri, count, &grid, &error), error.text);
  *vertex = tri[range(0, (int64_t)count - 1)].v[range(0, 2)];
  free(tri);
  return tree;
}

/* ------------------------------------------------------------------- poses */

static void turn(double r[3][3], double w, double x, double y, double z) {
  double n = 2 / (w * w + x * x + y * y + z * z);
  const double m[3][3] = {{1 - n * (y * y + z * z), n * (x * y - w * z), n * (x * z + w * y)},
                          {n * (x * y + w * z), 1 - n * (x * x + z * z), n * (y * z - w * x)},
                          {n * (x * z - w * y), n * (y * z + w * x), 1 - n * (x * x + y * y)}};
  memcpy(r, m, sizeof m);
}

/* As it stands, a quarter turn, a turn by 3-4-5, a little, anyhow; mostly where it collides. */
static sepax_pose some_pose(void) {
  sepax_pose pose;
  double far = sepax_word_max(SEPAX_WORD);
  double axis[3] = {0, 0, 0};
  axis[range(0, 2)] = 1;
  switch (range(0, 4)) {
  case 0:
    turn(pose.rotation, 1, 0, 0, 0);
    break;
  case 1:
    turn(pose.rotation, 1, axis[0], axis[1], axis[2]);
    break;
  case 2:
    turn(pose.rotation, 2, axis[0], axis[1], axis[2]);
    break;
  case 3:
    turn(pose.rotation, 1, 0.01 * unit(), 0.01 * unit(), 0.01 * unit());
    break;
  default:
    turn(pose.rotation, unit() + 1e-3, unit(), unit(), unit());
  }
  static const double part[] = {0, 1e-4, 0.02, 0.3, 1.5};
  double most = far * part[range(0, 4)];
  bool whole = range(0, 1) != 0;
  for (int i = 0; i < 3; i++) {
    double t = most * unit();
    pose.translation[i] = whole ? rint(t) : t;
  }
  return pose;
}

/* The driver's pose against that of the library: side 0 is the same, sigma_B the least. */
static void check_driver(const uint8_t bytes[SEPAX_TREE_POSE_BYTES]) {
  sepax_tree_pose pose;
  sepax_tree_pose same;
  uint8_t closed[SEPAX_TREE_POSE_BYTES];
  sepax_error error = {0};
  uint8_t packed[SEPAX_TREE_POSE_BYTES];
  int margin = (int)design.margin[1];
  stop_on(!sepax_tree_pose_unpack(&pose, bytes, &error), error.text);
  int64_t shift[3];
  for (int i = 0; i < 3; i++) {
    shift[i] = pose.side[0].shift[i] - (1 << 19);
  }
  expect("the driver makes the pose",
         sepax_tree_device_pose(packed, (const int32_t(*)[3])pose.side[0].matrix, shift, SEPAX_WORD,
                                margin),
         1);
  expect("its side of B",
         memcmp(packed, bytes, 24) == 0 && memcmp(packed + 48, bytes + 48, 36) == 0, 1);
  stop_on(!sepax_tree_pose_unpack(&same, packed, &error) ||
              !sepax_tree_pose_close(&same, SEPAX_WORD, margin, &error),
          error.text);
  sepax_tree_pose_pack(&same, closed);
  expect("its sigma", memcmp(packed, closed, sizeof packed) == 0, 1);
}

/* ------------------------------------------------------------------- rounds */

static unsigned some_modes(bool same_bodies) {
  unsigned modes = (unsigned)range(0, 127);
  modes &= range(0, 1) != 0 ? ~0U : ~(unsigned)(SEPAX_TREE_FIRST | SEPAX_TREE_LEAVE);
  modes &= range(0, 2) != 0 ? ~(unsigned)SEPAX_TREE_QUIET : ~0U;
  return same_bodies ? modes : modes & ~(unsigned)SEPAX_TREE_WARM;
}

static uint32_t some_leaf(const sepax_tree *tree, uint32_t shift) {
  uint32_t nodes = (uint32_t)sepax_tree_nodes(tree);
  size_t bytes;
  const uint8_t *image = sepax_tree_image(tree, &bytes);
  uint32_t n = (uint32_t)range(0, nodes - 1);
  while ((image[SEPAX_TREE_NODE_BYTES * n + 14] & 15) != 0) { /* the level */
    n = (n + 1) % nodes;
  }
  return n > 0 ? n + shift : n;
}

static int64_t turned(const int32_t m[3], sepax_vec p) {
  return (int64_t)m[0] * p.x + (int64_t)m[1] * p.y + (int64_t)m[2] * p.z;
}

/* The same turn, or what is none, with entries of -1, 0 and 1, that brings a vertex near the
 * middle, others far from it; mostly right below whole numbers, where each bit counts. */
static void other_pose(uint8_t *bytes, sepax_tree_side side, sepax_vec vertex) {
  bool is_turn = range(0, 2) != 0;
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3 && !is_turn; k++) {
      side.matrix[i][k] = (int32_t)range(-1, 1) * (1 << 20);
    }
    int64_t sum = turned(side.matrix[i], vertex);
    side.shift[i] = is_turn ? side.shift[i] : range(-8, 8) * (1 << 20) + (1 << 19) - sum;
    if (range(0, 1) != 0) {
      int64_t fraction = (sum + side.shift[i]) & ((1 << 20) - 1);
      side.shift[i] += (1 << 20) - (1 << range(0, 12)) - fraction;
    }
    side.shift[i] -= 1 << 19;
  }
  uint8_t packed[SEPAX_TREE_POSE_BYTES];
  if (sepax_tree_device_pose(packed, (const int32_t(*)[3])side.matrix, side.shift, SEPAX_WORD,
                             (int)design.margin[1])) {
    memcpy(bytes, packed, sizeof packed);
  }
}

static void some_job(scene *s, uint32_t n, const sepax_tree_job *last) {
  sepax_error error = {0};
  sepax_tree_job job = *last;
  job.count = (uint32_t)range(is_full ? poses_most : 1, poses_most);
  job.modes = some_modes(n > 0);
  job.budget = range(0, 5) == 0 ? (uint32_t)range(1, range(0, 1) != 0 ? 200 : 3000) : 0;
  for (int i = 0; i < 2; i++) {
    job.leaf[i] = some_leaf(s->tree[i], s->shift[i]);
    job.child[i] = 0;
  }
  s->poses[n] = job.count;
  s->pose[n] = bench_space(SEPAX_TREE_POSE_STRIDE * job.count, SEPAX_TREE_POSE_STRIDE);
  sepax_pose pose = some_pose();
  for (size_t k = 0; k < job.count; k++) {
    sepax_tree_pose fixed;
    uint8_t *bytes = bench_at(s->pose[n] + SEPAX_TREE_POSE_STRIDE * k);
    if (range(0, 1) != 0) {
      pose = some_pose();
    }
    stop_on(!sepax_tree_pose_make(&fixed, s->tree[0], NULL, s->tree[1], &pose, design.margin[1],
                                  &error),
            error.text);
    sepax_tree_pose_pack(&fixed, bytes);
    check_driver(bytes);
    if (range(0, 3) == 0) {
      other_pose(bytes, fixed.side[0], s->vertex[1]);
    }
  }
  job.poses = bench_address(s->pose[n]);
  sepax_tree_job_pack(&job, bench_at(s->job[n]));
}

/* Bodies and jobs in memory. */
static void draw_scene(scene *s, bool is_scattered) {
  bench_base = 4096 * (uint64_t)range(1, (INT64_C(1) << 28) - (SCATTERED_BYTES >> 12) - 1);
  *s = (scene){.batch = {.jobs = (uint32_t)range(1, jobs_most), .stop_at = -1}};
  bench_clear();
  if (is_scattered) {
    bench_reserve(SCATTERED_BYTES);
  }
  bench_space((size_t)range(0, 3) * 4096, 4096);
  sepax_tree_job job = {.count = 0};
  for (int i = 0; i < 2; i++) {
    s->tree[i] = some_tree(i == 1, &s->vertex[i]);
    if (is_scattered) {
      s->shift[i] = scattered_tree(s->tree[i], i == 1, &rng, job.body[i]);
    } else {
      bench_tree(s->tree[i], job.body[i]);
    }
    sepax_tree_image(s->tree[i], &s->bytes[i]);
    uint64_t address = 0;
    for (int k = 7; k >= 0; k--) {
      address = address << 8 | job.body[i][k];
    }
    s->body[i] = (size_t)(address - bench_base);
  }
  s->batch.list = bench_space(SEPAX_TREE_JOB_BYTES * s->batch.jobs, SEPAX_TREE_JOB_BYTES);
  for (uint32_t n = 0; n < s->batch.jobs; n++) {
    s->job[n] = s->batch.list + SEPAX_TREE_JOB_BYTES * n;
    some_job(s, n, &job);
  }
}

void some_scene(scene *s) { draw_scene(s, false); }

void simple_scene(scene *s, uint32_t poses, bool of_small) {
  const int64_t most[] = {jobs_most, poses_most};
  bool before = is_small;
  jobs_most = 1;
  poses_most = poses;
  is_small = of_small;
  is_full = true;
  some_scene(s);
  jobs_most = most[0];
  poses_most = most[1];
  is_small = before;
  is_full = false;
  memset(bench_at(s->job[0]) + 76, 0, 8); /* modes, budget */
}

void free_scene(scene *s) {
  sepax_tree_free(s->tree[0]);
  sepax_tree_free(s->tree[1]);
}

static memory_options some_memory(bool stressed, uint64_t seed) {
  static const int latency[] = {1, 2, 20, 100, 200};
  return (memory_options){.latency = latency[range(0, 4)],
                          .stress =
                              stressed && range(0, 3) > 0 ? seed + (uint64_t)range(1, 99) : 0};
}

static void add(bench_batch *sum, const bench_batch *one) {
  sum->poses += one->poses;
  sum->near += one->near;
  sum->hits += one->hits;
  sum->warnings += one->warnings;
  sum->out_of_range += one->out_of_range;
  sum->stopped += one->stopped;
  sum->damaged += one->damaged;
  sum->bus += one->bus;
  sum->refused += one->refused;
  sum->cycles += one->cycles;
}

static void round_of(bench_batch *sum, bool stressed, uint64_t seed, bool is_scattered) {
  scene s;
  draw_scene(&s, is_scattered);
  bench_attach(some_memory(stressed, seed));
  if (range(0, 7) == 0) {
    s.batch.stop_at = (int)range(0, 5);
  }
  bench_run(&s.batch);
  add(sum, &s.batch);
  free_scene(&s);
}

/* ------------------------------------------------------------------- damage */

/* Some bytes of trees, jobs or poses become any others; the first row may be of any node. */
static void damage(const scene *s) {
  int64_t count = range(1, 6);
  if (range(0, 7) == 0) {
    int i = (int)range(0, 1);
    uint32_t node = (uint32_t)range(0, (int64_t)sepax_tree_nodes(s->tree[i]) - 1);
    bytes_put32(bench_at(s->job[0] + 88 + 4 * (size_t)i), node);
    count = range(0, 1);
  }
  while (count-- > 0) {
    int64_t where = range(0, 9);
    size_t at;
    if (where < 6) {
      int i = (int)(where & 1);
      size_t nodes = SEPAX_TREE_NODE_BYTES * sepax_tree_nodes(s->tree[i]);
      size_t most = where < 4 ? nodes : s->bytes[i];
      at = s->body[i] + (size_t)range(0, (int64_t)most - 1);
      if (where < 2) { /* where numbers are */
        at = at / SEPAX_TREE_NODE_BYTES * SEPAX_TREE_NODE_BYTES + (size_t)range(12, 23);
      }
    } else if (where < 8) {
      at = s->job[0] + (size_t)range(0, SEPAX_TREE_JOB_BYTES - 1);
    } else {
      at = s->pose[0] + (size_t)range(0, SEPAX_TREE_POSE_BYTES - 1);
    }
    *bench_at(at) = (uint8_t)(range(0, 1) != 0 ? range(0, 255) : *bench_at(at) ^ 1 << range(0, 7));
  }
}

/* Numbers of a pose that have nothing to do with each other, mostly in their ranges; in half of
 * them a vertex of each body comes near one of the other. */
static void any_pose(const scene *s, uint8_t *bytes) {
  sepax_tree_pose pose;
  bool is_close = range(0, 1) != 0;
  int64_t small = range(0, 1) != 0 ? INT64_C(1) << 43 : INT64_C(1) << range(10, 42);
  for (int side = 0; side < 2; side++) {
    for (int k = 0; k < 9; k++) {
      pose.side[side].matrix[k / 3][k % 3] = (int32_t)range(-(1 << 20), 1 << 20);
    }
    for (int k = 0; k < 3; k++) {
      const sepax_vec to = s->vertex[side];
      const int64_t at = (k == 0 ? to.x : k == 1 ? to.y : to.z) * (INT64_C(1) << 20);
      const int64_t close =
          range(-(1 << 22), 1 << 22) + at - turned(pose.side[side].matrix[k], s->vertex[1 - side]);
      pose.side[side].shift[k] = is_close ? close : range(-small, small - 1);
      pose.side[side].sigma[k] = (uint32_t)range(0, (1 << range(1, 24)) - 1);
    }
  }
  sepax_tree_pose_pack(&pose, bytes);
  for (int k = 0; k < SEPAX_TREE_POSE_BYTES && range(0, 9) == 0; k++) {
    bytes[k] = (uint8_t)range(0, 255);
  }
}

static void damaged_round(bench_batch *sum, bool stressed, uint64_t seed) {
  scene s;
  some_scene(&s);
  bool is_posed = is_small && range(0, 2) == 0;
  if (!is_posed || range(0, 1) != 0) {
    damage(&s);
  }
  if (is_posed) {
    any_pose(&s, bench_at(s.pose[0]));
  }
  memory_options options = some_memory(stressed, seed);
  if (range(0, 3) == 0) {
    options.error_odds = (uint64_t)range(20, 2000);
    s.batch.errors = true;
  }
  bench_attach(options);
  s.batch.any = true;
  s.batch.jobs = 1;
  uint8_t *job = bench_at(s.job[0]);
  job[72] = 1; /* one pose: behind an error that only the model sees it would go on alone */
  job[73] = job[74] = job[75] = 0;
  bench_run(&s.batch);
  add(sum, &s.batch);
  free_scene(&s);
}

/* A reset at any time of a batch; what comes behind it is right. */
static void reset_round(uint64_t seed) {
  scene s;
  some_scene(&s);
  bench_attach(some_memory(true, seed));
  expect("start", sepax_tree_device_start(&device, bench_address(s.batch.list), s.batch.jobs),
         SEPAX_TREE_DEVICE_OK);
  bus_idle((uint64_t)range(0, 2000));
  bus_reset();
  free_scene(&s);
}

/* ------------------------------------------------------------------------- */

static void tell(const char *what, const bench_batch *sum) {
  printf("%s: %llu poses, %llu collide, %llu near pairs, %llu warnings, %llu out of range, %llu "
         "stopped, %llu damaged, %llu errors, %llu refused, %llu cycles\n",
         what, (unsigned long long)sum->poses, (unsigned long long)sum->hits,
         (unsigned long long)sum->near, (unsigned long long)sum->warnings,
         (unsigned long long)sum->out_of_range, (unsigned long long)sum->stopped,
         (unsigned long long)sum->damaged, (unsigned long long)sum->bus,
         (unsigned long long)sum->refused, (unsigned long long)sum->cycles);
}

void bench_rounds(unsigned long long rounds, uint64_t seed, bool stressed) {
  rng.state = 1 + seed;
  bench_batch sound = {.list = 0};
  bench_batch broken = {.list = 0};
  for (unsigned long long n = 0; n < rounds && wrong == 0; n++) {
    round_of(&sound, stressed, seed + n, n % 3 == 1);
    damaged_round(&broken, stressed, seed + n);
    if (n % 4 == 0) {
      reset_round(seed + n);
    }
  }
  if (rounds > 0 && wrong == 0) {
    refusals();
    partners(seed);
  }
  tell("sound", &sound);
  tell("damaged", &broken);
  printf("%llu rounds, %llu transfers, %llu cycles, %llu wrong\n", rounds,
         (unsigned long long)bus_beats(), (unsigned long long)bus_cycles(), wrong);
}

void bench_sound(unsigned long long rounds, uint64_t seed, bool stressed) {
  rng.state = 1 + seed;
  bench_batch sum = {.list = 0};
  for (unsigned long long n = 0; n < rounds && wrong == 0; n++) {
    round_of(&sum, stressed, seed + n, n % 3 == 1);
  }
  tell("sound", &sum);
}

void bench_fuzz(unsigned long long batches, uint64_t seed) {
  rng.state = 1 + seed;
  jobs_most = 1;
  poses_most = 1;
  is_small = true;
  bench_batch sum = {.list = 0};
  for (unsigned long long n = 0; n < batches && wrong == 0; n++) {
    damaged_round(&sum, n % 2 == 1, seed + n);
  }
  tell("damaged", &sum);
  printf("%llu batches, %llu cycles, %llu wrong\n", batches, (unsigned long long)bus_cycles(),
         wrong);
}
