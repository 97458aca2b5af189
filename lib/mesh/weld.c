/* SPDX-License-Identifier: MIT */
/* weld.c - merges vertices of a mesh that are within a length of each other. */
#include "mesh/weld.h"
#include "util/error.h"
#include "util/hash.h"
#include "util/memory.h"

#include <math.h>
#include <string.h>

/* ------------------------------------------------------------------- the vertices */

static bool same(const double p[3], const double q[3]) {
  return !weld_below(p, q) && !weld_below(q, p);
}

/* Number the vertices; equal coordinates get one number. At least half of the slots of the hash
 * table stay free. */
static bool number_vertices(welding *w, const sepax_soup *soup) {
  size_t slots = 16;
  while (slots < 6 * soup->count) {
    slots *= 2;
  }
  uint32_t *slot = sepax__zeroed(slots, sizeof *slot);
  w->vertex = sepax_allocate(3 * soup->count * sizeof *w->vertex);
  w->corner = sepax_allocate(soup->count * sizeof *w->corner);
  bool ok = slot != NULL && w->vertex != NULL && w->corner != NULL;
  for (size_t n = 0; n < 3 * soup->count && ok; n++) {
    double v[3];
    for (int i = 0; i < 3; i++) {
      v[i] = soup->facet[n / 3].v[n % 3][i] + 0.0; /* -0 becomes 0 */
    }
    size_t at = (size_t)(hash_doubles(v, 3) >> 8) & (slots - 1);
    while (slot[at] != 0 && !same(w->vertex[slot[at] - 1], v)) {
      at = (at + 1) & (slots - 1);
    }
    if (slot[at] == 0) {
      memcpy(w->vertex[w->vertices++], v, sizeof v);
      slot[at] = (uint32_t)w->vertices;
    }
    w->corner[n / 3][n % 3] = slot[at] - 1;
  }
  sepax_release(slot);
  w->count = w->capacity = soup->count;
  return ok;
}

/* ------------------------------------------------------------------- near vertices */

/* The vertices in a grid of cells, as lists. A cell is 8 times as long as the length, so for most
 * vertices only their own cell matters. */
typedef struct {
  double (*cell)[3]; /* cell of each vertex */
  uint32_t *slot;    /* the first vertex of a cell + 1 */
  uint32_t *after;   /* next vertex in the same cell + 1 */
  size_t mask;
  uint32_t *parent;
  uint64_t tests, most;
} cells;

static double cell_of(const welding *w, double x) { return floor(x / (8 * w->length)) + 0.0; }

static size_t find_cell(const cells *c, const double cell[3]) {
  size_t at = (size_t)(hash_doubles(cell, 3) >> 8) & c->mask;
  while (c->slot[at] != 0 && !same(c->cell[c->slot[at] - 1], cell)) {
    at = (at + 1) & c->mask;
  }
  return at;
}

static uint32_t root_of(uint32_t *parent, uint32_t n) {
  while (parent[n] != n) {
    parent[n] = parent[parent[n]];
    n = parent[n];
  }
  return n;
}

/* The square of (distance / length). It is the same for (q, p). */
static double square_of(const welding *w, uint32_t p, uint32_t q) {
  double sum = 0;
  for (int i = 0; i < 3; i++) {
    double d = (w->vertex[p][i] - w->vertex[q][i]) / w->length;
    sum += d * d;
  }
  return sum;
}

/* Join a vertex with those of a cell that are within the length. Of two vertices the lower is the
 * root. */
static bool join_near(const welding *w, cells *c, uint32_t v, const double cell[3]) {
  for (uint32_t n = c->slot[find_cell(c, cell)]; n != 0; n = c->after[n - 1]) {
    if (++c->tests > c->most) {
      return false;
    }
    uint32_t p = root_of(c->parent, v);
    uint32_t q = root_of(c->parent, n - 1);
    if (p != q && square_of(w, v, n - 1) <= 1) {
      bool lower = weld_below(w->vertex[p], w->vertex[q]);
      c->parent[lower ? q : p] = lower ? p : q;
    }
  }
  return true;
}

