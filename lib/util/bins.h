/* SPDX-License-Identifier: MIT */
/* bins.h - ranges of AABBs, and the cut of a range by the surface area heuristic, from bins of the
 * boxes' middles (private). */
#ifndef SEPAX_BINS_H
#define SEPAX_BINS_H

#include "util/box.h"

/* Ranges of up to SHORT triangles have half as many bins. */
enum { BINS = 16, SHORT = 64 };

/* Entries are the AABBs of triangles with their numbers. Those of a range follow each other; their
 * places in the tree's order are begin ... end - 1. */
typedef struct {
  uint32_t begin, end;
  box4 bounds;
} range;

static inline uint32_t count_of(const range *r) { return r->end - r->begin; }

static inline float area(const box4 *b) {
  corner size = b->high - b->low;
  return size[0] * (size[1] + size[2]) + size[1] * size[2];
}

static inline box4 bounds_of(const box4 *e, uint32_t begin, uint32_t end) {
  box4 all = box4_of_none();
  for (uint32_t n = begin; n < end; n++) {
    box4_enclose(&all, &e[n]);
  }
  return all;
}

/* The middles of a range's boxes, times 2: bin (position - low) * per_bin of an axis. */
typedef struct {
  corner low, per_bin;
  bool is_short;
} bin_scale;

typedef struct {
  box4 bounds[3][BINS];
  uint32_t count[3][BINS];
} bins;

/* A cut: entries in bins below `at` of an axis. axis < 0: no cut is better than another. */
typedef struct {
  float cost;
  int axis, at;
  box4 first, second;
} cut;

static inline int bin_count(const bin_scale *s) { return s->is_short ? BINS / 2 : BINS; }

static inline bin_scale scale_bins(const box4 *e, const range *r) {
  box4 middles = box4_of_none();
  for (uint32_t n = r->begin; n < r->end; n++) {
    corner middle = e[n].low + e[n].high;
    middles.low = corner_least(middles.low, middle);
    middles.high = corner_most(middles.high, middle);
  }
  bin_scale s = {.low = middles.low, .is_short = count_of(r) <= SHORT};
  for (int i = 0; i < 3; i++) {
    float side = middles.high[i] - middles.low[i];
    s.per_bin[i] = side > 0 ? 0.9999F * (float)bin_count(&s) / side : 0;
  }
  return s;
}

static inline corner_bits bins_of(const box4 *b, const bin_scale *s) {
  return __builtin_convertvector((b->low + b->high - s->low) * s->per_bin, corner_bits);
}

static inline void fill_bins(bins *to, const box4 *e, const range *r, const bin_scale *s) {
  for (int k = 0; k < bin_count(s); k++) {
    for (int axis = 0; axis < 3; axis++) {
      to->bounds[axis][k] = box4_of_none();
      to->count[axis][k] = 0;
    }
  }
  for (uint32_t n = r->begin; n < r->end; n++) {
    corner_bits k = bins_of(&e[n], s);
    for (int axis = 0; axis < 3; axis++) {
      box4_enclose(&to->bounds[axis][k[axis]], &e[n]);
      to->count[axis][k[axis]]++;
    }
  }
}

/* Find the cheapest cut along one axis, by area times count on both sides, and keep it if it is
 * better. */
static inline void find_cut(const bins *in, const bin_scale *s, int axis, cut *best) {
  const int most = bin_count(s);
  box4 after[BINS];
  float cost_after[BINS] = {0};
  box4 all = box4_of_none();
  uint32_t count = 0;
  for (int k = most - 1; k > 0; k--) {
    box4_enclose(&all, &in->bounds[axis][k]);
    count += in->count[axis][k];
    after[k] = all;
    cost_after[k] = count > 0 ? area(&all) * (float)count : FLT_MAX;
  }
  all = box4_of_none();
  count = 0;
  for (int k = 1; k < most; k++) {
    box4_enclose(&all, &in->bounds[axis][k - 1]);
    count += in->count[axis][k - 1];
    float cost = count > 0 ? area(&all) * (float)count + cost_after[k] : FLT_MAX;
    if (cost < best->cost) {
      *best = (cut){cost, axis, k, all, after[k]};
    }
  }
}

/* Move the entries below the cut to the front. Returns where the others begin. */
static inline uint32_t partition(box4 *e, const range *r, const bin_scale *s, const cut *c) {
  uint32_t first = r->begin;
  for (uint32_t n = r->begin; n < r->end; n++) {
    box4 keep = e[n];
    e[n] = e[first];
    e[first] = keep;
    first += bins_of(&keep, s)[c->axis] < c->at;
  }
  return first;
}

#endif
