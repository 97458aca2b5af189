/* SPDX-License-Identifier: MIT */
/* draft.h - drafts of pairs, and the random draws that the families share (private; families.c).
 *
 * Each draw is a statement of its own, so that the stream of random numbers does not depend on the
 * order of evaluation that a compiler chooses. */
#ifndef SEPAX_DRAFT_H
#define SEPAX_DRAFT_H

#include "points.h"
#include "sepax_vectors.h"

#include <assert.h>

/* ------------------------------------------------------------------- drawing */

typedef struct {
  sepax_random *random;
  int word;      /* W */
  int bits;      /* bits of this pair, 4 ... W; many pairs are small in a large range */
  int64_t half;  /* 2^(bits - 1) - 1 */
  bool fixed;    /* the position belongs to the family, so the pair is not translated */
  bool oriented; /* either both normals change their sign or none does */
  triangle t[2]; /* A, B */
} draft;

static inline point *vertex(draft *d, int i) { return &d->t[i / 3].v[i % 3]; }

static inline int64_t range(draft *d, int64_t lo, int64_t hi) {
  return sepax_random_range(d->random, lo, hi);
}

static inline bool one_in(draft *d, int64_t n) { return range(d, 1, n) == 1; }

static inline int64_t sign(draft *d) { return one_in(d, 2) ? 1 : -1; }

static inline void set_bits(draft *d, int bits) {
  d->bits = bits;
  d->half = (INT64_C(1) << (bits - 1)) - 1;
}

/* A power of two, 1 ... 2^(bits - 3), at most `most`: how many steps a lattice has. */
static inline int64_t draw_steps(draft *d, int64_t most) {
  int64_t steps = INT64_C(1) << range(d, 0, d->bits - 3);
  return steps < most ? steps : most;
}

static inline point around(draft *d, int64_t reach) {
  point p;
  for (int i = 0; i < 3; i++) {
    p.c[i] = range(d, -reach, reach);
  }
  return p;
}

static inline point direction(draft *d, int64_t reach) {
  point p = around(d, reach);
  bool zero = p.c[0] == 0 && p.c[1] == 0 && p.c[2] == 0;
  return zero ? unit(0) : p;
}

/* A vector that is not parallel to u, which is not zero. */
static inline point independent(draft *d, point u, int64_t reach) {
  point p = around(d, reach);
  for (int axis = 0; axis < 2 && parallel(u, p); axis++) {
    p = unit(axis);
  }
  return p;
}

static inline basis draw_basis(draft *d, int64_t reach) {
  basis b;
  b.u = direction(d, reach);
  b.v = independent(d, b.u, reach);
  return b;
}

static inline point lsb(draft *d) {
  point p = unit(range(d, 0, 2));
  return times(p, sign(d));
}

/* The origin, or in three of four cases a point 1 LSB off. */
static inline point nearly(draft *d) { return one_in(d, 4) ? (point){{0, 0, 0}} : lsb(d); }

/* +-1 LSB along an axis that is not parallel to the plane of normal n (not zero). */
static inline point off_plane(draft *d, wide_vec n) {
  int64_t axis = range(d, 0, 2);
  while (n.c[axis] == 0) {
    axis = (axis + 1) % 3;
  }
  point p = unit(axis);
  return times(p, sign(d));
}

/* ------------------------------------------------- triangles round the origin */

static inline void draw_edge(draft *d, triangle *t, point u, int64_t steps) {
  int64_t ahead = range(d, 1, steps);
  int64_t behind = range(d, 1, steps);
  t->v[0] = times(u, ahead);
  t->v[1] = times(u, -behind);
}

/* Draw a triangle with the origin inside. Its coordinates are at most 2 * steps times those of u
 * and v. */
static inline void draw_face(draft *d, triangle *t, const basis *b, int64_t steps) {
  int64_t k = range(d, 1, steps);
  int64_t l = range(d, 1, steps);
  int64_t i = range(d, 1, steps);
  int64_t j = range(d, 1, steps);
  t->v[0] = times(b->u, k);
  t->v[1] = times(b->v, l);
  t->v[2] = combine(b, -i, -j);
}

static inline void draw_segment(draft *d, triangle *t, point u, int64_t steps) {
  draw_edge(d, t, u, steps);
  int64_t at = range(d, -steps, steps);
  t->v[2] = times(u, at);
  if (one_in(d, 3)) {
    t->v[2] = t->v[0];
  }
}

