/* SPDX-License-Identifier: MIT */
/* scattered.c - bodies that are spread over the addresses of one of millions of triangles. */
#include "rounds.h"
#include "tree_engine/format.h"

#include <string.h>

enum { PAGE = 4096, NODES_A_PAGE = PAGE / TREE_NODE_BYTES, TRIANGLES = 12, BEATS = 16 };

static void add(uint8_t *at, uint32_t more) { bytes_put32(at, bytes_get32(at) + more); }

uint32_t scattered_tree(const sepax_tree *tree, bool of_b, sepax_random *rng,
                        uint8_t record[SEPAX_TREE_BODY_BYTES]) {
  size_t bytes;
  const uint8_t *image = sepax_tree_image(tree, &bytes);
  uint32_t nodes = (uint32_t)sepax_tree_nodes(tree);
  uint32_t pages = (uint32_t)sepax_random_range(rng, 0, (TREE_NODES_MAX - nodes) / NODES_A_PAGE);
  uint32_t shift = pages * NODES_A_PAGE;
  size_t behind = (size_t)pages * PAGE;
  size_t at = bench_space(bytes + behind, PAGE);
  memcpy(bench_at(at), image, TREE_NODE_BYTES);
  memcpy(bench_at(at + behind + TREE_NODE_BYTES), image + TREE_NODE_BYTES, bytes - TREE_NODE_BYTES);
  sepax_tree_body(tree, bench_address(at), record);
  int64_t most = of_b ? INT64_C(1) << 24 : UINT32_MAX;
  uint32_t first = (uint32_t)sepax_random_range(rng, 0, most - bytes_get32(record + TRIANGLES));
  for (uint32_t n = 0; n < nodes; n++) {
    uint8_t *node = bench_at(at + (n > 0 ? behind : 0) + (size_t)TREE_NODE_BYTES * n);
    bool leaf = (node[14] & 15) == 0; /* the level */
    add(node + 16, leaf ? first : shift);
    if (leaf) {
      add(node + 20, (uint32_t)(behind / TREE_BEAT));
    }
  }
  add(record + 8, shift);
  add(record + TRIANGLES, first);
  add(record + BEATS, (uint32_t)(behind / TREE_BEAT));
  return shift;
}
