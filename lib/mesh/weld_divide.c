/* SPDX-License-Identifier: MIT */
/* weld_divide.c - inserts vertices of a welded mesh into open edges near them.
 *
 * Only the ends of open edges can close an open edge. So only these are searched, by a tree that
 * halves them along their longest side. */
#include "mesh/weld.h"
#include "util/list.h"
#include "util/memory.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

enum { LEAF = 8 };

/* A vertex to insert into an edge. */
typedef struct {
  uint32_t vertex;
  double at; /* place along the edge, 0 ... 1 */
} insertion;

typedef struct {
  welding *w;
  uint32_t *point;     /* the ends of open edges, in the order of the tree */
  double (*box)[2][3]; /* box of each node; the children of node n are 2 n + 1 and 2 n + 2 */
  size_t points;
  insertion *in; /* insertions into the current edge */
  size_t ins, in_capacity;
  uint32_t low, high; /* ends of the current edge */
} search;

/* ----------------------------------------------------------------------- the tree */

static void find_box(const search *s, size_t from, size_t to, double box[2][3]) {
  for (int i = 0; i < 3; i++) {
    box[0][i] = INFINITY;
    box[1][i] = -INFINITY;
    for (size_t n = from; n < to; n++) {
      double x = s->w->vertex[s->point[n]][i];
      box[0][i] = fmin(box[0][i], x);
      box[1][i] = fmax(box[1][i], x);
    }
  }
}

/* Move the points with the lower coordinates before `middle`. */
static void halve(search *s, size_t begin, size_t end, size_t middle, int axis) {
  ptrdiff_t low = (ptrdiff_t)begin;
  ptrdiff_t high = (ptrdiff_t)end - 1;
  while (low < high) {
    double pivot = s->w->vertex[s->point[low + (high - low) / 2]][axis];
    ptrdiff_t p = low;
    ptrdiff_t q = high;
    while (p <= q) {
      while (s->w->vertex[s->point[p]][axis] < pivot) {
        p++;
      }
      while (s->w->vertex[s->point[q]][axis] > pivot) {
        q--;
      }
      if (p <= q) {
        uint32_t one = s->point[p];
        s->point[p++] = s->point[q];
        s->point[q--] = one;
      }
    }
    if ((ptrdiff_t)middle <= q) {
      high = q;
    } else if ((ptrdiff_t)middle >= p) {
      low = p;
    } else {
      return;
    }
  }
}

static void build(search *s, size_t node, size_t from, size_t to) {
  double(*box)[3] = s->box[node];
  find_box(s, from, to, box);
  if (to - from <= LEAF) {
    return;
  }
  int axis = 0;
  for (int i = 1; i < 3; i++) {
    axis = box[1][i] - box[0][i] > box[1][axis] - box[0][axis] ? i : axis;
  }
  size_t middle = from + (to - from) / 2;
  halve(s, from, to, middle, axis);
  build(s, 2 * node + 1, from, middle);
  build(s, 2 * node + 2, middle, to);
}

/* --------------------------------------------------------------- near an open edge */

/* True if the segment comes within the length of the box, or a little farther. */
static bool near_box(const search *s, const double box[2][3]) {
  const double *p = s->w->vertex[s->low];
  const double *q = s->w->vertex[s->high];
  double from = 0;
  double to = 1;
  for (int i = 0; i < 3; i++) {
    double slack = s->w->length * 1.001 + 0x1p-48 * (fabs(p[i]) + fabs(q[i]));
    double low = box[0][i] - slack;
    double high = box[1][i] + slack;
    double way = q[i] - p[i];
    if (fmax(p[i], q[i]) < low || fmin(p[i], q[i]) > high) {
      return false;
    }
    if (fabs(way) > slack) {
      double a = (low - p[i]) / way;
      double b = (high - p[i]) / way;
      from = fmax(from, fmin(a, b));
      to = fmin(to, fmax(a, b));
    }
  }
  return from <= to + 0x1p-40;
}

/* True if the vertex is within the length of the inside of the edge; *at is its place along the
 * edge. */
