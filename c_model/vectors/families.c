/* SPDX-License-Identifier: MIT */
/* families.c - the families of hard pairs.
 *
 * A maker writes a draft: six points round the origin, all coordinates within +-half, of which one
 * group may then move by 1 LSB in one direction. So the draft is at most 2 half + 1 long and always
 * fits the W-bit range. Sizes are derived from `half`; a choice that would spoil the family
 * (parallel edges, say) is replaced by a unit vector that does not. Hence no maker retries or
 * fails. The contact that a family is about is at the origin. */
#include "draft.h"

/* -------------------------------------------------------------------- makers */

static void make_uniform(draft *d) {
  d->fixed = true;
  for (int i = 0; i < 6; i++) {
    for (int k = 0; k < 3; k++) {
      vertex(d, i)->c[k] = range(d, sepax_word_min(d->word), sepax_word_max(d->word));
    }
  }
}

/* Both triangles have their centres at the origin. Then B is moved. */
static void make_local(draft *d) {
  set_bits(d, d->word);
  int64_t reach = d->half >> range(d, 2, d->word > 6 ? 5 : 2);
  for (int i = 0; i < 2; i++) {
    triangle *t = &d->t[i];
    t->v[0] = around(d, reach);
    t->v[1] = around(d, reach);
    t->v[2] = times(sum(t->v[0], t->v[1]), -1);
  }
  move(&d->t[1], around(d, (reach + 1) / 2));
}

static void make_touch_face(draft *d) {
  int64_t steps = draw_steps(d, INT64_MAX);
  basis b = draw_basis(d, d->half / (2 * steps));
  draw_face(d, &d->t[0], &b, steps);
  draw_wing(d, &d->t[1]);
  if (!one_in(d, 6)) {
    wing_to_side(&d->t[1], cross(b.u, b.v), 1);
  }
  d->t[1].v[0] = nearly(d);
}

static void make_touch_edge(draft *d) {
  int64_t steps = draw_steps(d, INT64_MAX);
  basis b = draw_basis(d, d->half / steps);
  wide_vec n = cross(b.u, b.v);
  draw_edge(d, &d->t[0], b.u, steps);
  d->t[0].v[2] = on_side(independent(d, b.u, d->half), n, -1);
  draw_wing(d, &d->t[1]);
  if (!one_in(d, 4)) {
    wing_to_side(&d->t[1], n, 1);
  }
  d->t[1].v[0] = nearly(d);
}

static void make_touch_edges(draft *d) {
  int64_t steps = draw_steps(d, INT64_MAX);
  basis b = draw_basis(d, d->half / steps);
  wide_vec n = cross(b.u, b.v);
  draw_edge(d, &d->t[0], b.u, steps);
  draw_edge(d, &d->t[1], b.v, steps);
  d->t[0].v[2] = on_side(independent(d, b.u, d->half), n, -1);
  d->t[1].v[2] = independent(d, b.v, d->half);
  if (!one_in(d, 4)) {
    d->t[1].v[2] = on_side(d->t[1].v[2], n, 1);
  }
  d->t[1].v[0] = sum(d->t[1].v[0], nearly(d));
}

static void make_coplanar(draft *d) { draw_coplanar(d); }

static void make_almost_coplanar(draft *d) {
  lattice l = draw_coplanar(d);
  point by = off_plane(d, cross(l.b.u, l.b.v));
  point *moved = &d->t[1].v[range(d, 0, 2)];
  *moved = sum(*moved, by);
}

static void make_parallel(draft *d) {
  lattice l = draw_lattice(d);
  wide_vec n = cross(l.b.u, l.b.v);
  draw_flat(d, &d->t[0], &l);
  draw_flat(d, &d->t[1], &l);
  if (one_in(d, 2)) {
    point gap = around(d, 3);
    move(&d->t[1], dot(n, gap) == 0 ? off_plane(d, n) : gap);
  }
}

