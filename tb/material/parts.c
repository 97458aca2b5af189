/* SPDX-License-Identifier: MIT */
#include "parts.h"

#include "lines.h"
#include "touch.h"

#include <string.h>

/* What joining takes. */
typedef struct {
  const soup *s;
  division *d;
} joining;

static size_t root(division *d, size_t i) {
  while (d->part[i] != i) {
    i = d->part[i] = d->part[d->part[i]];
  }
  return i;
}

/* Directions along the edges with the ends of `e`, of triangles that have an area. */
static int sum_along(const line *l, const edge *e, const soup *s) {
  int sum = 0;
  for (size_t i = 0; i < l->edges; i++) {
    const edge *other = &l->edge[i];
    bool same = other->at[0] == e->at[0] && other->at[1] == e->at[1];
    sum += same && !is_zero(normal(s->t[other->of].v)) ? other->sign : 0;
  }
  return sum;
}

static void join_along(void *context, const line *l) {
  joining *to = context;
  bool uneven[3 * MOST];
  for (size_t i = 0; i < l->edges; i++) {
    uneven[i] = sum_along(l, &l->edge[i], to->s) != 0;
    for (size_t j = 0; j < i; j++) {
      const edge *a = &l->edge[i];
      const edge *b = &l->edge[j];
      bool same = a->at[0] == b->at[0] && a->at[1] == b->at[1];
      bool share = a->at[0] == b->at[0] || a->at[0] == b->at[1] || a->at[1] == b->at[0] ||
                   a->at[1] == b->at[1];
      if (same || (share && uneven[i] && uneven[j])) {
        to->d->part[root(to->d, a->of)] = root(to->d, b->of);
      }
    }
  }
}

/* The parts of which an odd number of triangles run along a segment. */
static void open_along(void *context, const line *l) {
  joining *to = context;
  for (size_t n = 0; n + 1 < l->cuts; n++) {
    for (size_t i = 0; i < l->edges; i++) {
      size_t part = to->d->part[l->edge[i].of];
      int edges = 0;
      for (size_t j = 0; j < l->edges; j++) {
        const edge *e = &l->edge[j];
        bool on = e->at[0] <= l->cut[n] && l->cut[n] < e->at[1];
        edges += on && to->d->part[e->of] == part;
      }
      to->d->open[part] = to->d->open[part] || edges % 2 != 0;
    }
  }
}

static void find_open_box(division *d, const soup *s) {
  for (size_t n = 0; n < 9 * s->count; n++) {
    if (d->open[d->part[n / 9]]) {
      int64_t x = s->t[n / 9].v[n % 9 / 3].x[n % 3];
      d->low.x[n % 3] = x < d->low.x[n % 3] ? x : d->low.x[n % 3];
      d->high.x[n % 3] = x > d->high.x[n % 3] ? x : d->high.x[n % 3];
    }
  }
}

void find_parts(division *d, const soup *s) {
  *d = (division){.low = {{INT64_MAX, INT64_MAX, INT64_MAX}},
                  .high = {{INT64_MIN, INT64_MIN, INT64_MIN}}};
  joining to = {s, d};
  for (size_t i = 0; i < s->count; i++) {
    d->part[i] = i;
  }
  for_each_line(s, join_along, &to);
  for (size_t i = 0; i < s->count; i++) {
    d->part[i] = root(d, i);
    d->count += d->part[i] == i;
  }
  for_each_line(s, open_along, &to);
  find_open_box(d, s);
}

static bool boxes_touch(const triangle *a, const triangle *b) {
  for (int i = 0; i < 3; i++) {
    int64_t low[2] = {a->v[0].x[i], b->v[0].x[i]};
    int64_t high[2] = {low[0], low[1]};
    for (int k = 1; k < 3; k++) {
      const int64_t x[2] = {a->v[k].x[i], b->v[k].x[i]};
      for (int n = 0; n < 2; n++) {
        low[n] = x[n] < low[n] ? x[n] : low[n];
        high[n] = x[n] > high[n] ? x[n] : high[n];
      }
    }
    if (low[0] > high[1] || low[1] > high[0]) {
      return false;
    }
  }
  return true;
}

static size_t root_of(size_t *piece, size_t i) {
  while (piece[i] != i) {
    i = piece[i] = piece[piece[i]];
  }
  return i;
}

