/* SPDX-License-Identifier: MIT */
/* solid_copies.c - bodies with both sides of each face, with walls and cavities that are there
 * several times, and what else is at them; the answers are known. */
#include "solid_small.h"

#include <math.h>

/* The same of a closed mesh whose triangles wind in any way. */
static void assert_winds(sepax_soup *stock, double x, double y, double z, sepax_inside expected) {
  sepax_body *body = NULL;
  sepax_shell shell;
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(stock), NULL, &fault));
  assert_works(sepax_shell_find(&shell, body, &fault));
  const bool consistent = shell.consistent;
  sepax_shell_free(&shell);
  sepax_body_free(body);
  assert_small(stock, x, y, z, true, consistent, expected);
}

/* The triangles from `first` on once more, turned round or not. */
static void add_again(sepax_soup *m, size_t first, bool turned) {
  for (size_t end = m->count; first < end; first++) {
    sepax_facet f = m->facet[first];
    if (turned) {
      turn_round(&f);
    }
    add_triangle(m, f.v[0], f.v[1], f.v[2]);
  }
}

/* A block whose triangles are there several times, wound either way, as if both sides of each face
 * were exported: material, even if equal triangles cancel each other. */
CASE(equal_triangles) {
  for (int times = 1; times <= 4; times++) {
    for (int ways = 0; ways < 1 << times; ways++) {
      sepax_soup m = {0};
      add_block(&m, corner[0], corner[1], false);
      for (int n = 1; n < times; n++) {
        add_again(&m, m.count - 12, (ways >> n & 1) != 0);
      }
      assert_small(&m, 0.5, 1.5, 1, true, true, SEPAX_INSIDE);
      assert_small(&m, 2.5, 1.5, 1, true, true, SEPAX_OUTSIDE);
      sepax_soup_free(&m);
    }
  }
}

/* Each vertex somewhere else, so that squares are bent; equal ones to the same place. */
static void bend(sepax_soup *m) {
  for (size_t n = 0; n < 3 * m->count; n++) {
    double *v = m->facet[n / 3].v[n % 3];
    const double from[3] = {v[0], v[1], v[2]};
    for (int i = 0; i < 3; i++) {
      v[i] += 0.125 * sin(5 * from[i] + 7 * from[(i + 1) % 3] + 3 * from[(i + 2) % 3] + 1);
    }
  }
}

/* A box with both sides of each face, each side divided in its own way: material. With its vertices
 * anywhere; one of two such boxes within the other is a cavity. */
CASE(equal_sheets) {
  for (int n = 0; n < 60; n++) {
    const double c[3] = {1, 1, 1};
    const int cells = 1 + n % 3 % 2;
    sepax_soup m = {0};
    add_box(&m, c, 2, cells);
    add_box(&m, c, 2, cells);
    for (size_t k = m.count / 2; k < m.count; k++) {
      turn_round(&m.facet[k]);
    }
    if (n % 2 != 0) {
      bend(&m);
    }
    assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, 2.5, 0.5, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, 3.5, 0.5, true, true, SEPAX_OUTSIDE);
    const size_t outer = m.count;
    add_box(&m, c, 1, cells);
    add_box(&m, c, 1, cells);
    for (size_t k = outer; k < (outer + m.count) / 2; k++) {
      turn_round(&m.facet[k]);
    }
    assert_small(&m, 1, 1, 1, true, true, SEPAX_OUTSIDE);
    assert_small(&m, 1, 2.5, 0.5, true, true, SEPAX_INSIDE);
    sepax_soup_free(&m);
  }
}

/* Both sides of each face, and vertices in the middle of edges. */
CASE(equal_triangles_torn) {
  for (int n = 0; n < 60; n++) {
    sepax_soup m = {0};
    const double c[3] = {1, 1, 1};
    add_box(&m, c, 2, 1 + n % 2);
    for (int times = n % 7; times > 0; times--) {
      tear_edge(&m);
    }
    add_again(&m, 0, true);
    assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, 2.5, 0.5, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, 3.5, 0.5, true, true, SEPAX_OUTSIDE);
    sepax_soup_free(&m);
  }
}

/* A cavity that another solid fills is material. A cavity with both sides of each face is none. */
CASE(equal_triangles_inside) {
  const double hole[2][3] = {{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}};
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, hole[0], hole[1], true);
  add_again(&m, 12, true);
  assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE);
  assert_small(&m, 0.25, 0.25, 0.25, true, true, SEPAX_INSIDE);
  m.count = 24;
  add_again(&m, 0, true);
  assert_small(&m, 1, 1, 1, true, true, SEPAX_OUTSIDE);
  assert_small(&m, 0.25, 0.25, 0.25, true, true, SEPAX_INSIDE);
  sepax_soup_free(&m);
}

/* A tetrahedron as a cavity of another one with which it shares an edge. Its faces are there once
 * or three times. They are no copy of the outer ones, though both have the edge alone in common;
 * and half of three triangles is no reading. Otherwise the cavity would be material. */
