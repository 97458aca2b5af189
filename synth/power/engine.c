/* engine.c - an object engine as gates: what stands around it, for a whole run in 64 lanes.
 *
 * The memories (a word is there in the cycle after it was asked for) and the buses of
 * sepax_engine_logic are played: both objects are loaded, each lane's from another triangle on, and
 * run once, results taken as they come. Wrong are results, in order, ends, answers and counters
 * that are not sepax_engine's. */
#include "analysis.h"
#include "liberty/text.h"
#include "sepax_registers.h"

#include <err.h>
#include <stdio.h>
#include <stdlib.h>

enum { LANES = GATES_LANES, MEMORIES = 4, COUNTERS = 3, PATIENCE = 1000 };

static const uint64_t ALL = ~UINT64_C(0);
static const uint64_t END = UINT64_C(1) << 63;

/* sepax_ram: one port to write, one to read. */
typedef struct {
  const uint64_t *write, *read;
  const gates_port *write_address, *read_address, *write_data, *read_data;
  uint64_t *word; /* [address][bit], one bit a lane */
} memory;

/* A channel of a bus. */
typedef struct {
  uint64_t *valid, *ready;
  const gates_port *word;     /* an address, data */
  const gates_port *response; /* 0: okay; NULL: has none */
} channel;

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
  gates *g;
  const sepax_design *design;
  sepax_scene scene;
  memory memory[MEMORIES];
  channel write_address, write_data, write_answer, read_address, read_answer, in, out;
  uint64_t *rst, *in_last, *in_dest, *out_last;
  expected lane[LANES];
  uint64_t ended; /* lanes whose run has */
  uint64_t limit; /* cycles that no run takes */
  bool count;
  uint64_t wrong, pairs, collisions, coplanar, out_of_range; /* of all lanes */
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
    const gates_port *read_data = find(e->g, "read_", of[k].data, 0);
    e->memory[k] = (memory){
        .write = gates_bit(e->g, of[k].write),
        .read = gates_bit(e->g, of[k].read),
        .write_address = gates_find(e->g, "write_address", 0),
        .read_address = gates_find(e->g, of[k].read_address, __builtin_ctz((unsigned)words)),
        .write_data = find(e->g, "write_", of[k].write_data, 0),
        .read_data = read_data,
        .word = text_alloc((size_t)words * (size_t)read_data->bits, sizeof(uint64_t))};
  }
}

/* Those of the lanes `of` that ask for the same word as the first of them. */
static uint64_t with_first(const gates *g, const memory *m, const int address[], uint64_t of,
                           uint64_t **word) {
  int bits = m->read_address->bits;
  uint64_t number = gates_get(g, address, bits, (unsigned)__builtin_ctzll(of));
  for (int k = 0; k < bits; k++) {
    of &= (number >> k & 1) != 0 ? g->value[address[k]] : ~g->value[address[k]];
  }
  *word = m->word + number * (uint64_t)m->read_data->bits;
  return of;
}

/* The rising edge: the old word is read. */
static void clock_memory(gates *g, const memory *m) {
  uint64_t *word;
  for (uint64_t left = *m->read; left != 0;) {
    uint64_t now = with_first(g, m, m->read_address->net, left, &word);
    for (int k = 0; k < m->read_data->bits; k++) {
      uint64_t *net = &g->value[m->read_data->net[k]];
      *net = (*net & ~now) | (word[k] & now);
    }
    left &= ~now;
  }
  for (uint64_t left = *m->write; left != 0;) {
    uint64_t now = with_first(g, m, m->write_address->net, left, &word);
    for (int k = 0; k < m->read_data->bits; k++) { /* of B's triangles fewer than are written */
      word[k] = (word[k] & ~now) | (g->value[m->write_data->net[k]] & now);
    }
    left &= ~now;
  }
}

/* ---------------------------------------------------------------------- buses */

static channel find_channel(const gates *g, const char *bus, const char *word, int bits,
                            const char *response) {
  return (channel){.valid = &g->value[find(g, bus, "valid", 1)->net[0]],
                   .ready = &g->value[find(g, bus, "ready", 1)->net[0]],
                   .word = word == NULL ? NULL : find(g, bus, word, bits),
                   .response = response == NULL ? NULL : find(g, bus, response, 2)};
}

