/* SPDX-License-Identifier: MIT */
/* tree_engine.c - a tree engine as gates: what stands around it, for a batch in 64 lanes.
 *
 * The memories of sepax_engine, its AXI4 port to a memory with latency, and its buses are played.
 * Lane l walks the poses l, l + 64, ... of a file, with cold caches. Wrong are results, in order,
 * and ends of poses that are not sepax_tree_next's, and lanes whose batch does not end. */
#include "analysis.h"
#include "around.h"
#include "liberty/text.h"
#include "sepax_tree_registers.h"
#include "sepax_tree.h"

#include <err.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LANES = GATES_LANES, OPEN = 32, BEAT = 16, MOST_MEMORIES = 256 };
enum { BASE = 0x100000 }; /* address of the external memory */

static const char memory_in[] = "read_data_";
static const char memory_out[] = "to_memory_";

/* A burst that is open. */
typedef struct {
  uint64_t address, beats, from; /* the first cycle of its data */
} burst;

/* What is outstanding in a lane: words of its results in order. `mask`: bits that are compared. */
typedef struct {
  struct {
    uint64_t word, mask;
    bool last;
  } * result;
  size_t count, seen;
  burst open[OPEN];
  unsigned first, bursts;
} lane_state;

typedef struct {
  around a; /* first */
  const sepax_design *design;
  uint8_t *byte; /* of the external memory */
  size_t used, space;
  channel address, data;
  const gates_port *length;
  uint64_t *data_last;
  lane_state lane[LANES];
  uint64_t now, ended, limit;
  uint64_t near, collisions, out_of_range, poses; /* of all lanes */
} engine;

/* ------------------------------------------------------------------- memories */

static const gates_port *port_of(const gates *g, const char *head, const char *name, size_t length,
                                 const char *port) {
  char full[256];
  snprintf(full, sizeof full, "%s%.*s%s", head, (int)length, name, port);
  return gates_find(g, full, 0);
}

/* synth/area/memories.jq: each memory's ports are ports of the top. */
static void find_memories(engine *e) {
  const gates *g = e->a.g;
  e->a.memory = text_alloc(MOST_MEMORIES, sizeof *e->a.memory);
  for (int k = 0; k < g->ports; k++) {
    const char *name = g->port[k].name;
    if (strncmp(name, memory_in, strlen(memory_in)) != 0) {
      continue;
    }
    name += strlen(memory_in);
    size_t length = strlen(name) - strlen("read_data");
    const gates_port *address = port_of(g, memory_out, name, length, "read_address");
    if (e->a.memories == MOST_MEMORIES) {
      errx(2, "the netlist has more than %d memories", MOST_MEMORIES);
    }
    e->a.memory[e->a.memories++] = around_memory(
        (memory){.write = &g->value[port_of(g, memory_out, name, length, "write")->net[0]],
                 .read = &g->value[port_of(g, memory_out, name, length, "read")->net[0]],
                 .write_address = port_of(g, memory_out, name, length, "write_address"),
                 .read_address = address,
                 .write_data = port_of(g, memory_out, name, length, "write_data"),
                 .read_data = &g->port[k]});
  }
  if (e->a.memories == 0) {
    errx(2, "the netlist has no memories outside; map it with synth/area/map");
  }
}

/* Space in the external memory. */
static size_t space(engine *e, size_t bytes, size_t unit) {
  size_t at = (e->used + unit - 1) / unit * unit;
  e->used = at + bytes;
  if (e->used > e->space || e->byte == NULL) {
    e->byte = realloc(e->byte, 2 * e->used + 1);
    if (e->byte == NULL) {
      text_fail("out of", "memory");
    }
    memset(e->byte + e->space, 0, 2 * e->used - e->space);
    e->space = 2 * e->used;
  }
  return at;
}

/* Data come in order, a beat a cycle, the latency after their address at the soonest. */
static void offer_data(around *a) {
  engine *e = (engine *)a;
  for (unsigned l = 0; l < LANES; l++) {
    const lane_state *s = &e->lane[l];
    const burst *b = &s->open[s->first];
    bool valid = s->bursts > 0 && b->from <= e->now;
    uint64_t bit = UINT64_C(1) << l;
    *e->data.valid = valid ? *e->data.valid | bit : *e->data.valid & ~bit;
    if (valid) {
      uint64_t half[2];
      memcpy(half, e->byte + (b->address - BASE), sizeof half);
      gates_set(a->g, e->data.word->net, 64, l, half[0]);
      gates_set(a->g, e->data.word->net + 64, 64, l, half[1]);
      *e->data_last = b->beats == 1 ? *e->data_last | bit : *e->data_last & ~bit;
    }
  }
}

