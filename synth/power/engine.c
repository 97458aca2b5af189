/* engine.c - see engine.h. */
#include "engine.h"
#include "liberty/text.h"
#include "sepax_design.h"
#include "sepax_registers.h"

#include <stdio.h>
#include <stdlib.h>

enum {
  LANES = GATES_LANES,
  MEMORIES = 4,
  WORD_MOST = 9 * SEPAX_WORD_MAX,
  ADDRESS_MOST = 15,
  PATIENCE = 1000
};

static const uint64_t ALL = ~UINT64_C(0);
static const uint64_t END = UINT64_C(1) << 63;

/* sepax_ram: one port to write, one to read. */
typedef struct {
  int write, read, bits, address_bits; /* of a word, of an address */
  int write_address[ADDRESS_MOST], read_address[ADDRESS_MOST];
  int write_data[WORD_MOST], read_data[WORD_MOST];
  uint64_t *word; /* [address][bit], one bit a lane */
} memory;

/* What is outstanding in a lane: its results in order, the end behind them; its counts. */
typedef struct {
  uint64_t *result;
  size_t count, seen;
  uint32_t pairs, candidates, collisions;
} expected;

typedef struct {
  gates *g;
  const sepax_design *design;
  const sepax_scene *scene;
  memory memory[MEMORIES];
  int rst;
  int register_bits; /* of their addresses */
  int awvalid, awready, awaddr[ADDRESS_MOST], wvalid, wready, wdata[32], wstrb[4];
  int bvalid, bready, bresp[2];
  int arvalid, arready, araddr[ADDRESS_MOST], rvalid, rready, rdata[32], rresp[2];
  int in_valid, in_ready, in_data[96], in_last, in_dest;
  int out_valid, out_ready, out_data[64], out_last;
  expected lane[LANES];
  uint64_t ended; /* lanes whose run has */
  uint64_t limit; /* cycles that no run takes */
  bool count;
  engine_tally tally;
} engine;

/* ------------------------------------------------------------------- memories */

static void find_memories(engine *e) {
  const sepax_config *c = &e->design->config;
  gates *g = e->g;
  for (int k = 0; k < MEMORIES; k++) {
    memory *m = &e->memory[k];
    const char *kind = k < 2 ? "aabb" : "triangle";
    char x = (char)('a' + k % 2);
    char name[32];
    int words = k % 2 == 0 ? c->memory_a : c->memory_b;
    m->bits = (k < 2 ? 6 : 9) * c->word;
    while (1 << m->address_bits < words) {
      m->address_bits++;
    }
    snprintf(name, sizeof name, "write_%c", x);
    m->write = gates_find(g, name, -1);
    m->read = gates_find(g, k < 2 ? "step" : "fetch", -1);
    gates_find_word(g, "write_address", m->address_bits, m->write_address);
    snprintf(name, sizeof name, "write_%s", kind);
    gates_find_word(g, name, m->bits, m->write_data);
    snprintf(name, sizeof name, k < 2 ? "aabb_address_%c" : "fetch_%c", x);
    gates_find_word(g, name, m->address_bits, m->read_address);
    snprintf(name, sizeof name, "read_%s_%c", kind, x);
    gates_find_word(g, name, m->bits, m->read_data);
    m->word = text_alloc((size_t)words * (size_t)m->bits, sizeof *m->word);
  }
}

/* Those of the lanes `of` that ask for the same word as the first of them. */
static uint64_t with_first(const gates *g, const memory *m, const int address[], uint64_t of,
                           uint64_t **word) {
  uint64_t number = gates_get(g, address, m->address_bits, (unsigned)__builtin_ctzll(of));
  for (int k = 0; k < m->address_bits; k++) {
    of &= (number >> k & 1) != 0 ? g->value[address[k]] : ~g->value[address[k]];
  }
  *word = m->word + number * (uint64_t)m->bits;
  return of;
}

/* The rising edge: the old word is read. */
static void clock_memory(gates *g, const memory *m) {
  uint64_t *word;
  for (uint64_t left = g->value[m->read]; left != 0;) {
    uint64_t now = with_first(g, m, m->read_address, left, &word);
    for (int k = 0; k < m->bits; k++) {
      uint64_t *net = &g->value[m->read_data[k]];
      *net = (*net & ~now) | (word[k] & now);
    }
    left &= ~now;
  }
  for (uint64_t left = g->value[m->write]; left != 0;) {
    uint64_t now = with_first(g, m, m->write_address, left, &word);
    for (int k = 0; k < m->bits; k++) {
      word[k] = (word[k] & ~now) | (g->value[m->write_data[k]] & now);
    }
    left &= ~now;
  }
}

/* ---------------------------------------------------------------------- buses */