static void find_buses(engine *e) {
  const gates *g = e->g;
  e->write_address = find_channel(g, "s_axi_aw", "addr", 0, NULL);
  e->write_data = find_channel(g, "s_axi_w", "data", 32, NULL);
  e->write_answer = find_channel(g, "s_axi_b", NULL, 0, "resp");
  e->read_address = find_channel(g, "s_axi_ar", "addr", 0, NULL);
  e->read_answer = find_channel(g, "s_axi_r", "data", 32, "resp");
  e->in = find_channel(g, "s_axis_t", "data", 96, NULL);
  e->out = find_channel(g, "m_axis_t", "data", 64, NULL);
  e->in_last = gates_bit(g, "s_axis_tlast");
  e->in_dest = gates_bit(g, "s_axis_tdest");
  e->out_last = gates_bit(g, "m_axis_tlast");
  e->rst = gates_bit(g, "rst");
}

static void blame(engine *e, uint64_t lanes) { e->wrong += (uint64_t)__builtin_popcountll(lanes); }

static void take_result(engine *e, unsigned l) {
  expected *outstanding = &e->lane[l];
  uint64_t lane = UINT64_C(1) << l;
  uint64_t result = gates_get(e->g, e->out.word->net, 64, l);
  bool last = (*e->out_last & lane) != 0;
  bool right = (e->ended & lane) == 0 && result == outstanding->result[outstanding->seen] &&
               last == (outstanding->seen == outstanding->count);
  e->wrong += !right;
  e->coplanar += !last && (result >> 56 & 1) != 0;
  e->out_of_range += !last && (result >> 57 & 1) != 0;
  outstanding->seen += right && !last;
  e->ended |= last ? lane : 0;
}

/* The rest of a cycle whose inputs have settled. */
static void clock_edge(engine *e) {
  for (uint64_t left = *e->out.valid; left != 0; left &= left - 1) {
    take_result(e, (unsigned)__builtin_ctzll(left));
  }
  gates_rise(e->g, e->count);
  for (int k = 0; k < MEMORIES; k++) {
    clock_memory(e->g, &e->memory[k]);
  }
}

static void tick(engine *e) {
  gates_settle(e->g);
  clock_edge(e);
}

/* Offer what is on one or two channels until all lanes have taken it and, where there is an answer,
 * have given that; its word is `data` where it has one. */
static void transfer(engine *e, const channel *first, const channel *second, const channel *answer,
                     uint32_t data[LANES]) {
  const channel *const offer[2] = {first, second};
  uint64_t left[2] = {ALL, second == NULL ? 0 : ALL};
  uint64_t waits = answer == NULL ? 0 : ALL;
  for (int k = 0; k < PATIENCE && (left[0] | left[1] | waits) != 0; k++) {
    for (int n = 0; n < 2 && offer[n] != NULL; n++) {
      *offer[n]->valid = left[n];
    }
    gates_settle(e->g);
    for (int n = 0; n < 2 && offer[n] != NULL; n++) {
      left[n] &= ~*offer[n]->ready;
    }
    uint64_t now = answer == NULL ? 0 : waits & *answer->valid;
    for (uint64_t lanes = now; lanes != 0; lanes &= lanes - 1) {
      unsigned l = (unsigned)__builtin_ctzll(lanes);
      e->wrong += gates_get(e->g, answer->response->net, 2, l) != 0;
      if (answer->word != NULL) {
        data[l] = (uint32_t)gates_get(e->g, answer->word->net, 32, l);
      }
    }
    waits &= ~now;
    clock_edge(e);
  }
  blame(e, left[0] | left[1] | waits);
  for (int n = 0; n < 2 && offer[n] != NULL; n++) {
    *offer[n]->valid = 0;
  }
}

static void write_register(engine *e, uint64_t address, uint32_t data) {
  gates_set_all(e->g, e->write_address.word, address);
  gates_set_all(e->g, e->write_data.word, data);
  transfer(e, &e->write_address, &e->write_data, &e->write_answer, NULL);
}

static void read_register(engine *e, uint64_t address, uint32_t data[LANES]) {
  gates_set_all(e->g, e->read_address.word, address);
  transfer(e, &e->read_address, NULL, &e->read_answer, data);
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
  *e->in_dest = object == 1 ? ALL : 0;
  for (size_t k = 0; k < 3 * count; k++) {
    for (unsigned l = 0; l < LANES; l++) {
      const sepax_vec *v = &triangle_of(e, object, k / 3, l)->v[k % 3];
      gates_set(e->g, net, 32, l, (uint32_t)v->x);
      gates_set(e->g, net + 32, 32, l, (uint32_t)v->y);
      gates_set(e->g, net + 64, 32, l, (uint32_t)v->z);
    }
    *e->in_last = k + 1 == 3 * count ? ALL : 0;
    transfer(e, &e->in, NULL, NULL, NULL);
  }
  *e->in_last = 0;
}

