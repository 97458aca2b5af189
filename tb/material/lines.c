/* SPDX-License-Identifier: MIT */
#include "lines.h"

#include <stdlib.h>

static edge edge_of(point from, point to, size_t of) {
  point d = minus(to, from);
  int64_t factor = common_factor(common_factor(d.x[0], d.x[1]), d.x[2]);
  const point none = {{0, 0, 0}};
  int way = compare(d, none);
  for (int i = 0; i < 3; i++) {
    d.x[i] /= way * factor;
  }
  point low = way > 0 ? from : to;
  point high = way > 0 ? to : from;
  axis along = axis_of(d);
  return (edge){.direction = d,
                .moment = cross(axis_of(low), along),
                .end = {low, high},
                .at = {(int64_t)dot(along, low), (int64_t)dot(along, high)},
                .sign = way,
                .of = of};
}

static int compare_lines(const void *p, const void *q) {
  const edge *a = p;
  const edge *b = q;
  int way = compare(a->direction, b->direction);
  for (int i = 0; i < 3 && way == 0; i++) {
    way = sign(a->moment.x[i] - b->moment.x[i]);
  }
  return way;
}

typedef struct {
  int64_t at;
  point where;
} place;

static int compare_places(const void *p, const void *q) {
  const place *a = p;
  const place *b = q;
  return (a->at > b->at) - (a->at < b->at);
}

/* The ends of the edges in their order. */
static void cut_line(line *l) {
  static place all[6 * MOST];
  size_t count = 0;
  for (size_t i = 0; i < l->edges; i++) {
    for (int k = 0; k < 2; k++) {
      all[count++] = (place){l->edge[i].at[k], l->edge[i].end[k]};
    }
  }
  qsort(all, count, sizeof *all, compare_places);
  l->cuts = 0;
  for (size_t i = 0; i < count; i++) {
    if (i == 0 || all[i].at != all[i - 1].at) {
      l->cut[l->cuts] = all[i].at;
      l->where[l->cuts++] = all[i].where;
    }
  }
}

void for_each_line(const soup *s, void (*each)(void *context, const line *l), void *context) {
  static edge all[3 * MOST];
  static int64_t cut[6 * MOST];
  static point where[6 * MOST];
  size_t count = 0;
  for (size_t i = 0; i < s->count; i++) {
    for (int k = 0; k < 3; k++) {
      const point *v = s->t[i].v;
      if (!equal(v[k], v[(k + 1) % 3])) {
        all[count++] = edge_of(v[k], v[(k + 1) % 3], i);
      }
    }
  }
  qsort(all, count, sizeof *all, compare_lines);
  for (size_t first = 0, next; first < count; first = next) {
    for (next = first + 1; next < count && compare_lines(&all[first], &all[next]) == 0; next++) {}
    line l = {.edge = &all[first], .edges = next - first, .cut = cut, .where = where};
    cut_line(&l);
    each(context, &l);
  }
}
