/* SPDX-License-Identifier: MIT */
/* shell.c - is a body closed, do its triangles wind alike, what hangs together by edges and sheets.
 *
 * Edges are summed as segments in space: of a closed body, every point of every edge is in an even
 * number of triangles' edges. So a vertex in the middle of another triangle's edge opens nothing.
 * Signed, the sum tells whether the triangles wind alike. lines.c judges both.
 *
 * Corners of equal coordinates get one number, by a hash table, in the order of the tree, so that
 * neighbours have numbers near each other. Each edge is then listed at the lower of its two
 * numbers, by counting, and these short lists are sorted.
 *
 * Two triangles are neighbours if each closed surface that the triangles can form has the same
 * factor of both: they alone have an edge and run along it in opposite directions, or lines.c says
 * so. What hangs together by neighbours is a sheet. */
#include "body/body.h"
#include "parts.h"
#include "surface.h"
#include "util/error.h"
#include "util/hash.h"
#include "util/memory.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Numbers fit 31 bits: with an edge's direction, 32. */
enum { MOST_TRIANGLES = INT32_MAX / 3 };

/* ---------------------------------------------------------------------- vertices */

static void enter(slot *slots, size_t mask, uint64_t hash, uint32_t number) {
  size_t at = (size_t)hash & mask;
  while (slots[at].number != 0) {
    at = (at + 1) & mask;
  }
  slots[at] = (slot){(uint32_t)(hash >> 32), number};
}

/* Memory for another vertex; half of the slots at least stay free. */
static bool reserve_vertex(surface *s) {
  if (s->vertices < s->capacity) {
    return true;
  }
  size_t capacity = 2 * s->capacity;
  double(*vertex)[3] = sepax_resize(s->vertex, capacity * sizeof *vertex);
  if (vertex == NULL) {
    return false;
  }
  s->vertex = vertex;
  slot *slots = sepax__zeroed(2 * capacity, sizeof *slots);
  if (slots == NULL) {
    return false;
  }
  for (size_t n = 0; n < s->vertices; n++) {
    enter(slots, 2 * capacity - 1, hash_doubles(s->vertex[n], 3), (uint32_t)n + 1);
  }
  sepax_release(s->slot);
  s->slot = slots;
  s->mask = 2 * capacity - 1;
  s->capacity = capacity;
  return true;
}

static bool same_point(const double p[3], const double q[3]) {
  bool differ = false;
  for (int i = 0; i < 3; i++) {
    differ = differ || p[i] < q[i] || p[i] > q[i];
  }
  return !differ;
}

/* The number of the vertex with these coordinates, which may be new. */
static uint32_t number_vertex(surface *s, const double v[3]) {
  uint64_t hash = hash_doubles(v, 3);
  for (size_t at = (size_t)hash & s->mask; s->slot[at].number != 0; at = (at + 1) & s->mask) {
    uint32_t number = s->slot[at].number - 1;
    if (s->slot[at].tag == (uint32_t)(hash >> 32) && same_point(s->vertex[number], v)) {
      return number;
    }
  }
  uint32_t number = (uint32_t)s->vertices++;
  memcpy(s->vertex[number], v, sizeof *s->vertex);
  enter(s->slot, s->mask, hash, number + 1);
  return number;
}

static bool number_vertices(surface *s, const sepax_body *body) {
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 0; k < 3; k++) {
      double v[3];
      for (int i = 0; i < 3; i++) {
        v[i] = body->triangle[n][k][i] + 0.0; /* -0 becomes 0 */
      }
      if (!reserve_vertex(s)) {
        return false;
      }
      s->corner[n][k] = number_vertex(s, v);
    }
  }
  return true;
}

/* ------------------------------------------------------------------------- edges */

/* Is the triangle without area? Each product is wrong by less than 4 u of its size, u = 2^-53, or
 * by what underflows. */
static bool is_flat_triangle(const surface *s, const uint32_t corner[3]) {
  const double *p = s->vertex[corner[0]];
  double v[2][3];
  for (int k = 0; k < 6; k++) {
    v[k / 3][k % 3] = s->vertex[corner[k / 3 + 1]][k % 3] - p[k % 3];
  }
  for (int i = 0; i < 3; i++) {
    const double left = v[0][i] * v[1][(i + 1) % 3];
    const double right = v[0][(i + 1) % 3] * v[1][i];
    if (fabs(left - right) > 8 * 0x1p-53 * (fabs(left) + fabs(right)) + 0x1p-1000) {
      return false;
    }
  }
  return corner[0] == corner[1] || corner[1] == corner[2] || corner[2] == corner[0] ||
         sepax__on_line(p, s->vertex[corner[1]], s->vertex[corner[2]]);
}

