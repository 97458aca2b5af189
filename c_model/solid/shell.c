/* shell.c - is a body closed, do its triangles wind alike, what hangs together.
 *
 * Corners of equal coordinates get one number, by a hash table, in the order of the tree, so that
 * neighbours have numbers near each other. Each edge is then listed at the lower of its two
 * numbers, by counting, and these short lists are sorted. */
#include "body/body.h"
#include "util/error.h"

#include <stdlib.h>
#include <string.h>

/* Numbers fit 31 bits: with an edge's direction, 32. */
enum { MOST_TRIANGLES = INT32_MAX / 3 };

typedef struct {
  uint32_t tag, number; /* of the hash; of the vertex + 1, 0: free */
} slot;

typedef struct {
  size_t count;          /* of triangles */
  uint32_t (*corner)[3]; /* the vertices of a triangle */
  double (*vertex)[3];
  size_t vertices, capacity;
  slot *slot;
  size_t mask;      /* slots - 1 */
  uint32_t *parent; /* a vertex of the same part; of one vertex of each part, itself */
  uint32_t *begin;  /* of a vertex's list */
  uint32_t *edge;   /* 2 other vertex + 1 where the edge runs to the lower number */
} surface;

/* ---------------------------------------------------------------------- vertices */

static uint64_t hash_of(const double v[3]) {
  uint64_t word[3];
  uint64_t h = 0;
  memcpy(word, v, sizeof word);
  for (int i = 0; i < 3; i++) {
    h = (h ^ word[i]) * UINT64_C(0x9e3779b97f4a7c15);
    h ^= h >> 32;
  }
  return h * UINT64_C(0xd6e8feb86659fd93);
}

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
  double(*vertex)[3] = realloc(s->vertex, capacity * sizeof *vertex);
  if (vertex == NULL) {
    return false;
  }
  s->vertex = vertex;
  slot *slots = calloc(2 * capacity, sizeof *slots);
  if (slots == NULL) {
    return false;
  }
  for (size_t n = 0; n < s->vertices; n++) {
    enter(slots, 2 * capacity - 1, hash_of(s->vertex[n]), (uint32_t)n + 1);
  }
  free(s->slot);
  s->slot = slots;
  s->mask = 2 * capacity - 1;
  s->capacity = capacity;
  return true;
}

/* The number of the vertex with these coordinates, which may be new. */
static uint32_t number_vertex(surface *s, const double v[3]) {
  uint64_t hash = hash_of(v);
  for (size_t at = (size_t)hash & s->mask; s->slot[at].number != 0; at = (at + 1) & s->mask) {
    uint32_t number = s->slot[at].number - 1;
    if (s->slot[at].tag == (uint32_t)(hash >> 32) &&
        memcmp(s->vertex[number], v, sizeof *s->vertex) == 0) {
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

/* ------------------------------------------------------------------------- parts */

static uint32_t root(uint32_t *parent, uint32_t v) {
  while (parent[v] != v) {
    parent[v] = parent[parent[v]];
    v = parent[v];
  }
  return v;
}

/* One vertex of each part; the lowest number. */
static bool find_parts(const surface *s, sepax_shell *shell) {
  for (size_t n = 0; n < s->vertices; n++) {
    s->parent[n] = (uint32_t)n;
  }
  for (size_t n = 0; n < s->count; n++) {
    for (int k = 1; k < 3; k++) {
      uint32_t p = root(s->parent, s->corner[n][0]);
      uint32_t q = root(s->parent, s->corner[n][k]);
      s->parent[p > q ? p : q] = p > q ? q : p;
    }
  }
  for (size_t n = 0; n < s->vertices; n++) {
    shell->parts += s->parent[n] == n;
  }
  shell->part = malloc(shell->parts * sizeof *shell->part);
  if (shell->part == NULL) {
    return false;
  }
  size_t parts = 0;
  for (size_t n = 0; n < s->vertices; n++) {
    if (s->parent[n] == n) {
      memcpy(shell->part[parts++], s->vertex[n], sizeof *shell->part);
    }
  }
  return true;
}

/* ------------------------------------------------------------------------- edges */

/* Each edge that has a length at its lower vertex. */
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
        s->edge[--s->begin[down ? to : from]] = 2 * (down ? from : to) + down;
      }
    }
  }
}

