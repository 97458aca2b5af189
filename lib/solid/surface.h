/* SPDX-License-Identifier: MIT */
/* surface.h - a body's vertices, edges and parts while its shell is found (private). */
#ifndef SEPAX_SURFACE_H
#define SEPAX_SURFACE_H

#include "sepax.h"

typedef struct {
  uint32_t tag, number; /* tag of the hash; number of the vertex + 1, 0: free */
} slot;

/* An end of an edge of an odd number of triangles. */
typedef struct {
  uint32_t at, other; /* vertices */
  uint32_t triangle;
  int32_t away; /* how many more triangles run from `at` to `other` than back */
} edge_end;

typedef struct {
  edge_end *end;
  size_t count, capacity;
} edge_ends;

typedef struct {
  size_t count;          /* number of triangles */
  uint32_t (*corner)[3]; /* the vertices of a triangle */
  double (*vertex)[3];
  size_t vertices, capacity;
  slot *slot;
  size_t mask;      /* slots - 1 */
  uint32_t *begin;  /* begin of each vertex's list; begin[vertices]: the end of the last one */
  uint64_t *edge;   /* high half: 2 * other vertex, + 1 if the edge runs to the lower number; low
                       half: the triangle */
  bool *turned;     /* marks one triangle at each edge that is not consistent */
  bool *open;       /* marks one triangle at each open edge */
  bool crowded;     /* an edge has more than two triangles with three corners */
  uint32_t *times;  /* of each triangle: how often its sheet is there, 0: not known, SOLID_MEMBER:
                       that does not matter; NULL: once */
  uint64_t *word;   /* of each triangle, see sheets.h; NULL if no sheets were needed */
  bool *tangled;    /* its closed surfaces are too many to be found */
  uint32_t *parent; /* another triangle of the same part; the first of a part has itself */
} surface;

/* Triangles at one edge, which begins at its lower vertex. */
typedef struct {
  uint32_t from;
  const uint64_t *edge; /* as in `surface` */
  size_t count;
} edge_uses;

static inline uint32_t other_vertex(const uint64_t *edge) { return (uint32_t)(*edge >> 33); }
static inline bool runs_down(const uint64_t *edge) { return (*edge >> 32 & 1) != 0; }
static inline uint32_t triangle_at(const uint64_t *edge) { return (uint32_t)*edge; }

/* The next edge, of sorted lists; {0, s->edge, 0} comes before the first one. False at the end. */
static inline bool next_edge(const surface *s, edge_uses *at) {
  const uint64_t *first = at->edge + at->count;
  while (at->from < s->vertices && first == s->edge + s->begin[at->from + 1]) {
    at->from++;
  }
  if (at->from == s->vertices) {
    return false;
  }
  const uint64_t *end = s->edge + s->begin[at->from + 1];
  at->edge = first;
  for (at->count = 1; first + at->count < end; at->count++) {
    if (other_vertex(first + at->count) != other_vertex(first)) {
      break;
    }
  }
  return true;
}

/* The third vertex of a triangle at an edge; `from` if there is none. */
static inline uint32_t third_vertex(const surface *s, const edge_uses *at, size_t n) {
  uint32_t to = other_vertex(at->edge);
  const uint32_t *corner = s->corner[triangle_at(at->edge + n)];
  for (int k = 0; k < 3; k++) {
    if (corner[k] != at->from && corner[k] != to) {
      return corner[k];
    }
  }
  return at->from;
}

/* Add both ends of an edge. `end` is the one at its lower vertex. False without memory. */
bool sepax__add_ends(edge_ends *ends, edge_end end);

/* Order ends by their vertices, and at each vertex by lines. compare_ends is exactly 0 for ends at
 * one vertex and on one line. sort_ends returns false without memory. */
int sepax__compare_ends(const surface *s, const edge_end *p, const edge_end *q);
bool sepax__sort_ends(const surface *s, edge_ends *ends);

/* Fill in `times`, `word` and `tangled` of a surface whose edges are judged, if it needs them, and
 * join parts that are closed together. False without memory. */
bool sepax__find_copies(surface *s, const sepax_body *body);

#endif
