/* SPDX-License-Identifier: MIT */
#include "soup.h"

#include <stdlib.h>

void add(soup *s, point a, point b, point c) {
  if (s->count < MOST) {
    s->t[s->count++] = (triangle){{a, b, c}};
  }
}

bool full(const soup *s) { return s->count == MOST; }

void add_simplex(soup *s, const point p[4], bool turned) {
  static const int face[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  for (int f = 0; f < 4; f++) {
    point a = p[face[f][0]];
    point b = p[face[f][1]];
    point c = p[face[f][2]];
    add(s, a, turned ? c : b, turned ? b : c);
  }
}

bool add_tetrahedron(soup *s, const point p[4], bool inwards) {
  wide volume = determinant(minus(p[1], p[0]), minus(p[2], p[0]), minus(p[3], p[0]));
  if (volume == 0) {
    return false;
  }
  add_simplex(s, p, (volume < 0) != inwards);
  return true;
}

point box_corner(point low, point high, int k) {
  point p;
  for (int i = 0; i < 3; i++) {
    p.x[i] = (k >> i & 1) != 0 ? high.x[i] : low.x[i];
  }
  return p;
}

void box_face(point low, point high, int face, point corner[4]) {
  int i = face % 3;
  int j = (i + 1) % 3;
  int k = (i + 2) % 3;
  int at = face < 3 ? 0 : 1 << i;
  const int round[4] = {at, at | 1 << j, at | 1 << j | 1 << k, at | 1 << k};
  for (int n = 0; n < 4; n++) {
    corner[n] = box_corner(low, high, round[face < 3 ? 3 - n : n]);
  }
}

static void add_halves(soup *s, const point c[4], bool other) {
  if (other) {
    add(s, c[0], c[1], c[3]);
    add(s, c[1], c[2], c[3]);
  } else {
    add(s, c[0], c[1], c[2]);
    add(s, c[0], c[2], c[3]);
  }
}

void add_box(soup *s, point low, point high, bool inwards, generator *g) {
  for (int face = 0; face < 6; face++) {
    point c[4];
    box_face(low, high, face, c);
    if (inwards) {
      point kept = c[1];
      c[1] = c[3];
      c[3] = kept;
    }
    add_halves(s, c, one_in(g, 2));
  }
}

/* The point of a + (b - a) * part / 12. */
static point between(point a, point b, int64_t part) {
  point d = minus(b, a);
  return (point){
      {a.x[0] + d.x[0] * part / 12, a.x[1] + d.x[1] * part / 12, a.x[2] + d.x[2] * part / 12}};
}

static void add_strips(soup *s, const point c[4], generator *g) {
  int64_t strips = draw(g, 2, 4);
  for (int64_t n = 0; n < strips; n++) {
    int64_t from = n * 12 / strips;
    int64_t to = (n + 1) * 12 / strips;
    const point part[4] = {between(c[0], c[1], from), between(c[0], c[1], to),
                           between(c[3], c[2], to), between(c[3], c[2], from)};
    add_halves(s, part, one_in(g, 2));
  }
}

void add_face(soup *s, const point corner[4], generator *g) {
  int64_t first = draw(g, 0, 1);
  const point c[4] = {corner[first], corner[first + 1], corner[first + 2], corner[(first + 3) % 4]};
  switch (draw(g, 0, 4)) {
  case 0: {
    point middle = between(c[0], c[2], draw(g, 1, 3) * 3);
    for (int n = 0; n < 4; n++) {
      add(s, c[n], c[(n + 1) % 4], middle);
    }
    return;
  }
  case 1:
    add_strips(s, c, g);
    return;
  default:
    add_halves(s, c, false);
  }
}

void turn(triangle *t) {
  point kept = t->v[1];
  t->v[1] = t->v[2];
  t->v[2] = kept;
}

int64_t common_factor(int64_t a, int64_t b) {
  while (b != 0) {
    int64_t rest = a % b;
    a = b;
    b = rest;
  }
  return a < 0 ? -a : a;
}

bool divide(soup *s, size_t i, generator *g) {
  triangle t = s->t[i];
  int e = (int)draw(g, 0, 2);
  point a = t.v[e];
  point b = t.v[(e + 1) % 3];
  point c = t.v[(e + 2) % 3];
  point d = minus(b, a);
  int64_t steps = common_factor(common_factor(d.x[0], d.x[1]), d.x[2]);
  if (steps < 2 || full(s)) {
    return false;
  }
  int64_t at = one_in(g, 2) && steps % 2 == 0 ? steps / 2 : draw(g, 1, steps - 1);
  point m = plus(a, (point){{d.x[0] / steps * at, d.x[1] / steps * at, d.x[2] / steps * at}});
  s->t[i] = (triangle){{a, m, c}};
  add(s, m, b, c);
  return true;
}

void divide_row(soup *s, size_t i, int e, int pieces) {
  triangle t = s->t[i];
  point a = t.v[e];
  point b = t.v[(e + 1) % 3];
  point c = t.v[(e + 2) % 3];
  point d = minus(b, a);
  if (d.x[0] % pieces != 0 || d.x[1] % pieces != 0 || d.x[2] % pieces != 0) {
    return;
  }
  point step = {{d.x[0] / pieces, d.x[1] / pieces, d.x[2] / pieces}};
  s->t[i] = (triangle){{a, plus(a, step), c}};
  for (int n = 1; n < pieces; n++) {
    add(s, plus(a, times(step, n)), plus(a, times(step, n + 1)), c);
  }
}

/* 1 or -1 if both triangles have the same corners in the same or in opposite directions, else 0. */
static int alike(const triangle *a, const triangle *b) {
  for (int k = 0; k < 3; k++) {
    if (equal(a->v[0], b->v[k])) {
      const point *next = &b->v[(k + 1) % 3];
      const point *last = &b->v[(k + 2) % 3];
      if (equal(a->v[1], *next) && equal(a->v[2], *last)) {
        return 1;
      }
      if (equal(a->v[1], *last) && equal(a->v[2], *next)) {
        return -1;
      }
    }
  }
  return 0;
}

static bool cancel_one(soup *s, bool in_any_direction) {
  for (size_t i = 0; i < s->count; i++) {
    for (size_t j = i + 1; j < s->count; j++) {
      int how = alike(&s->t[i], &s->t[j]);
      if (how < 0 || (how > 0 && in_any_direction)) {
        remove_triangle(s, j);
        remove_triangle(s, i);
        return true;
      }
    }
  }
  return false;
}

void cancel(soup *s, bool in_any_direction) {
  while (cancel_one(s, in_any_direction)) {}
}

void remove_triangle(soup *s, size_t i) { s->t[i] = s->t[--s->count]; }

void shuffle(soup *s, generator *g) {
  for (size_t i = s->count; i-- > 1;) {
    size_t j = (size_t)draw(g, 0, (int64_t)i);
    triangle kept = s->t[i];
    s->t[i] = s->t[j];
    s->t[j] = kept;
  }
  for (size_t i = 0; i < s->count; i++) {
    int64_t first = draw(g, 0, 2);
    triangle t = s->t[i];
    for (int k = 0; k < 3; k++) {
      s->t[i].v[k] = t.v[(first + k) % 3];
    }
  }
}
