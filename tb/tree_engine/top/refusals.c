/* SPDX-License-Identifier: MIT */
/* refusals.c - what the tree engine refuses in its registers, jobs and poses; interrupts; errors of
 * the memory in jobs and poses. */
#include "rounds.h"
#include "tree_engine/format.h"

#include <string.h>

static uint32_t value_of(uint32_t address) {
  uint32_t value = 0;
  expect("a register can be read", bus_read(NULL, address, &value), 1);
  return value;
}

/* ------------------------------------------------------------------ registers */

/* Each bit beyond those that a register has, alone; commands that are none; bytes of a word. */
static void single_bits(void) {
  static const struct {
    uint32_t address, bits;
  } known[] = {{SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_STOP},
               {SEPAX_TREE_ENABLE, 7},
               {SEPAX_TREE_PENDING, 7},
               {SEPAX_TREE_LIST_LOW, ~UINT32_C(127)},
               {SEPAX_TREE_LIST_HIGH, 255}};
  expect("JOBS", bus_write(NULL, SEPAX_TREE_JOBS, 1),
         1); /* START may be refused for its bits alone */
  for (size_t n = 0; n < sizeof known / sizeof *known; n++) {
    for (int k = 0; k < 32; k++) {
      const uint32_t bit = UINT32_C(1) << k;
      bool start = known[n].address == SEPAX_TREE_COMMAND && bit == SEPAX_TREE_COMMAND_START;
      if (!start) {
        expect("one bit", bus_write(NULL, known[n].address, bit), (bit & known[n].bits) != 0);
      }
      if (known[n].address == SEPAX_TREE_COMMAND && bit > SEPAX_TREE_COMMAND_STOP) {
        expect("a bit with START",
               bus_write(NULL, SEPAX_TREE_COMMAND, bit | SEPAX_TREE_COMMAND_START), 0);
        expect("a bit with STOP",
               bus_write(NULL, SEPAX_TREE_COMMAND, bit | SEPAX_TREE_COMMAND_STOP), 0);
      }
    }
  }
  for (unsigned strobes = 0; strobes < 15; strobes++) {
    expect("a write of bytes", bus_write_part(SEPAX_TREE_JOBS, 1, strobes), 0);
  }
  for (int k = 0; k < 32; k++) { /* no batch begins without jobs, and with each number there are */
    expect("JOBS", bus_write(NULL, SEPAX_TREE_JOBS, UINT32_C(1) << k), 1);
    expect("JOBS reads back", value_of(SEPAX_TREE_JOBS), UINT32_C(1) << k);
  }
  expect("nothing has begun", value_of(SEPAX_TREE_STATUS), 0);
}

/* One event after the other is cleared, and each alone is an interrupt. */
static void events(void) {
  const uint32_t all = SEPAX_TREE_PENDING_DONE | SEPAX_TREE_PENDING_HIT | SEPAX_TREE_PENDING_POSE;
  uint32_t left = all;
  expect("all events are pending", value_of(SEPAX_TREE_PENDING), all);
  for (uint32_t bit = 1; bit < 8; bit *= 2) {
    for (uint32_t enabled = 1; enabled < 8; enabled *= 2) {
      expect("ENABLE", bus_write(NULL, SEPAX_TREE_ENABLE, enabled), 1);
      bus_idle(4);
      expect("an interrupt of an event", bus_interrupt(), (left & enabled) != 0);
    }
    left &= ~bit;
    expect("PENDING", bus_write(NULL, SEPAX_TREE_PENDING, bit), 1);
    expect("the others are pending", value_of(SEPAX_TREE_PENDING), left);
  }
  bus_idle(4);
  expect("no interrupt that was cleared", bus_interrupt(), 0);
}