static void find_buses(engine *e) {
  e->register_bits = gates_bits(e->g, "s_axi_awaddr", ADDRESS_MOST);
  const struct {
    const char *name;
    int bits; /* 0: no vector */
    int *net;
  } list[] = {
      {"rst", 0, &e->rst},
      {"s_axi_awvalid", 0, &e->awvalid},
      {"s_axi_awready", 0, &e->awready},
      {"s_axi_awaddr", e->register_bits, e->awaddr},
      {"s_axi_wvalid", 0, &e->wvalid},
      {"s_axi_wready", 0, &e->wready},
      {"s_axi_wdata", 32, e->wdata},
      {"s_axi_wstrb", 4, e->wstrb},
      {"s_axi_bvalid", 0, &e->bvalid},
      {"s_axi_bready", 0, &e->bready},
      {"s_axi_bresp", 2, e->bresp},
      {"s_axi_arvalid", 0, &e->arvalid},
      {"s_axi_arready", 0, &e->arready},
      {"s_axi_araddr", e->register_bits, e->araddr},
      {"s_axi_rvalid", 0, &e->rvalid},
      {"s_axi_rready", 0, &e->rready},
      {"s_axi_rdata", 32, e->rdata},
      {"s_axi_rresp", 2, e->rresp},
      {"s_axis_tvalid", 0, &e->in_valid},
      {"s_axis_tready", 0, &e->in_ready},
      {"s_axis_tdata", 96, e->in_data},
      {"s_axis_tlast", 0, &e->in_last},
      {"s_axis_tdest", 0, &e->in_dest},
      {"m_axis_tvalid", 0, &e->out_valid},
      {"m_axis_tready", 0, &e->out_ready},
      {"m_axis_tdata", 64, e->out_data},
      {"m_axis_tlast", 0, &e->out_last},
  };
  for (size_t k = 0; k < sizeof list / sizeof list[0]; k++) {
    if (list[k].bits == 0) {
      *list[k].net = gates_find(e->g, list[k].name, -1);
    } else {
      gates_find_word(e->g, list[k].name, list[k].bits, list[k].net);
    }
  }
}

static void blame(engine *e, uint64_t lanes) {
  e->tally.wrong += (uint64_t)__builtin_popcountll(lanes);
}

static void take_result(engine *e, unsigned l) {
  expected *outstanding = &e->lane[l];
  uint64_t lane = UINT64_C(1) << l;
  uint64_t result = gates_get(e->g, e->out_data, 64, l);
  bool last = (e->g->value[e->out_last] >> l & 1) != 0;
  bool right = (e->ended & lane) == 0 && result == outstanding->result[outstanding->seen] &&
               last == (outstanding->seen == outstanding->count);
  e->tally.wrong += !right;
  e->tally.coplanar += !last && (result >> 56 & 1) != 0;
  e->tally.out_of_range += !last && (result >> 57 & 1) != 0;
  outstanding->seen += right && !last;
  e->ended |= last ? lane : 0;
}

