/* lanes.h - the 16 boxes of a node side by side, compared at once: tree_hits, faster (private). */
#ifndef SEPAX_TREE_LANES_H
#define SEPAX_TREE_LANES_H

#include "tree/walk.h"

#include <string.h>

#if defined __SSE2__
#include <emmintrin.h>
#endif

typedef int8_t tree_lane __attribute__((vector_size(TREE_FAN_OUT)));

typedef struct {
  tree_lane low[3], high[3];
  uint16_t there; /* children */
} tree_lanes;

static inline tree_lanes tree_lanes_of(const tree_node *n) {
  int8_t low[3][TREE_FAN_OUT];
  int8_t high[3][TREE_FAN_OUT];
  tree_lanes lanes;
  for (int j = 0; j < TREE_FAN_OUT; j++) {
    for (int i = 0; i < 3; i++) {
      low[i][j] = n->low[j][i];
      high[i][j] = n->high[j][i];
    }
  }
  memcpy(lanes.low, low, sizeof low);
  memcpy(lanes.high, high, sizeof high);
  lanes.there = (uint16_t)((1U << n->children) - 1);
  return lanes;
}

static inline uint16_t tree_lanes_mask(tree_lane v) {
#if defined __SSE2__
  return (uint16_t)_mm_movemask_epi8((__m128i)v);
#else
  unsigned mask = 0;
  for (int j = 0; j < TREE_FAN_OUT; j++) {
    mask |= (unsigned)(v[j] < 0) << j;
  }
  return (uint16_t)mask;
#endif
}

/* Cells -129 and 128 are beyond int8: a low end of 128 and a high end of -129 hit nothing, other
 * ends are like -128 and 127. */
static inline uint16_t tree_lanes_hits(const tree_lanes *t, const tree_cells *box) {
  tree_lane all = (tree_lane){0} == 0;
  for (int i = 0; i < 3; i++) {
    if (box->low[i] > INT8_MAX || box->high[i] < INT8_MIN) {
      return 0;
    }
    int8_t low = (int8_t)(box->low[i] < INT8_MIN ? INT8_MIN : box->low[i]);
    int8_t high = (int8_t)(box->high[i] > INT8_MAX ? INT8_MAX : box->high[i]);
    all &= (tree_lane)(t->high[i] >= low) & (tree_lane)(t->low[i] <= high);
  }
  return tree_lanes_mask(all) & t->there;
}

#endif
