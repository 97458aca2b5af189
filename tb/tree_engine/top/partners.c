/* SPDX-License-Identifier: MIT */
/* partners.c - a memory and a host that do to the tree engine what they must not, or the worst that
 * they may: a wrong answer to each beat, beats that nobody asked for, trees that lead across pages
 * or too deep, STOP at any time, results that are taken late, as many bursts and poses as fit. */
#include "rounds.h"
#include "tree_engine/format.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
  PAGE_BEATS = TREE_PAGE / TREE_BEAT,
  NODES = 8,
  TRIANGLES = 12,
  BEATS = 16,
  MODES = 76,
  BUDGET = 80
};

static uint64_t seed_of_gaps; /* of the memory's */

static bench_batch batch_of(const scene *s) {
  return (bench_batch){.list = s->batch.list, .jobs = 1, .stop_at = -1};
}

/* The scene as it is, with this memory. */
static bench_batch run_with(const scene *s, memory_options options, bool errors) {
  bench_batch batch = batch_of(s);
  batch.errors = errors;
  bench_attach(options);
  bench_run(&batch);
  return batch;
}

/* A small scene that collides, and whose one pose reads no more than `most` beats. */
static uint64_t colliding_scene(scene *s, uint64_t most) {
  uint64_t beats = 0;
  for (bool found = false; !found;) {
    simple_scene(s, 1, true);
    bench_batch batch = run_with(s, (memory_options){.latency = 3}, false);
    beats = bus_attached()->counts.beats;
    found = batch.hits > 0 && beats <= most;
    if (!found) {
      free_scene(s);
    }
  }
  return beats;
}

/* Each beat of a job, a pose, nodes and records comes with each wrong RRESP, or with RLAST too
 * early or missing: the pose has no verdict, also where the data are right. What came with a wrong
 * answer is not used by the next job, which keeps what the caches have. */
static void each_answer(void) {
  scene s;
  uint64_t beats = colliding_scene(&s, 60);
  uint8_t *modes = bench_at(s.job[0]) + MODES;
  for (uint64_t beat = 1; beat <= beats && wrong == 0; beat++) {
    for (unsigned how = 0; how < 4; how++) {
      for (int keeps = how != 1 + beat % 3; keeps < 2; keeps++) {
        memory_options options = {.latency = 1 + (int)(beat % 7),
                                  .wrong_beat = beat,
                                  .wrong_how = how,
                                  .wrong_keeps = keeps != 0};
        bench_batch batch = run_with(&s, options, true);
        expect("a wrong answer is an error of the bus", batch.status, SEPAX_TREE_BUS);
        if (keeps == 0) {
          *modes = SEPAX_TREE_WARM;
          batch = run_with(&s, (memory_options){.latency = 2}, true);
          expect("no error behind it", batch.status & SEPAX_TREE_NO_VERDICT, 0);
          *modes = 0;
        }
      }
    }
  }
  free_scene(&s);
}

/* Beats that belong to no burst are not taken, and change nothing. */
static void uncalled_beats(void) {
  for (int n = 0; n < 4 && wrong == 0; n++) {
    scene s;
    simple_scene(&s, 6, true);
    run_with(&s, (memory_options){.latency = 1 + n, .uncalled = true}, false);
    free_scene(&s);
  }
}

/* A damaged leaf beside a wrong answer to a beat of another one: the end says one of both. */
static void damage_and_errors(void) {
  uint64_t damaged = 0;
  uint64_t bus = 0;
  for (int n = 0; (n < 12 || damaged == 0 || bus == 0) && n < 200 && wrong == 0; n++) {
    scene s;
    uint64_t beats = colliding_scene(&s, 200);
    size_t nodes = sepax_tree_nodes(s.tree[n % 2]);
    size_t node = nodes > 1 ? 1 + (size_t)n / 2 % (nodes - 1) : 0;
    uint8_t *bytes = bench_at(s.body[n % 2] + TREE_NODE_BYTES * node);
    bytes[14] &= 15; /* a record of one beat */
    for (uint64_t beat = 1; beat <= beats; beat++) {
      memory_options options = {
          .latency = n % 4 < 3 ? 100 : 10, .wrong_beat = beat, .wrong_how = 2, .wrong_keeps = true};
      bench_batch batch = batch_of(&s);
      batch.errors = batch.any = true;
      bench_attach(options);
      bench_run(&batch);
      damaged += batch.damaged;
      bus += batch.bus;
    }
    free_scene(&s);
  }
  expect("some are damaged, some met an error", damaged > 0 && bus > 0, 1);
}

/* ------------------------------------------------------------------ trees */

/* A record that ends with a page, and 1 beat, 2 beats ... behind it: where it crosses, the tree is
 * damaged. */
