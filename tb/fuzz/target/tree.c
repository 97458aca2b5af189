/* SPDX-License-Identifier: MIT */
/* tree.c - .sxt files, of which the input has what is not padding, and whose CRCs are
 * made right first so that the checks behind them are reached; what is read can be walked. */
#include "fuzz/fuzz.h"
#include "sepax_design.h"
#include "sepax_tree.h"
#include "tree_engine/tree.h"

#include <string.h>

enum { HEADER = TREE_PAGE, HEAD = 72, NODES_MOST = 64 };

/* The header's zeros, and those behind the nodes. */
static uint8_t *pad(const uint8_t *data, size_t size, size_t *bytes) {
  const uint32_t nodes = bytes_get32(data + 48) % NODES_MOST;
  size_t packed = nodes * TREE_NODE_BYTES;
  packed = packed < size - HEAD ? packed : size - HEAD;
  const size_t padded = tree_records_at(nodes);
  *bytes = HEADER + padded + (size - HEAD - packed);
  uint8_t *file = calloc(*bytes, 1);
  REQUIRE(file != NULL);
  memcpy(file, data, HEAD);
  memcpy(file + HEADER, data + HEAD, packed);
  memcpy(file + HEADER + padded, data + HEAD + packed, size - HEAD - packed);
  return file;
}

/* The first byte says which CRCs stay as they are. */
static void mend(uint8_t *file, size_t size, unsigned keep) {
  const size_t image = size - HEADER;
  const uint32_t nodes = bytes_get32(file + 48);
  for (size_t n = 0; (keep & 1) == 0 && n < nodes && (n + 1) * TREE_NODE_BYTES <= image; n++) {
    uint8_t *node = file + HEADER + n * TREE_NODE_BYTES;
    const tree_node t = sepax__tree_unpack(node, SEPAX_TREE_WORD_MAX);
    const size_t record = (size_t)TREE_BEAT * t.record;
    if (t.level > 0 || record + TREE_RECORD_BYTES <= image) {
      bytes_put32(node + 24,
                  sepax__tree_node_crc(node, t.level > 0 ? NULL : file + HEADER + record));
    }
  }
  if ((keep & 2) == 0) {
    bytes_put32(file + 64, sepax__tree_crc(0, file + HEADER, image));
  }
  if ((keep & 4) == 0) {
    bytes_put32(file + 68, sepax__tree_crc(0, file, 68));
  }
}

static void require_walk(const sepax_tree *tree) {
  static const sepax_pose still = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  sepax_config config = sepax_config_default();
  sepax_design design;
  sepax_tree_pose pose;
  sepax_error error = {0};
  REQUIRE(sepax_config_set(&config, "word", "21", &error));
  REQUIRE(sepax_config_set(&config, "tree", "on", &error));
  REQUIRE(sepax_design_init(&design, &config, &error));
  if (sepax_tree_triangles(tree) < 1000 &&
      sepax_tree_pose_make(&pose, tree, &still, tree, &still, 0, &error)) {
    const sepax_tree_walk_options how = {.design = &design, .first = true};
    sepax_tree_run run;
    REQUIRE(sepax_tree_walk(tree, tree, &pose, &how, &run, &error));
    REQUIRE(!run.damaged && run.collisions > 0);
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  if (size <= HEAD) {
    return 0;
  }
  size_t bytes = 0;
  uint8_t *file = pad(data + 1, size - 1, &bytes);
  mend(file, bytes, data[0]);
  fuzz_file("input.sxt", file, bytes);
  free(file);
  sepax_tree *tree;
  sepax_error error = {0};
  bool ok = fuzz_answer(sepax_tree_read(&tree, "input.sxt", &error), &error);
  if (ok) {
    require_walk(tree);
    sepax_tree_free(tree);
  }
  return 0;
}
