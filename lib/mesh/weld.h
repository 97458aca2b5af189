/* SPDX-License-Identifier: MIT */
/* weld.h - the steps of welding a mesh (private). */
#ifndef SEPAX_WELD_H
#define SEPAX_WELD_H

#include "sepax.h"

typedef struct {
  double length;
  size_t count; /* number of triangles */
  uint32_t (*corner)[3];
  double (*vertex)[3]; /* all vertices differ */
  size_t vertices;
  size_t capacity; /* triangles that `corner` has space for */
  sepax_weld said;
} welding;

typedef enum { WELD_DONE, WELD_MEMORY, WELD_CROWDED, WELD_FAR, WELD_FLAT } weld_result;

/* An edge of a triangle, low < high. */
typedef struct {
  uint32_t low, high, triangle;
} weld_edge;

/* List the edges with a length, sorted by their vertices and then by triangle. NULL without memory;
 * *count may be 0. */
weld_edge *sepax__weld_edges(const welding *w, size_t *count);

/* Leave out triangles that became points and edges of others, and copies. */
weld_result sepax__weld_leave_out(welding *w);

/* Insert vertices that are near an open edge into it. */
weld_result sepax__weld_divide(welding *w);

static inline bool weld_no_area(const uint32_t c[3]) {
  return c[0] == c[1] || c[1] == c[2] || c[2] == c[0];
}

/* True if p comes before q by x, then y, then z. */
static inline bool weld_below(const double p[3], const double q[3]) {
  int i = 0;
  while (i < 2 && !(p[i] < q[i] || p[i] > q[i])) {
    i++;
  }
  return p[i] < q[i];
}

#endif