static void records_at_pages(void) {
  scene s;
  int beats = 0;
  do { /* A is one leaf */
    colliding_scene(&s, 200);
    tree_node node = sepax__tree_unpack(bench_at(s.body[0]), SEPAX_WORD);
    beats = node.level == 0 ? node.beats : 0;
    if (beats == 0) {
      free_scene(&s);
    }
  } while (beats == 0);
  bench_clear();
  size_t bytes;
  const uint8_t *image = sepax_tree_image(s.tree[0], &bytes);
  uint8_t job[SEPAX_TREE_JOB_BYTES + SEPAX_TREE_POSE_STRIDE];
  memcpy(job, bench_at(s.job[0]), SEPAX_TREE_JOB_BYTES);
  memcpy(job + SEPAX_TREE_JOB_BYTES, bench_at(s.pose[0]), SEPAX_TREE_POSE_STRIDE);
  /* Again, with four pages behind A's image. */
  size_t b = bench_space(0, TREE_PAGE);
  bench_tree(s.tree[1], job + SEPAX_TREE_BODY_BYTES);
  size_t list = bench_space(SEPAX_TREE_JOB_BYTES, SEPAX_TREE_JOB_BYTES);
  size_t pose = bench_space(SEPAX_TREE_POSE_STRIDE, SEPAX_TREE_POSE_STRIDE);
  size_t a = bench_space(bytes, TREE_PAGE);
  uint32_t first_page = (uint32_t)((bytes + TREE_PAGE - 1) / TREE_PAGE);
  bench_space((first_page + 4) * (size_t)TREE_PAGE - bytes, 1);
  sepax_tree_body(s.tree[0], bench_address(a), job);
  bytes_put32(job + BEATS, (first_page + 4) * PAGE_BEATS);
  memcpy(bench_at(pose), job + SEPAX_TREE_JOB_BYTES, SEPAX_TREE_POSE_STRIDE);
  bytes_put64(job + 64, bench_address(pose));
  memcpy(bench_at(list), job, SEPAX_TREE_JOB_BYTES);
  (void)b;
  for (int over = -1; over <= beats && wrong == 0; over++) {
    memcpy(bench_at(a), image, bytes);
    tree_node node = sepax__tree_unpack(image, SEPAX_WORD);
    const uint8_t *record = image + (size_t)TREE_BEAT * node.record;
    node.record = (first_page + 2) * PAGE_BEATS + (uint32_t)over - (uint32_t)beats;
    memcpy(bench_at(a + (size_t)TREE_BEAT * node.record), record,
           (size_t)TREE_BEAT * (size_t)beats);
    sepax__tree_pack(bench_at(a), &node, record);
    bench_batch batch = {.list = list, .jobs = 1, .stop_at = -1, .any = true};
    bench_attach((memory_options){.latency = 5});
    bench_run(&batch);
    expect("a record across a page is damaged", batch.damaged, over > 0 && over < beats);
  }
  free_scene(&s);
}

/* Trees of many levels, of which the roots say one: the stack is full before an end is reached. No
 * node is read twice on the way there; on a slow memory as many bursts are open as may be. */
static void deep_tree(void) {
  enum { CHAIN = 20000 };
  scene s;
  colliding_scene(&s, 200);
  uint8_t job[SEPAX_TREE_JOB_BYTES];
  memcpy(job, bench_at(s.job[0]), sizeof job);
  size_t a = bench_space((size_t)TREE_NODE_BYTES * CHAIN, TREE_PAGE);
  for (size_t body = 0; body < 2; body++) {
    uint8_t *record = job + SEPAX_TREE_BODY_BYTES * body;
    bytes_put64(record, bench_address(a));
    bytes_put32(record + NODES, CHAIN);
    bytes_put32(record + BEATS, CHAIN * (TREE_NODE_BYTES / TREE_BEAT));
  }
  memcpy(bench_at(s.job[0]), job, sizeof job);
  for (uint32_t n = 0; n < CHAIN; n++) {
    uint32_t first = 16 * (n / 16 + 1 + n % 16);
    tree_node node = {.children = 16, .level = 1, .first = first + 16 <= CHAIN ? first : n};
    for (int i = 0; i < 3; i++) {
      node.exponent[i] = TREE_EXPONENT_MAX;
      node.own[i] = INT8_MAX;
      for (int k = 0; k < TREE_FAN_OUT; k++) {
        node.low[k][i] = INT8_MIN;
        node.high[k][i] = INT8_MAX;
      }
    }
    sepax__tree_pack(bench_at(a + (size_t)TREE_NODE_BYTES * n), &node, NULL);
  }
  bench_batch batch = batch_of(&s);
  batch.any = true;
  bench_attach((memory_options){.latency = 1000});
  bench_run(&batch);
  expect("a full stack is damage", batch.damaged, 1);
  expect("bursts are open", (unsigned long long)bus_attached()->counts.open_most, 32);
  free_scene(&s);
}

/* ------------------------------------------------------------------ traffic */

/* Many poses, each with cold caches, while others are read ahead; then poses that end quickly while
 * results are taken with gaps. */
static void many_poses(void) {
  for (unsigned n = 0; n < 6 && wrong == 0; n++) {
    scene s;
    simple_scene(&s, 40, n % 2 != 0);
    bench_at(s.job[0])[MODES] = n % 2 != 0 ? SEPAX_TREE_QUIET : SEPAX_TREE_COLD;
    run_with(&s, (memory_options){.latency = 30, .stress = n % 3 != 0 ? seed_of_gaps + n : 0},
             false);
    free_scene(&s);
  }
}

