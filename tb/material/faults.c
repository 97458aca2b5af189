/* SPDX-License-Identifier: MIT */
#include "faults.h"

static size_t any(const soup *s, generator *g) { return (size_t)draw(g, 0, (int64_t)s->count - 1); }

void turn_some(soup *s, generator *g) {
  if (s->count == 0) {
    return;
  }
  if (one_in(g, 3)) {
    int64_t chance = draw(g, 2, 5);
    for (size_t i = 0; i < s->count; i++) {
      if (one_in(g, chance)) {
        turn(&s->t[i]);
      }
    }
    return;
  }
  for (int64_t n = draw(g, 1, 3); n > 0; n--) {
    turn(&s->t[any(s, g)]);
  }
}

void copy_some(soup *s, generator *g) {
  for (int64_t n = draw(g, 1, 3); n > 0 && s->count > 0; n--) {
    triangle t = s->t[any(s, g)];
    for (int64_t copies = one_in(g, 4) ? 1 : 2; copies > 0; copies--) {
      if (one_in(g, 3)) {
        turn(&t);
      }
      add(s, t.v[0], t.v[1], t.v[2]);
    }
  }
}

void divide_some(soup *s, int64_t most, generator *g) {
  for (int64_t n = draw(g, 1, most); n > 0 && s->count > 0; n--) {
    divide(s, any(s, g), g);
  }
}

void fill_in(soup *s, generator *g) {
  for (int64_t n = draw(g, 1, 3); n > 0 && s->count > 0; n--) {
    triangle t = s->t[any(s, g)];
    point d = minus(t.v[1], t.v[0]);
    point third = plus(t.v[0], times(d, 2));
    switch (draw(g, 0, 3)) {
    case 0:
      third = t.v[0];
      break;
    case 1:
      t.v[1] = third = t.v[0];
      break;
    case 2:
      if (d.x[0] % 2 == 0 && d.x[1] % 2 == 0 && d.x[2] % 2 == 0) {
        third = plus(t.v[0], (point){{d.x[0] / 2, d.x[1] / 2, d.x[2] / 2}});
      }
      break;
    default:
      break;
    }
    add(s, t.v[0], t.v[1], third);
  }
}

void spoil(soup *s, generator *g) {
  if (one_in(g, 2)) {
    turn_some(s, g);
  }
  if (one_in(g, 4)) {
    copy_some(s, g);
  }
  if (one_in(g, 4)) {
    divide_some(s, 6, g);
  }
  if (one_in(g, 6)) {
    fill_in(s, g);
  }
  if (one_in(g, 10) && s->count > 1) {
    remove_triangle(s, any(s, g));
  }
}