/* A triangle of nearly no area: a long edge through the origin, and a point of this edge, rounded
 * and moved by 1 LSB. */
static void draw_sliver(draft *d, triangle *t) {
  int64_t steps = draw_steps(d, 8);
  int64_t reach = (d->half - 1) / steps;
  point u = around(d, reach);
  u.c[range(d, 0, 2)] = reach;
  draw_edge(d, t, u, steps);
  int64_t share = range(d, 0, 1 << 16);
  t->v[2] = lsb(d);
  for (int i = 0; i < 3; i++) {
    int64_t part = (t->v[1].c[i] - t->v[0].c[i]) * share;
    part += part < 0 ? -(1 << 15) : 1 << 15;
    t->v[2].c[i] += t->v[0].c[i] + part / (1 << 16);
  }
}

static void make_sliver(draft *d) {
  set_bits(d, d->word);
  draw_sliver(d, &d->t[0]);
  if (one_in(d, 2)) {
    draw_sliver(d, &d->t[1]);
  } else {
    draw_open(d, &d->t[1], d->half - 1, 8);
  }
  move(&d->t[1], nearly(d));
}

/* Move B 1 LSB away from the plane of normal n (not zero). B must not be below the plane. */
static void move_off(draft *d, wide_vec n) {
  point by = off_plane(d, n);
  move(&d->t[1], dot(n, by) > 0 ? by : times(by, -1));
}

static void make_shared_vertex(draft *d) {
  basis b = draw_basis(d, d->half);
  wide_vec n = cross(b.u, b.v);
  for (int i = 0; i < 2; i++) {
    d->t[i].v[0] = (point){{0, 0, 0}};
    draw_wing(d, &d->t[i]);
  }
  bool off = one_in(d, 2);
  if (off || !one_in(d, 4)) {
    wing_to_side(&d->t[0], n, -1);
    wing_to_side(&d->t[1], n, 1);
  }
  if (off) {
    move_off(d, n);
  }
}

/* Two triangles with a common edge, in space or in one plane; their other vertices are on one side
 * of the edge or on both. */
static void make_shared_edge(draft *d) {
  int64_t reach = d->half / 2;
  point u = direction(d, reach);
  for (int i = 0; i < 2; i++) {
    d->t[i].v[0] = (point){{0, 0, 0}};
    d->t[i].v[1] = u;
    d->t[i].v[2] = independent(d, u, reach);
  }
  if (one_in(d, 3)) {
    d->t[1].v[2] = times(d->t[0].v[2], sign(d));
    d->t[1].v[2] = sum(d->t[1].v[2], times(u, sign(d)));
  }
  if (one_in(d, 2)) {
    wide_vec n = cross(u, d->t[0].v[2]);
    d->t[1].v[2] = on_side(d->t[1].v[2], n, 1);
    move_off(d, n);
  }
}

/* A is a point or a segment, and B is anything. Both contain the origin. Then A moves. */
static void make_degenerate(draft *d) {
  int64_t steps = draw_steps(d, INT64_MAX);
  int64_t reach = d->half / (2 * steps);
  int64_t kind = range(d, 0, 4);
  basis a = draw_basis(d, reach);
  basis b = one_in(d, 2) ? a : draw_basis(d, reach);
  if (!one_in(d, 4)) {
    draw_segment(d, &d->t[0], a.u, steps);
  }
  draw_segment(d, &d->t[1], b.u, steps);
  if (kind == 0) {
    d->t[1].v[0] = d->t[1].v[1] = d->t[1].v[2];
  } else if (kind > 1) {
    draw_face(d, &d->t[1], &b, steps);
  }
  move(&d->t[0], one_in(d, 2) ? times(a.u, range(d, -steps, steps)) : nearly(d));
}

