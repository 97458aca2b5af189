/* build.h - a binary tree of ranges of triangles, and which of its nodes a tree of fan-out 16 keeps
 * (private). */
#ifndef SEPAX_TREE_BUILD_H
#define SEPAX_TREE_BUILD_H

#include "tree_engine/format.h"
#include "util/bins.h"

/* A node of the binary tree. Its children, of a leaf none, are at child and child + 1. */
typedef struct {
  range of;
  uint32_t child;
} tree_twin;

/* The binary tree; node[0] is the root, children are behind their parents. Leaves are ranges of up
 * to 16 triangles and 28 vertices. */
typedef struct {
  const sepax_tri *tri;
  box4 *entry; /* of each triangle, in the tree's order */
  tree_twin *node;
  size_t nodes, capacity;
  uint8_t (*slots)[TREE_FAN_OUT + 1]; /* of each node, by sepax__tree_choose */
} tree_binary;

/* Divide the triangles; into halves if `even`, else by the surface area heuristic. False without
 * memory; free with sepax__tree_binary_free. */
bool sepax__tree_divide(tree_binary *binary, const sepax_tri *tri, size_t count, bool even);
void sepax__tree_binary_free(tree_binary *binary);

/* Choose the children of all nodes of fan-out 16, so that the areas of their boxes have the least
 * sum; if `even`, four levels below. False without memory. */
bool sepax__tree_choose(tree_binary *binary, bool even);

/* The chosen children of a node that is no leaf, in order; how many they are. */
int sepax__tree_children(const tree_binary *binary, uint32_t node, uint32_t child[TREE_FAN_OUT]);

/* The numbers of different vertices of the triangles begin ... end - 1 in vertex[triangle][k], and
 * the vertices packed as in a record; more than TREE_VERTICES if they do not fit. */
int sepax__tree_distinct(const tree_binary *binary, uint32_t begin, uint32_t end,
                         uint8_t vertex[TREE_FAN_OUT][3], uint64_t packed[TREE_VERTICES]);

#endif
