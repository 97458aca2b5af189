/* SPDX-License-Identifier: MIT */
/* solid_sheets.c - bodies of several sheets: both sides of faces, walls that are there several
 * times, edges that lie on each other; the answers are known, or that they are not. */
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

/* Add a plate of a room of 6 x 6 x 6: what is in the room's wall across an axis. */
static void add_plate(sepax_soup *m, int axis, int side, bool both_sides) {
  static const int round[5][2] = {{0, 0}, {6, 0}, {6, 6}, {0, 6}, {0, 0}};
  const int cuts = axis + 1;
  double rim[12][3];
  double middle[3];
  for (int n = 0; n < 4 * cuts; n++) {
    const int *from = round[n / cuts];
    const int *to = round[n / cuts + 1];
    rim[n][axis] = 6 * side;
    middle[axis] = 6 * side;
    for (int k = 0; k < 2; k++) {
      rim[n][(axis + 1 + k) % 3] = from[k] + 1.0 * (to[k] - from[k]) * (n % cuts) / cuts;
      middle[(axis + 1 + k) % 3] = 3;
    }
  }
  for (int n = 0; n < 4 * cuts; n++) {
    add_triangle(m, middle, rim[n], rim[(n + 1) % (4 * cuts)]);
    if (both_sides) {
      add_triangle(m, middle, rim[(n + 1) % (4 * cuts)], rim[n]);
    }
  }
}

/* Six plates, each with both of its sides and a part of its own, as the walls of a room. The edges
 * of neighbours are divided differently, so that they have vertices at the corners alone in common.
 * What is in the room is not known; the boxes of the plates do not have it. With one side alone, a
 * plate is open, and may close the others even though the room is not in the box of open parts. */
CASE(plates_as_walls) {
  for (int single = -1; single < 6; single++) {
    for (int n = 0; n < 6; n++) {
      double at[3] = {2.25, 2.75, 3.5};
      sepax_soup m = {0};
      for (int k = 0; k < 6; k++) {
        add_plate(&m, k / 2, k % 2, k != single);
      }
      at[n / 2] = n % 2 == 0 ? 0.25 : 5.75; /* the ray runs to this plate first */
      assert_small(&m, at[0], at[1], at[2], single < 0, true, SEPAX_INSIDE_UNKNOWN);
      assert_small(&m, 7, 2.75, 3.5, single < 0, true, SEPAX_OUTSIDE);
      sepax_soup_free(&m);
    }
  }
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

/* ----------------------------------------------------------------------- reasons */

/* Why is it so, or not known, whether a small octahedron is inside? Frees the mesh. */
static void assert_why(sepax_soup *stock, double x, double y, double z, sepax_inside expected,
                       sepax_within_reason reason) {
  const double c[3] = {x, y, z};
  sepax_soup m[2] = {{0}, *stock};
  sepax_body *body[2];
  sepax_shell shell[2];
  sepax_inside within[2];
  sepax_within_reason why[2];
  add_octahedron(&m[0], c, 0.0625);
  for (int k = 0; k < 2; k++) {
    assert_works(sepax_body_new(&body[k], SEPAX_SOUP_MESH(&m[k]), NULL, &fault));
    assert_works(sepax_shell_find(&shell[k], body[k], &fault));
  }
  assert_works(sepax_bodies_within_why(&shell[0], NULL, &shell[1], NULL, within, why, &fault));
  assert_int_equal(within[0], expected);
  assert_int_equal(why[0], reason);
  assert_int_equal(within[1], SEPAX_OUTSIDE);
  assert_int_equal(why[1], SEPAX_WITHIN_PLAIN);
  for (int k = 0; k < 2; k++) {
    sepax_shell_free(&shell[k]);
    sepax_body_free(body[k]);
    sepax_soup_free(&m[k]);
  }
  *stock = (sepax_soup){0};
}

static const double inner[2][3] = {{0.5, 0.5, 0.5}, {1.5, 1.5, 1.5}};

CASE(reason_of_solids) {
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, corner[2], corner[3], false);
  assert_why(&m, 1.5, 0.5, 1, SEPAX_INSIDE, SEPAX_WITHIN_PLAIN); /* they overlap */
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, inner[0], inner[1], false);
  assert_why(&m, 1, 1, 1, SEPAX_INSIDE, SEPAX_WITHIN_NESTED);
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, inner[0], inner[1], true);
  assert_why(&m, 1, 1, 1, SEPAX_OUTSIDE, SEPAX_WITHIN_PLAIN);
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, corner[2], corner[3], true);
  assert_why(&m, 1.5, 0.5, 1, SEPAX_INSIDE_UNKNOWN, SEPAX_WITHIN_OPPOSED);
  static const double room[2][2][3] = {{{-9, -9, -9}, {9, 9, 9}}, {{-8, -8, -8}, {8, 8, 8}}};
  for (int inwards = 0; inwards < 2; inwards++) { /* two solids that overlap, in a cavity */
    add_block(&m, room[0][0], room[0][1], false);
    add_block(&m, room[1][0], room[1][1], inwards != 0);
    add_block(&m, corner[0], corner[1], false);
    add_block(&m, corner[2], corner[3], false);
    assert_why(&m, 1.5, 0.5, 1, SEPAX_INSIDE,
               inwards != 0 ? SEPAX_WITHIN_PLAIN : SEPAX_WITHIN_NESTED);
  }
}

