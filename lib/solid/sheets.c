/* SPDX-License-Identifier: MIT */
/* sheets.c - finds edges that lie on each other, sheets, and the boundaries of sheets. */
#include "sheets.h"
#include "parts.h"
#include "util/memory.h"

#include <stdlib.h>
#include <string.h>

/* An edge on a line of several edges, from `low` to `high` along a coordinate axis. */
typedef struct {
  double low, high;
  uint32_t line, edge;
} stretch;

typedef struct {
  const surface *s;
  edge_uses *edge;
  size_t edges;
  uint32_t *line;        /* union-find: edges that meet on a line */
  uint32_t *cluster;     /* of each edge: 0, or a number of the edges that lie on each other */
  uint32_t (*places)[2]; /* of each edge: of a seam, at its lower and at its other vertex */
  edge_ends ends;        /* `triangle` is the number of an edge here */
} seams;

static bool list_edges(seams *m) {
  for (edge_uses at = {0, m->s->edge, 0}; next_edge(m->s, &at);) {
    m->edges++;
  }
  m->edge = sepax_allocate(m->edges * sizeof *m->edge);
  m->line = sepax_allocate(m->edges * sizeof *m->line);
  m->cluster = sepax__zeroed(m->edges, sizeof *m->cluster);
  m->places = sepax__zeroed(m->edges, sizeof *m->places);
  if (m->edge == NULL || m->line == NULL || m->cluster == NULL || m->places == NULL) {
    return false;
  }
  uint32_t n = 0;
  for (edge_uses at = {0, m->s->edge, 0}; next_edge(m->s, &at); n++) {
    const edge_end end = {at.from, other_vertex(at.edge), n, 0};
    m->edge[n] = at;
    m->line[n] = n;
    if (!sepax__add_ends(&m->ends, end)) {
      return false;
    }
  }
  return sepax__sort_ends(m->s, &m->ends);
}

/* How many ends from `first` on are at one vertex and on one line. */
static size_t ends_together(const seams *m, size_t first) {
  size_t count = 1;
  while (first + count < m->ends.count &&
         sepax__compare_ends(m->s, m->ends.end + first, m->ends.end + first + count) == 0) {
    count++;
  }
  return count;
}

static void join_lines(seams *m) {
  for (size_t first = 0; first < m->ends.count;) {
    size_t count = ends_together(m, first);
    for (size_t n = 1; n < count; n++) {
      join(m->line, m->ends.end[first].triangle, m->ends.end[first + n].triangle);
    }
    first += count;
  }
}

static stretch stretch_of(seams *m, uint32_t n) {
  const double *p = m->s->vertex[m->edge[n].from];
  const double *q = m->s->vertex[other_vertex(m->edge[n].edge)];
  int i = 0;
  while (i < 2 && !(p[i] < q[i] || p[i] > q[i])) {
    i++;
  }
  return (stretch){p[i] < q[i] ? p[i] : q[i], p[i] < q[i] ? q[i] : p[i], set_of(m->line, n), n};
}

static int compare_stretches(const void *p, const void *q) {
  const stretch *a = p;
  const stretch *b = q;
  return a->line != b->line ? (a->line > b->line) - (a->line < b->line)
                            : (a->low > b->low) - (a->low < b->low);
}

/* Number the clusters: edges on one line that overlap, also by way of others. */
static bool find_clusters(seams *m) {
  uint8_t *several = sepax__zeroed(m->edges, 1);
  if (several == NULL) {
    return false;
  }
  size_t count = 0;
  for (uint32_t n = 0; n < m->edges; n++) {
    uint32_t line = set_of(m->line, n);
    several[line] |= line != n;
  }
  for (uint32_t n = 0; n < m->edges; n++) {
    count += several[set_of(m->line, n)];
  }
  stretch *list = sepax_allocate(count * sizeof *list);
  if (count > 0 && list == NULL) {
    sepax_release(several);
    return false;
  }
  count = 0;
  for (uint32_t n = 0; n < m->edges; n++) {
    if (several[set_of(m->line, n)]) {
      list[count++] = stretch_of(m, n);
    }
  }
  sepax_release(several);
  if (count > 0) {
    qsort(list, count, sizeof *list, compare_stretches);
  }
  uint32_t clusters = 0;
  for (size_t first = 0; first < count;) {
    double high = list[first].high;
    size_t n = first + 1;
    for (; n < count && list[n].line == list[first].line && list[n].low < high; n++) {
      high = list[n].high > high ? list[n].high : high;
    }
    bool overlap = n - first > 1;
    clusters += overlap;
    for (; first < n; first++) {
      m->cluster[list[first].edge] = overlap ? clusters : 0;
    }
  }
  sepax_release(list);
  return true;
}

/* Find the two triangles of an edge that is no seam. Triangles of equal corners do not count. */
static bool is_seam(const seams *m, size_t n, uint32_t pair[2]) {
  const edge_uses *at = &m->edge[n];
  uint32_t third[2] = {at->from, at->from};
  size_t count = 0;
  for (size_t k = 0; k < at->count && count <= 2; k++) {
    uint32_t vertex = third_vertex(m->s, at, k);
    if (vertex != at->from) {
      if (count < 2) {
        third[count] = vertex;
        pair[count] = triangle_at(at->edge + k);
      }
      count++;
    }
  }
  return m->cluster[n] != 0 || count != 2 || third[0] == third[1];
}

