/* SPDX-License-Identifier: MIT */
/* object.c - the test bench of an object engine; sepax_engine_tb.v is the bench without its objects
 * and results. */
#include "bench/bench.h"
#include "bench/draw.h"

#include "engine/engine.h"

#include "sepax_vectors.h"

#include <strings.h>

enum { COUNT_A = 40, COUNT_B = 36, RUNS = 2 };

typedef struct {
  const sepax_design *design;
  sepax_tri a[COUNT_A], b[COUNT_B];
  int32_t move[RUNS][3];
  sepax_object_run run[RUNS];
} objects;

/* Hard triangles, not the ones of a core's bench in pairs: each meets all of the other object. */
static void draw_objects(objects *o, const sepax_design *d) {
  sepax_random random = {2};
  const int32_t step = sepax_word_max(d->config.word) / 8 + 1;
  o->design = d;
  for (int n = 0; n < COUNT_A; n++) {
    const sepax_pair pair = bench_draw(d, n, &random);
    o->a[n] = pair.a;
    o->b[n % COUNT_B] = pair.b;
  }
  for (int k = 0; k < 3; k++) {
    o->move[1][k] = (int32_t)sepax_random_range(&random, -step, step);
  }
}

/* Triangle j of B where the run has it; false: out of the word. */
static bool moved(const objects *o, int run, size_t j, sepax_tri *b) {
  const int word = o->design->config.word;
  bool within = true;
  *b = o->b[j];
  for (int i = 0; i < 9; i++) {
    sepax_vec *v = &b->v[i / 3];
    int32_t *c = i % 3 == 0 ? &v->x : i % 3 == 1 ? &v->y : &v->z;
    const int64_t at = (int64_t)*c + o->move[run][i % 3];
    within = within && at >= sepax_word_min(word) && at <= sepax_word_max(word);
    *c = within ? (int32_t)at : 0;
  }
  return within;
}

/* A transfer of m_axis. */
static uint64_t result_of(const objects *o, int run, const size_t pair[2]) {
  enum { B_AT = 32, COPLANAR_AT = 56, RANGE_AT, WARNING_AT };
  sepax_pair judged = {.a = o->a[pair[0]]};
  const bool within = moved(o, run, pair[1], &judged.b);
  const sepax_judgement v = within ? sepax_judge(o->design, &judged) : (sepax_judgement){0};
  const bool undecided = !within || v.axis == SEPAX_AXIS_EXTENT;
  const bool warning = o->design->limits > 0 && !undecided && v.band == SEPAX_BAND_WARNING;
  return (uint64_t)pair[0] | (uint64_t)pair[1] << B_AT |
         (uint64_t)(v.coplanar && !undecided) << COPLANAR_AT | (uint64_t)undecided << RANGE_AT |
         (uint64_t)warning << WARNING_AT;
}

static void put_object(const char *name, const sepax_tri *tri, int count, emit_text *out) {
  for (int i = 0; i < 3 * count; i++) {
    const sepax_vec *v = &tri[i / 3].v[i % 3];
    text_printf(out, "    %s[%d] = 96'h%08x%08x%08x;\n", name, i, (unsigned)v->z, (unsigned)v->y,
                (unsigned)v->x);
  }
}

static void put_results(const objects *o, emit_text *out) {
  size_t n = 0;
  for (int run = 0; run < RUNS; run++) {
    const sepax_pairs *found = &o->run[run].found;
    for (size_t i = 0; i < found->count; i++) {
      text_printf(out, "    result[%zu] = 64'h%016llx;\n", n++,
                  (unsigned long long)result_of(o, run, found->pair[i]));
    }
    text_printf(out, "    result[%zu] = 64'h%016llx;\n", n++,
                (unsigned long long)(UINT64_C(1) << 63 | found->count));
  }
}

static void put_runs(const objects *o, emit_text *out) {
  for (int run = 0; run < RUNS; run++) {
    const sepax_object_run *r = &o->run[run];
    const int32_t *by = o->move[run];
    const struct {
      const char *name;
      uint64_t value;
    } count[] = {{"PAIRS", r->pairs},
                 {"CANDIDATES", r->candidates},
                 {"COLLISIONS", r->collisions},
                 {"OUT_OF_RANGE", r->out_of_range},
                 {"WARNINGS", r->found.count - r->collisions}};
    text_printf(out, "    run(32'h%08x, 32'h%08x, 32'h%08x);\n", (unsigned)by[0], (unsigned)by[1],
                (unsigned)by[2]);
    for (size_t i = 0; i < sizeof count / sizeof count[0]; i++) {
      text_printf(out, "    expect_register(\"%s\", %s, 32'd%llu);\n", count[i].name, count[i].name,
                  (unsigned long long)count[i].value);
    }
  }
}

/* The addresses of the registers, each as a hole with its name in small letters. */
static void set_addresses(emit_holes *h) {
  static const char *const names[] = {"command",    "mode",       "enable",   "pending",
                                      "move_x",     "move_y",     "move_z",   "pairs",
                                      "candidates", "collisions", "warnings", "out_of_range"};
  const engine_registers *map = generator_object.registers;
  for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
    unsigned address = 0;
    for (const engine_register *r = map->row; r < map->row + map->rows; r++) {
      if (r->kind != ENGINE_FIELD && strcasecmp(r->name, names[i]) == 0) {
        emit_hole_set(h, names[i], "%x", address);
      }
      address += r->kind != ENGINE_FIELD ? 4 : 0;
    }
  }
}

static void print(emitter *e, const objects *o, emit_text *out) {
  emit_holes h = {0};
  emit_hole_numbers(&h, (emit_number[]){{"count_a", COUNT_A},
                                        {"count_b", COUNT_B},
                                        {"results", (int64_t)(o->run[0].found.count +
                                                              o->run[1].found.count + RUNS)},
                                        {"patience", 20000 + 200 * (int64_t)e->design->config.ii},
                                        {"address_msb", 6},
                                        {NULL, 0}});
  emit_hole_set(&h, "prefix", "%s", e->prefix);
  set_addresses(&h);
  put_runs(o, emit_hole_open(&h, "runs"));
  emit_hole_close(&h);
  text_puts(out, "// sepax_engine_tb.v\n// SPDX-License-Identifier: MIT\n//\n");
  emit_origin(e, "//", out);
  text_puts(out, "//\n");
  emit_fill(e, "bench/sepax_engine_tb", h.hole, out);
  put_object("vertex_a", o->a, COUNT_A, out);
  put_object("vertex_b", o->b, COUNT_B, out);
  put_results(o, out);
  text_puts(out, "  end\nendmodule\n\n`default_nettype wire\n");
  emit_holes_free(&h);
}

void bench_write_object(emitter *e, emit_text *out) {
  objects o = {.design = NULL};
  bool ok = true;
  draw_objects(&o, e->design);
  for (int run = 0; run < RUNS && ok; run++) {
    ok = sepax_object_engine(e->design, o.a, COUNT_A, o.b, COUNT_B, o.move[run], &o.run[run],
                             &e->error);
  }
  if (ok) {
    print(e, &o, out);
  }
  for (int run = 0; run < RUNS; run++) {
    sepax_pairs_free(&o.run[run].found);
  }
}
