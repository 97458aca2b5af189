/* SPDX-License-Identifier: MIT */
/* memory.c - see memory.h. */
#include "tree_engine/memory/memory.h"

#include "emit/template.h"

void gen_tree_memory(emitter *e, bool fpga) {
  const emit_hole holes[] = {{"fpga", fpga ? "1" : "0"},
                             {"look_up", fpga ? "4" : "3"},
                             {"words", fpga ? "16" : "8"},
                             {"asked", fpga ? "asked_a_q, asked_b_q" : "asked_a, asked_b"},
                             {NULL, NULL}};
  static const char *const modules[] = {
      "sepax_ram_fifo",  "sepax_tags",         "sepax_cache",    "sepax_node_cache",
      "sepax_leaf_fill", "sepax_leaf_buffers", "sepax_axi_read", "sepax_tree_memory"};
  for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
    emit_template(e, modules[i], holes);
  }
}

void gen_tree_ram(emitter *e, bool fpga) {
  const emit_hole holes[] = {{"fpga", "0"}, {"distributed", fpga ? "1" : "0"}, {NULL, NULL}};
  emit_template(e, "sepax_ram", holes);
}
