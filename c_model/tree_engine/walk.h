/* SPDX-License-Identifier: MIT */
/* walk.h - the formulas of the walk, one function for each module of the engine (private). The
 * functions have no state. docs/reference/tree-engine.md, Arithmetic, has formulas and widths. */
#ifndef SEPAX_TREE_WALK_H
#define SEPAX_TREE_WALK_H

#include "sepax_tree.h"
#include "tree_engine/format.h"

#include <string.h>

#if defined __SSE2__
#include <emmintrin.h>
#endif

/* The numbers that turn boxes of S into the cells of T. */
typedef struct {
  int32_t n[3][3];         /* N, 12 bits */
  int32_t low[3], high[3]; /* 21 bits */
  int shift[3];            /* -5 ... 10 */
} tree_setting;

/* A turned box in cells of T, -129 ... 128. */
typedef struct {
  int low[3], high[3];
} tree_cells;

/* The result of testing a pair. */
typedef struct {
  bool near;         /* the AABBs leave no gap above the margin */
  bool out_of_range; /* near, and a turned coordinate does not fit W bits */
  int thinnest;      /* the axis that the core gets as z, in exchange for z */
} tree_pair;

tree_setting sepax__tree_set_up(const sepax_tree_side *side, const tree_node *s,
                                const tree_node *t);
tree_cells sepax__tree_turn_box(const tree_setting *setting, const int8_t low[3],
                                const int8_t high[3]);

/* Bit j of the result: child j of T is hit. */
uint16_t sepax__tree_hits(const tree_cells *box, const tree_node *t);

void sepax__tree_turn_vertex(int32_t v[3], const sepax_tree_side *side, const int32_t p[3]);

/* Test the vertices a of A against the turned vertices b of B. margin is 0 ... 2^(W-1). */
tree_pair sepax__tree_test_pair(const int32_t a[3][3], const int32_t b[3][3], int64_t margin,
                                int word);

/* A triangle as the core gets it. */
sepax_tri sepax__tree_thin_along_z(const int32_t v[3][3], int thinnest);

/* ------------------------------------------------- sepax__tree_hits with vectors */

typedef int8_t tree_lane __attribute__((vector_size(TREE_FAN_OUT)));

/* The boxes of a node's children, one lane each. */
typedef struct {
  tree_lane low[3], high[3];
  uint16_t there; /* bit j: child j exists */
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

/* The same result as sepax__tree_hits. Cells -129 and 128 do not fit int8. A low end of 128 and a
 * high end of -129 hit nothing; a low end of -129 hits what -128 hits, and a high end of 128 hits
 * what 127 hits. */
static inline uint16_t tree_lanes_hits(const tree_lanes *t, const tree_cells *box) {
  tree_lane all = {0};
  all = ~all;
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
