/* SPDX-License-Identifier: MIT */
/* shell.c - is a body closed, do its triangles wind alike, what hangs together by edges.
 *
 * Edges are summed as segments in space: of a closed body, every point of every edge is in an even
 * number of triangles' edges. Edges of an even number of triangles add nothing. The others cancel
 * iff at every vertex, and on every line through it, an even number of them ends: on each line they
 * then are a cycle, and a line has none but zero. So a vertex in the middle of another triangle's
 * edge opens nothing. Signed, the sum tells whether the triangles wind alike.
 *
 * Corners of equal coordinates get one number, by a hash table, in the order of the tree, so that
 * neighbours have numbers near each other. Each edge is then listed at the lower of its two
 * numbers, by counting, and these short lists are sorted. */
#include "body/body.h"
#include "body/orient.h"
#include "parts.h"
#include "util/hash.h"
#include "util/memory.h"
#include "util/error.h"
#include "util/list.h"

#include <stdlib.h>
#include <string.h>

/* Numbers fit 31 bits: with an edge's direction, 32. */
enum { MOST_TRIANGLES = INT32_MAX / 3 };

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
  size_t count;          /* number of triangles */
  uint32_t (*corner)[3]; /* the vertices of a triangle */
  double (*vertex)[3];
  size_t vertices, capacity;
  slot *slot;
  size_t mask;     /* slots - 1 */
  uint32_t *begin; /* begin of each vertex's list */
  uint64_t *edge;  /* high half: 2 * other vertex, + 1 if the edge runs to the lower number; low
                      half: the triangle */
  bool *turned;    /* marks one triangle at each edge that is not consistent */
  bool *open;      /* marks one triangle at each open edge */
  uint8_t *copy;   /* the readings that leave out the triangle */
  uint8_t *broken; /* the readings in which an edge of the triangle is open */
  edge_end *odd;
  size_t odds, odd_capacity;
  uint32_t *parent; /* another triangle of the same part; the first of a part has itself */
} surface;

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
    for (int k = 0; k < 3; k++) {
      uint32_t from = s->corner[n][k];
      uint32_t to = s->corner[n][(k + 1) % 3];
      if (from != to) {
        bool down = from > to;
        uint64_t other = down ? from : to;
        s->edge[--s->begin[down ? to : from]] = (2 * other + down) << 32 | n;
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

/* Judge an edge, or several on one line, by their sums. An open edge is named rather than a turned
 * one. */
static void judge_sum(const surface *s, bool odd, int64_t turn, const edge_end *first,
                      sepax_shell *shell) {
  bool uneven = turn > 1 || turn < -1;
  if ((odd && shell->closed) || (uneven && shell->closed && shell->consistent)) {
    memcpy(shell->edge[0], s->vertex[first->at], sizeof *s->vertex);
    memcpy(shell->edge[1], s->vertex[first->other], sizeof *s->vertex);
    shell->facet = shell->body->number[first->triangle];
  }
  s->turned[first->triangle] |= uneven;
  s->open[first->triangle] |= odd;
  shell->closed = shell->closed && !odd;
  shell->consistent = shell->consistent && !uneven;
}

/* Triangles that are compared with each other at one edge. */
enum { MOST_COPIES = 64 };

static uint32_t third_vertex(const surface *s, uint32_t triangle, uint32_t p, uint32_t q) {
  for (int k = 0; k < 3; k++) {
    uint32_t v = s->corner[triangle][k];
    if (v != p && v != q) {
      return v;
    }
  }
  return p; /* it has no area */
}

/* Mark equal triangles that a reading of the part leaves out, and an edge that is open in it. Each
 * triangle is looked at where its two lowest vertices are. */
static void find_copies(const surface *s, const uint64_t *edge, size_t count, uint32_t p) {
  uint32_t q = (uint32_t)(edge[0] >> 33);
  uint32_t third[MOST_COPIES];
  size_t left[2] = {0};
  bool halves = true;
  if (count > MOST_COPIES) {
    s->broken[(uint32_t)edge[0]] |= SOLID_ONE | SOLID_HALF;
    return;
  }
  for (size_t n = 0; n < count; n++) {
    third[n] = third_vertex(s, (uint32_t)edge[n], p, q);
  }
  for (size_t n = 0; n < count; n++) {
    size_t before = 0;
    size_t equal = 0;
    if (third[n] == p) {
      continue; /* it has the edge twice */
    }
    for (size_t k = 0; k < count; k++) {
      equal += third[k] == third[n];
      before += k < n && third[k] == third[n];
    }
    halves = halves && equal % 2 == 0;
    left[0] += before == 0;
    left[1] += before % 2 == 0;
    if (third[n] > q) {
      s->copy[(uint32_t)edge[n]] =
          (before > 0 ? SOLID_ONE : 0) | (before % 2 != 0 ? SOLID_HALF : 0);
    }
  }
  s->broken[(uint32_t)edge[0]] |=
      (left[0] % 2 != 0 ? SOLID_ONE : 0) | (!halves || left[1] % 2 != 0 ? SOLID_HALF : 0);
}

/* Judge the triangles at one edge with the vertices p and edge[...] >> 33. */
static bool judge_edge(surface *s, const uint64_t *edge, size_t count, uint32_t p,
                       sepax_shell *shell) {
  int64_t turn = 0;
  for (size_t n = 0; n < count; n++) {
    turn += (edge[n] >> 32 & 1) != 0 ? 1 : -1;
    join(s->parent, (uint32_t)edge[0], (uint32_t)edge[n]);
  }
  find_copies(s, edge, count, p);
  edge_end end = {p, (uint32_t)(edge[0] >> 33), (uint32_t)edge[0], -(int32_t)turn};
  if (count % 2 == 0) {
    judge_sum(s, false, turn, &end, shell);
    return true;
  }
  for (int k = 0; k < 2; k++) {
    edge_end *grown = list_grow(s->odd, &s->odd_capacity, s->odds, sizeof *grown);
    if (grown == NULL) {
      return false;
    }
    s->odd = grown;
    s->odd[s->odds++] = end;
    end = (edge_end){end.other, end.at, end.triangle, -end.away};
  }
  return true;
}

static bool judge_edges(surface *s, sepax_shell *shell) {
  for (size_t n = 0; n < s->count; n++) {
    s->parent[n] = (uint32_t)n;
  }
  for (uint32_t p = 0; p < s->vertices; p++) {
    uint64_t *e = s->edge + s->begin[p];
    size_t count = s->begin[p + 1] - s->begin[p];
    sort(e, count);
    for (size_t first = 0; first < count;) {
      size_t end = first + 1;
      while (end < count && e[end] >> 33 == e[first] >> 33) {
        end++;
      }
      if (!judge_edge(s, e + first, end - first, p, shell)) {
        return false;
      }
      first = end;
    }
  }
  return true;
}

/* --------------------------------------------------------- edges of an odd number */

/* The order of the lines through p and q, p and r, around p: exactly 0 for the same line. A line's
 * direction is taken with its first coordinate that is not 0 positive. */
static int compare_lines(const double p[3], const double q[3], const double r[3]) {
  const double *end[2] = {q, r};
  int first[2];
  bool back[2];
  for (int k = 0; k < 2; k++) {
    first[k] = 0;
    while (first[k] < 2 && !(end[k][first[k]] < p[first[k]] || end[k][first[k]] > p[first[k]])) {
      first[k]++;
    }
    back[k] = end[k][first[k]] < p[first[k]];
  }
  int order = first[1] - first[0];
  for (int i = first[0] + 1; i < 3 && order == 0; i++) {
    const double at[2] = {p[first[0]], p[i]};
    const double to_q[2] = {q[first[0]], q[i]};
    const double to_r[2] = {r[first[0]], r[i]};
    order = sepax__orient2d(at, to_q, to_r);
    order = back[0] != back[1] ? -order : order;
  }
  return order;
}

/* Order ends by their vertices, and at each vertex by lines. */
static int compare_ends(const surface *s, const edge_end *p, const edge_end *q) {
  if (p->at != q->at) {
    return p->at < q->at ? -1 : 1;
  }
  return compare_lines(s->vertex[p->at], s->vertex[p->other], s->vertex[q->other]);
}

/* Sort by merging; `scratch` has space for half of the ends. */
static void sort_ends(const surface *s, edge_end *end, edge_end *scratch, size_t count) {
  if (count < 2) {
    return;
  }
  size_t half = count / 2;
  sort_ends(s, end, scratch, half);
  sort_ends(s, end + half, scratch, count - half);
  memcpy(scratch, end, half * sizeof *end);
  size_t p = 0;
  size_t q = half;
  for (size_t n = 0; p < half; n++) {
    bool lower = q == count || compare_ends(s, &scratch[p], &end[q]) <= 0;
    end[n] = lower ? scratch[p++] : end[q++];
  }
}

/* If the ends on a line do not cancel, then an edge is open. Otherwise their triangles are one
 * part. */
static bool judge_ends(const surface *s, sepax_shell *shell) {
  if (s->odds == 0) {
    return true;
  }
  edge_end *scratch = sepax_allocate(s->odds / 2 * sizeof *scratch);
  if (scratch == NULL) {
    return false;
  }
  sort_ends(s, s->odd, scratch, s->odds);
  sepax_release(scratch);
  for (size_t first = 0; first < s->odds;) {
    size_t end = first;
    int64_t away = 0;
    for (; end < s->odds && compare_ends(s, &s->odd[first], &s->odd[end]) == 0; end++) {
      away += s->odd[end].away;
      join(s->parent, s->odd[first].triangle, s->odd[end].triangle);
    }
    judge_sum(s, (end - first) % 2 != 0, away, &s->odd[first], shell);
    first = end;
  }
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
  s->turned = sepax__zeroed(s->count, sizeof *s->turned);
  s->open = sepax__zeroed(s->count, sizeof *s->open);
  s->broken = sepax__zeroed(s->count, sizeof *s->broken);
  s->copy = sepax__zeroed(s->count, sizeof *s->copy);
  s->begin = sepax_allocate((s->vertices + 1) * sizeof *s->begin);
  s->edge = sepax_allocate(3 * s->count * sizeof *s->edge);
  if (s->parent == NULL || s->turned == NULL || s->open == NULL || s->broken == NULL ||
      s->copy == NULL || s->begin == NULL || s->edge == NULL) {
    return false;
  }
  list_edges(s);
  return judge_edges(s, shell) && judge_ends(s, shell) &&
         sepax__find_parts(shell, s->parent, s->turned, s->open, s->broken, &s->copy);
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
  sepax_release(s.broken);
  sepax_release(s.copy);
  sepax_release(s.begin);
  sepax_release(s.edge);
  sepax_release(s.odd);
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
