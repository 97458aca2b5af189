/* SPDX-License-Identifier: MIT */
/* solid_sheets.c - bodies of several sheets: both sides of faces, walls that are there several times,
 * edges that lie on each other; the answers are known, or that they are not. */
#include "solid_small.h"

#include <math.h>

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

/* Triangles that are there several times, in all ways: inside if more are wound one way than the
 * other, else unknown. Beside it a ray is free. */
CASE(equal_triangles) {
  for (int times = 1; times <= 4; times++) {
    for (int ways = 0; ways < 1 << times; ways++) {
      sepax_soup m = {0};
      int sum = 1;
      add_block(&m, corner[0], corner[1], false);
      for (int n = 1; n < times; n++) {
        add_again(&m, m.count - 12, (ways >> n & 1) != 0);
      }
      for (int n = 1, way = 1; n < times; n++) {
        way = (ways >> n & 1) != 0 ? -way : way;
        sum += way;
      }
      assert_small(&m, 0.5, 1.5, 1, true, true, sum != 0 ? SEPAX_INSIDE : SEPAX_INSIDE_UNKNOWN);
      assert_small(&m, 2.5, 1.5, 1, true, true, SEPAX_OUTSIDE);
      sepax_soup_free(&m);
    }
  }
}

/* Both sides of each face, each side divided in its own way, vertices on edges, too. */
CASE(both_sides) {
  for (int n = 0; n < 60; n++) {
    const double c[3] = {1, 1, 1};
    sepax_soup m = {0};
    add_box(&m, c, 2, 1 + n % 2);
    for (int times = n % 7; times > 0; times--) {
      tear_edge(&m);
    }
    const size_t one = m.count;
    add_box(&m, c, 2, 1 + n % 3 % 2);
    for (size_t k = one; k < m.count; k++) {
      turn_round(&m.facet[k]);
    }
    assert_small(&m, 1, 1, 1, true, true, SEPAX_INSIDE_UNKNOWN);
    assert_small(&m, 1, 3.5, 0.5, true, true, SEPAX_OUTSIDE);
    sepax_soup_free(&m);
  }
}

/* Two blocks that overlap and have an edge line in common, on which one has a vertex. As solids: in
 * both is inside. One turned: unknown, however the edges pair. */
CASE(edges_on_each_other) {
  static const double block[2][2][3] = {{{0, 0, 0}, {2, 2, 2}}, {{0, 0, 0}, {2, 1, 3}}};
  for (int torn = 0; torn < 4; torn++) {
    for (int turned = 0; turned < 2; turned++) {
      sepax_soup m = {0};
      for (int k = 0; k < 2; k++) {
        const size_t first = m.count;
        add_block(&m, block[k][0], block[k][1], k == 1 && turned != 0);
        if ((torn >> k & 1) != 0) { /* divide one triangle's edge y = z = 0 in the middle */
          for (size_t n = first; n < m.count; n++) {
            sepax_facet *f = &m.facet[n];
            int e = 0;
            while (e < 3 && !(f->v[e][1] == 0 && f->v[e][2] == 0 && f->v[(e + 1) % 3][1] == 0 &&
                              f->v[(e + 1) % 3][2] == 0)) {
              e++;
            }
            if (e < 3) {
              const double middle[3] = {1, 0, 0};
              double last[3];
              double third[3];
              memcpy(last, f->v[(e + 1) % 3], sizeof last);
              memcpy(third, f->v[(e + 2) % 3], sizeof third);
              memcpy(f->v[(e + 1) % 3], middle, sizeof middle);
              add_triangle(&m, middle, last, third);
              break;
            }
          }
        }
      }
      assert_small(&m, 1, 0.5, 1, true, true,
                   turned == 0 ? SEPAX_INSIDE : SEPAX_INSIDE_UNKNOWN); /* in both */
      assert_small(&m, 1, 1.5, 1, true, true, SEPAX_INSIDE);
      assert_small(&m, 1, 0.5, 2.5, true, true, SEPAX_INSIDE);
      assert_small(&m, 1, 1.5, 2.5, true, true, SEPAX_OUTSIDE);
      sepax_soup_free(&m);
    }
  }
}

/* Six plates, each with both of its sides and a part of its own, as the walls of a room. The edges of
 * neighbours are divided differently, so that they have vertices at the corners alone in common. What
 * is in the room is not known; the boxes of the plates do not have it. */
CASE(plates_as_walls) {
  sepax_soup m = {0};
  for (int axis = 0; axis < 3; axis++) {
    const int cuts = axis + 1;
    for (int side = 0; side < 2; side++) {
      double rim[12][3];
      double middle[3];
      for (int n = 0; n < 4 * cuts; n++) {
        static const int round[5][2] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}};
        const int *from = round[n / cuts];
        const int *to = round[n / cuts + 1];
        rim[n][axis] = 6 * side;
        middle[axis] = 6 * side;
        for (int k = 0; k < 2; k++) {
          rim[n][(axis + 1 + k) % 3] = from[k] + (to[k] - from[k]) / cuts * (n % cuts);
          middle[(axis + 1 + k) % 3] = 3;
        }
      }
      for (int n = 0; n < 4 * cuts; n++) {
        add_triangle(&m, middle, rim[n], rim[(n + 1) % (4 * cuts)]);
        add_triangle(&m, middle, rim[(n + 1) % (4 * cuts)], rim[n]);
      }
    }
  }
  assert_small(&m, 2.25, 2.75, 3.5, true, true, SEPAX_INSIDE_UNKNOWN);
  assert_small(&m, 7, 2.75, 3.5, true, true, SEPAX_OUTSIDE);
  sepax_soup_free(&m);
}

/* A fan of 65 and more two-sided tetrahedra round an edge, and a point in many of them. */
CASE(two_sided_wedges) {
  sepax_soup m = {0};
  for (int n = 0; n < 72; n++) {
    const double a = 0.01 * n;
    const double b = a + 2;
    const double p[4][3] = {
        {0, 0, -9}, {0, 0, 9}, {9 * cos(a), 9 * sin(a), 0}, {9 * cos(b), 9 * sin(b), 0}};
    for (int k = 0; k < 4; k++) {
      add_triangle(&m, p[k], p[(k + 1) % 4], p[(k + 2) % 4]);
      add_triangle(&m, p[(k + 2) % 4], p[(k + 1) % 4], p[k]);
    }
  }
  assert_small(&m, 1, 2, 0.01, true, true, SEPAX_INSIDE_UNKNOWN);
  sepax_soup_free(&m);
}

/* A tetrahedron as a cavity of another one with which it shares an edge. As
 * the two touch, it is no cavity for certain. */
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
  assert_small(&m, 2.5, 0.75, 0.75, true, true, SEPAX_INSIDE_UNKNOWN);
  assert_small(&m, 2, 3, 0.5, true, true, SEPAX_INSIDE);
  sepax_soup_free(&m);
}

/* Two blocks with a common side, as solids of their own: this side is there twice, and the outside
 * is outside. */
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
  assert_small(&m, 0.5, 1.5, 1, true, true, SEPAX_INSIDE);
  assert_small(&m, 1.5, 1.5, 1, true, true, SEPAX_INSIDE);
  assert_small(&m, -0.25, 1.5, 1, true, true, SEPAX_OUTSIDE);
  assert_small(&m, 2.25, 0.5, 1, true, true, SEPAX_OUTSIDE);
  sepax_soup_free(&m);
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