static void make_identical(draft *d) {
  d->t[0].v[0] = (point){{0, 0, 0}};
  draw_wing(d, &d->t[0]);
  d->t[1] = d->t[0];
  if (one_in(d, 2)) {
    move_off(d, cross(d->t[0].v[1], d->t[0].v[2]));
  }
}

static void make_big_tiny(draft *d) {
  set_bits(d, d->word);
  draw_open(d, &d->t[0], d->half, 8);
  int64_t reach = INT64_C(1) << range(d, 0, d->word > 6 ? d->word - 6 : 0);
  for (int k = 0; k < 3; k++) {
    d->t[1].v[k] = around(d, reach);
  }
  move(&d->t[1], around(d, reach));
}

/* Map t by a symmetry of the cube that does not map its plane to itself; there is one for every
 * plane. */
static void map_out_of_plane(draft *d, triangle *t, wide_vec n, wide level) {
  int64_t number = range(d, 0, 47);
  triangle image;
  do {
    for (int k = 0; k < 3; k++) {
      image.v[k] = symmetric(t->v[k], number);
    }
    number = (number + 1) % 48;
  } while (in_plane(&image, n, level));
  *t = image;
}

/* A symmetry of the cube keeps the distance of a plane from the origin exactly. */
static void make_tangent(draft *d) {
  d->fixed = true;
  d->oriented = true;
  lattice l = draw_lattice(d);
  l.steps = (l.steps + 1) / 2;
  wide_vec n = cross(l.b.u, l.b.v);
  point at = around(d, (d->half - lattice_reach(&l)) >> range(d, 1, 5));
  at = dot(n, at) == 0 ? off_plane(d, n) : at;
  for (int i = 0; i < 2; i++) {
    draw_face(d, &d->t[i], &l.b, l.steps);
    move(&d->t[i], at);
  }
  map_out_of_plane(d, &d->t[1], n, dot(n, at));
  wide a = dot(normal_of(&d->t[0]), d->t[0].v[0]);
  wide b = dot(normal_of(&d->t[1]), d->t[1].v[0]);
  if ((a < 0) != (b < 0)) {
    exchange(&d->t[1].v[1], &d->t[1].v[2]);
  }
}

static void make_corners(draft *d) {
  int64_t min = sepax_word_min(d->word);
  int64_t max = sepax_word_max(d->word);
  const int64_t corner[7] = {min, min + 1, -1, 0, 1, max - 1, max};
  d->fixed = true;
  for (int i = 0; i < 6; i++) {
    for (int k = 0; k < 3; k++) {
      vertex(d, i)->c[k] = corner[range(d, 0, 6)];
    }
  }
}

static void make_grid(draft *d) {
  d->fixed = true;
  for (int i = 0; i < 6; i++) {
    *vertex(d, i) = around(d, 1);
  }
}

/* --------------------------------------------------------------------- table */

typedef struct {
  const char *name, *about;
  void (*make)(draft *d);
} family_entry;

static const family_entry families[] = {
    {"uniform", "every coordinate uniform in the whole range", make_uniform},
    {"local", "small triangles round nearly the same centre", make_local},
    {"touch-face", "vertex of B on the face of A, exactly or 1 LSB off", make_touch_face},
    {"touch-edge", "vertex of B on an edge of A, exactly or 1 LSB off", make_touch_edge},
    {"touch-edges", "two edges cross, exactly or with an end 1 LSB off", make_touch_edges},
    {"coplanar", "both in one plane: overlapping, touching or disjoint", make_coplanar},
    {"almost-coplanar", "coplanar but for one coordinate, 1 LSB off", make_almost_coplanar},
    {"parallel", "in one plane or in parallel ones at a distance of a few LSB", make_parallel},
    {"sliver", "long triangles of nearly no area that meet or just miss", make_sliver},
    {"shared-vertex", "one common vertex, or 1 LSB off", make_shared_vertex},
    {"shared-edge", "two common vertices, folded or flat, or 1 LSB off", make_shared_edge},
    {"degenerate", "a segment or a point near a triangle, segment or point", make_degenerate},
    {"identical", "twice the same triangle, or the same 1 LSB off", make_identical},
    {"big-tiny", "a tiny triangle at the face or an edge of a big one", make_big_tiny},
    {"tangent", "A.N_A = B.N_B without being coplanar", make_tangent},
    {"corners", "coordinates at the ends and the middle of the range", make_corners},
    {"grid", "coordinates -1, 0, 1: every degeneracy", make_grid},
};

