/* SPDX-License-Identifier: MIT */
/* object_engine.c - an object engine as gates: what stands around it, for a whole run in 64 lanes.
 *
 * The memories (a word is there in the cycle after it was asked for) and the buses of
 * sepax_engine_logic are played: both objects are loaded, each lane's from another triangle on, and
 * run once, results taken as they come. Wrong are results, in order, ends, answers and counters
 * that are not sepax_object_engine's. */
#include "analysis.h"
#include "around.h"
#include "liberty/text.h"
#include "sepax_registers.h"

#include <err.h>
#include <stdio.h>
#include <stdlib.h>

enum { LANES = GATES_LANES, MEMORIES = 4, COUNTERS = 3, SPARE = 1000 };

static const uint64_t END = UINT64_C(1) << 63;

/* What is outstanding in a lane: its results in order, the end behind them; its counters. */
typedef struct {
  uint64_t *result;
  size_t count, seen;
  uint32_t counter[COUNTERS];
} expected;

/* What is counted: from START to the end of the last lane's run; both objects as they come; the
 * cycles after the run, in which nothing comes. */
typedef enum { PART_RUN, PART_LOADING, PART_IDLE } run_part;

typedef struct {
  around a; /* first: what take_results is given */
  const sepax_design *design;
  sepax_scene scene;
  memory memory[MEMORIES];
  channel in;
  uint64_t *in_last, *in_dest;
  expected lane[LANES];
  uint64_t ended;                                     /* lanes whose run has */
  uint64_t limit;                                     /* cycles that no run takes */
  uint64_t pairs, collisions, coplanar, out_of_range; /* of all lanes */
} engine;

/* ------------------------------------------------------------------- memories */

static const gates_port *find(const gates *g, const char *group, const char *name, int bits) {
  char full[64];
  snprintf(full, sizeof full, "%s%s", group, name);
  return gates_find(g, full, bits);
}

static void find_memories(engine *e) {
  static const struct {
    const char *data, *write_data, *read_address, *write, *read;
  } of[MEMORIES] = {{"aabb_a", "aabb", "aabb_address_a", "write_a", "step"},
                    {"aabb_b", "aabb", "aabb_address_b", "write_b", "step"},
                    {"triangle_a", "triangle", "fetch_a", "write_a", "fetch"},
                    {"triangle_b", "triangle", "fetch_b", "write_b", "fetch"}};
  const sepax_config *c = &e->design->config;
  for (int k = 0; k < MEMORIES; k++) {
    int words = k % 2 == 0 ? c->memory_a : c->memory_b;
    e->memory[k] = around_memory((memory){
        .write = gates_bit(e->a.g, of[k].write),
        .read = gates_bit(e->a.g, of[k].read),
        .write_address = gates_find(e->a.g, "write_address", 0),
        .read_address = gates_find(e->a.g, of[k].read_address, __builtin_ctz((unsigned)words)),
        .write_data = find(e->a.g, "write_", of[k].write_data, 0),
        .read_data = find(e->a.g, "read_", of[k].data, 0)});
  }
}

/* -------------------------------------------------------------------- results */

static void take_result(engine *e, unsigned l) {
  expected *outstanding = &e->lane[l];
  uint64_t lane = UINT64_C(1) << l;
  uint64_t result = gates_get(e->a.g, e->a.out.word->net, 64, l);
  bool last = (*e->a.out_last & lane) != 0;
  bool right = (e->ended & lane) == 0 && result == outstanding->result[outstanding->seen] &&
               last == (outstanding->seen == outstanding->count);
  e->a.wrong += !right;
  e->coplanar += !last && (result >> 56 & 1) != 0;
  e->out_of_range += !last && (result >> 57 & 1) != 0;
  outstanding->seen += right && !last;
  e->ended |= last ? lane : 0;
}

static void take_results(around *a) {
  for (uint64_t left = *a->out.valid; left != 0; left &= left - 1) {
    take_result((engine *)a, (unsigned)__builtin_ctzll(left));
  }
}

/* ------------------------------------------------------------------------ a run */

/* The triangle that is number k of a lane's object. */
static const sepax_tri *triangle_of(const engine *e, int object, size_t k, unsigned l) {
  size_t count = e->scene.count[object];
  return &e->scene.tri[object][(k + count * l / LANES) % count];
}

static void load(engine *e, int object) {
  size_t count = e->scene.count[object];
  const int *net = e->in.word->net;
  *e->in_dest = object == 1 ? around_all : 0;
  for (size_t k = 0; k < 3 * count; k++) {
    for (unsigned l = 0; l < LANES; l++) {
      const sepax_vec *v = &triangle_of(e, object, k / 3, l)->v[k % 3];
      gates_set(e->a.g, net, 32, l, (uint32_t)v->x);
      gates_set(e->a.g, net + 32, 32, l, (uint32_t)v->y);
      gates_set(e->a.g, net + 64, 32, l, (uint32_t)v->z);
    }
    *e->in_last = k + 1 == 3 * count ? around_all : 0;
    around_transfer(&e->a, &e->in, NULL, NULL, NULL);
  }
  *e->in_last = 0;
}