static bool join_all(const welding *w, cells *c) {
  for (uint32_t v = 0; v < w->vertices; v++) {
    double side[3][2];
    for (int i = 0; i < 3; i++) {
      side[i][0] = cell_of(w, w->vertex[v][i] - 1.001 * w->length);
      side[i][1] = cell_of(w, w->vertex[v][i] + 1.001 * w->length);
    }
    for (int k = 0; k < 8; k++) {
      bool twice = false;
      double cell[3];
      for (int i = 0; i < 3; i++) {
        cell[i] = side[i][k >> i & 1];
        twice = twice || ((k >> i & 1) != 0 && !(side[i][0] < side[i][1]));
      }
      if (!twice && !join_near(w, c, v, cell)) {
        return false;
      }
    }
  }
  return true;
}

static bool enter_cells(const welding *w, cells *c) {
  size_t slots = 16;
  while (slots < 2 * w->vertices) {
    slots *= 2;
  }
  c->mask = slots - 1;
  c->most = 1000000 + 300 * (uint64_t)w->vertices;
  c->slot = sepax__zeroed(slots, sizeof *c->slot);
  c->cell = sepax_allocate(w->vertices * sizeof *c->cell);
  c->after = sepax_allocate(w->vertices * sizeof *c->after);
  c->parent = sepax_allocate(w->vertices * sizeof *c->parent);
  if (c->slot == NULL || c->cell == NULL || c->after == NULL || c->parent == NULL) {
    return false;
  }
  for (uint32_t v = 0; v < w->vertices; v++) {
    for (int i = 0; i < 3; i++) {
      c->cell[v][i] = cell_of(w, w->vertex[v][i]);
    }
    size_t at = find_cell(c, c->cell[v]);
    c->parent[v] = v;
    c->after[v] = c->slot[at];
    c->slot[at] = v + 1;
  }
  return true;
}

/* Merge vertices within the length of each other into the least of them. */
static weld_result merge_vertices(welding *w) {
  cells c = {0};
  weld_result result = WELD_MEMORY;
  if (enter_cells(w, &c)) {
    result = join_all(w, &c) ? WELD_DONE : WELD_CROWDED;
  }
  double far = 0;
  for (uint32_t v = 0; v < w->vertices && result == WELD_DONE; v++) {
    uint32_t root = root_of(c.parent, v);
    w->said.moved += root != v;
    far = fmax(far, square_of(w, v, root));
  }
  w->said.farthest = w->length * sqrt(far);
  for (size_t n = 0; n < 3 * w->count && result == WELD_DONE; n++) {
    w->corner[n / 3][n % 3] = root_of(c.parent, w->corner[n / 3][n % 3]);
  }
  sepax_release(c.slot);
  sepax_release(c.cell);
  sepax_release(c.after);
  sepax_release(c.parent);
  return result == WELD_DONE && far > 100 ? WELD_FAR : result;
}

/* --------------------------------------------------------------------- the edges */

/* Sort a list of edges with one lower vertex by the higher vertex. The lists themselves are made by
 * counting. */
static void sort_list(weld_edge *e, size_t count) {
  for (size_t gap = count > 16 ? count / 2 : 1; gap > 0; gap /= 2) {
    for (size_t n = gap; n < count; n++) {
      weld_edge one = e[n];
      size_t at = n;
      for (; at >= gap && (e[at - gap].high > one.high ||
                           (e[at - gap].high == one.high && e[at - gap].triangle > one.triangle));
           at -= gap) {
        e[at] = e[at - gap];
      }
      e[at] = one;
    }
  }
}

weld_edge *sepax__weld_edges(const welding *w, size_t *count) {
  weld_edge *edge = sepax_allocate((3 * w->count + 1) * sizeof *edge);
  size_t *begin = sepax__zeroed(w->vertices + 1, sizeof *begin);
  if (edge == NULL || begin == NULL) {
    sepax_release(edge);
    sepax_release(begin);
    return NULL;
  }
  for (int pass = 0; pass < 2; pass++) {
    for (size_t n = 0; n < 3 * w->count; n++) {
      uint32_t p = w->corner[n / 3][n % 3];
      uint32_t q = w->corner[n / 3][(n + 1) % 3];
      uint32_t low = p < q ? p : q;
      if (p != q && pass == 0) {
        begin[low]++;
      } else if (p != q) {
        edge[--begin[low]] = (weld_edge){low, p < q ? q : p, (uint32_t)(n / 3)};
      }
    }
    size_t sum = 0;
    for (size_t v = 0; v <= w->vertices && pass == 0;
         v++) { /* begin[v] becomes the end of list v */
      sum += begin[v];
      begin[v] = sum;
    }
  }
  *count = begin[w->vertices];
  for (size_t v = 0; v < w->vertices; v++) {
    sort_list(edge + begin[v], begin[v + 1] - begin[v]);
  }
  sepax_release(begin);
  return edge;
}