enum { FAMILIES = sizeof families / sizeof families[0] };

const char *sepax_family_name(size_t family) {
  return family < FAMILIES ? families[family].name : NULL;
}

const char *sepax_family_about(size_t family) {
  return family < FAMILIES ? families[family].about : NULL;
}

/* --------------------------------------------------------------- the last steps */

static int64_t draw_shift(draft *d, int64_t from, int64_t to) {
  assert(from <= to);
  int64_t choice = range(d, 0, 7);
  return choice == 0 ? from : choice == 1 ? to : range(d, from, to);
}

/* Translate the draft to anywhere in the range, now and then to its very end. */
static void translate_anywhere(draft *d) {
  point shift;
  for (int axis = 0; axis < 3; axis++) {
    int64_t low = d->t[0].v[0].c[axis];
    int64_t high = low;
    for (int i = 1; i < 6; i++) {
      int64_t value = vertex(d, i)->c[axis];
      low = value < low ? value : low;
      high = value > high ? value : high;
    }
    shift.c[axis] = draw_shift(d, sepax_word_min(d->word) - low, sepax_word_max(d->word) - high);
  }
  move(&d->t[0], shift);
  move(&d->t[1], shift);
}

static void shuffle_vertices(draft *d, triangle *t, bool odd) {
  for (int64_t steps = range(d, 0, 2); steps > 0; steps--) {
    exchange(&t->v[0], &t->v[1]);
    exchange(&t->v[1], &t->v[2]);
  }
  if (odd) {
    exchange(&t->v[0], &t->v[1]);
  }
}

static void shuffle(draft *d) {
  bool odd = one_in(d, 2);
  shuffle_vertices(d, &d->t[0], odd);
  odd = d->oriented ? odd : one_in(d, 2);
  shuffle_vertices(d, &d->t[1], odd);
  if (one_in(d, 2)) {
    triangle kept = d->t[0];
    d->t[0] = d->t[1];
    d->t[1] = kept;
  }
}

/* The smallest coordinate has no opposite, so an axis that holds it keeps its sign. */
static void permute_axes(draft *d) {
  int64_t number = range(d, 0, 47);
  for (int i = 0; i < 6; i++) {
    point image = symmetric(*vertex(d, i), number);
    for (int axis = 0; axis < 3; axis++) {
      bool stuck = image.c[axis] > sepax_word_max(d->word);
      number = stuck ? number & ~(INT64_C(1) << axis) : number;
    }
  }
  for (int i = 0; i < 6; i++) {
    *vertex(d, i) = symmetric(*vertex(d, i), number);
  }
}

sepax_pair sepax_family_triangles(size_t family, int word, sepax_random *random) {
  assert(family < FAMILIES);
  draft d = {.random = random, .word = word};
  set_bits(&d, one_in(&d, 2) ? word : (int)range(&d, SEPAX_WORD_MIN, word));
  families[family].make(&d);
  if (!d.fixed) {
    translate_anywhere(&d);
  }
  shuffle(&d);
  permute_axes(&d);
  return (sepax_pair){.a = to_tri(&d.t[0]), .b = to_tri(&d.t[1])};
}

sepax_pair sepax_family_pair(size_t family, int word, sepax_random *random) {
  sepax_pair pair = sepax_family_triangles(family, word, random);
  pair.na = sepax_unit_normal(&pair.a, word);
  pair.nb = sepax_unit_normal(&pair.b, word);
  return pair;
}
