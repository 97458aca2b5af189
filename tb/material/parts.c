/* SPDX-License-Identifier: MIT */
#include "parts.h"

#include "lines.h"
#include "touch.h"

#include <stdlib.h>

static size_t root(size_t *part, size_t i) {
  while (part[i] != i) {
    i = part[i] = part[part[i]];
  }
  return i;
}

static void join(size_t *part, size_t a, size_t b) { part[root(part, a)] = root(part, b); }

/* Directions along the edges with the ends of `e`. */
static int sum_along(const line *l, const edge *e) {
  int sum = 0;
  for (size_t i = 0; i < l->edges; i++) {
    const edge *other = &l->edge[i];
    sum += other->at[0] == e->at[0] && other->at[1] == e->at[1] ? other->sign : 0;
  }
  return sum;
}

static void join_along(void *context, const line *l) {
  size_t *part = context;
  bool uneven[3 * MOST];
  for (size_t i = 0; i < l->edges; i++) {
    uneven[i] = sum_along(l, &l->edge[i]) != 0;
  }
  for (size_t i = 0; i < l->edges; i++) {
    for (size_t j = 0; j < i; j++) {
      const edge *a = &l->edge[i];
      const edge *b = &l->edge[j];
      bool same = a->at[0] == b->at[0] && a->at[1] == b->at[1];
      bool share = a->at[0] == b->at[0] || a->at[0] == b->at[1] || a->at[1] == b->at[0] ||
                   a->at[1] == b->at[1];
      if (same || (share && uneven[i] && uneven[j])) {
        join(part, a->of, b->of);
      }
    }
  }
}

size_t find_parts(const soup *s, size_t *part) {
  size_t count = 0;
  for (size_t i = 0; i < s->count; i++) {
    part[i] = i;
  }
  for_each_line(s, join_along, part);
  for (size_t i = 0; i < s->count; i++) {
    count += part[i] == i;
  }
  for (size_t i = 0; i < s->count; i++) {
    part[i] = root(part, i);
  }
  return count;
}

/* A part that encloses the point. */
typedef struct {
  soup s;
  int sum; /* how often a ray leaves less how often it enters */
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

static bool walls_touch(const wall *a, const wall *b) {
  for (size_t i = 0; i < a->s.count; i++) {
    for (size_t j = 0; j < b->s.count; j++) {
      const triangle *t = &a->s.t[i];
      const triangle *u = &b->s.t[j];
      if (!is_zero(normal(t->v)) && !is_zero(normal(u->v)) && triangles_touch(t, u)) {
        return true;
      }
    }
  }
  return false;
}

/* Fill in a wall. False if the part does not enclose the point. *even: directions cancel in it. */
static bool find_wall(wall *w, const surfaces *f, const size_t *part, size_t which, point p,
                      bool *even, generator *g) {
  static enclosure e;
  surfaces own;
  w->s.count = 0;
  for (size_t i = 0; i < f->s->count; i++) {
    if (part[i] == which) {
      w->s.t[w->s.count++] = f->s->t[i];
    }
  }
  find_surfaces(&own, &w->s);
  find_crossings(&e, &w->s, p, g);
  find_enclosure(&e, &own, MOST);
  w->sum = 0;
  for (size_t i = 0; i < w->s.count; i++) {
    w->sum += e.crossing[i];
  }
  *even = own.closed && own.consistent;
  free_surfaces(&own);
  find_box(w);
  return e.enclosed || e.enclosed_of_2;
}

/* Do the walls follow each other as those round a cavity do? */
static bool alternate(const wall *w, size_t walls) {
  for (size_t i = 0; i < walls; i++) {
    size_t outer = 0;
    for (size_t j = 0; j < walls; j++) {
      bool in = is_round(&w[j], &w[i]);
      if (i != j && !in && !is_round(&w[i], &w[j])) {
        return false;
      }
      if (j < i && walls_touch(&w[i], &w[j])) {
        return false;
      }
      outer += in;
    }
    if (w[i].sum != (outer % 2 == 0 ? 1 : -1)) {
      return false;
    }
  }
  return walls % 2 == 0;
}

/* No closed surface encloses the point by the triangles of other parts. */
static bool nothing_else(const surfaces *f, const size_t *part, const bool *is_wall, point p,
                         generator *g) {
  static enclosure e;
  find_crossings(&e, f->s, p, g);
  for (size_t i = 0; i < f->s->count; i++) {
    e.crossing[i] = is_wall[part[i]] ? 0 : e.crossing[i];
  }
  find_enclosure(&e, f, MOST);
  return !e.enclosed && !e.enclosed_of_2;
}

enum { WALLS = 16 };

bool is_cavity(const surfaces *f, point p, generator *g) {
  static wall w[WALLS];
  size_t part[MOST];
  bool is_wall[MOST] = {false};
  size_t walls = 0;
  find_parts(f->s, part);
  for (size_t i = 0; i < f->s->count && walls < WALLS; i++) {
    bool even;
    if (part[i] == i && find_wall(&w[walls], f, part, i, p, &even, g)) {
      if (!even) {
        return false;
      }
      is_wall[i] = true;
      walls++;
    }
  }
  return walls > 0 && walls < WALLS && alternate(w, walls) && nothing_else(f, part, is_wall, p, g);
}