static void take_address(engine *e, unsigned l) {
  lane_state *s = &e->lane[l];
  burst b = {gates_get(e->a.g, e->address.word->net, 40, l),
             gates_get(e->a.g, e->length->net, 8, l) + 1, e->now + SEPAX_TREE_LATENCY};
  bool there = b.address >= BASE && b.address - BASE + BEAT * b.beats <= e->used;
  if (!there || s->bursts == OPEN) {
    e->a.wrong++;
    b.address = BASE;
  }
  if (s->bursts < OPEN) {
    s->open[(s->first + s->bursts++) % OPEN] = b;
  }
}

static void take_data(engine *e, unsigned l) {
  lane_state *s = &e->lane[l];
  burst *b = &s->open[s->first];
  b->address += BEAT;
  if (--b->beats == 0) {
    s->first = (s->first + 1) % OPEN;
    s->bursts--;
  }
}

/* -------------------------------------------------------------------- results */

static void take_result(engine *e, unsigned l) {
  lane_state *s = &e->lane[l];
  uint64_t lane = UINT64_C(1) << l;
  uint64_t word = gates_get(e->a.g, e->a.out.word->net, 64, l);
  bool last = (*e->a.out_last & lane) != 0;
  if (s->seen == s->count) {
    e->a.wrong++;
    return;
  }
  e->a.wrong += ((word ^ s->result[s->seen].word) & s->result[s->seen].mask) != 0 ||
                last != s->result[s->seen].last;
  s->seen++;
  e->ended |= s->seen == s->count ? lane : 0;
}

/* All that happens in a cycle in which inputs have settled. */
static void take(around *a) {
  engine *e = (engine *)a;
  for (uint64_t left = *e->data.valid & *e->data.ready; left != 0; left &= left - 1) {
    take_data(e, (unsigned)__builtin_ctzll(left));
  }
  for (uint64_t left = *e->address.valid & *e->address.ready; left != 0; left &= left - 1) {
    take_address(e, (unsigned)__builtin_ctzll(left));
  }
  for (uint64_t left = *a->out.valid; left != 0; left &= left - 1) {
    take_result(e, (unsigned)__builtin_ctzll(left));
  }
  e->now++;
}

static void expect_word(lane_state *s, uint64_t word, uint64_t mask, bool last) {
  s->result = text_more(s->result, s->count, sizeof *s->result);
  s->result[s->count].word = word;
  s->result[s->count].mask = mask;
  s->result[s->count++].last = last;
}

static uint64_t both(uint64_t low, uint64_t high) { return low | high << 32; }

static void expect_pair(void *context, const sepax_tree_pair *p) {
  uint64_t flags =
      (uint64_t)p->coplanar << 56 | (uint64_t)p->out_of_range << 57 | (uint64_t)!p->collision << 58;
  expect_word(context, both(p->triangle[0], p->triangle[1]) | flags, around_all, false);
}

/* docs/reference/tree-engine.md, Results. */
static void expect_end(lane_state *s, const sepax_tree_result *r, bool more) {
  const sepax_tree_run *run = &r->run;
  bool hit = run->collisions > 0;
  uint64_t status = r->status | (more ? 0U : 64U);
  uint64_t row[2];
  for (int i = 0; i < 2; i++) {
    row[i] = run->found.leaf[i] | (uint64_t)run->found.child[i] << 23;
  }
  expect_word(s, both(run->steps, status) | UINT64_C(1) << 63, around_all, false);
  expect_word(s, both(r->job, r->pose), around_all, false);
  expect_word(s, both(0, run->near), around_all << 32, false); /* cycles are not compared */
  expect_word(s, both(run->collisions, run->warnings), around_all, false);
  expect_word(s, both(run->out_of_range, run->pairs), around_all, false);
  expect_word(s, both(run->rows, run->entries), around_all, false);
  expect_word(s, both(run->found.triangle[0], run->found.triangle[1]), hit ? around_all : 0, false);
  expect_word(s, both(row[0], row[1]), hit ? around_all : 0, true);
}

static void expect(engine *e, unsigned l, size_t list) {
  const sepax_tree_memory seen = {e->byte, BASE, e->used};
  sepax_tree_batch batch = {.design = e->design,
                            .memory = &seen,
                            .list = BASE + list,
                            .jobs = 1,
                            .each = expect_pair,
                            .context = &e->lane[l]};
  sepax_error error = {0};
  sepax_tree_result r;
  bool more;
  uint64_t cycles = 0;
  while (sepax_tree_next(&batch, &r, &more, &error) && more) {
    if ((r.status & SEPAX_TREE_NO_VERDICT) != 0) {
      errx(2, "a pose has no verdict");
    }
    expect_end(&e->lane[l], &r, batch.job < batch.jobs);
    cycles += 2 * r.run.cycles + 1000;
    e->near += r.run.near;
    e->collisions += r.run.collisions;
    e->out_of_range += r.run.out_of_range;
    e->poses++;
  }
  if (error.code != SEPAX_OK) {
    errx(2, "%s", error.text);
  }
  e->limit = cycles > e->limit ? cycles : e->limit;
}