static void settings(void) {
  static const crowd_register known[] = {{SEPAX_TREE_ENABLE, 7, false, false},
                                         {SEPAX_TREE_PENDING, 7, false, true},
                                         {SEPAX_TREE_LIST_LOW, ~UINT32_C(127), false, false},
                                         {SEPAX_TREE_LIST_HIGH, 255, false, false},
                                         {SEPAX_TREE_JOBS, UINT32_MAX, false, false}};
  bus_reset();
  crowd(known, sizeof known / sizeof known[0], SEPAX_TREE_COMMAND, 1);
  bus_reset();
  uint32_t value = 0;
  for (uint32_t address = 0; address < 0x80; address++) {
    bool is_one = address % 4 == 0 && address <= SEPAX_TREE_CYCLES && address != SEPAX_TREE_COMMAND;
    expect("which addresses can be read", bus_read(NULL, address, &value), is_one);
    if (address % 4 != 0) {
      expect("a write that is not aligned", bus_write(NULL, address, 1), 0);
    }
  }
  expect("START without jobs", bus_write(NULL, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_START), 0);
  expect("ID is read only", bus_write(NULL, SEPAX_TREE_ID, 0), 0);
  expect("a list at 64", bus_write(NULL, SEPAX_TREE_LIST_LOW, 64), 0);
  expect("a list beyond 40 bits", bus_write(NULL, SEPAX_TREE_LIST_HIGH, 256), 0);
  expect("partial strobes", bus_write_part(SEPAX_TREE_JOBS, 1, 7), 0);
  expect("STATUS after a reset", value_of(SEPAX_TREE_STATUS), 0);
  expect("PENDING after a reset", value_of(SEPAX_TREE_PENDING), 0);
  single_bits();
  bus_reset();
}

/* ------------------------------------------------------------------ jobs, poses */

/* A job and a pose of a scene as they were. */
typedef struct {
  scene scene;
  uint8_t *job, *pose;
  uint64_t tried;
} subject;

static bool is_refused(const subject *s) {
  sepax_tree_job job;
  sepax_tree_pose pose;
  sepax_error error;
  return !sepax_tree_job_unpack(&job, s->job) || !sepax_tree_pose_unpack(&pose, s->pose, &error);
}

/* What they are now is refused, if the golden model refuses it; else it is not tried. */
static void try_it(subject *s, const char *what) {
  if (is_refused(s)) {
    bench_batch batch = {.list = s->scene.batch.list, .jobs = 1, .stop_at = -1, .any = true};
    bench_run(&batch);
    expect(what, batch.refused, 1);
    s->tried++;
  }
}

static void each_bit(subject *s, uint8_t *bytes, size_t from, size_t to, const char *what) {
  for (size_t k = from; k < to && wrong == 0; k++) {
    for (int bit = 0; bit < 8; bit++) {
      bytes[k] ^= (uint8_t)(1U << bit);
      try_it(s, what);
      bytes[k] ^= (uint8_t)(1U << bit);
    }
  }
}

/* Each bit that takes a number out of its range: of numbers of which all bits are 0 or 1, and of
 * the greatest there are. */
static void bits_of_poses(subject *s) {
  enum { SHIFTS = 0, MATRIX = 48, SIGMA = 120 };
  uint8_t kept[SEPAX_TREE_POSE_BYTES];
  memcpy(kept, s->pose, sizeof kept);
  for (int sign = 0; sign < 2; sign++) {
    memset(s->pose, sign != 0 ? 255 : 0, SIGMA);
    memset(s->pose + SIGMA, 0, SEPAX_TREE_POSE_BYTES - SIGMA);
    each_bit(s, s->pose, SHIFTS, sign != 0 ? SIGMA : SEPAX_TREE_POSE_BYTES, "a bit of a pose");
  }
  for (int k = MATRIX; k < SIGMA; k += 4) {
    bytes_put32(s->pose + k, UINT32_C(1) << 20);
  }
  each_bit(s, s->pose, MATRIX, SIGMA, "a bit of an entry that is 1");
  memcpy(s->pose, kept, sizeof kept);
}