CASE(cavity_at_an_edge) {
  static const double p[6][3] = {{0, 0, 0}, {8, 0, 0}, {0, 8, 0}, {0, 0, 8}, {1, 2, 1}, {1, 1, 2}};
  static const int face[8][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2},
                                 {0, 4, 1}, {0, 1, 5}, {1, 4, 5}, {0, 5, 4}};
  sepax_soup m = {0};
  for (int n = 0; n < 8; n++) {
    add_triangle(&m, p[face[n][0]], p[face[n][1]], p[face[n][2]]);
  }
  for (size_t n = 4; n < 8; n++) {
    turn_round(&m.facet[n]);
  }
  assert_small(&m, 2.5, 0.75, 0.75, true, true, SEPAX_OUTSIDE);
  assert_small(&m, 2, 3, 0.5, true, true, SEPAX_INSIDE);
  for (size_t n = 4; n < 8; n++) {
    turn_round(&m.facet[n]);
  }
  for (size_t n = 4; n < 12; n++) { /* of the inner faces one as the outer ones, two turned */
    double v[3][3];
    memcpy(v, m.facet[4 + n % 4].v, sizeof v);
    add_triangle(&m, v[0], v[2], v[1]);
  }
  assert_small(&m, 2.5, 0.75, 0.75, true, true, SEPAX_OUTSIDE);
  assert_small(&m, 2, 3, 0.5, true, true, SEPAX_INSIDE);
  sepax_soup_free(&m);
}

/* Two blocks with a common side, as solids of their own: this side is there twice, and the outside
 * is outside. With both sides of each face, too; but one face alone is no solid. */
CASE(equal_triangles_between) {
  const double half[2][3] = {{0, 0, 0}, {1, 2, 2}};
  sepax_soup m = {0};
  add_block(&m, half[0], half[1], false);
  add_again(&m, 0, true);
  for (size_t n = 12; n < 24; n++) { /* mirrored in x = 1 */
    for (int k = 0; k < 3; k++) {
      m.facet[n].v[k][0] = 2 - m.facet[n].v[k][0];
    }
  }
  for (int sides = 1; sides <= 2; sides++) {
    assert_small(&m, 0.5, 1.5, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, 1.5, 1.5, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, -0.25, 1.5, 1, true, true, SEPAX_OUTSIDE);
    assert_small(&m, 2.25, 0.5, 1, true, true, SEPAX_OUTSIDE);
    add_again(&m, 0, true);
  }
  m.count = 11;
  add_again(&m, 0, true);
  assert_small(&m, 0.5, 1.5, 1, true, true, SEPAX_OUTSIDE);
  sepax_soup_free(&m);
}

/* A sheet of two triangles, and both of its sides. */
static void add_fin(sepax_soup *m, const double p[3], const double q[3], const double r[3]) {
  add_triangle(m, p, q, r);
  add_triangle(m, p, r, q);
}

/* A fin at an edge of a block with both sides of each face: its edge has six triangles, and no
 * choice of one or of half of the equal triangles is closed. */
CASE(fin_of_equal_triangles) {
  static const double fin[3][3] = {{0, 0, 2}, {2, 0, 2}, {1, -2, 3}};
  for (int sides = 1; sides <= 2; sides++) {
    sepax_soup m = {0};
    add_block(&m, corner[0], corner[1], false);
    if (sides == 2) {
      add_again(&m, 0, true);
    }
    add_fin(&m, fin[0], fin[1], fin[2]);
    assert_small(&m, 0.5, 0.75, 0.5, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, -0.5, 1.5, true, true, SEPAX_OUTSIDE);
    assert_small(&m, 1, -0.5, 2.75, true, true, SEPAX_OUTSIDE);
    sepax_soup_free(&m);
  }
}

/* Two blocks side by side, each of which has its faces one to four times. */
CASE(unlike_neighbours) {
  const double half[2][2][3] = {{{0, 0, 0}, {1, 2, 2}}, {{1, 0, 0}, {2, 2, 2}}};
  for (int n = 0; n < 16; n++) {
    sepax_soup m = {0};
    for (int k = 0; k < 2; k++) {
      for (int times = (k == 0 ? n % 4 : n / 4); times >= 0; times--) {
        add_block(&m, half[k][0], half[k][1], times % 2 != 0);
      }
    }
    assert_small(&m, 0.5, 1.5, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, 1.5, 0.5, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, 2.25, 0.5, 1, true, true, SEPAX_OUTSIDE);
    sepax_soup_free(&m);
  }
}

/* Both sides of each face. A vertex in the middle of an edge divides one side alone, and the other
 * side of the other face at this edge: its two halves and the whole edge have two triangles each.
 */
CASE(equal_sheets_torn) {
  for (int n = 0; n < 60; n++) {
    const double c[3] = {1, 1, 1};
    sepax_soup m = {0};
    add_box(&m, c, 2, 1);
    for (int times = 1 + n % 7; times > 0; times--) {
      tear_edge(&m);
    }
    const size_t one = m.count;
    add_box(&m, c, 2, 1);
    for (size_t k = one; k < m.count; k++) {
      turn_round(&m.facet[k]);
    }
    assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, 2.5, 0.5, true, true, SEPAX_INSIDE);
    assert_small(&m, 1, 3.5, 0.5, true, true, SEPAX_OUTSIDE);
    sepax_soup_free(&m);
  }
}