static uint64_t result_of(const sepax_design *design, const sepax_tri *a, const sepax_tri *b,
                          const size_t number[2]) {
  const sepax_pair pair = {.a = *a, .b = *b};
  sepax_verdict v = sepax_judge(design, &pair);
  bool undecided = v.axis == SEPAX_AXIS_EXTENT;
  bool warning = design->limits > 0 && !undecided && v.band == SEPAX_BAND_WARNING;
  return (uint64_t)number[0] | (uint64_t)number[1] << 32 |
         (uint64_t)(v.coplanar && !undecided) << 56 | (uint64_t)undecided << 57 |
         (uint64_t)warning << 58;
}

static void expect(engine *e, unsigned l) {
  static const int32_t still[3] = {0, 0, 0};
  expected *outstanding = &e->lane[l];
  sepax_error error = {""};
  sepax_engine_run run;
  sepax_tri *tri[2];
  for (int object = 0; object < 2; object++) {
    tri[object] = text_alloc(e->scene.count[object], sizeof *tri[object]);
    for (size_t k = 0; k < e->scene.count[object]; k++) {
      tri[object][k] = *triangle_of(e, object, k, l);
    }
  }
  if (!sepax_engine(e->design, tri[0], e->scene.count[0], tri[1], e->scene.count[1], still, &run,
                    &error)) {
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
  e->limit = 2 * run.cycles + PATIENCE > e->limit ? 2 * run.cycles + PATIENCE : e->limit;
  sepax_pairs_free(&run.found);
  free(tri[0]);
  free(tri[1]);
}

/* Both objects have come, in all lanes. */
static void check_loaded(engine *e) {
  for (int object = 0; object < 2; object++) {
    uint32_t count[LANES] = {0};
    read_register(e, object == 0 ? SEPAX_COUNT_A : SEPAX_COUNT_B, count);
    for (unsigned l = 0; l < LANES; l++) {
      e->wrong += count[l] != e->scene.count[object];
    }
  }
}

/* From START to the end of the last lane's run. */
static void run_lanes(engine *e) {
  write_register(e, SEPAX_COMMAND, SEPAX_COMMAND_START);
  for (uint64_t k = 0; k < e->limit && e->ended != ALL; k++) {
    tick(e);
  }
  blame(e, ~e->ended);
}

/* The registers after the run, all of which must be the model's. */
static void check_counters(engine *e) {
  static const uint64_t address[COUNTERS] = {SEPAX_PAIRS, SEPAX_CANDIDATES, SEPAX_COLLISIONS};
  uint32_t counter[COUNTERS][LANES] = {{0}};
  for (int k = 0; k < COUNTERS; k++) {
    read_register(e, address[k], counter[k]);
  }
  for (unsigned l = 0; l < LANES; l++) {
    bool right = true;
    for (int k = 0; k < COUNTERS; k++) {
      right = right && counter[k][l] == e->lane[l].counter[k];
    }
    e->wrong += !right;
    e->pairs += counter[0][l];
    e->collisions += counter[2][l];
  }
}

void power_engine(analysis *m) {
  enum { RESET = 2, SETTLING = 4 };
  static engine it;
  engine *e = &it;
  run_part part = m->want->idle ? PART_IDLE : m->want->loading ? PART_LOADING : PART_RUN;
  if (m->want->mesh[0] == NULL) {
    errx(2, "an object engine wants two meshes; give -r RESOLUTION A.stl B.stl");
  }
  *e = (engine){.g = &m->g, .design = &m->design, .scene = power_meshes(m)};
  find_memories(e);
  find_buses(e);
  for (unsigned l = 0; l < LANES; l++) {
    expect(e, l);
  }
  gates_set_all(e->g, gates_find(e->g, "s_axi_wstrb", 4), 15);
  *e->write_answer.ready = *e->read_answer.ready = *e->out.ready = ALL;
  *e->rst = ALL;
  for (int k = 0; k < RESET; k++) {
    gates_settle(e->g);
    gates_rise(e->g, false);
  }
  *e->rst = 0;
  tick(e);
  e->count = part == PART_LOADING;
  load(e, 0);
  load(e, 1);
  for (int k = 0; k < SETTLING; k++) {
    tick(e);
  }
  e->count = false;
  check_loaded(e);
  if (part != PART_LOADING) {
    e->count = part == PART_RUN;
    run_lanes(e);
    e->count = false;
    check_counters(e);
  }
  e->count = part == PART_IDLE;
  for (int k = 0; k < m->want->cycles && e->count; k++) {
    tick(e);
  }
  m->wrong = e->wrong;
  if (part == PART_RUN) {
    m->taken = m->judged = m->pairs = e->pairs;
    m->collisions = e->collisions;
    m->coplanar = e->coplanar;
    m->undecided = e->out_of_range;
  }
}
