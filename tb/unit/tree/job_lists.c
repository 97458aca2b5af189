/* SPDX-License-Identifier: MIT */
/* job_lists.c - lists of jobs in the golden model: which poses are walked, with which first row,
 * and what is refused. */
#include "unit/tree/scenes.h"

#include <string.h>

enum { POSES = 5, JOBS = 2, BYTES = 1 << 17 };

static const uint64_t base = UINT64_C(0x7000000);

typedef struct {
  triangles t[2];
  sepax_tree *tree[2];
  sepax_design design;
  uint8_t byte[BYTES];
  sepax_tree_memory memory;
  sepax_tree_job job; /* of all poses */
  sepax_tree_pose pose[POSES];
  sepax_tree_run run[POSES]; /* by the walk alone */
  size_t list, queue;
} scene;

/* B comes nearer from pose to pose; in some the bodies collide. */
static scene *new_scene(void) {
  scene *s = calloc(1, sizeof *s);
  assert_non_null(s);
  s->design = design_of("--word=12");
  size_t at = 4096;
  for (int i = 0; i < 2; i++) {
    s->t[i] = drawn(300, 4, 300, 0, 12);
    s->tree[i] = tree_of(&s->t[i], 12);
    size_t bytes;
    const uint8_t *image = sepax_tree_image(s->tree[i], &bytes);
    memcpy(s->byte + at, image, bytes);
    sepax_tree_body(s->tree[i], base + at, s->job.body[i]);
    at = (at + bytes + 4095) / 4096 * 4096;
  }
  s->queue = at;
  s->list = at + 4096;
  for (int n = 0; n < POSES; n++) {
    sepax_pose p = posed(4, 0);
    p.translation[0] = n < 2 ? 800 : 480 - n;
    assert_works(sepax_tree_pose_make(&s->pose[n], s->tree[0], NULL, s->tree[1], &p, 0, &fault));
    sepax_tree_pose_pack(&s->pose[n], s->byte + at + SEPAX_TREE_POSE_STRIDE * (size_t)n);
    const sepax_tree_walk_options how = {.design = &s->design};
    assert_works(sepax_tree_walk(s->tree[0], s->tree[1], &s->pose[n], &how, &s->run[n], &fault));
    assert_int_equal(s->run[n].collisions > 0, n >= 2);
  }
  s->job.poses = base + at;
  s->job.count = POSES;
  s->memory = (sepax_tree_memory){s->byte, base, BYTES};
  return s;
}

static void free_scene(scene *s) {
  for (int i = 0; i < 2; i++) {
    sepax_tree_free(s->tree[i]);
    free(s->t[i].tri);
  }
  free(s);
}

static sepax_tree_batch batch_of(scene *s, uint32_t jobs, unsigned modes) {
  for (uint32_t n = 0; n < jobs; n++) {
    sepax_tree_job job = s->job;
    job.modes = modes;
    sepax_tree_job_pack(&job, s->byte + s->list + SEPAX_TREE_JOB_BYTES * n);
  }
  return (sepax_tree_batch){
      .design = &s->design, .memory = &s->memory, .list = base + s->list, .jobs = jobs};
}

/* The next pose; false: there is none. */
static bool next(sepax_tree_batch *b, sepax_tree_result *r) {
  bool more = false;
  assert_works(sepax_tree_next(b, r, &more, &fault));
  return more;
}

CASE(poses_of_jobs_come_in_order) {
  scene *s = new_scene();
  sepax_tree_batch b = batch_of(s, JOBS, 0);
  sepax_tree_result r;
  for (uint32_t n = 0; n < JOBS * POSES; n++) {
    assert_true(next(&b, &r));
    const sepax_tree_run *run = &s->run[n % POSES];
    assert_int_equal(r.job, n / POSES);
    assert_int_equal(r.pose, n % POSES);
    assert_int_equal(r.status, run->collisions > 0 ? SEPAX_TREE_HIT : 0);
    assert_int_equal(r.run.collisions, run->collisions);
    assert_int_equal(r.run.steps, run->steps);
  }
  assert_false(next(&b, &r));
  free_scene(s);
}

CASE(the_first_row_is_that_of_the_pose_that_collided) {
  scene *s = new_scene();
  sepax_tree_batch b = batch_of(s, JOBS, SEPAX_TREE_FIRST | SEPAX_TREE_AGAIN);
  sepax_tree_result r;
  sepax_tree_pair row = {.child = {0, 0}};
  bool has_row = false;
  int again = 0;
  for (uint32_t n = 0; n < JOBS * POSES; n++) {
    has_row = has_row && n % POSES > 0;
    const sepax_tree_walk_options how = {
        .design = &s->design, .first = true, .row = has_row ? &row : NULL};
    sepax_tree_run run;
    assert_works(sepax_tree_walk(s->tree[0], s->tree[1], &s->pose[n % POSES], &how, &run, &fault));
    assert_true(next(&b, &r));
    assert_int_equal(r.run.near, run.near);
    assert_int_equal(r.run.found.triangle[0], run.found.triangle[0]);
    again += has_row && run.near == 1;
    has_row = has_row || run.collisions > 0;
    row = run.collisions > 0 ? run.found : row;
  }
  assert_true(again > 0); /* told after one pair */
  free_scene(s);
}