/* ----------------------------------------------------------------------- the soup */

static weld_result weld(welding *w) {
  weld_result result = w->length > 0 ? merge_vertices(w) : WELD_DONE;
  result = result == WELD_DONE ? sepax__weld_leave_out(w) : result;
  return result == WELD_DONE && w->length > 0 ? sepax__weld_divide(w) : result;
}

static bool fill(sepax_soup *soup, const welding *w) {
  sepax_facet *facet = sepax_resize(soup->facet, w->count * sizeof *facet);
  if (facet == NULL) {
    return false;
  }
  for (size_t n = 0; n < 3 * w->count; n++) {
    memcpy(facet[n / 3].v[n % 3], w->vertex[w->corner[n / 3][n % 3]], sizeof facet->v[0]);
  }
  soup->facet = facet;
  soup->count = w->count;
  sepax_release(soup->normal);
  soup->normal = NULL;
  return true;
}

static bool has_area(const welding *w) {
  size_t n = 0;
  while (n < w->count && weld_no_area(w->corner[n])) {
    n++;
  }
  return n < w->count;
}

static bool coordinates_right(const sepax_soup *soup) {
  for (size_t n = 0; n < 9 * soup->count; n++) {
    if (!(fabs(soup->facet[n / 9].v[n / 3 % 3][n % 3]) <= 0x1p1000)) {
      return false;
    }
  }
  return true;
}

/* The longest side of the soup's AABB. */
static double size_of(const sepax_soup *soup) {
  double size = 0;
  for (int i = 0; i < 3; i++) {
    double low = INFINITY;
    double high = -INFINITY;
    for (size_t n = 0; n < 3 * soup->count; n++) {
      low = fmin(low, soup->facet[n / 3].v[n % 3][i]);
      high = fmax(high, soup->facet[n / 3].v[n % 3][i]);
    }
    size = fmax(size, high - low);
  }
  return size;
}

static bool fail(weld_result result, double length, sepax_error *error) {
  switch (result) {
  case WELD_CROWDED:
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "too many vertices are within %.9g of each other; weld by a shorter length",
                      length);
  case WELD_FAR:
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "vertices within %.9g of each other form a chain longer than ten times this length; weld "
        "by a shorter length",
        length);
  case WELD_FLAT:
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "no triangle with an area is left after welding by %.9g; weld by a shorter "
                      "length",
                      length);
  case WELD_MEMORY:
  case WELD_DONE:
    break;
  }
  return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory to weld a mesh");
}

bool sepax_soup_weld(sepax_soup *soup, double length, sepax_weld *said, sepax_error *error) {
  sepax_weld none = {0};
  said = said != NULL ? said : &none;
  *said = none;
  if (!(length >= 0 && length <= 0x1p1000)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "a weld length of %g is not in 0 ... 2^1000",
                      length);
  }
  if (soup->count > INT32_MAX / 3) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT, "up to %d triangles can be welded, not %zu",
                      INT32_MAX / 3, soup->count);
  }
  if (soup->count == 0 || !coordinates_right(soup)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      soup->count == 0 ? "a mesh without triangles cannot be welded"
                                       : "a coordinate is not within 2^1000");
  }
  double size = size_of(soup);
  if (length > size / 10 && length > 0) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "a weld length of %.9g is too long for a mesh whose longest side is %.9g; weld by at most "
        "a tenth of the side",
        length, size);
  }
  welding w = {.length = length, .said = {.length = length}};
  weld_result result = number_vertices(&w, soup) ? weld(&w) : WELD_MEMORY;
  if (result == WELD_DONE && length > 0 && !has_area(&w)) {
    result = WELD_FLAT;
  }
  bool ok = result == WELD_DONE && fill(soup, &w);
  sepax_release(w.vertex);
  sepax_release(w.corner);
  if (!ok) {
    return fail(result, length, error);
  }
  *said = w.said;
  return true;
}
