/* SPDX-License-Identifier: MIT */
/* solid_examples.c - closed, open and inconsistent bodies of a few triangles, whose answers are
 * known. */
#include "solid_small.h"

#include <math.h>

CASE(one_of_two_inside_out) {
  for (int which = 0; which < 4; which++) {
    sepax_soup m = {0};
    add_block(&m, corner[0], corner[1], (which & 1) != 0);
    add_block(&m, corner[2], corner[3], (which & 2) != 0);
    assert_small(&m, 1.5, 0.5, 1, true, true, /* in both */
                 which % 3 == 0 ? SEPAX_INSIDE : SEPAX_INSIDE_UNKNOWN);
    assert_small(&m, 0.5, 1.5, 1, true, true, SEPAX_INSIDE);  /* in one */
    assert_small(&m, 2.5, 1.5, 1, true, true, SEPAX_OUTSIDE); /* beside */
    sepax_soup_free(&m);
  }
}

CASE(two_triangles_turned) {
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  for (int n = 0; n < 12; n++) {
    int k = random_below(12);
    turn_round(&m.facet[n]);
    turn_round(&m.facet[k]);
    assert_small(&m, 0.5, 0.75, -1, true, n == k, SEPAX_OUTSIDE);
    assert_small(&m, 0.5, 0.75, 3, true, n == k, SEPAX_OUTSIDE);
    assert_small(&m, 0.5, 0.75, 0.5, true, n == k, SEPAX_INSIDE);
    turn_round(&m.facet[n]);
    turn_round(&m.facet[k]);
  }
  sepax_soup_free(&m);
}

/* A box of which one side of an edge is divided: closed, of one part, consistent; with a triangle
 * turned round at the vertex: not. */
CASE(vertex_on_an_edge_of_a_box) {
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  double middle[3];
  double last[3];
  sepax_facet *f = &m.facet[4];
  memcpy(last, f->v[1], sizeof last);
  for (int i = 0; i < 3; i++) {
    middle[i] = f->v[0][i] / 2 + f->v[1][i] / 2;
  }
  memcpy(f->v[1], middle, sizeof middle);
  double third[3];
  memcpy(third, f->v[2], sizeof third);
  add_triangle(&m, middle, last, third);
  assert_small(&m, 0.5, 0.75, 0.5, true, true, SEPAX_INSIDE);
  assert_small(&m, 0.5, 0.75, 3, true, true, SEPAX_OUTSIDE);
  turn_round(&m.facet[4]);
  assert_small(&m, 0.5, 0.75, 0.5, true, false, SEPAX_INSIDE);
  turn_round(&m.facet[4]);
  m.facet[4].v[1][0] = nextafter(m.facet[4].v[1][0], -9);
  assert_small(&m, 0.5, 0.75, 0.5, false, true, SEPAX_INSIDE_UNKNOWN);
  sepax_soup_free(&m);
}

CASE(cavity) {
  const double in[2][3] = {{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}};
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, in[0], in[1], false); /* a solid in a solid */
  assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE);
  m.count -= 12;
  add_block(&m, in[0], in[1], true);
  assert_small(&m, 1, 1, 1, true, true, SEPAX_OUTSIDE);
  assert_small(&m, 0.25, 0.25, 0.25, true, true, SEPAX_INSIDE);
  turn_round(&m.facet[13]); /* a cavity or a solid */
  assert_small(&m, 1, 1, 1, true, false, SEPAX_INSIDE_UNKNOWN);
  turn_round(&m.facet[13]);
  for (size_t n = 0; n < m.count; n++) { /* a solid in one that is inside out, or a cavity */
    turn_round(&m.facet[n]);
  }
  assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE_UNKNOWN);
  assert_small(&m, 0.25, 0.25, 0.25, true, true, SEPAX_INSIDE);
  for (size_t n = 0; n < m.count; n++) {
    turn_round(&m.facet[n]);
  }
  m.count--; /* what is open has no inside, but the wall around its box has one */
  assert_small(&m, 1, 1, 1, false, true, SEPAX_INSIDE_UNKNOWN);
  assert_small(&m, 0.25, 0.25, 0.25, false, true, SEPAX_INSIDE);
  assert_small(&m, 0.25, 0.25, 5, false, true, SEPAX_OUTSIDE);
  sepax_soup_free(&m);
}

/* Two blocks that overlap, a cavity in the first. */
CASE(cavity_in_a_piece) {
  const double first[2][3] = {{0, 0, 0}, {4, 4, 4}};
  const double second[2][3] = {{3, 1, 1}, {6, 5, 3}};
  const double hole[2][3] = {{1, 1, 1}, {2, 2, 2}};
  sepax_soup m = {0};
  add_block(&m, first[0], first[1], false);
  add_block(&m, hole[0], hole[1], true);
  add_block(&m, second[0], second[1], false);
  assert_small(&m, 1.5, 1.5, 1.5, true, true, SEPAX_OUTSIDE);
  assert_small(&m, 3.5, 2, 2, true, true, SEPAX_INSIDE);
  assert_small(&m, 5, 4.5, 2, true, true, SEPAX_INSIDE);
  assert_small(&m, 2.5, 2.5, 2.5, true, true, SEPAX_INSIDE);
  sepax_soup_free(&m);
}

