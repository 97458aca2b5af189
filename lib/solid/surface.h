/* SPDX-License-Identifier: MIT */
/* surface.h - a body's vertices, edges, parts and sheets while its shell is found (private). */
#ifndef SEPAX_SURFACE_H
#define SEPAX_SURFACE_H

#include "sepax.h"

typedef struct {
  uint32_t tag, number; /* tag of the hash; number of the vertex + 1, 0: free */
} slot;

typedef struct {
  size_t count;          /* number of triangles */
  uint32_t (*corner)[3]; /* the vertices of a triangle */
  double (*vertex)[3];
  size_t vertices, capacity;
  slot *slot;
  size_t mask;         /* slots - 1 */
  uint32_t *begin;     /* begin of each vertex's list; begin[vertices]: the end of the last one */
  uint64_t *edge;      /* high half: 2 * other vertex, + 1 if the edge runs to the lower number; low
                          half: the triangle, and EDGE_FLAT */
  bool *turned;        /* marks one triangle at each edge that is not consistent */
  bool *open;          /* marks one triangle at each open edge */
  uint32_t *parent;    /* another triangle of the same part; the first of a part has itself */
  uint32_t *sheet;     /* another triangle of the same sheet likewise */
  uint8_t *walked;     /* at the first use of each edge; NULL: 0 for all of them */
  uint32_t *entangled; /* another triangle at edges that overlap likewise; NULL: none do */
} surface;

/* Flag of a use of an edge: the triangle's corners are on one line. */
#define EDGE_FLAT UINT32_C(0x80000000)

/* What `walked` says of an edge: lines.c has walked along its line; and the factors of its
 * triangles need not have the sum 0. */
enum { EDGE_WALKED = 1, EDGE_FLOWS };

/* Triangles at one edge, which begins at its lower vertex. */
typedef struct {
  uint32_t from;
  const uint64_t *edge; /* as in `surface` */
  size_t count;
} edge_uses;

/* What an edge bounds. A flat triangle bounds nothing: its edges cancel on their line. */
typedef struct {
  size_t triangles; /* that are not flat */
  uint32_t two[2];  /* the first and, if there are two or more, the last of them */
  int32_t turn;     /* how many more of them run from the lower to the higher vertex than back */
} edge_sum;

static inline uint32_t other_vertex(const uint64_t *edge) { return (uint32_t)(*edge >> 33); }
static inline bool runs_down(const uint64_t *edge) { return (*edge >> 32 & 1) != 0; }
static inline uint32_t triangle_at(const uint64_t *edge) { return (uint32_t)*edge & ~EDGE_FLAT; }
static inline bool is_flat(const uint64_t *edge) { return (*edge & EDGE_FLAT) != 0; }

/* The edge whose uses, which are sorted, begin at `edge` in the list of vertex `from`. */
static inline edge_uses edge_at(const surface *s, uint32_t from, const uint64_t *edge) {
  edge_uses at = {from, edge, 1};
  const uint64_t *end = s->edge + s->begin[from + 1];
  while (edge + at.count < end && other_vertex(edge + at.count) == other_vertex(edge)) {
    at.count++;
  }
  return at;
}

/* The next edge; {0, s->edge, 0} comes before the first one. False at the end. */
static inline bool next_edge(const surface *s, edge_uses *at) {
  const uint64_t *first = at->edge + at->count;
  while (at->from < s->vertices && first == s->edge + s->begin[at->from + 1]) {
    at->from++;
  }
  if (at->from == s->vertices) {
    return false;
  }
  *at = edge_at(s, at->from, first);
  return true;
}

static inline edge_sum sum_edge(const edge_uses *at) {
  edge_sum sum = {0};
  for (size_t n = 0; n < at->count; n++) {
    if (!is_flat(at->edge + n)) {
      sum.two[sum.triangles++ > 0] = triangle_at(at->edge + n);
      sum.turn += runs_down(at->edge + n) ? -1 : 1;
    }
  }
  return sum;
}

/* Judge the edges of a surface on their lines: fill in what is open and turned, there and in the
 * shell; join triangles at such edges to parts; and where edges overlap, fill in `walked` and
 * `entangled` and join sheets. False without memory. */
bool sepax__judge_lines(surface *s, sepax_shell *shell);

/* Are three points on one line? Exact. */
bool sepax__on_line(const double p[3], const double q[3], const double r[3]);

#endif
