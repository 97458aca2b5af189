/* SPDX-License-Identifier: MIT */
/* engine.c - emits the tree engine (docs/reference/tree-engine.md): registers, jobs and results,
 * the walk, and the cores that judge near pairs. Its row in the table of generators. */
#include "engine/engine.h"
#include "tree_engine/boxes/boxes.h"
#include "tree_engine/memory/memory.h"
#include "tree_engine/registers.h"
#include "tree_engine/walk/walk.h"

static void generate(emitter *e, emit_holes *of_top, int pairs) {
  static const char *const around[] = {
      "sepax_registers",    "sepax_tree_counts", "sepax_tree_job",
      "sepax_tree_pose",    "sepax_tree_fetch",  "sepax_tree_jobs",
      "sepax_tree_results", "sepax_cores",       "host/sepax_engine"};
  const sepax_design *design = e->design;
  const sepax_config *c = &design->config;
  const delay_model *m = delay_model_of(c->target);
  const int constants[] = {(int)tree_engine_registers.identity, engine_version(),
                           c->word + (c->cores << 16) + (c->ii << 24), (int)design->margin[1]};
  emit_holes h = {0};
  (void)of_top;
  engine_cores(&h, design, pairs, 1);
  engine_decode(&tree_engine_registers, &h, constants);
  emit_hole_numbers(&h, (emit_number[]){{"tree", 1},
                                        {"fpga", m->family},
                                        {"move_is_word", 0},
                                        {"ii", c->ii},
                                        {"leaf_sets", engine_log2(c->leaves) - 2},
                                        {"rows", engine_log2(c->rows)},
                                        {"margin", design->limits > 0 ? design->margin[1] : 0},
                                        {NULL, 0}});
  emit_hole_set(&h, "data", "data_q");
  emit_hole_set(&h, "shown", m->family ? "shown_q" : "shown");
  emit_hole_set(&h, "free", m->family ? "item_free" : "item_ready");
  emit_hole_set(&h, "item", m->family ? "listed" : "item");
  emit_hole_set(&h, "plural", c->cores > 1 ? "s" : "");
  emit_hole_set(&h, "verb", c->cores > 1 ? "" : "s");
  gen_tree_ram(e, m->family);
  emit_template(e, "sepax_fifo", (emit_hole[]){{"fpga", m->family ? "1" : "0"}, {NULL, NULL}});
  gen_tree_memory(e, m->family);
  gen_tree_compare(e, m);
  int turn = gen_turn_vertex(e, m, c->word);
  gen_tree_walk(e, m->family, turn);
  emit_hole_numbers(&h, (emit_number[]){{"turn", turn},
                                        {"turn_last", turn - 1},
                                        {"end", turn - 1},
                                        {"turn_before", turn - 2},
                                        {NULL, 0}});
  emit_template(e, "sepax_tree_engine", h.hole);
  for (size_t i = 0; i < sizeof around / sizeof around[0]; i++) {
    emit_template(e, around[i], h.hole);
  }
  emit_holes_free(&h);
}

const engine_generator generator_tree = {.generate = generate, .registers = &tree_engine_registers};
