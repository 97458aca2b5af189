/* SPDX-License-Identifier: MIT */
/* divide.c - makes the binary tree: divides ranges of triangles by the surface area heuristic, with
 * cuts at multiples of 16, so that leaves are full. */
#include "tree_engine/build.h"

#include "util/list.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Ranges of up to SORTED triangles are sorted along each axis, and all cuts at multiples of 16 are
 * compared. Larger ranges use bins. */
enum { SORTED = 128 };

static float middle_of(const box4 *e, int axis) { return e->low[axis] + e->high[axis]; }

static bool is_before(const box4 *p, const box4 *q, int axis) {
  float a = middle_of(p, axis);
  float b = middle_of(q, axis);
  return a < b || (a == b && box4_number(p) < box4_number(q));
}

static void swap(box4 *p, box4 *q) {
  box4 keep = *p;
  *p = *q;
  *q = keep;
}

/* Quickselect: reorder the entries begin ... end - 1 so that those that belong before index
 * `first`, in the order along an axis, stand before it. */
static void select_first(box4 *e, uint32_t begin, uint32_t end, uint32_t first, int axis) {
  while (end - begin > 1) {
    box4 *middle = &e[begin + (end - begin) / 2];
    if (is_before(middle, &e[begin], axis)) {
      swap(middle, &e[begin]);
    }
    if (is_before(&e[end - 1], middle, axis)) {
      swap(middle, &e[end - 1]);
      if (is_before(middle, &e[begin], axis)) {
        swap(middle, &e[begin]);
      }
    }
    box4 pivot = *middle;
    uint32_t low = begin;
    uint32_t high = end - 1;
    while (low <= high) {
      while (is_before(&e[low], &pivot, axis)) {
        low++;
      }
      while (is_before(&pivot, &e[high], axis)) {
        high--;
      }
      if (low <= high) {
        swap(&e[low++], &e[high]);
        if (high-- == 0) {
          break;
        }
      }
    }
    if (first <= high) {
      end = high + 1;
    } else if (first >= low) {
      begin = low;
    } else {
      return;
    }
  }
}

static void sort(box4 *e, uint32_t begin, uint32_t end, int axis) {
  for (uint32_t n = begin + 1; n < end; n++) {
    box4 keep = e[n];
    uint32_t to = n;
    while (to > begin && is_before(&keep, &e[to - 1], axis)) {
      e[to] = e[to - 1];
      to--;
    }
    e[to] = keep;
  }
}

/* Divide a range at its best cut by bins, moved to a multiple of 16 from its beginning. Returns the
 * index of the cut. */
static uint32_t cut_by_bins(box4 *e, const range *r) {
  bins filled;
  memset(&filled, 0, sizeof filled);
  bin_scale s = scale_bins(e, r);
  cut best = {.cost = FLT_MAX, .axis = -1};
  fill_bins(&filled, e, r, &s);
  for (int axis = 0; axis < 3; axis++) {
    find_cut(&filled, &s, axis, &best);
  }
  if (best.axis < 0) {
    return r->begin + (count_of(r) / 2 + 15) / 16 * 16;
  }
  uint32_t at = partition(e, r, &s, &best);
  uint32_t last = (count_of(r) - 1) / 16;
  uint32_t blocks = (at - r->begin + 8) / 16;
  blocks = blocks < 1 ? 1 : blocks > last ? last : blocks;
  uint32_t to = r->begin + 16 * blocks;
  if (to < at) {
    select_first(e, r->begin, at, to, best.axis);
  } else if (to > at) {
    select_first(e, at, r->end, to, best.axis);
  }
  return to;
}

/* The same, but compare all cuts at multiples of 16. */
static uint32_t cut_sorted(box4 *e, const range *r) {
  uint32_t count = count_of(r);
  float least = FLT_MAX;
  uint32_t at = 16;
  box4 best[SORTED];
  memcpy(best, e + r->begin, count * sizeof *best);
  for (int axis = 0; axis < 3; axis++) {
    sort(e, r->begin, r->end, axis);
    bool better = false;
    for (uint32_t n = 16; n < count; n += 16) {
      box4 low = bounds_of(e, r->begin, r->begin + n);
      box4 high = bounds_of(e, r->begin + n, r->end);
      float cost = area(&low) * (float)n + area(&high) * (float)(count - n);
      if (cost < least) {
        least = cost;
        at = n;
        better = true;
      }
    }
    if (better) {
      memcpy(best, e + r->begin, count * sizeof *best);
    }
  }
  memcpy(e + r->begin, best, count * sizeof *best);
  return r->begin + at;
}