size_t find_pieces(const soup *s, const division *d, size_t *piece) {
  size_t count = 0;
  memcpy(piece, d->part, sizeof d->part);
  for (size_t i = 0; i < s->count; i++) {
    for (size_t j = 0; j < i && !is_zero(normal(s->t[i].v)); j++) {
      size_t a = root_of(piece, i);
      size_t b = root_of(piece, j);
      if (a != b && boxes_touch(&s->t[i], &s->t[j]) && !is_zero(normal(s->t[j].v)) &&
          triangles_touch(&s->t[i], &s->t[j])) {
        piece[a] = b;
      }
    }
  }
  for (size_t i = 0; i < s->count; i++) {
    count += piece[i] == i;
    piece[i] = root_of(piece, i);
  }
  return count;
}

/* A part that encloses the point. */
typedef struct {
  soup s;
  size_t part;
  int sum;
  point low, high;
} wall;

static void find_box(wall *w) {
  w->low = w->high = w->s.t[0].v[0];
  for (size_t n = 0; n < 9 * w->s.count; n++) {
    int64_t x = w->s.t[n / 9].v[n % 9 / 3].x[n % 3];
    w->low.x[n % 3] = x < w->low.x[n % 3] ? x : w->low.x[n % 3];
    w->high.x[n % 3] = x > w->high.x[n % 3] ? x : w->high.x[n % 3];
  }
}

/* The box of a strictly holds that of b. */
static bool is_round(const wall *a, const wall *b) {
  bool round = true;
  for (int i = 0; i < 3; i++) {
    round = round && a->low.x[i] < b->low.x[i] && b->high.x[i] < a->high.x[i];
  }
  return round;
}

/* Fill in a wall. False if the part does not enclose the point. */
static bool find_wall(wall *w, const soup *s, const division *d, size_t part,
                      const int8_t *crossing, bool *consistent) {
  surfaces own;
  int8_t crossing_own[MOST];
  w->s.count = 0;
  w->part = part;
  w->sum = 0;
  for (size_t i = 0; i < s->count; i++) {
    if (d->part[i] == part) {
      crossing_own[w->s.count] = crossing[i];
      w->s.t[w->s.count++] = s->t[i];
      w->sum += crossing[i];
    }
  }
  find_surfaces(&own, &w->s);
  bool encloses = is_enclosed(&own, crossing_own);
  *consistent = own.closed && own.consistent;
  free_surfaces(&own);
  find_box(w);
  return encloses;
}

/* Do the walls follow each other as those round a cavity do? */
static bool alternate(const wall *w, size_t count, const size_t *piece) {
  for (size_t i = 0; i < count; i++) {
    size_t outer = 0;
    for (size_t j = 0; j < count; j++) {
      bool in = is_round(&w[j], &w[i]);
      if (i != j && !in && !is_round(&w[i], &w[j])) {
        return false;
      }
      if (i != j && piece[w[i].part] == piece[w[j].part]) {
        return false;
      }
      outer += in;
    }
    if (w[i].sum != (outer % 2 == 0 ? 1 : -1)) {
      return false;
    }
  }
  return count % 2 == 0;
}

enum { WALLS = 64 };

void find_walls(walls *found, const surfaces *f, const division *d, const int8_t *crossing) {
  static wall w[WALLS];
  int8_t rest[MOST];
  *found = (walls){.consistent = true};
  memcpy(rest, crossing, sizeof rest);
  for (size_t part = 0; part < f->s->count && found->count < WALLS; part++) {
    bool consistent;
    if (d->part[part] != part ||
        !find_wall(&w[found->count], f->s, d, part, crossing, &consistent)) {
      continue;
    }
    int sum = w[found->count++].sum;
    found->consistent = found->consistent && consistent;
    found->sum += sum;
    found->below += sum < 0;
    for (size_t i = 0; i < f->s->count; i++) {
      rest[i] = d->part[i] == part ? 0 : rest[i];
    }
  }
  found->alone = !is_enclosed(f, rest);
  if (found->consistent && found->sum == 0 && found->count > 0) {
    size_t piece[MOST];
    find_pieces(f->s, d, piece);
    found->in_turn = alternate(w, found->count, piece);
  }
}
