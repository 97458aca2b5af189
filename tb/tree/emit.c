/* emit.c - the Verilog of the tree engine's modules, for its test benches: emit FOLDER, or of the
 * memory side alone: emit FOLDER memory. */
#include "emit/gen.h"
#include "emit/template.h"
#include "tree/modules.h"

#include <stdio.h>
#include <string.h>

int main(int argc, char **argv) {
  emitter e;
  bool memory = argc == 3 && strcmp(argv[2], "memory") == 0;
  if (argc != 2 && !memory) {
    fprintf(stderr, "emit: give a folder\n");
    return 2;
  }
  emit_init(&e, NULL, "tb/tree/emit");
  emit_template(&e, "sepax_ram", NULL);
  gen_tree_memory(&e);
  if (!memory) {
    emit_template(&e, "sepax_bounds", (emit_hole[]){{"word", "18"}, {NULL, NULL}});
    gen_tree_walk(&e);
  }
  sepax_error error = e.error;
  bool ok = error.text[0] == '\0' && gen_write(&e, argv[1], &error);
  emit_free(&e);
  if (!ok) {
    fprintf(stderr, "emit: %s\n", error.text);
  }
  return ok ? 0 : 1;
}
