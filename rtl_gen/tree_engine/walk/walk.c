/* SPDX-License-Identifier: MIT */
/* walk.c - see walk.h. */
#include "tree_engine/walk/walk.h"

#include "aabb/aabb.h"
#include "emit/template.h"

void gen_tree_walk(emitter *e, bool fpga, int turn) {
  static const char *const modules[] = {"sepax_tree_stack", "sepax_node_check", "sepax_tree_walk",
                                        "sepax_turned_box", "sepax_pair_test",  "sepax_tree_rows",
                                        "sepax_tree_pairs", "sepax_tree_run"};
  emit_holes h = {0};
  emit_hole_numbers(&h, (emit_number[]){{"fpga", fpga},
                                        {"turn", turn},
                                        {"turn_last", turn - 1},
                                        {"turn_before", turn - 2},
                                        {NULL, 0}});
  emit_hole_set(&h, "triangle", fpga ? "triangle_b_q" : "triangle_b");
  emit_hole_set(&h, "of_a", fpga ? "triangle_q" : "triangle_a");
  emit_hole_set(&h, "out", "%d*FLIGHT-1:%d*FLIGHT", turn, turn - 1);
  emit_hole_set(&h, "half", fpga ? "out_half" : "half(out_mask)");
  emit_hole_set(&h, "filling", fpga ? "filling" : "(filling_q && can_pop)");
  emit_hole_set(&h, "leaves", fpga ? "release_q" : "leaf_release");
  emit_hole_set(&h, "move", fpga ? "move" : "match");
  gen_bounds(e);
  gen_thinnest(e);
  for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
    emit_template(e, modules[i], h.hole);
  }
  emit_holes_free(&h);
}