/* List each edge with a length at its lower vertex. */
static void list_edges(const surface *s) {
  memset(s->begin, 0, (s->vertices + 1) * sizeof *s->begin);
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 0; k < 3; k++) {
      uint32_t from = s->corner[n][k];
      uint32_t to = s->corner[n][(k + 1) % 3];
      if (from != to) {
        s->begin[from < to ? from : to]++;
      }
    }
  }
  uint32_t sum = 0;
  for (size_t n = 0; n <= s->vertices; n++) { /* the ends of the lists, which then fill downwards */
    sum += s->begin[n];
    s->begin[n] = sum;
  }
  for (size_t n = 0; n < s->count; n++) {
    const uint64_t use = n | (is_flat_triangle(s, s->corner[n]) ? EDGE_FLAT : 0);
    for (int k = 0; k < 3; k++) {
      uint32_t from = s->corner[n][k];
      uint32_t to = s->corner[n][(k + 1) % 3];
      if (from != to) {
        bool down = from > to;
        uint64_t other = down ? from : to;
        s->edge[--s->begin[down ? to : from]] = (2 * other + down) << 32 | use;
      }
    }
  }
}

static int compare(const void *p, const void *q) {
  uint64_t a = *(const uint64_t *)p;
  uint64_t b = *(const uint64_t *)q;
  return (a > b) - (a < b);
}

static void sort(uint64_t *e, size_t count) {
  if (count > 24) {
    qsort(e, count, sizeof *e, compare);
    return;
  }
  for (size_t n = 1; n < count; n++) {
    uint64_t one = e[n];
    size_t at = n;
    for (; at > 0 && e[at - 1] > one; at--) {
      e[at] = e[at - 1];
    }
    e[at] = one;
  }
}

/* Join triangles at edges to parts, and neighbours to sheets. */
static void join_triangles(const surface *s) {
  for (edge_uses at = {0, s->edge, 0}; next_edge(s, &at);) {
    for (size_t n = 1; n < at.count; n++) {
      join(s->parent, triangle_at(at.edge), triangle_at(at.edge + n));
    }
    const edge_sum sum = sum_edge(&at);
    const bool flows = s->walked != NULL && s->walked[at.edge - s->edge] == EDGE_FLOWS;
    if (!flows && sum.triangles == 2 && sum.turn == 0) {
      join(s->sheet, sum.two[0], sum.two[1]);
    }
  }
}

static bool judge_edges(surface *s, sepax_shell *shell) {
  for (size_t n = 0; n < s->count; n++) {
    s->parent[n] = s->sheet[n] = (uint32_t)n;
  }
  for (uint32_t p = 0; p < s->vertices; p++) {
    sort(s->edge + s->begin[p], s->begin[p + 1] - s->begin[p]);
  }
  if (!sepax__judge_lines(s, shell)) {
    return false;
  }
  join_triangles(s);
  return true;
}

/* --------------------------------------------------------------------- the shell */

static bool find(surface *s, const sepax_body *body, sepax_shell *shell) {
  s->capacity = 16;
  while (s->capacity < s->count / 2 + s->count / 16) {
    s->capacity *= 2;
  }
  s->mask = 2 * s->capacity - 1;
  s->corner = sepax_allocate(s->count * sizeof *s->corner);
  s->vertex = sepax_allocate(s->capacity * sizeof *s->vertex);
  s->slot = sepax__zeroed(2 * s->capacity, sizeof *s->slot);
  if (s->corner == NULL || s->vertex == NULL || s->slot == NULL || !number_vertices(s, body)) {
    return false;
  }
  s->parent = sepax_allocate(s->count * sizeof *s->parent);
  s->sheet = sepax_allocate(s->count * sizeof *s->sheet);
  s->turned = sepax__zeroed(s->count, sizeof *s->turned);
  s->open = sepax__zeroed(s->count, sizeof *s->open);
  s->begin = sepax_allocate((s->vertices + 1) * sizeof *s->begin);
  s->edge = sepax_allocate(3 * s->count * sizeof *s->edge);
  if (s->parent == NULL || s->sheet == NULL || s->turned == NULL || s->open == NULL ||
      s->begin == NULL || s->edge == NULL) {
    return false;
  }
  list_edges(s);
  return judge_edges(s, shell) && sepax__find_parts(shell, s);
}

bool sepax_shell_find(sepax_shell *shell, const sepax_body *body, sepax_error *error) {
  *shell = (sepax_shell){0};
  if (body->count > MOST_TRIANGLES) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT, "a shell has up to %d triangles, not %zu",
                      MOST_TRIANGLES, body->count);
  }
  *shell = (sepax_shell){.body = body, .closed = true, .consistent = true};
  surface s = {.count = body->count};
  bool ok = find(&s, body, shell);
  sepax_release(s.corner);
  sepax_release(s.vertex);
  sepax_release(s.slot);
  sepax_release(s.parent);
  sepax_release(s.turned);
  sepax_release(s.open);
  sepax_release(s.sheet);
  sepax_release(s.walked);
  sepax_release(s.entangled);
  sepax_release(s.begin);
  sepax_release(s.edge);
  if (!ok) {
    sepax_shell_free(shell);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the shell of %zu triangles",
                      body->count);
  }
  return true;
}

void sepax_shell_free(sepax_shell *shell) {
  sepax__free_parts(shell->own);
  *shell = (sepax_shell){0};
}
