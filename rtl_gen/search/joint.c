/* joint.c - the tree engine: the walk, the pairs of its rows, its runs. */
#include "aabb/aabb.h"
#include "emit/template.h"
#include "tree/modules.h"

void gen_tree_walk(emitter *e) {
  static const char *const modules[] = {"sepax_tree_stack", "sepax_node_check", "sepax_tree_walk",
                                        "sepax_turned_box", "sepax_pair_test",  "sepax_tree_rows",
                                        "sepax_tree_pairs", "sepax_tree_run"};
  gen_bounds(e);
  gen_thinnest(e);
  for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
    emit_template(e, modules[i], NULL);
  }
}
