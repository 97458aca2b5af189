/* SPDX-License-Identifier: MIT */
/* binding.c - operations to units and slots. */
#include "binding.h"

/* Place of operation n in its kind's order: a rotated class begins with its member 1. */
static int place_of(const graph_kind *k, int n) {
  bool rotated = (k->rotated >> n / 3 & 1) != 0;
  return n / 3 * 3 + (n % 3 + (rotated ? 2 : 0)) % 3;
}

void binding_make(graph *g, int ii) {
  for (int i = 0; i < g->kinds; i++) {
    graph_kind *k = &g->kind[i];
    for (int n = 0; n < k->operations; n++) {
      graph_node *node = &g->node[k->operation[n]];
      const graph_node *beside = &g->node[node->beside];
      node->unit = node->beside > 0 ? beside->unit : place_of(k, n) / ii;
      node->slot = node->beside > 0 ? beside->slot : place_of(k, n) % ii;
      if (node->unit >= GRAPH_UNITS || k->at[node->unit][node->slot] != 0) {
        graph_fault(g, "two operations in one slot");
        return;
      }
      k->at[node->unit][node->slot] = k->operation[n];
      k->count[node->unit]++;
      k->units = node->unit >= k->units ? node->unit + 1 : k->units;
    }
  }
}