static uint64_t result_of(const sepax_design *design, const sepax_tri *a, const sepax_tri *b,
                          const size_t number[2]) {
  const sepax_pair pair = {.a = *a, .b = *b};
  sepax_judgement v = sepax_judge(design, &pair);
  bool undecided = v.axis == SEPAX_AXIS_EXTENT;
  bool warning = design->limits > 0 && !undecided && v.band == SEPAX_BAND_WARNING;
  return (uint64_t)number[0] | (uint64_t)number[1] << 32 |
         (uint64_t)(v.coplanar && !undecided) << 56 | (uint64_t)undecided << 57 |
         (uint64_t)warning << 58;
}

static void expect(engine *e, unsigned l) {
  static const int32_t still[3] = {0, 0, 0};
  expected *outstanding = &e->lane[l];
  sepax_error error = {0};
  sepax_object_run run;
  sepax_tri *tri[2];
  for (int object = 0; object < 2; object++) {
    tri[object] = text_alloc(e->scene.count[object], sizeof *tri[object]);
    for (size_t k = 0; k < e->scene.count[object]; k++) {
      tri[object][k] = *triangle_of(e, object, k, l);
    }
  }
  if (!sepax_object_engine(e->design, tri[0], e->scene.count[0], tri[1], e->scene.count[1], still,
                           &run, &error)) {
    errx(2, "%s", error.text);
  }
  outstanding->count = run.found.count;
  outstanding->counter[0] = (uint32_t)run.pairs;
  outstanding->counter[1] = (uint32_t)run.candidates;
  outstanding->counter[2] = (uint32_t)run.collisions;
  outstanding->result = text_alloc(outstanding->count + 1, sizeof *outstanding->result);
  for (size_t k = 0; k < outstanding->count; k++) {
    const size_t *number = run.found.pair[k];
    outstanding->result[k] = result_of(e->design, &tri[0][number[0]], &tri[1][number[1]], number);
  }
  outstanding->result[outstanding->count] = END | outstanding->count;
  e->limit = 2 * run.cycles + SPARE > e->limit ? 2 * run.cycles + SPARE : e->limit;
  sepax_pairs_free(&run.found);
  free(tri[0]);
  free(tri[1]);
}

/* Both objects have come, in all lanes. */
static void check_loaded(engine *e) {
  for (int object = 0; object < 2; object++) {
    uint32_t count[LANES] = {0};
    around_read(&e->a, object == 0 ? SEPAX_COUNT_A : SEPAX_COUNT_B, count);
    for (unsigned l = 0; l < LANES; l++) {
      e->a.wrong += count[l] != e->scene.count[object];
    }
  }
}

/* From START to the end of the last lane's run. */
static void run_lanes(engine *e) {
  around_write(&e->a, SEPAX_COMMAND, SEPAX_COMMAND_START);
  for (uint64_t k = 0; k < e->limit && e->ended != around_all; k++) {
    around_tick(&e->a);
  }
  e->a.wrong += (uint64_t)__builtin_popcountll(~e->ended);
}

/* The registers after the run, all of which must be the model's. */
static void check_counters(engine *e) {
  static const uint64_t address[COUNTERS] = {SEPAX_PAIRS, SEPAX_CANDIDATES, SEPAX_COLLISIONS};
  uint32_t counter[COUNTERS][LANES] = {{0}};
  for (int k = 0; k < COUNTERS; k++) {
    around_read(&e->a, address[k], counter[k]);
  }
  for (unsigned l = 0; l < LANES; l++) {
    bool right = true;
    for (int k = 0; k < COUNTERS; k++) {
      right = right && counter[k][l] == e->lane[l].counter[k];
    }
    e->a.wrong += !right;
    e->pairs += counter[0][l];
    e->collisions += counter[2][l];
  }
}

void power_object(analysis *m) {
  enum { SETTLING = 4 };
  static engine it;
  engine *e = &it;
  run_part part = m->want->idle ? PART_IDLE : m->want->loading ? PART_LOADING : PART_RUN;
  if (m->want->mesh[0] == NULL) {
    errx(2, "an object engine wants two meshes; give -r RESOLUTION A.stl B.stl");
  }
  *e = (engine){.a = {.g = &m->g, .memories = MEMORIES, .take = take_results},
                .design = &m->design,
                .scene = power_meshes(m)};
  e->a.memory = e->memory;
  find_memories(e);
  for (unsigned l = 0; l < LANES; l++) {
    expect(e, l);
  }
  e->in = around_channel(e->a.g, "s_axis_t", "data", 96, NULL);
  e->in_last = gates_bit(e->a.g, "s_axis_tlast");
  e->in_dest = gates_bit(e->a.g, "s_axis_tdest");
  around_begin(&e->a);
  e->a.count = part == PART_LOADING;
  load(e, 0);
  load(e, 1);
  for (int k = 0; k < SETTLING; k++) {
    around_tick(&e->a);
  }
  e->a.count = false;
  check_loaded(e);
  if (part != PART_LOADING) {
    e->a.count = part == PART_RUN;
    run_lanes(e);
    e->a.count = false;
    check_counters(e);
  }
  e->a.count = part == PART_IDLE;
  for (int k = 0; k < m->want->cycles && e->a.count; k++) {
    around_tick(&e->a);
  }
  m->wrong = e->a.wrong;
  if (part == PART_RUN) {
    m->taken = m->judged = m->pairs = e->pairs;
    m->collisions = e->collisions;
    m->coplanar = e->coplanar;
    m->undecided = e->out_of_range;
  }
}
