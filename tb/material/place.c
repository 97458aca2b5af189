/* SPDX-License-Identifier: MIT */
#include "place.h"

#include <math.h>
#include <stdlib.h>

static wide draw_matrix(point row[3], bool plainly, generator *g) {
  for (int i = 0; i < 3; i++) {
    row[i] = (point){{i == 0, i == 1, i == 2}};
  }
  wide volume = plainly || one_in(g, 2) ? 1 : 0;
  while (volume == 0) {
    for (int k = 0; k < 9; k++) {
      row[k / 3].x[k % 3] = draw(g, -2, 2);
    }
    volume = determinant(row[0], row[1], row[2]);
  }
  return volume;
}

static void map_soup(soup *s, const point row[3], bool mirrored) {
  for (size_t i = 0; i < s->count; i++) {
    for (int k = 0; k < 3; k++) {
      point v = s->t[i].v[k];
      for (int n = 0; n < 3; n++) {
        s->t[i].v[k].x[n] = FINE * (int64_t)dot(axis_of(row[n]), v);
      }
    }
    if (mirrored) {
      turn(&s->t[i]);
    }
  }
}

static bool fits(const soup *s) {
  for (size_t i = 0; i < s->count; i++) {
    for (int k = 0; k < 9; k++) {
      if (llabs(s->t[i].v[k / 3].x[k % 3]) >= INT64_C(1) << 21) {
        return false;
      }
    }
  }
  return true;
}

bool map_body(body *b, bool plainly, generator *g) {
  point row[3];
  bool mirrored = draw_matrix(row, plainly, g) < 0;
  bool kept = mirrored && (b->solids > 0 || one_in(g, 2));
  map_soup(&b->s, row, kept);
  map_soup(&b->proof, row, kept);
  return fits(&b->s);
}

/* Rotations that turn axes into axes, each body by its own. */
static void draw_turns(placing *p, generator *g) {
  for (int k = 0; k < 2; k++) {
    int *from = p->from[k];
    int *way = p->way[k];
    int first = (int)draw(g, 0, 2);
    int step = (int)draw(g, 1, 2); /* 2: an odd permutation */
    for (int i = 0; i < 3; i++) {
      from[i] = (first + step * i) % 3;
      way[i] = one_in(g, 2) ? 1 : -1;
    }
    way[2] = way[0] * way[1] * (step == 1 ? 1 : -1);
    for (int i = 0; i < 3; i++) {
      p->away[k].x[i] = one_in(g, 2) ? 0 : draw(g, -(INT64_C(1) << 40), INT64_C(1) << 40);
    }
  }
}

static void write_turns(placing *p) {
  for (int k = 0; k < 2; k++) {
    for (int i = 0; i < 3; i++) {
      p->pose[k].rotation[i][p->from[k][i]] = p->way[k][i];
      p->pose[k].translation[i] = ldexp((double)p->away[k].x[i], p->exponent);
    }
    p->given[k] = &p->pose[k];
  }
}

/* One pose of both bodies may be any: it moves them alike, so nothing depends on its rounding. */
static void draw_common_pose(placing *p, generator *g) {
  double q[4];
  double square = 0;
  for (int i = 0; i < 4; i++) {
    q[i] = (double)draw(g, -1000, 1000) + 0.5;
    square += q[i] * q[i];
  }
  double n = 2 / square;
  double noise = one_in(g, 2) ? 1e-7 : 0;
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    double *row = p->pose[0].rotation[i];
    row[i] = 1 - n * (q[j] * q[j] + q[k] * q[k]) + noise;
    row[j] = n * (q[i] * q[j] - q[3] * q[k]) - noise;
    row[k] = n * (q[i] * q[k] + q[3] * q[j]);
    p->pose[0].translation[i] = one_in(g, 3) ? 0 : (double)draw(g, -1000000, 1000000) / 7;
  }
  p->pose[1] = p->pose[0];
  p->given[0] = &p->pose[0];
  p->given[1] = one_in(g, 2) ? &p->pose[0] : &p->pose[1];
}

void draw_place(placing *p, bool plainly, generator *g) {
  *p = (placing){.exponent = -10, .from = {{0, 1, 2}, {0, 1, 2}}, .way = {{1, 1, 1}, {1, 1, 1}}};
  if (plainly) {
    return;
  }
  p->minus_zero = one_in(g, 4);
  if (one_in(g, 3)) {
    p->exponent = (int)draw(g, -40, 20);
  }
  if (one_in(g, 3)) {
    for (int i = 0; i < 3; i++) {
      p->offset.x[i] = draw(g, -1, 1) * 1000000 * FINE;
    }
  }
  if (one_in(g, 3)) {
    draw_turns(p, g);
    write_turns(p);
  } else if (one_in(g, 2)) {
    draw_common_pose(p, g);
  }
}

void place(const placing *p, int which, const triangle *t, size_t count, sepax_facet *to) {
  const int *from = p->from[which];
  const int *way = p->way[which];
  for (size_t n = 0; n < 3 * count; n++) {
    point v = minus(plus(t[n / 3].v[n % 3], p->offset), p->away[which]);
    for (int i = 0; i < 3; i++) {
      double x = ldexp((double)(way[i] * v.x[i]), p->exponent);
      to[n / 3].v[n % 3][from[i]] = x == 0 && p->minus_zero ? -0.0 : x == 0 ? 0.0 : x;
    }
  }
}