CASE(reason_of_faults) {
  sepax_soup m = {0};
  add_block(&m, corner[0], corner[1], false);
  m.count--;
  assert_why(&m, 1, 1, 1, SEPAX_INSIDE_UNKNOWN, SEPAX_WITHIN_OPEN);
  add_block(&m, corner[0], corner[1], false);
  add_block(&m, inner[0], inner[1], true);
  turn_round(&m.facet[13]);
  assert_why(&m, 1, 1, 1, SEPAX_INSIDE_UNKNOWN, SEPAX_WITHIN_INCONSISTENT);
  add_block(&m, corner[0], corner[1], false);
  add_again(&m, 0, true);
  assert_why(&m, 1, 1, 1, SEPAX_INSIDE_UNKNOWN, SEPAX_WITHIN_DOUBLED);
}

/* A ray from within boxes with both sides of each face crosses two sheets of each of them. */
CASE(reason_of_many_sheets) {
  for (int boxes = 127; boxes <= 129; boxes++) {
    const double c[3] = {0, 0, 0};
    sepax_soup m = {0};
    for (int n = 0; n < boxes; n++) {
      add_box(&m, c, 1 + n, 1);
    }
    add_again(&m, 0, true);
    assert_why(&m, 0.25, 0.125, 0, SEPAX_INSIDE_UNKNOWN,
               boxes > 128 ? SEPAX_WITHIN_SHEETS : SEPAX_WITHIN_DOUBLED);
  }
}

/* ----------------------------------------------------------- edges on one line */

/* A prism along x between the bends of an outline in y and z, whose edges along x are divided at
 * the places that `cuts` has of each of them. */
static void add_prism(sepax_soup *m, const double (*outline)[2], int bends, const int *cuts,
                      double length) {
  for (int n = 0; n < bends; n++) {
    const double *p = outline[n];
    const double *q = outline[(n + 1) % bends];
    const double far[3] = {length, q[0], q[1]};
    const double near[3] = {0, q[0], q[1]};
    for (int k = 0; k < cuts[n]; k++) { /* a fan from a corner of the next edge */
      const double from[3] = {length * k / cuts[n], p[0], p[1]};
      const double to[3] = {length * (k + 1) / cuts[n], p[0], p[1]};
      add_triangle(m, from, to, far);
    }
    const double first[3] = {0, p[0], p[1]};
    add_triangle(m, first, far, near);
    if (n > 0 && n + 1 < bends) { /* both ends as fans from the first bend */
      const double a[2][3] = {{0, outline[0][0], outline[0][1]},
                              {length, outline[0][0], outline[0][1]}};
      const double b[2][3] = {{0, p[0], p[1]}, {length, p[0], p[1]}};
      add_triangle(m, a[0], b[0], near);
      add_triangle(m, a[1], far, b[1]);
    }
  }
}

/* Rows of vertices in the middle of long edges leave one sheet: in the bore a ray that crosses the
 * wall twice is no doubt. */
CASE(rows_of_vertices) {
  static const double outline[8][2] = {{0, 0}, {8, 0}, {8, 8}, {0, 8},
                                       {0, 6}, {6, 6}, {6, 2}, {0, 2}};
  for (int most = 1; most <= 8; most *= 2) {
    int cuts[8];
    for (int n = 0; n < 8; n++) {
      cuts[n] = 1 + n % most;
    }
    sepax_soup m = {0};
    add_prism(&m, outline, 8, cuts, 16);
    assert_small(&m, 7.5, 3, 4, true, true, SEPAX_OUTSIDE); /* in the slot */
    assert_small(&m, 7.5, 3, 7, true, true, SEPAX_INSIDE);
    sepax_soup_free(&m);
  }
}

/* A triangle without area, of three corners on one line, fills a gap between edges, and is nothing
 * to the rule. */
CASE(triangles_without_area) {
  static const double outline[4][2] = {{0, 0}, {8, 0}, {8, 8}, {0, 8}};
  const int cuts[4] = {2, 1, 2, 1};
  sepax_soup m = {0};
  add_prism(&m, outline, 4, cuts, 16);
  for (int n = 0; n < 4; n += 2) {
    const double a[3] = {0, outline[n][0], outline[n][1]};
    const double b[3] = {8, outline[n][0], outline[n][1]};
    const double c[3] = {16, outline[n][0], outline[n][1]};
    add_triangle(&m, a, b, c);
    add_triangle(&m, b, b, c);
  }
  assert_small(&m, 3, 3, 4, true, true, SEPAX_INSIDE);
  sepax_soup_free(&m);
}