static uint32_t cut_half(box4 *e, const range *r) {
  uint32_t count = count_of(r);
  uint32_t to = r->begin + (count > 16 ? (count / 2 + 15) / 16 * 16 : count / 2);
  select_first(e, r->begin, r->end, to, box4_longest_axis(&r->bounds));
  return to;
}

static bool is_leaf(const tree_binary *b, const range *r) {
  uint8_t vertex[TREE_FAN_OUT][3];
  uint64_t packed[TREE_VERTICES];
  return count_of(r) <= TREE_FAN_OUT &&
         sepax__tree_distinct(b, r->begin, r->end, vertex, packed) <= TREE_VERTICES;
}

static uint32_t cut_range(box4 *e, const range *r, bool even) {
  return even || count_of(r) <= TREE_FAN_OUT ? cut_half(e, r)
         : count_of(r) <= SORTED             ? cut_sorted(e, r)
                                             : cut_by_bins(e, r);
}

static bool add(tree_binary *b, uint32_t begin, uint32_t end) {
  tree_twin *grown = list_grow(b->node, &b->capacity, b->nodes, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  b->node = grown;
  b->node[b->nodes++] = (tree_twin){{begin, end, bounds_of(b->entry, begin, end)}, 0};
  return true;
}

/* Divide depth first, so that the current range stays in the processor's caches. */
static bool divide_all(tree_binary *b, bool even) {
  uint32_t *open = NULL;
  size_t capacity = 0;
  size_t count = 0;
  uint32_t number = 0;
  bool ok = true;
  for (;;) {
    const range r = b->node[number].of;
    if (!is_leaf(b, &r)) {
      uint32_t at = cut_range(b->entry, &r, even);
      uint32_t *grown = list_grow(open, &capacity, count, sizeof *grown);
      open = grown != NULL ? grown : open;
      b->node[number].child = (uint32_t)b->nodes;
      number = (uint32_t)b->nodes;
      ok = grown != NULL && add(b, r.begin, at) && add(b, at, r.end);
      if (!ok) {
        break;
      }
      open[count++] = number + 1;
    } else if (count > 0) {
      number = open[--count];
    } else {
      break;
    }
  }
  free(open);
  return ok;
}

static corner corner_of(const sepax_vec *v) {
  return (corner){(float)v->x, (float)v->y, (float)v->z, 0};
}

bool sepax__tree_divide(tree_binary *b, const sepax_tri *tri, size_t count, bool even) {
  *b = (tree_binary){.tri = tri};
  b->entry = malloc(count * sizeof *b->entry);
  if (b->entry == NULL) {
    return false;
  }
  for (size_t n = 0; n < count; n++) {
    corner p[3] = {corner_of(&tri[n].v[0]), corner_of(&tri[n].v[1]), corner_of(&tri[n].v[2])};
    b->entry[n] = (box4){corner_least(corner_least(p[0], p[1]), p[2]),
                         corner_most(corner_most(p[0], p[1]), p[2])};
    box4_set_number(&b->entry[n], (uint32_t)n);
  }
  return add(b, 0, (uint32_t)count) && divide_all(b, even);
}

void sepax__tree_binary_free(tree_binary *b) {
  free(b->entry);
  free(b->node);
  free(b->slots);
}

static uint64_t packed_vertex(const sepax_vec *v) {
  const uint64_t low = (UINT64_C(1) << 21) - 1;
  return ((uint64_t)v->x & low) | ((uint64_t)v->y & low) << 21 | ((uint64_t)v->z & low) << 42;
}

int sepax__tree_distinct(const tree_binary *b, uint32_t begin, uint32_t end,
                         uint8_t vertex[TREE_FAN_OUT][3], uint64_t packed[TREE_VERTICES]) {
  int count = 0;
  for (uint32_t n = begin; n < end; n++) {
    const sepax_tri *t = &b->tri[box4_number(&b->entry[n])];
    for (int k = 0; k < 3; k++) {
      uint64_t p = packed_vertex(&t->v[k]);
      int at = 0;
      while (at < count && packed[at] != p) {
        at++;
      }
      if (at == count) {
        if (count == TREE_VERTICES) {
          return TREE_VERTICES + 1;
        }
        packed[count++] = p;
      }
      vertex[n - begin][k] = (uint8_t)at;
    }
  }
  return count;
}
