/* memory.c - the tree engine's way to external memory. */
#include "modules.h"
#include "emit/template.h"

void gen_tree_memory(emitter *e) {
  static const char *const modules[] = {
      "sepax_ram_fifo",  "sepax_tags",         "sepax_cache",    "sepax_node_cache",
      "sepax_leaf_fill", "sepax_leaf_buffers", "sepax_axi_read", "sepax_tree_memory"};
  for (size_t i = 0; i < sizeof modules / sizeof modules[0]; i++) {
    emit_template(e, modules[i], NULL);
  }
}
