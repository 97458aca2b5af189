/* SPDX-License-Identifier: MIT */
/* aabb.h - axis-aligned bounding boxes (AABB) of integer triangles (private).
 *
 * Corners are int64_t, so that neither a translated triangle nor a gap overflows. */
#ifndef SEPAX_AABB_H
#define SEPAX_AABB_H

#include "sepax_grid.h"

typedef struct {
  int64_t low[3], high[3];
} aabb;

static inline int32_t vec_component(const sepax_vec *v, int axis) {
  return axis == 0 ? v->x : axis == 1 ? v->y : v->z;
}

/* The AABB of no triangle. It is disjoint from every AABB, also from another empty one, by more
 * than any margin below 2^61. */
static inline aabb aabb_of_none(void) {
  const int64_t far = INT64_C(1) << 61;
  return (aabb){{far, far, far}, {-far, -far, -far}};
}

static inline aabb aabb_of(const sepax_tri *t) {
  aabb b;
  for (int axis = 0; axis < 3; axis++) {
    int64_t p = vec_component(&t->v[0], axis);
    int64_t q = vec_component(&t->v[1], axis);
    int64_t r = vec_component(&t->v[2], axis);
    int64_t low = p < q ? p : q;
    int64_t high = p < q ? q : p;
    b.low[axis] = low < r ? low : r;
    b.high[axis] = high > r ? high : r;
  }
  return b;
}

static inline aabb aabb_translated(aabb b, const int32_t by[3]) {
  for (int axis = 0; axis < 3; axis++) {
    b.low[axis] += by[axis];
    b.high[axis] += by[axis];
  }
  return b;
}

/* Enlarge *b so that it encloses `other`, too. */
static inline void aabb_enclose(aabb *b, const aabb *other) {
  for (int axis = 0; axis < 3; axis++) {
    b->low[axis] = other->low[axis] < b->low[axis] ? other->low[axis] : b->low[axis];
    b->high[axis] = other->high[axis] > b->high[axis] ? other->high[axis] : b->high[axis];
  }
}

/* True if x, y or z has a gap above the margin. With margin 0: true if the AABBs have no common
 * point. */
static inline bool aabb_disjoint(const aabb *a, const aabb *b, int64_t margin) {
  for (int axis = 0; axis < 3; axis++) {
    if (a->low[axis] - b->high[axis] > margin || b->low[axis] - a->high[axis] > margin) {
      return true;
    }
  }
  return false;
}

static inline int64_t aabb_longest_side(const aabb *b) {
  int64_t longest = 0;
  for (int axis = 0; axis < 3; axis++) {
    int64_t side = b->high[axis] - b->low[axis];
    longest = side > longest ? side : longest;
  }
  return longest;
}

/* The axis of the thinnest side. Of equal sides z comes first, then x. */
static inline int aabb_thinnest(const aabb *b) {
  int64_t side[3];
  for (int axis = 0; axis < 3; axis++) {
    side[axis] = b->high[axis] - b->low[axis];
  }
  return side[2] <= side[0] && side[2] <= side[1] ? 2 : side[0] <= side[1] ? 0 : 1;
}

/* True if all coordinates fit `word` bits. */
static inline bool aabb_fits(const aabb *b, int word) {
  for (int axis = 0; axis < 3; axis++) {
    if (b->low[axis] < sepax_word_min(word) || b->high[axis] > sepax_word_max(word)) {
      return false;
    }
  }
  return true;
}

#endif
