/* SPDX-License-Identifier: MIT */
/* copies.c - finds sheets of a surface that have the same boundary, such as both sides of a face.
 *
 * Triangles that hang together without a seam are a sheet. A seam is an edge of more than two
 * triangles, or of two equal ones. Sheets with the same boundary are copies of each other, however
 * each of them is divided. A boundary counts modulo 2: what is closed stays so if two copies are
 * left out. */
#include "parts.h"
#include "surface.h"
#include "util/hash.h"
#include "util/memory.h"

#include <stdlib.h>

/* Another triangle of the same sheet, as in `surface`; the boundary of each sheet. */
typedef struct {
  uint32_t *parent;
  uint64_t *boundary; /* of a sheet's first triangle: hashes of its edges, added modulo 2 */
} sheets;

typedef struct {
  uint64_t boundary;
  uint32_t sheet;
} bounded;

/* The third vertex of a triangle at an edge; `from` if there is none. */
static uint32_t third_vertex(const surface *s, const edge_uses *at, size_t n) {
  uint32_t to = other_vertex(at->edge);
  const uint32_t *corner = s->corner[triangle_at(at->edge + n)];
  for (int k = 0; k < 3; k++) {
    if (corner[k] != at->from && corner[k] != to) {
      return corner[k];
    }
  }
  return at->from;
}

static bool is_seam(const surface *s, const edge_uses *at) {
  return at->count > 2 || (at->count == 2 && third_vertex(s, at, 0) == third_vertex(s, at, 1));
}

static void join_sheets(const surface *s, sheets *all) {
  for (uint32_t n = 0; n < s->count; n++) {
    all->parent[n] = n;
  }
  for (edge_uses at = {0, s->edge, 0}; next_edge(s, &at);) {
    if (at.count == 2 && !is_seam(s, &at)) {
      join(all->parent, triangle_at(at.edge), triangle_at(at.edge + 1));
    }
  }
}

static uint64_t hash_of(const edge_uses *at) {
  uint64_t hash = hash_add(hash_add(1, at->from), other_vertex(at->edge));
  return hash_add(hash, hash >> 29); /* sums modulo 2 need all bits mixed */
}

static void find_boundaries(const surface *s, sheets *all) {
  for (edge_uses at = {0, s->edge, 0}; next_edge(s, &at);) {
    bool seam = is_seam(s, &at);
    for (size_t n = 0; seam && n < at.count; n++) {
      all->boundary[set_of(all->parent, triangle_at(at.edge + n))] ^= hash_of(&at);
    }
  }
}

static int compare(const void *p, const void *q) {
  const bounded *a = p;
  const bounded *b = q;
  return a->boundary != b->boundary ? (a->boundary > b->boundary) - (a->boundary < b->boundary)
                                    : (a->sheet > b->sheet) - (a->sheet < b->sheet);
}

/* Mark sheets that readings leave out. Where one has no counterpart, half of them are no reading.
 * False without memory. */
static bool mark_copies(const surface *s, sheets *all) {
  bounded *list = sepax_allocate(s->count * sizeof *list);
  if (list == NULL) {
    return false;
  }
  size_t count = 0;
  for (size_t n = 0; n < s->count; n++) {
    if (all->boundary[n] != 0) {
      list[count++] = (bounded){all->boundary[n], (uint32_t)n};
    }
  }
  qsort(list, count, sizeof *list, compare);
  for (size_t first = 0; first < count;) {
    size_t copies = 1;
    while (first + copies < count && list[first + copies].boundary == list[first].boundary) {
      s->copy[list[first + copies].sheet] = SOLID_ONE | (copies % 2 != 0 ? SOLID_HALF : 0);
      copies++;
    }
    s->broken[list[first].sheet] |= copies % 2 != 0 ? SOLID_HALF : 0;
    first += copies;
  }
  sepax_release(list);
  for (uint32_t n = 0; n < s->count; n++) {
    s->copy[n] = s->copy[set_of(all->parent, n)];
  }
  return true;
}

/* List the ends of edges that have an odd number of triangles in a reading. */
static bool list_odd(const surface *s, edge_ends *ends) {
  for (edge_uses at = {0, s->edge, 0}; next_edge(s, &at);) {
    uint8_t odd = 0;
    for (size_t n = 0; n < at.count; n++) {
      odd ^= (SOLID_ONE | SOLID_HALF) & ~s->copy[triangle_at(at.edge + n)];
    }
    const edge_end end = {at.from, other_vertex(at.edge), triangle_at(at.edge), 0, odd};
    if (odd != 0 && !sepax__add_ends(ends, end)) {
      return false;
    }
  }
  return sepax__sort_ends(s, ends);
}

/* If the ends on a line do not cancel in a reading, then it is open. If they do, then their
 * triangles are one part. */
static void judge_readings(const surface *s, const edge_ends *ends) {
  for (size_t first = 0; first < ends->count;) {
    const edge_end *end = ends->end + first;
    size_t count = 0;
    unsigned odd = 0;
    unsigned any = 0;
    for (; first + count < ends->count && sepax__compare_ends(s, end, end + count) == 0; count++) {
      odd ^= end[count].odd;
      any |= end[count].odd;
    }
    for (size_t n = 0; n < count; n++) {
      s->broken[end[n].triangle] |= (uint8_t)(odd & end[n].odd);
      if (odd != any) {
        join(s->parent, end->triangle, end[n].triangle);
      }
    }
    first += count;
  }
}

bool sepax__find_copies(surface *s) {
  if (!s->crowded) {
    return true;
  }
  sheets all = {sepax_allocate(s->count * sizeof *all.parent),
                sepax__zeroed(s->count, sizeof *all.boundary)};
  edge_ends ends = {0};
  bool ok = all.parent != NULL && all.boundary != NULL;
  if (ok) {
    join_sheets(s, &all);
    find_boundaries(s, &all);
  }
  ok = ok && mark_copies(s, &all) && list_odd(s, &ends);
  if (ok) {
    judge_readings(s, &ends);
  }
  sepax_release(ends.end);
  sepax_release(all.boundary);
  sepax_release(all.parent);
  return ok;
}