/* Number the places: a seam is one, or has two ends, of which those at one vertex and of one
 * cluster are one place. At a vertex a line has two clusters at most. */
static void number_places(seams *m, sheets *all) {
  all->places = 0;
  for (size_t n = 0; n < m->edges; n++) {
    uint32_t pair[2];
    m->places[n][0] = m->cluster[n] == 0 && is_seam(m, n, pair) ? all->places++ : 0;
  }
  for (size_t first = 0; first < m->ends.count;) {
    size_t count = ends_together(m, first);
    uint32_t cluster = 0;
    for (size_t n = 0; n < count && cluster == 0; n++) {
      cluster = m->cluster[m->ends.end[first + n].triangle];
    }
    for (size_t n = 0; n < count; n++) {
      const edge_end *end = &m->ends.end[first + n];
      uint32_t own = m->cluster[end->triangle];
      if (own != 0) {
        bool high = end->at != m->edge[end->triangle].from;
        m->places[end->triangle][high] = all->places + (own != cluster);
      }
    }
    all->places += cluster != 0 ? 2 : 0;
    first += count;
  }
}

static void join_sheets(const seams *m, sheets *all) {
  for (uint32_t n = 0; n < m->s->count; n++) {
    all->of[n] = n;
  }
  for (size_t n = 0; n < m->edges; n++) {
    uint32_t pair[2];
    if (!is_seam(m, n, pair)) {
      join(all->of, pair[0], pair[1]);
    }
  }
}

static void list_borders(const seams *m, sheets *all) {
  for (size_t n = 0; n < m->edges; n++) {
    const edge_uses *at = &m->edge[n];
    uint32_t pair[2];
    bool seam = is_seam(m, n, pair);
    for (size_t k = 0; k < at->count && seam; k++) {
      uint32_t triangle = triangle_at(at->edge + k);
      uint32_t sheet = set_of(all->of, triangle);
      all->joint[triangle] |= m->cluster[n] != 0 || at->count > 2;
      all->border[all->borders++] = (border){sheet, m->places[n][0]};
      if (m->cluster[n] != 0) {
        all->border[all->borders++] = (border){sheet, m->places[n][1]};
      }
    }
  }
}

/* Sort by `place` or `sheet`, which is below `limit`; stable. begin: limit + 1 numbers. */
static void sort_by(const border *from, border *to, size_t count, bool place, uint32_t *begin,
                    uint32_t limit) {
  memset(begin, 0, ((size_t)limit + 1) * sizeof *begin);
  for (size_t n = 0; n < count; n++) {
    begin[(place ? from[n].place : from[n].sheet) + 1]++;
  }
  for (uint32_t k = 0; k < limit; k++) {
    begin[k + 1] += begin[k];
  }
  for (size_t n = 0; n < count; n++) {
    to[begin[place ? from[n].place : from[n].sheet]++] = from[n];
  }
}

bool sepax__sort_borders(border *list, size_t *count, uint32_t numbers, uint32_t places) {
  uint32_t limit = numbers > places ? numbers : places;
  border *other = sepax_allocate(*count * sizeof *other + 1);
  uint32_t *begin = sepax_allocate(((size_t)limit + 1) * sizeof *begin);
  bool ok = other != NULL && begin != NULL;
  if (ok) {
    sort_by(list, other, *count, true, begin, limit);
    sort_by(other, list, *count, false, begin, limit);
    size_t kept = 0;
    for (size_t n = 0; n < *count; n++) {
      if (kept > 0 && list[kept - 1].sheet == list[n].sheet &&
          list[kept - 1].place == list[n].place) {
        kept--;
      } else {
        list[kept++] = list[n];
      }
    }
    *count = kept;
  }
  sepax_release(begin);
  sepax_release(other);
  return ok;
}

bool sepax__find_sheets(const surface *s, sheets *all) {
  seams m = {.s = s};
  all->of = sepax_allocate(s->count * sizeof *all->of);
  all->joint = sepax__zeroed(s->count, sizeof *all->joint);
  bool ok = all->of != NULL && all->joint != NULL && list_edges(&m);
  if (ok) {
    join_lines(&m);
    ok = find_clusters(&m);
  }
  if (ok) {
    number_places(&m, all);
    join_sheets(&m, all);
    size_t most = 0;
    for (size_t n = 0; n < m.edges; n++) {
      uint32_t pair[2];
      most += is_seam(&m, n, pair) ? (m.cluster[n] != 0 ? 2 : 1) * m.edge[n].count : 0;
    }
    all->border = sepax_allocate(most * sizeof *all->border + 1);
    ok = all->border != NULL;
  }
  if (ok) {
    list_borders(&m, all);
    ok = sepax__sort_borders(all->border, &all->borders, (uint32_t)s->count, all->places);
  }
  sepax_release(m.edge);
  sepax_release(m.line);
  sepax_release(m.cluster);
  sepax_release(m.places);
  sepax_release(m.ends.end);
  return ok;
}

void sepax__free_sheets(sheets *all) {
  sepax_release(all->of);
  sepax_release(all->border);
  sepax_release(all->joint);
}