static bool is_near(const search *s, uint32_t vertex, double *at) {
  const double *v = s->w->vertex[vertex];
  const double *p = s->w->vertex[s->low];
  const double *q = s->w->vertex[s->high];
  double size = 0;
  for (int i = 0; i < 3; i++) {
    size = fmax(size, fabs(q[i] - p[i]));
  }
  double square = 0;
  double along = 0;
  for (int i = 0; i < 3; i++) {
    double way = (q[i] - p[i]) / size;
    square += way * way;
    along += way * ((v[i] - p[i]) / size);
  }
  *at = along / square;
  if (!(*at > 0 && *at < 1)) {
    return false;
  }
  double aside = 0;
  for (int i = 0; i < 3; i++) {
    double d = (v[i] - p[i] - *at * (q[i] - p[i])) / s->w->length;
    aside += d * d;
  }
  return aside <= 1;
}

static bool take(search *s, uint32_t vertex) {
  insertion one = {.vertex = vertex};
  if (vertex == s->low || vertex == s->high || !is_near(s, vertex, &one.at)) {
    return true;
  }
  insertion *grown = list_grow(s->in, &s->in_capacity, s->ins, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  s->in = grown;
  size_t n = s->ins++; /* sorted along the edge, and by coordinates at equal places */
  for (; n > 0 && (grown[n - 1].at > one.at ||
                   (!(grown[n - 1].at < one.at) &&
                    weld_below(s->w->vertex[vertex], s->w->vertex[grown[n - 1].vertex])));
       n--) {
    grown[n] = grown[n - 1];
  }
  grown[n] = one;
  return true;
}

static bool look(search *s, size_t node, size_t from, size_t to) {
  if (from == to || !near_box(s, (const double(*)[3])s->box[node])) {
    return true;
  }
  if (to - from <= LEAF) {
    for (size_t n = from; n < to; n++) {
      if (!take(s, s->point[n])) {
        return false;
      }
    }
    return true;
  }
  size_t middle = from + (to - from) / 2;
  return look(s, 2 * node + 1, from, middle) && look(s, 2 * node + 2, middle, to);
}

/* ---------------------------------------------------------------------- dividing */

/* The corner of a triangle at which an edge begins; 3 if it does not have the edge. */
static int side_of(const uint32_t c[3], uint32_t p, uint32_t q) {
  int k = 0;
  while (k < 3 && !((c[k] == p && c[(k + 1) % 3] == q) || (c[k] == q && c[(k + 1) % 3] == p))) {
    k++;
  }
  return k;
}

/* Divide a triangle at its side k into a fan around the opposite corner. A corner of the triangle
 * is inserted into none of its sides. */
static bool divide_side(search *s, size_t triangle, int k, bool *divided) {
  welding *w = s->w;
  uint32_t c[3];
  memcpy(c, w->corner[triangle], sizeof c);
  uint32_t across = c[(k + 2) % 3];
  uint32_t at = c[k];
  size_t place = triangle;
  for (size_t n = 0; n <= s->ins; n++) {
    uint32_t next = n == s->ins      ? c[(k + 1) % 3]
                    : c[k] == s->low ? s->in[n].vertex
                                     : s->in[s->ins - 1 - n].vertex;
    if (next == across) {
      continue;
    }
    uint32_t(*grown)[3] = list_grow(w->corner, &w->capacity, w->count, sizeof *grown);
    if (grown == NULL) {
      return false;
    }
    w->corner = grown;
    memcpy(grown[place], (const uint32_t[3]){at, next, across}, sizeof *grown);
    at = next;
    *divided = *divided || place != triangle;
    w->count += place != triangle;
    place = w->count;
  }
  return true;
}

/* Divide a triangle at one of its edges; its parts so far begin at `parts`. */
static bool divide(search *s, size_t triangle, size_t parts, const weld_edge *e, bool *divided) {
  const double(*v)[3] = (const double(*)[3])s->w->vertex;
  bool up = weld_below(v[e->low], v[e->high]);
  s->low = up ? e->low : e->high;
  s->high = up ? e->high : e->low;
  s->ins = 0;
  if (!look(s, 0, 0, s->points)) {
    return false;
  }
  size_t part = triangle;
  while (side_of(s->w->corner[part], s->low, s->high) == 3) {
    part = part == triangle ? parts : part + 1;
  }
  return s->ins == 0 || divide_side(s, part, side_of(s->w->corner[part], s->low, s->high), divided);
}

/* ---------------------------------------------------------------------- open edges */

static bool same_edge(const weld_edge *p, const weld_edge *q) {
  return p->low == q->low && p->high == q->high;
}

/* Keep only the edges of an odd number of triangles. */
static size_t keep_open(weld_edge *edge, size_t count) {
  size_t kept = 0;
  for (size_t first = 0; first < count;) {
    size_t end = first;
    while (end < count && same_edge(&edge[first], &edge[end])) {
      end++;
    }
    for (size_t n = first; n < end && (end - first) % 2 != 0; n++) {
      edge[kept++] = edge[n];
    }
    first = end;
  }
  return kept;
}

static int compare(const void *p, const void *q) {
  const weld_edge *a = p;
  const weld_edge *b = q;
  return (a->triangle > b->triangle) - (a->triangle < b->triangle);
}

/* Edge p comes before q by the coordinates of its vertices, the lower one first. */
static bool comes_before(const search *s, const weld_edge *p, const weld_edge *q) {
  const double(*v)[3] = (const double(*)[3])s->w->vertex;
  bool up[2] = {weld_below(v[p->low], v[p->high]), weld_below(v[q->low], v[q->high])};
  const double *low[2] = {v[up[0] ? p->low : p->high], v[up[1] ? q->low : q->high]};
  const double *high[2] = {v[up[0] ? p->high : p->low], v[up[1] ? q->high : q->low]};
  return weld_below(low[0], low[1]) ||
         (!weld_below(low[1], low[0]) && weld_below(high[0], high[1]));
}

/* Divide one triangle at its open edges, in an order that depends only on their vertices. */
static bool divide_triangle(search *s, weld_edge *edge, size_t count) {
  size_t triangle = edge[0].triangle;
  size_t parts = s->w->count;
  if (weld_no_area(s->w->corner[triangle])) {
    return true;
  }
  for (size_t n = 1; n < count; n++) {
    for (size_t k = n; k > 0 && comes_before(s, &edge[k], &edge[k - 1]); k--) {
      weld_edge one = edge[k];
      edge[k] = edge[k - 1];
      edge[k - 1] = one;
    }
  }
  for (size_t n = 0; n < count; n++) {
    bool divided = false;
    if (!divide(s, triangle, parts, &edge[n], &divided)) {
      return false;
    }
    s->w->said.divided += divided;
  }
  return true;
}

/* List the vertices of open edges, each once, for the tree. */
static bool list_points(search *s, const weld_edge *edge, size_t count) {
  uint8_t *seen = sepax__zeroed(s->w->vertices, 1);
  s->point = sepax_allocate((2 * count + 1) * sizeof *s->point);
  if (seen == NULL || s->point == NULL) {
    sepax_release(seen);
    return false;
  }
  for (size_t n = 0; n < 2 * count; n++) {
    uint32_t v = n % 2 == 0 ? edge[n / 2].low : edge[n / 2].high;
    if (seen[v] == 0) {
      s->point[s->points++] = v;
    }
    seen[v] = 1;
  }
  sepax_release(seen);
  size_t boxes = 1;
  for (size_t n = s->points; n > LEAF; n = (n + 1) / 2) {
    boxes = 2 * boxes + 1;
  }
  s->box = sepax_allocate(boxes * sizeof *s->box);
  if (s->box != NULL && s->points > 0) {
    build(s, 0, 0, s->points);
  }
  return s->box != NULL;
}

static bool divide_all(search *s, weld_edge *edge, size_t count) {
  count = keep_open(edge, count);
  if (count == 0) {
    return true;
  }
  if (!list_points(s, edge, count)) {
    return false;
  }
  qsort(edge, count, sizeof *edge, compare);
  for (size_t first = 0; first < count;) {
    size_t end = first;
    while (end < count && edge[end].triangle == edge[first].triangle) {
      end++;
    }
    if (!divide_triangle(s, edge + first, end - first)) {
      return false;
    }
    first = end;
  }
  return true;
}

weld_result sepax__weld_divide(welding *w) {
  search s = {.w = w};
  size_t count = 0;
  weld_edge *edge = sepax__weld_edges(w, &count);
  bool ok = edge != NULL && divide_all(&s, edge, count);
  sepax_release(edge);
  sepax_release(s.point);
  sepax_release(s.box);
  sepax_release(s.in);
  return ok ? WELD_DONE : WELD_MEMORY;
}
