/* SPDX-License-Identifier: MIT */
/* choose.c - which nodes of the binary tree become nodes with up to 16 children: the optimal
 * collapse (Wald, Benthin, Boulos 2008; Ylitie, Karras, Laine 2017), by dynamic programming from
 * the leaves to the root. */
#include "tree_engine/build.h"

#include <stdlib.h>

/* costs[k]: the least sum of areas if a node and what is below it takes up to k + 1 child slots of
 * its parent. */
typedef float costs[TREE_FAN_OUT];

/* Divide k slots between two children at the least cost. Returns the cost; *slots is the share of
 * the first child. */
static float share(const costs first, const costs second, int k, uint8_t *slots) {
  float least = FLT_MAX;
  for (int i = 1; i < k; i++) {
    float cost = first[i - 1] + second[k - i - 1];
    if (cost < least) {
      least = cost;
      *slots = (uint8_t)i;
    }
  }
  return least;
}

/* Compute slots[n]. If node n has k slots, slots[n][k] is the share of its first child; 0 means
 * that n itself takes one slot. slots[n][1] is always 0. slots[n][0] is the share if n is a node of
 * the result, which has 16 slots for its children. The children of n are computed before n. */
static void choose(const tree_binary *b, costs *cost, uint32_t n) {
  uint8_t *slots = b->slots[n];
  const tree_twin *node = &b->node[n];
  if (node->child == 0) {
    for (int k = 1; k <= TREE_FAN_OUT; k++) {
      slots[k] = 0;
      cost[n][k - 1] = 0;
    }
    return;
  }
  const float *first = cost[node->child];
  const float *second = cost[node->child + 1];
  float own = area(&node->of.bounds) + share(first, second, TREE_FAN_OUT, &slots[0]);
  float least = own;
  cost[n][0] = own;
  slots[1] = 0;
  uint8_t best = 0;
  for (int k = 2; k <= TREE_FAN_OUT; k++) {
    uint8_t split = 0;
    float c = share(first, second, k, &split);
    if (c < least) {
      least = c;
      best = split;
    }
    slots[k] = best;
    cost[n][k - 1] = least;
  }
}

/* The choice for a tree of halves: four levels become one node. */
static void choose_evenly(const tree_binary *b, uint32_t n) {
  bool leaf = b->node[n].child == 0;
  for (int k = 1; k <= TREE_FAN_OUT; k++) {
    b->slots[n][k] = (uint8_t)(leaf ? 0 : k / 2);
  }
  b->slots[n][0] = TREE_FAN_OUT / 2;
}

bool sepax__tree_choose(tree_binary *b, bool even) {
  costs *cost = malloc(b->nodes * sizeof *cost);
  b->slots = malloc(b->nodes * sizeof *b->slots);
  bool ok = cost != NULL && b->slots != NULL;
  for (size_t n = b->nodes; ok && n-- > 0;) {
    if (even) {
      choose_evenly(b, (uint32_t)n);
    } else {
      choose(b, cost, (uint32_t)n);
    }
  }
  free(cost);
  return ok;
}

static int gather(const tree_binary *b, uint32_t n, int slots, uint32_t *child) {
  int first = b->slots[n][slots];
  if (first == 0) {
    *child = n;
    return 1;
  }
  int count = gather(b, b->node[n].child, first, child);
  return count + gather(b, b->node[n].child + 1, slots - first, child + count);
}

int sepax__tree_children(const tree_binary *b, uint32_t n, uint32_t child[TREE_FAN_OUT]) {
  int first = b->slots[n][0];
  int count = gather(b, b->node[n].child, first, child);
  return count + gather(b, b->node[n].child + 1, TREE_FAN_OUT - first, child + count);
}