/* ------------------------------------------------------------------------ a run */

static void put_tree(engine *e, const sepax_tree *tree, uint8_t record[SEPAX_TREE_BODY_BYTES]) {
  size_t bytes;
  const uint8_t *image = sepax_tree_image(tree, &bytes);
  size_t at = space(e, bytes, 4096);
  memcpy(e->byte + at, image, bytes);
  sepax_tree_body(tree, BASE + at, record);
}

/* Both bodies, and a job for each lane; where they are. */
static void put_jobs(engine *e, const analysis *m, size_t list[LANES]) {
  sepax_error error = {0};
  sepax_poses poses;
  sepax_scene scene = power_meshes(m);
  sepax_tree *tree[2];
  uint8_t record[2][SEPAX_TREE_BODY_BYTES];
  if (!sepax_poses_read(&poses, m->want->poses, &error)) {
    errx(2, "%s", error.text);
  }
  for (int i = 0; i < 2; i++) {
    if (!sepax_tree_new(&tree[i], scene.tri[i], scene.count[i], &scene.grid, &error)) {
      errx(2, "%s", error.text);
    }
    put_tree(e, tree[i], record[i]);
  }
  size_t each = (poses.count + LANES - 1) / LANES;
  for (unsigned l = 0; l < LANES; l++) {
    size_t at = space(e, SEPAX_TREE_POSE_STRIDE * each, SEPAX_TREE_POSE_STRIDE);
    for (size_t k = 0; k < each; k++) {
      const sepax_pose *of_b = &poses.pose[(k * LANES + l) % poses.count];
      sepax_tree_pose pose;
      if (!sepax_tree_pose_make(&pose, tree[0], NULL, tree[1], of_b, e->design->margin[1],
                                &error)) {
        errx(2, "%s", error.text);
      }
      sepax_tree_pose_pack(&pose, e->byte + at + SEPAX_TREE_POSE_STRIDE * k);
    }
    sepax_tree_job job = {.poses = BASE + at, .count = (uint32_t)each, .modes = SEPAX_TREE_COLD};
    memcpy(job.body, record, sizeof record);
    list[l] = space(e, SEPAX_TREE_JOB_BYTES, SEPAX_TREE_JOB_BYTES);
    sepax_tree_job_pack(&job, e->byte + list[l]);
  }
  space(e, 0, 4096);
  sepax_tree_free(tree[0]);
  sepax_tree_free(tree[1]);
  sepax_poses_free(&poses);
  sepax_scene_free(&scene);
}

static void run_lanes(engine *e, const size_t list[LANES]) {
  uint32_t address[LANES];
  for (unsigned l = 0; l < LANES; l++) {
    address[l] = (uint32_t)(BASE + list[l]);
  }
  around_write_each(&e->a, SEPAX_TREE_LIST_LOW, address);
  around_write(&e->a, SEPAX_TREE_LIST_HIGH, 0);
  around_write(&e->a, SEPAX_TREE_JOBS, 1);
  around_write(&e->a, SEPAX_TREE_COMMAND, SEPAX_TREE_COMMAND_START);
  for (uint64_t k = 0; k < e->limit && e->ended != around_all; k++) {
    around_tick(&e->a);
  }
  e->a.wrong += (uint64_t)__builtin_popcountll(~e->ended);
}

void power_tree(analysis *m) {
  enum { SETTLING = 8 };
  static engine it;
  engine *e = &it;
  size_t list[LANES];
  if (m->want->mesh[0] == NULL || m->want->poses == NULL) {
    errx(2, "a tree engine wants two meshes and poses; give -m POSES -r RESOLUTION A.stl B.stl");
  }
  *e = (engine){.a = {.g = &m->g, .offer = offer_data, .take = take}, .design = &m->design};
  put_jobs(e, m, list);
  for (unsigned l = 0; l < LANES; l++) {
    expect(e, l, list[l]);
  }
  find_memories(e);
  e->address = around_channel(e->a.g, "m_axi_ar", "addr", 40, NULL);
  e->data = around_channel(e->a.g, "m_axi_r", "data", 128, "resp");
  e->length = gates_find(e->a.g, "m_axi_arlen", 8);
  e->data_last = gates_bit(e->a.g, "m_axi_rlast");
  *e->address.ready = around_all;
  around_begin(&e->a);
  e->a.count = !m->want->idle;
  run_lanes(e, list);
  e->a.count = false;
  for (int k = 0; k < SETTLING; k++) {
    around_tick(&e->a);
  }
  e->a.count = m->want->idle;
  for (int k = 0; k < m->want->cycles && e->a.count; k++) {
    around_tick(&e->a);
  }
  m->wrong = e->a.wrong;
  if (!m->want->idle) {
    m->poses = e->poses;
    m->taken = m->judged = m->pairs = e->near;
    m->collisions = e->collisions;
    m->undecided = e->out_of_range;
  }
}