static uint32_t value_of(uint32_t address) {
  uint32_t value = 0;
  expect("a register can be read", bus_read(NULL, address, &value), 1);
  return value;
}

/* STOP at any time of a batch of many poses, also while one waits for its results to be taken: no
 * other pose begins. */
static void stops(void) {
  scene s;
  simple_scene(&s, 40, true);
  bench_at(s.job[0])[MODES] = SEPAX_TREE_QUIET;
  bench_attach((memory_options){.latency = 12});
  for (uint64_t n = 0; n < 90 && wrong == 0; n++) {
    bool blocked = n % 6 == 5;
    bus_block_results(blocked);
    bus_limit(1000000);
    expect("START", sepax_tree_device_start(&device, bench_address(s.batch.list), 1),
           SEPAX_TREE_DEVICE_OK);
    bus_idle(blocked ? 3000 + n : 7 * n);
    expect("STOP", sepax_tree_device_stop(&device), SEPAX_TREE_DEVICE_OK);
    uint32_t ended = value_of(SEPAX_TREE_POSES);
    bus_block_results(false);
    sepax_outcome o = {.last = false};
    uint32_t count = 0;
    sepax_tree_device_status status = SEPAX_TREE_DEVICE_OK;
    while (!o.last && status == SEPAX_TREE_DEVICE_OK && count < 50) {
      status = sepax_tree_device_take(&device, NULL, NULL, &o);
      count++;
    }
    expect("a stopped batch", status, SEPAX_TREE_DEVICE_OK);
    expect("poses that end behind STOP", count > ended + 1 ? count - ended : 0, 0);
    bool busy = true;
    for (int k = 0; k < 1000 && busy; k++) {
      expect("busy", sepax_tree_device_busy(&device, &busy), SEPAX_TREE_DEVICE_OK);
    }
    expect("it ends", busy, 0);
  }
  free_scene(&s);
}

/* ------------------------------------------------------------------ late results */

enum { LATE_POSES = 40 };

typedef struct {
  sepax_outcome pose[LATE_POSES];
  size_t count;
} outcomes;

static void keep_outcome(void *context, const sepax_outcome *outcome, bool right) {
  outcomes *kept = context;
  (void)right;
  if (kept->count < LATE_POSES) {
    kept->pose[kept->count++] = *outcome;
  }
}

void bench_late(uint64_t seed) {
  for (uint64_t n = 0; n < 8 && wrong == 0; n++) {
    scene s = {0};
    outcomes kept = {.count = 0};
    if (n == 0) {
      bench_sound(1, seed, false); /* the seed */
    }
    bench_batch batch = {.hits = 0};
    while (batch.hits < LATE_POSES / 4) { /* without a collision the last transfers are 0 */
      if (kept.count > 0) {
        free_scene(&s);
      }
      simple_scene(&s, LATE_POSES, true);
      bench_at(s.job[0])[MODES] = SEPAX_TREE_QUIET;
      batch = batch_of(&s);
      kept.count = 0;
      batch.told = keep_outcome;
      batch.context = &kept;
      bench_attach((memory_options){.latency = 2});
      bench_run(&batch);
    }
    bus_limit(1000000);
    bus_block_results(true);
    expect("START", sepax_tree_device_start(&device, bench_address(s.batch.list), 1),
           SEPAX_TREE_DEVICE_OK);
    for (size_t k = 0; k < 8 * kept.count; k += 1 + n) { /* so many transfers, then none */
      bus_idle(400);
      bus_block_results(false);
      bus_idle(1 + n);
      bus_block_results(true);
    }
    bus_block_results(false);
    for (size_t k = 0; k < kept.count && wrong == 0; k++) {
      sepax_outcome o = {.job = 1};
      sepax_tree_device_status status = sepax_tree_device_take(&device, NULL, NULL, &o);
      expect("a pose whose results are taken late",
             status == SEPAX_TREE_DEVICE_OK || status == SEPAX_TREE_DEVICE_NO_VERDICT, 1);
      expect("its number", o.pose, kept.pose[k].pose);
      expect("its status", o.status, kept.pose[k].status);
      expect("its near pairs", o.near, kept.pose[k].near);
      for (int i = 0; i < 2; i++) {
        expect("its first pair", o.first[i], kept.pose[k].first[i]);
        expect("its first row", o.row[i], kept.pose[k].row[i]);
      }
    }
    bool busy = true;
    for (int k = 0; k < 1000 && busy; k++) {
      expect("busy", sepax_tree_device_busy(&device, &busy), SEPAX_TREE_DEVICE_OK);
    }
    free_scene(&s);
  }
  printf("results taken late: %llu cycles, %llu wrong\n", (unsigned long long)bus_cycles(), wrong);
}

void partners(uint64_t seed) {
  seed_of_gaps = 1 + seed;
  each_answer();
  uncalled_beats();
  damage_and_errors();
  records_at_pages();
  deep_tree();
  many_poses();
  stops();
}