static void bits_of_jobs(subject *s) {
  enum { NODES = 8, TRIANGLES = 12, BEATS = 16, COUNT = 72 };
  uint8_t kept[SEPAX_TREE_JOB_BYTES];
  memcpy(kept, s->job, sizeof kept);
  each_bit(s, s->job, 0, sizeof kept, "a bit of a job");
  bytes_put32(s->job + COUNT, 0);
  try_it(s, "no pose");
  memcpy(s->job, kept, sizeof kept);
  for (size_t body = 0; body < 2; body++) {
    uint8_t *record = s->job + SEPAX_TREE_BODY_BYTES * body;
    for (int k = 0; k < 23; k++) { /* nodes that end just behind the image */
      for (uint32_t one = 0; one < 2; one++) {
        uint32_t nodes = UINT32_C(1) << k | one;
        bytes_put32(record + NODES, nodes);
        bytes_put32(record + BEATS, 8 * nodes - 1);
        try_it(s, "an image that is too short");
      }
    }
    bytes_put32(record + BEATS, UINT32_MAX);
    bytes_put32(record + NODES, TREE_NODES_MAX);
    each_bit(s, record, NODES, TRIANGLES, "more nodes than there may be");
    bytes_put32(record + NODES, 0);
    try_it(s, "no nodes");
    memcpy(s->job, kept, sizeof kept);
    bytes_put32(record + TRIANGLES, UINT32_C(1) << 24);
    each_bit(s, record, TRIANGLES, BEATS, "more triangles than there may be");
    bytes_put32(record + TRIANGLES, 0);
    try_it(s, "no triangles");
    memcpy(s->job, kept, sizeof kept);
  }
}

static void ranges(void) {
  subject s = {.tried = 0};
  some_scene(&s.scene);
  bench_attach((memory_options){.latency = 1});
  s.job = bench_at(s.scene.job[0]);
  s.pose = bench_at(s.scene.pose[0]);
  bits_of_jobs(&s);
  bits_of_poses(&s);
  expect("hundreds of numbers are out of their ranges", s.tried > 1000, 1);
  for (int of_pose = 0; of_pose < 2; of_pose++) { /* errors of the memory in each of their beats */
    for (size_t beat = 0; beat < (of_pose != 0 ? 9U : 6U); beat++) {
      bench_batch batch = {.list = s.scene.batch.list, .jobs = 1, .stop_at = -1, .errors = true};
      uint64_t at =
          bench_address((of_pose != 0 ? s.scene.pose[0] : s.scene.job[0]) + MEMORY_BEAT * beat);
      bench_attach((memory_options){.latency = 5, .error_from = at, .error_to = at + 1});
      bench_run(&batch);
      expect("an error in a beat of a job or a pose", batch.bus, 1);
    }
  }
  free_scene(&s.scene);
}

/* Interrupts; registers of a batch; nobody takes results; nothing is written while it is busy. */
static void controls(void) {
  scene s;
  do {
    some_scene(&s);
    free_scene(&s);
    s.batch.jobs = 1;
    bench_at(s.job[0])[76] = 0;
    memset(bench_at(s.job[0]) + 80, 0, 4);
    bench_attach((memory_options){.latency = 20});
    bench_run(&s.batch);
  } while (s.batch.hits == 0);
  uint32_t value = 0;
  expect("STATUS",
         bus_read(NULL, SEPAX_TREE_STATUS, &value) && (value & SEPAX_TREE_STATUS_HIT) != 0, 1);
  expect("no interrupt that is not enabled", bus_interrupt(), 0);
  events();
  bus_block_results(true);
  expect("START", bus_write(NULL, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_START), 1);
  bus_idle(3000);
  expect("BUSY while nobody takes results",
         bus_read(NULL, SEPAX_TREE_STATUS, &value) && (value & SEPAX_TREE_STATUS_BUSY) != 0, 1);
  expect("JOBS while busy", bus_write(NULL, SEPAX_TREE_JOBS, 2), 0);
  expect("START while busy", bus_write(NULL, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_START), 0);
  expect("STOP", bus_write(NULL, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_STOP), 1);
  bus_block_results(false);
  sepax_outcome outcome = {.last = false};
  sepax_tree_device_status status = SEPAX_TREE_DEVICE_OK;
  do {
    status = sepax_tree_device_take(&device, NULL, NULL, &outcome);
    expect("a pose that ends", status, SEPAX_TREE_DEVICE_OK);
  } while (!outcome.last && status == SEPAX_TREE_DEVICE_OK);
}

void refusals(void) {
  settings();
  ranges();
  controls();
}
