/* SPDX-License-Identifier: MIT */
/* build.h - how a tree is made: first a binary tree of ranges of triangles, then the choice of its
 * nodes that become nodes with up to 16 children (private). */
#ifndef SEPAX_TREE_BUILD_H
#define SEPAX_TREE_BUILD_H

#include "tree_engine/format.h"
#include "util/bins.h"

/* A node of the binary tree. Its children are the nodes child and child + 1; child is 0 in a leaf.
 */
typedef struct {
  range of;
  uint32_t child;
} tree_twin;

/* The binary tree. node[0] is the root, and children have higher numbers than their parents. A leaf
 * is a range of up to 16 triangles and 28 different vertices. */
typedef struct {
  const sepax_tri *tri;
  box4 *entry; /* box and number of each triangle, in the tree's order */
  tree_twin *node;
  size_t nodes, capacity;
  uint8_t (*slots)[TREE_FAN_OUT + 1]; /* the choice for each node, made by sepax__tree_choose */
} tree_binary;

/* Make the binary tree: by halves if `even`, otherwise by the surface area heuristic. Coordinates
 * have at most 21 bits, so they are exact in single precision. False without memory. Free with
 * sepax__tree_binary_free, also after a failure. */
bool sepax__tree_divide(tree_binary *binary, const sepax_tri *tri, size_t count, bool even);
void sepax__tree_binary_free(tree_binary *binary);

/* Choose the up to 16 children of each node, so that the areas of all chosen boxes have the least
 * sum; if `even`, the children are the nodes four levels below. False without memory. */
bool sepax__tree_choose(tree_binary *binary, bool even);

/* Write the chosen children of a node that is not a leaf, in order, and return their number. */
int sepax__tree_children(const tree_binary *binary, uint32_t node, uint32_t child[TREE_FAN_OUT]);

/* Number the different vertices of the entries begin ... end - 1, at most 16 of them. Writes the
 * number of vertex k of each triangle to vertex[triangle][k], and the vertices to packed[] as in a
 * leaf's record. Returns how many vertices there are; TREE_VERTICES + 1 if they do not fit. */
int sepax__tree_distinct(const tree_binary *binary, uint32_t begin, uint32_t end,
                         uint8_t vertex[TREE_FAN_OUT][3], uint64_t packed[TREE_VERTICES]);

#endif