/* What stands in a cavity and touches its wall in a vertex, in an edge, or all over, is material.
 * Beside it is the cavity. */
CASE(filled_cavity) {
  const double wall[2][2][3] = {{{0, 0, 0}, {8, 8, 8}}, {{2, 2, 2}, {6, 6, 6}}};
  const double vertex[3] = {4, 4, 3};
  const double edge[2][3] = {{3, 2, 2}, {5, 4, 4}};
  for (int n = 0; n < 8; n++) {
    sepax_soup m = {0};
    add_block(&m, wall[0][0], wall[0][1], false);
    add_block(&m, wall[1][0], wall[1][1], (n & 1) != 0);
    switch (n / 2) {
    case 0:
      add_octahedron(&m, vertex, 1);
      break;
    case 1:
      add_block(&m, edge[0], edge[1], false);
      break;
    case 2:
      add_block(&m, wall[1][0], wall[1][1], false);
      break;
    default:
      break;
    }
    assert_small(&m, 4, 3.75, 3.25, true, true, n < 6 ? SEPAX_INSIDE : SEPAX_OUTSIDE);
    if (n / 2 != 2) {
      assert_small(&m, 5.5, 5.5, 5.5, true, true, SEPAX_OUTSIDE);
    }
    sepax_soup_free(&m);
  }
}

/* The same with both sides of each face. What fills a corner of the cavity has three faces in
 * common with its wall; each of them may be divided in another way. */
CASE(filled_corner) {
  const double outer[2][3] = {{0, 0, 0}, {8, 8, 8}};
  const double wall[2][3] = {{2, 2, 2}, {6, 6, 6}};
  const double middle[3] = {4, 4, 4};
  for (int n = 0; n < 60; n++) {
    sepax_soup m = {0};
    add_cells(&m, outer[0], outer[1], 1);
    add_cells(&m, wall[0], wall[1], 2);
    if (n % 2 != 0) {
      add_cells(&m, wall[0], middle, 1);
    }
    add_again(&m, 0, true);
    assert_small(&m, 3, 3.25, 3.5, true, true, n % 2 != 0 ? SEPAX_INSIDE : SEPAX_OUTSIDE);
    assert_small(&m, 1, 3.25, 3.5, true, true, SEPAX_INSIDE);
    sepax_soup_free(&m);
  }
}

/* Many sheets of one boundary take no more time each than a few. */
CASE(many_sheets) {
  static const double rim[4][3] = {{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}};
  sepax_soup m = {0};
  for (int n = 0; n < 20000; n++) {
    const int cone = n / 4 + 1;
    const double top[3] = {0, 0, cone / 4096.0};
    add_triangle(&m, rim[n % 4], rim[(n + 1) % 4], top);
  }
  assert_soon(&m, 1);
}

/* A house of two halves, which are solids of their own: where they meet, the wall is there twice.
 * The room within is no material. */
CASE(house_of_two_halves) {
  static const double v[2][4][2] = {{{0, 0}, {8, 0}, {8, 8}, {0, 8}},
                                    {{2, 2}, {6, 2}, {6, 6}, {2, 6}}};
  for (int sides = 1; sides <= 2; sides++) {
    sepax_soup m = {0};
    for (int half = 0; half < 2; half++) {
      const double z[2][2] = {{4, half == 0 ? 0 : 8}, {4, half == 0 ? 2 : 6}};
      for (int k = 0; k < 4; k++) {
        double rim[4][3];
        for (int shell = 0; shell < 2; shell++) {
          const double *p = v[shell][k];
          const double *q = v[shell][(k + 1) % 4];
          double side[4][3] = {{p[0], p[1], z[shell][0]},
                               {q[0], q[1], z[shell][0]},
                               {q[0], q[1], z[shell][1]},
                               {p[0], p[1], z[shell][1]}};
          add_quad(&m, side);
          memcpy(rim[3 * shell], side[0], sizeof rim[0]);
          memcpy(rim[1 + shell], side[1], sizeof rim[0]);
        }
        add_triangle(&m, rim[0], rim[1], rim[2]);
        add_triangle(&m, rim[0], rim[2], rim[3]);
      }
      for (int shell = 0; shell < 2; shell++) {
        double end[4][3];
        for (int k = 0; k < 4; k++) {
          memcpy(end[k], (double[3]){v[shell][k][0], v[shell][k][1], z[shell][1]}, sizeof end[k]);
        }
        add_quad(&m, end);
      }
    }
    if (sides == 2) {
      add_again(&m, 0, true);
    }
    assert_winds(&m, 1, 4.5, 4.5, SEPAX_INSIDE);
    assert_winds(&m, 4, 4.5, 7, SEPAX_INSIDE);
    assert_winds(&m, 4, 4.5, 8.5, SEPAX_OUTSIDE);
    assert_winds(&m, 4, 4.5, 4.5, sides == 1 ? SEPAX_OUTSIDE : SEPAX_INSIDE);
    sepax_soup_free(&m);
  }
}