/* Draw a triangle with the origin inside or on an edge. Its coordinates are at most `reach`. */
static inline void draw_open(draft *d, triangle *t, int64_t reach, int64_t most) {
  int64_t steps = draw_steps(d, most);
  basis b = draw_basis(d, reach / (2 * steps));
  if (one_in(d, 2)) {
    draw_face(d, t, &b, steps);
    return;
  }
  draw_edge(d, t, b.u, steps);
  t->v[2] = independent(d, b.u, reach);
}

/* Draw vertices 1 and 2 so that the triangle with the origin has an area. */
static inline void draw_wing(draft *d, triangle *t) {
  t->v[1] = direction(d, d->half);
  t->v[2] = independent(d, t->v[1], d->half);
}

static inline void wing_to_side(triangle *t, wide_vec n, int side) {
  t->v[1] = on_side(t->v[1], n, side);
  t->v[2] = on_side(t->v[2], n, side);
}

/* ------------------------------------------------------------ lattice planes */

/* Draw a lattice. Coordinates stay within +-half, even one lattice step outside. */
static inline lattice draw_lattice(draft *d) {
  lattice l;
  if (one_in(d, 4)) {
    l.b = (basis){unit(0), unit(1)};
    l.steps = d->half - 1;
    return l;
  }
  l.steps = draw_steps(d, INT64_MAX);
  assert(l.steps > 0);
  l.b = draw_basis(d, d->half / 2 / (l.steps + 1));
  return l;
}

static inline flat flat_around(draft *d, const lattice *l) {
  flat f;
  f.i = range(d, -l->steps, l->steps);
  f.j = range(d, -l->steps, l->steps);
  return f;
}

static inline flat flat_direction(draft *d, const lattice *l) {
  flat f = flat_around(d, l);
  return f.i == 0 && f.j == 0 ? (flat){1, 0} : f;
}

/* Draw a vector that is not parallel to g (not zero) and lies on the given side of it. */
static inline flat flat_on_side(draft *d, const lattice *l, flat g, int side) {
  flat f = flat_around(d, l);
  if (flat_area(g, f) == 0) {
    f = g.i != 0 ? (flat){0, 1} : (flat){1, 0};
  }
  return flat_area(g, f) * side < 0 ? (flat){-f.i, -f.j} : f;
}

static inline void draw_flat(draft *d, triangle *t, const lattice *l) {
  flat f[3];
  for (int k = 0; k < 3; k++) {
    f[k] = flat_around(d, l);
  }
  flat u = {f[1].i - f[0].i, f[1].j - f[0].j};
  flat v = {f[2].i - f[0].i, f[2].j - f[0].j};
  if (flat_area(u, v) == 0) {
    f[0] = (flat){0, 0};
    f[1] = (flat){1, 0};
    f[2] = (flat){0, 1};
  }
  for (int k = 0; k < 3; k++) {
    t->v[k] = lifted(l, f[k]);
  }
}

/* Draw a pair in one plane: an edge or a vertex of A meets vertex 0 of B from outside, or misses it
 * by a lattice step. */
static inline void draw_flat_contact(draft *d, const lattice *l) {
  flat g = flat_direction(d, l);
  flat a = flat_on_side(d, l, g, 1);
  flat b = flat_on_side(d, l, g, -1);
  flat c = flat_on_side(d, l, b, one_in(d, 2) ? 1 : -1);
  c = flat_area(g, c) > 0 ? (flat){-c.i, -c.j} : c;
  d->t[0].v[0] = lifted(l, g);
  d->t[0].v[1] = times(d->t[0].v[0], -range(d, 0, 1));
  d->t[0].v[2] = lifted(l, a);
  d->t[1].v[0] = (point){{0, 0, 0}};
  d->t[1].v[1] = lifted(l, b);
  d->t[1].v[2] = lifted(l, c);
  point step = one_in(d, 2) ? l->b.u : l->b.v;
  move(&d->t[1], times(step, range(d, -1, 1)));
}

static inline lattice draw_coplanar(draft *d) {
  lattice l = draw_lattice(d);
  if (one_in(d, 3)) {
    draw_flat(d, &d->t[0], &l);
    draw_flat(d, &d->t[1], &l);
  } else {
    draw_flat_contact(d, &l);
  }
  return l;
}

#endif