/* The rest of a cycle whose inputs have settled. */
static void clock_edge(engine *e) {
  for (uint64_t left = e->g->value[e->out_valid]; left != 0; left &= left - 1) {
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

static void write_register(engine *e, uint64_t address_of, uint32_t data) {
  uint64_t *value = e->g->value;
  uint64_t address = ALL; /* lanes that still have to do it */
  uint64_t word = ALL;
  uint64_t answer = ALL;
  gates_set_all(e->g, e->awaddr, e->register_bits, address_of);
  gates_set_all(e->g, e->wdata, 32, data);
  for (int k = 0; k < PATIENCE && answer != 0; k++) {
    value[e->awvalid] = address;
    value[e->wvalid] = word;
    gates_settle(e->g);
    address &= ~value[e->awready];
    word &= ~value[e->wready];
    uint64_t now = answer & value[e->bvalid];
    blame(e, now & (value[e->bresp[0]] | value[e->bresp[1]]));
    answer &= ~now;
    clock_edge(e);
  }
  blame(e, answer);
  value[e->awvalid] = value[e->wvalid] = 0;
}

static void read_register(engine *e, uint64_t address_of, uint32_t data[LANES]) {
  uint64_t *value = e->g->value;
  uint64_t address = ALL;
  uint64_t answer = ALL;
  gates_set_all(e->g, e->araddr, e->register_bits, address_of);
  for (int k = 0; k < PATIENCE && answer != 0; k++) {
    value[e->arvalid] = address;
    gates_settle(e->g);
    address &= ~value[e->arready];
    uint64_t now = answer & value[e->rvalid];
    blame(e, now & (value[e->rresp[0]] | value[e->rresp[1]]));
    for (uint64_t left = now; left != 0; left &= left - 1) {
      unsigned l = (unsigned)__builtin_ctzll(left);
      data[l] = (uint32_t)gates_get(e->g, e->rdata, 32, l);
    }
    answer &= ~now;
    clock_edge(e);
  }
  blame(e, answer);
  value[e->arvalid] = 0;
}

/* ------------------------------------------------------------------------ a run */

/* The triangle that is number k of a lane's object. */
static const sepax_tri *triangle_of(const engine *e, int object, size_t k, unsigned l) {
  size_t count = e->scene->count[object];
  return &e->scene->tri[object][(k + count * l / LANES) % count];
}

static void load(engine *e, int object) {
  uint64_t *value = e->g->value;
  size_t count = e->scene->count[object];
  value[e->in_dest] = object == 1 ? ALL : 0;
  for (size_t k = 0; k < 3 * count; k++) {
    for (unsigned l = 0; l < LANES; l++) {
      const sepax_vec *v = &triangle_of(e, object, k / 3, l)->v[k % 3];
      gates_set(e->g, e->in_data, 32, l, (uint32_t)v->x);
      gates_set(e->g, e->in_data + 32, 32, l, (uint32_t)v->y);
      gates_set(e->g, e->in_data + 64, 32, l, (uint32_t)v->z);
    }
    value[e->in_last] = k + 1 == 3 * count ? ALL : 0;
    uint64_t left = ALL;
    for (int wait = 0; wait < PATIENCE && left != 0; wait++) {
      value[e->in_valid] = left;
      gates_settle(e->g);
      left &= ~value[e->in_ready];
      clock_edge(e);
    }
    blame(e, left);
  }
  value[e->in_valid] = value[e->in_last] = 0;
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
    tri[object] = text_alloc(e->scene->count[object], sizeof *tri[object]);
    for (size_t k = 0; k < e->scene->count[object]; k++) {
      tri[object][k] = *triangle_of(e, object, k, l);
    }
  }
  if (!sepax_engine(e->design, tri[0], e->scene->count[0], tri[1], e->scene->count[1], still, &run,
                    &error)) {
    fprintf(stderr, "power: %s\n", error.text);
    exit(2);
  }
  outstanding->count = run.found.count;
  outstanding->pairs = (uint32_t)run.pairs;
  outstanding->candidates = (uint32_t)run.candidates;
  outstanding->collisions = (uint32_t)run.collisions;
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
      e->tally.wrong += count[l] != e->scene->count[object];
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
static void check_counts(engine *e) {
  uint32_t pairs[LANES] = {0};
  uint32_t candidates[LANES] = {0};
  uint32_t collisions[LANES] = {0};
  read_register(e, SEPAX_PAIRS, pairs);
  read_register(e, SEPAX_CANDIDATES, candidates);
  read_register(e, SEPAX_COLLISIONS, collisions);
  for (unsigned l = 0; l < LANES; l++) {
    const expected *outstanding = &e->lane[l];
    e->tally.wrong += pairs[l] != outstanding->pairs || candidates[l] != outstanding->candidates ||
                      collisions[l] != outstanding->collisions;
    e->tally.pairs += pairs[l];
    e->tally.collisions += collisions[l];
  }
}

engine_tally engine_run(gates *g, const sepax_design *design, const sepax_scene *scene,
                        engine_part part, int cycles) {
  enum { RESET = 2, SETTLING = 4 };
  static engine it;
  engine *e = &it;
  *e = (engine){.g = g, .design = design, .scene = scene};
  find_memories(e);
  find_buses(e);
  for (unsigned l = 0; l < LANES; l++) {
    expect(e, l);
  }
  gates_scramble(g);
  gates_set_all(g, e->wstrb, 4, 15);
  g->value[e->bready] = g->value[e->rready] = g->value[e->out_ready] = ALL;
  g->value[e->rst] = ALL;
  for (int k = 0; k < RESET; k++) {
    gates_settle(g);
    gates_rise(g, false);
  }
  g->value[e->rst] = 0;
  tick(e);
  e->count = part == POWER_LOADING;
  load(e, 0);
  load(e, 1);
  for (int k = 0; k < SETTLING; k++) {
    tick(e);
  }
  e->count = false;
  check_loaded(e);
  if (part != POWER_LOADING) {
    e->count = part == POWER_RUN;
    run_lanes(e);
    e->count = false;
    check_counts(e);
  }
  e->count = part == POWER_IDLE;
  for (int k = 0; k < cycles && e->count; k++) {
    tick(e);
  }
  for (unsigned l = 0; l < LANES; l++) {
    free(e->lane[l].result);
  }
  for (int k = 0; k < MEMORIES; k++) {
    free(e->memory[k].word);
  }
  return e->tally;
}