CASE(a_job_has_a_first_row_of_its_own) {
  scene *s = new_scene();
  s->job.leaf[0] = s->run[2].found.leaf[0];
  s->job.leaf[1] = s->run[2].found.leaf[1];
  s->job.child[0] = s->run[2].found.child[0];
  s->job.child[1] = s->run[2].found.child[1];
  sepax_tree_batch b = batch_of(s, 1, SEPAX_TREE_ROW);
  sepax_tree_result r;
  for (uint32_t n = 0; n < POSES; n++) {
    assert_true(next(&b, &r));
    assert_int_equal(r.run.rows, s->run[n].rows + 1);
  }
  assert_int_equal(r.run.pairs, s->run[POSES - 1].pairs + 1);
  free_scene(s);
}

CASE(the_first_pose_that_collides_ends_a_job) {
  scene *s = new_scene();
  sepax_tree_batch b = batch_of(s, JOBS, SEPAX_TREE_LEAVE);
  sepax_tree_result r;
  for (uint32_t n = 0; n < JOBS * 3; n++) {
    assert_true(next(&b, &r));
    assert_int_equal(r.job, n / 3);
    assert_int_equal(r.pose, n % 3);
  }
  assert_false(next(&b, &r));
  free_scene(s);
}

/* A batch ends with its first pose without a verdict. */
static void ends(scene *s, unsigned status, uint32_t pose) {
  sepax_tree_batch b = {
      .design = &s->design, .memory = &s->memory, .list = base + s->list, .jobs = JOBS};
  sepax_tree_result r = {.status = 0};
  uint32_t seen = 0;
  while (next(&b, &r)) {
    seen++;
  }
  assert_int_equal(seen, pose + 1);
  assert_int_equal(r.status, status);
  assert_int_equal(r.pose, pose);
}

CASE(what_is_out_of_range_is_refused) {
  scene *s = new_scene();
  static const struct {
    size_t at;
    uint64_t value;
    int bytes;
  } bad[] = {{0, 8, 1},    {5, 1, 1},  {8, 0, 4},  {8, (1 << 23) + 1, 4},
             {12, 0, 4},   {16, 0, 4}, {44, 0, 4}, {44, (1 << 24) + 1, 4},
             {64, 128, 1}, {70, 1, 1}, {72, 0, 4}, {76, 128, 1},
             {79, 1, 1}};
  for (size_t n = 0; n < LENGTH(bad); n++) {
    (void)batch_of(s, JOBS, 0);
    for (int k = 0; k < bad[n].bytes; k++) {
      s->byte[s->list + bad[n].at + (size_t)k] = (uint8_t)(bad[n].value >> (8 * k));
    }
    ends(s, SEPAX_TREE_REFUSED, 0);
  }
  (void)batch_of(s, JOBS, 0);
  uint8_t *third = s->byte + s->queue + SEPAX_TREE_POSE_STRIDE * (size_t)3;
  third[123] = 1; /* sigma of 2^24 */
  ends(s, SEPAX_TREE_REFUSED, 3);
  free_scene(s);
}

CASE(what_is_not_in_the_memory_is_an_error_of_the_bus) {
  scene *s = new_scene();
  (void)batch_of(s, JOBS, 0);
  s->memory.size = s->list;
  ends(s, SEPAX_TREE_BUS, 0);
  s->memory.size = BYTES;
  s->byte[s->list + 67] = 0x17; /* the poses are beyond */
  ends(s, SEPAX_TREE_BUS, 0);
  (void)batch_of(s, JOBS, 0);
  s->byte[s->list + 18] = 1; /* A's image is larger */
  ends(s, SEPAX_TREE_BUS, 0);
  free_scene(s);
}

CASE(a_damaged_tree_ends_the_batch) {
  scene *s = new_scene();
  (void)batch_of(s, JOBS, 0);
  s->byte[4096 + 16] = 0; /* the root is its own child */
  s->byte[4096 + 17] = 0;
  ends(s, SEPAX_TREE_DAMAGED, 0);
  free_scene(s);
}

CASE(a_job_is_packed_as_it_was) {
  const sepax_tree_job job = {
      .body = {{0, 16, [8] = 1, [12] = 1, [16] = 8}, {0, 32, [8] = 2, [12] = 9, [16] = 99}},
      .poses = UINT64_C(0xfffffff300),
      .count = UINT32_MAX,
      .modes = 127,
      .budget = 5,
      .leaf = {(1 << 23) - 1, 77},
      .child = {15, 3}};
  uint8_t bytes[SEPAX_TREE_JOB_BYTES];
  uint8_t again[SEPAX_TREE_JOB_BYTES];
  sepax_tree_job back;
  sepax_tree_job_pack(&job, bytes);
  assert_true(sepax_tree_job_unpack(&back, bytes));
  sepax_tree_job_pack(&back, again);
  assert_memory_equal(bytes, again, sizeof bytes);
  assert_int_equal(back.leaf[0], job.leaf[0]);
  assert_int_equal(back.child[0], 15);
  assert_int_equal(back.child[1], 3);
}