static int compare(const void *p, const void *q) {
  uint32_t a = *(const uint32_t *)p;
  uint32_t b = *(const uint32_t *)q;
  return (a > b) - (a < b);
}

static void sort(uint32_t *e, size_t count) {
  if (count > 24) {
    qsort(e, count, sizeof *e, compare);
    return;
  }
  for (size_t n = 1; n < count; n++) {
    uint32_t one = e[n];
    size_t at = n;
    for (; at > 0 && e[at - 1] > one; at--) {
      e[at] = e[at - 1];
    }
    e[at] = one;
  }
}

/* A triangle that has this edge. */
static void name_edge(const surface *s, const sepax_body *body, uint32_t p, uint32_t q,
                      sepax_shell *shell) {
  memcpy(shell->edge[0], s->vertex[p], sizeof *s->vertex);
  memcpy(shell->edge[1], s->vertex[q], sizeof *s->vertex);
  for (size_t n = 0; n < s->count; n++) {
    const uint32_t *c = s->corner[n];
    if ((c[0] == p || c[1] == p || c[2] == p) && (c[0] == q || c[1] == q || c[2] == q)) {
      shell->facet = body->number[n];
      return;
    }
  }
}

static void judge_edges(const surface *s, const sepax_body *body, sepax_shell *shell) {
  for (uint32_t p = 0; p < s->vertices; p++) {
    uint32_t *e = s->edge + s->begin[p];
    size_t count = s->begin[p + 1] - s->begin[p];
    sort(e, count);
    for (size_t n = 0; n < count;) {
      uint32_t q = e[n] / 2;
      size_t first = n;
      int64_t turn = 0;
      for (; n < count && e[n] / 2 == q; n++) {
        turn += e[n] % 2 != 0 ? 1 : -1;
      }
      bool odd = (n - first) % 2 != 0;
      bool uneven = turn > 1 || turn < -1;
      if ((odd && shell->closed) || (uneven && shell->closed && shell->consistent)) {
        name_edge(s, body, p, q, shell);
      }
      shell->closed = shell->closed && !odd;
      shell->consistent = shell->consistent && !uneven;
    }
  }
}

/* --------------------------------------------------------------------- the shell */

static bool find(surface *s, const sepax_body *body, sepax_shell *shell) {
  s->capacity = 16;
  while (s->capacity < s->count / 2 + s->count / 16) {
    s->capacity *= 2;
  }
  s->mask = 2 * s->capacity - 1;
  s->corner = malloc(s->count * sizeof *s->corner);
  s->vertex = malloc(s->capacity * sizeof *s->vertex);
  s->slot = calloc(2 * s->capacity, sizeof *s->slot);
  if (s->corner == NULL || s->vertex == NULL || s->slot == NULL || !number_vertices(s, body)) {
    return false;
  }
  s->parent = malloc(s->vertices * sizeof *s->parent);
  s->begin = malloc((s->vertices + 1) * sizeof *s->begin);
  s->edge = malloc(3 * s->count * sizeof *s->edge);
  if (s->parent == NULL || s->begin == NULL || s->edge == NULL || !find_parts(s, shell)) {
    return false;
  }
  list_edges(s);
  judge_edges(s, body, shell);
  return true;
}

bool sepax_shell_find(sepax_shell *shell, const sepax_body *body, sepax_error *error) {
  *shell = (sepax_shell){.body = body, .closed = true, .consistent = true};
  if (body->count > MOST_TRIANGLES) {
    return sepax_fail(error, "a shell has up to %d triangles, not %zu", MOST_TRIANGLES,
                      body->count);
  }
  surface s = {.count = body->count};
  bool ok = find(&s, body, shell);
  free(s.corner);
  free(s.vertex);
  free(s.slot);
  free(s.parent);
  free(s.begin);
  free(s.edge);
  if (!ok) {
    sepax_shell_free(shell);
    return sepax_fail(error, "no memory for the shell of %zu triangles", body->count);
  }
  return true;
}

void sepax_shell_free(sepax_shell *shell) {
  free(shell->part);
  *shell = (sepax_shell){0};
}
