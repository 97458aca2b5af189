/* SPDX-License-Identifier: MIT */
/* tree.h - a tree as the library holds it (private). */
#ifndef SEPAX_TREE_TREE_H
#define SEPAX_TREE_TREE_H

#include "sepax_tree.h"
#include "tree_engine/format.h"

#include <stdio.h>

struct sepax_tree {
  sepax_grid grid;
  uint8_t *image;
  size_t bytes; /* of the image */
  uint32_t nodes, triangles;
  uint32_t *number; /* for each triangle its number in the mesh */
};

static inline tree_image tree_image_of(const sepax_tree *t) {
  return (tree_image){t->image, t->nodes, t->triangles, (uint32_t)(t->bytes / TREE_BEAT)};
}

/* The place in the image, in bytes, where the records of leaves begin. */
static inline size_t tree_records_at(size_t nodes) {
  return (nodes * TREE_NODE_BYTES + TREE_PAGE - 1) / TREE_PAGE * TREE_PAGE;
}

/* Check every rule of docs/reference/tree-engine.md, Memory, on an image of any bytes: CRCs, zeros,
 * levels, that each node and each triangle has exactly one parent, and that each box holds what is
 * below it. */
bool sepax__tree_check(const sepax_tree *tree, sepax_error *error);

/* The file of a tree (docs/reference/tree-engine.md, The file): its size in bytes; write it; read a
 * file that contains nothing else. */
uint64_t sepax__tree_file_bytes(const sepax_tree *tree);
bool sepax__tree_file_write(FILE *out, const sepax_tree *tree);
bool sepax__tree_file_read(sepax_tree **tree, FILE *in, sepax_error *error);

#endif
