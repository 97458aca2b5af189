/* SPDX-License-Identifier: MIT */
/* engine.c - the object engine (docs/reference/object-engine.md): two memories of triangles,
 * comparator lanes to which a pair enumerator leads all pairs, and the cores behind them. Its row
 * in the table of generators.
 */
#include "aabb/aabb.h"
#include "engine/engine.h"
#include "object_engine/registers.h"

/* Without second passes all axes are alike. */
static bool swaps_axes(const sepax_design *design) {
  return !design->config.flag && design->limits == 0;
}

static void set_sizes(emit_holes *h, const sepax_design *design) {
  const sepax_config *c = &design->config;
  int index_a = engine_log2(c->memory_a);
  int index_b = engine_log2(c->memory_b);
  bool a_is_smaller = index_a < index_b;
  bool fpga = c->target != SEPAX_TARGET_ASIC;
  emit_hole_set(h, "swaps", "%d", swaps_axes(design));
  emit_hole_set(h, "fpga", "%d", fpga);
  emit_hole_set(h, "distributed", "0");
  emit_hole_set(h, "staged", "%d", fpga && c->lanes > 1);
  emit_hole_set(h, "in", fpga ? "_in_q" : "");
  emit_hole_set(h, "after", fpga ? "_q" : "");
  emit_hole_set(h, "counted", fpga ? "_q" : "");
  emit_hole_set(h, "held", fpga ? "_q" : "");
  emit_hole_set(h, "last", fpga ? "last_q" : "tlast");
  emit_hole_set(h, "dest", fpga ? "to_b_q" : "tdest");
  emit_hole_set(h, "written", fpga ? "three" : "two");
  emit_hole_set(h, "ended", fpga ? "two cycles before" : "in the cycle before");
  emit_hole_set(h, "undecided", fpga ? "outside_q" : "undecided");
  emit_hole_set(h, "coplanar", fpga ? "coplanar_q" : "coplanar && !undecided");
  emit_hole_set(h, "at", fpga ? "_in" : "");
  emit_hole_set(h, "late", "%d", fpga ? 8 : 6);
  emit_hole_set(h, "late_q", fpga ? "_q3" : "_q2");
  emit_hole_set(h, "told", fpga ? "later" : "at once");
  emit_hole_set(h, "moved", "%d", c->word + 2);
  emit_hole_set(h, "narrow", "%d", c->word < 32);
  emit_hole_set(h, "move_is_word", "%d", c->word + 1 >= 32);
  emit_hole_set(h, "data", c->word + 1 > 32 ? "{data_q[31], data_q}" : "data_q[%d:0]", c->word);
  emit_hole_set(h, "margin", "%lld", (long long)(design->limits > 0 ? design->margin[1] : 0));
  emit_hole_set(h, "lanes", "%d", c->lanes);
  emit_hole_set(h, "fill", "%d", c->lanes + 8);
  emit_hole_set(h, "lane_bits", "%d", engine_log2(c->lanes));
  emit_hole_set(h, "round", "%d", c->lanes & (c->memory_a - 1));
  emit_hole_set(h, "memory_a", "%d", c->memory_a);
  emit_hole_set(h, "memory_b", "%d", c->memory_b);
  emit_hole_set(h, "index_a", "%d", index_a);
  emit_hole_set(h, "index_b", "%d", index_b);
  emit_hole_set(h, "index", "%d", a_is_smaller ? index_b : index_a);
  emit_hole_set(h, "smaller", "%d", a_is_smaller ? index_a : index_b < index_a ? index_b : 0);
  emit_hole_set(h, "not_smaller", a_is_smaller ? "to_b" : "!to_b");
  emit_hole_set(h, "plural", c->cores > 1 ? "s" : "");
  emit_hole_set(h, "each_cycle", "%d", c->ii == 1 || c->cores > 1);
}

/* What can be read of the design itself: its constant registers. */
static void set_registers(emit_holes *h, const sepax_config *c) {
  const int constants[] = {(int)object_engine_registers.identity, engine_version(),
                           c->word + (c->lanes << 8) + (c->cores << 16) + (c->ii << 24),
                           engine_log2(c->memory_a) + (engine_log2(c->memory_b) << 8)};
  engine_decode(&object_engine_registers, h, constants);
  emit_hole_set(h, "tree", "0");
}

static void generate(emitter *e, emit_holes *of_top, int pairs) {
  static const char *const modules[] = {"sepax_fifo",
                                        "sepax_ram",
                                        "sepax_registers",
                                        "sepax_load",
                                        "sepax_enumerator",
                                        "sepax_comparator",
                                        "sepax_comparators",
                                        "sepax_priority",
                                        "sepax_fetch",
                                        "sepax_cores",
                                        "sepax_results",
                                        "sepax_engine_logic",
                                        "object_engine/sepax_engine"};
  emit_holes h = {0};
  const sepax_config *c = &e->design->config;
  (void)of_top;
  set_sizes(&h, e->design);
  engine_cores(&h, e->design, pairs, engine_log2(c->memory_a) + engine_log2(c->memory_b) + 1);
  set_registers(&h, &e->design->config);
  if (c->target == SEPAX_TARGET_ASIC) {
    gen_bounds(e);
    gen_disjoint(e);
  }
  if (swaps_axes(e->design)) {
    gen_thinnest(e);
  }
  for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
    emit_template(e, modules[i], h.hole);
  }
  emit_holes_free(&h);
}

/* A queue that is read, and what is counted and compared of its output. */
static double delay(const delay_model *m, int word) { return m->engine + delay_adder(m, word); }

const engine_generator generator_object = {
    .generate = generate, .registers = &object_engine_registers, .delay = delay};
