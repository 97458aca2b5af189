/* SPDX-License-Identifier: MIT */
/* emit.c - the Verilog of the tree engine's modules, for its test benches: emit FOLDER [PART [W]],
 * PART memory, compare or walk; without it all, W 18. */
#include "arith/arith.h"
#include "emit/template.h"
#include "files/output.h"
#include "tree_engine/boxes/boxes.h"
#include "tree_engine/memory/memory.h"
#include "tree_engine/walk/walk.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int main(int argc, char **argv) {
  emitter e;
  const char *part = argc > 2 ? argv[2] : "all";
  int word = argc > 3 ? atoi(argv[3]) : 18;
  bool all = strcmp(part, "all") == 0;
  bool walk = all || strcmp(part, "walk") == 0;
  bool memory = walk || strcmp(part, "memory") == 0;
  bool compare = all || strcmp(part, "compare") == 0;
  if (argc < 2 || !(memory || compare) || word < 4 || word > 21) {
    fprintf(stderr, "emit: give a folder, and maybe memory, compare or walk, and 4 ... 21\n");
    return 2;
  }
  emit_init(&e, NULL, "tb/tree_engine/modules/emit");
  if (memory) {
    gen_tree_ram(&e, false);
    gen_tree_memory(&e, false);
  }
  if (compare) {
    emit_template(&e, "sepax_fifo", (emit_hole[]){{"fpga", "0"}, {NULL}});
    gen_multiplier_parts(&e, false);
    gen_turn_vertex(&e, delay_model_of(SEPAX_TARGET_ASIC), word);
    gen_tree_compare(&e, delay_model_of(SEPAX_TARGET_ASIC));
  }
  if (walk) {
    static const char *const of_boxes[] = {"sepax_bounds", "sepax_thinnest", "sepax_swap_axes"};
    for (int k = 0; k < 3; k++) {
      emit_template(&e, of_boxes[k], (emit_hole[]){{"word", "18"}, {NULL, NULL}});
    }
    gen_tree_walk(&e, false, 3);
  }
  sepax_error error = e.error;
  bool ok = emit_works(&e) && gen_write(&e, argv[1], &(sepax_output){NULL}, NULL, &error);
  emit_free(&e);
  if (!ok) {
    fprintf(stderr, "emit: %s\n", error.text);
  }
  return ok ? 0 : 1;
}