/* A part that touches another, in one point, is one piece with it: no cavity, for certain. */
CASE(touching_parts) {
  const double c[3] = {0.75, 1.25, 1.5};
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  add_octahedron(&m, c, 0.5);
  assert_small(&m, 0.75, 1.25, 1.5, true, true, SEPAX_INSIDE);
  for (size_t n = 12; n < m.count; n++) {
    turn_round(&m.facet[n]);
  }
  assert_small(&m, 0.75, 1.25, 1.5, true, true, SEPAX_INSIDE_UNKNOWN);
  sepax_soup_free(&m);
  const double lower[3] = {0.75, 1.25, 1.25};
  add_block(&m, corner[0], corner[1], false);
  add_octahedron(&m, lower, 0.5);
  for (size_t n = 12; n < m.count; n++) {
    turn_round(&m.facet[n]);
  }
  assert_small(&m, 0.75, 1.25, 1.25, true, true, SEPAX_OUTSIDE);
  sepax_soup_free(&m);
}

/* Two triangles that run along their common edge the same way, whichever. */
CASE(inconsistent_and_open) {
  const double p[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  for (int way = 0; way < 2; way++) {
    sepax_soup m = {0};
    add_triangle(&m, p[way], p[!way], p[2]);
    add_triangle(&m, p[way], p[!way], p[3]);
    assert_small(&m, 5, 5, 5, false, false, SEPAX_OUTSIDE);
    turn_round(&m.facet[1]);
    assert_small(&m, 5, 5, 5, false, true, SEPAX_OUTSIDE);
    sepax_soup_free(&m);
  }
}

/* An open tool in a closed stock is inside; the stock is not in the tool's box. */
CASE(open_tool) {
  sepax_soup tool = {0};
  sepax_soup stock = {0};
  sepax_body *body[2];
  sepax_shell shell[2];
  sepax_inside within[2];
  const double c[3] = {1, 1, 1};
  add_octahedron(&tool, c, 0.25);
  tool.count--;
  add_block(&stock, corner[0], corner[1], false);
  assert_works(sepax_body_new(&body[0], SEPAX_SOUP_MESH(&tool), NULL, &fault));
  assert_works(sepax_body_new(&body[1], SEPAX_SOUP_MESH(&stock), NULL, &fault));
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_shell_find(&shell[k], body[k], &fault));
  }
  assert_false(shell[0].closed);
  assert_works(sepax_bodies_within(&shell[0], NULL, &shell[1], NULL, within, &fault));
  assert_int_equal(within[0], SEPAX_INSIDE);
  assert_int_equal(within[1], SEPAX_OUTSIDE);
  assert_works(sepax_bodies_within(&shell[1], NULL, &shell[0], NULL, within, &fault));
  assert_int_equal(within[0], SEPAX_OUTSIDE);
  assert_int_equal(within[1], SEPAX_INSIDE);
  for (int k = 0; k < 2; k++) {
    sepax_shell_free(&shell[k]);
    sepax_body_free(body[k]);
  }
  sepax_soup_free(&tool);
  sepax_soup_free(&stock);
}

/* A cone of many triangles round one vertex, its rim with zeros of both signs. */
CASE(many_at_a_vertex) {
  sepax_soup m = {0};
  const double top[3] = {0, 0, 1};
  const double bottom[3] = {-0.0, 0, -1};
  for (int n = 0; n < 100; n++) {
    double zero = n % 2 == 0 ? 0.0 : -0.0;
    const double p[3] = {cos(PI * n / 50), sin(PI * n / 50), zero};
    const double q[3] = {cos(PI * ((n + 1) % 100) / 50), sin(PI * ((n + 1) % 100) / 50), zero};
    add_triangle(&m, top, p, q);
    add_triangle(&m, bottom, q, p);
  }
  assert_small(&m, 0.25, 0, 0, true, true, SEPAX_INSIDE);
  assert_small(&m, 0.75, 0, 0.75, true, true, SEPAX_OUTSIDE);
  m.facet[17].v[1][2] = 1e-300;
  assert_small(&m, 0.75, 0, 0.75, false, true, SEPAX_INSIDE_UNKNOWN);
  sepax_soup_free(&m);
}

/* Triangles that are one point, each a part of its own, are one piece, and soon. */
CASE(many_points) {
  sepax_soup m = {.facet = calloc(400000, sizeof *m.facet), .count = 400000};
  assert_non_null(m.facet);
  assert_soon(&m, 400000);
}
