/* SPDX-License-Identifier: MIT */
/* fits.c - the boxes of a tree are as tight as they should be: what is looser costs time, and no
 * verdict shows it. */
#include "body/body.h"
#include "harness.h"
#include "unit/body/draws.h"

#include <math.h>

enum { TURNS = 40 };

static void sort(double v[3]) {
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 2; k++) {
      double most = fmax(v[k], v[k + 1]);
      v[k + 1] = fmin(v[k], v[k + 1]);
      v[k] = most;
    }
  }
}

/* Half sides of the box of a lane, the longest first, are these but for the margin that covers
 * rounding, 2^-15 of all three; the centre is there, and the axes are at right angles. */
static void assert_box(const body_boxes *box, int lane, double half[3], const double centre[3]) {
  double sum = half[0] + half[1] + half[2];
  double own[3];
  sort(half);
  for (int i = 0; i < 3; i++) {
    own[i] = (double)box->half[i][lane];
    assert_true(fabs((double)box->centre[i][lane] - centre[i]) < 1e-4 * sum + 1e-7);
    for (int j = 0; j < 3; j++) {
      double cosine = 0;
      for (int k = 0; k < 3; k++) {
        cosine += (double)box->axis[i][k][lane] * (double)box->axis[j][k][lane];
      }
      assert_true(fabs(cosine - (i == j)) < 1e-6);
    }
  }
  sort(own);
  for (int i = 0; i < 3; i++) {
    if (!(own[i] > half[i] + 0x1.8p-16 * sum && own[i] < half[i] + 0x1.4p-15 * sum + 1e-7)) {
      fail_msg("half side %d is %.9g, not %.9g of %.9g", i, own[i], half[i], sum);
    }
  }
}

/* In units of the body, from its centre. */
static void local(const sepax_body *b, const double v[3], double r[3]) {
  for (int i = 0; i < 3; i++) {
    r[i] = (v[i] - b->centre[i]) / b->scale;
  }
}

static const double sides[][3] = {{1, 0.3, 0.05}, {0.2, 1, 0.5}, {0.1, 0.4, 1}, {1, 0.1, 0.02}};

/* A cuboid in a pose. */
static sepax_soup cuboid(const double side[3], const sepax_pose *pose) {
  static const int quads[6][4] = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                  {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  sepax_soup mesh = {.facet = calloc(12, sizeof(sepax_facet)), .count = 12};
  assert_non_null(mesh.facet);
  for (int n = 0; n < 36; n++) {
    int corner = quads[n / 6][n % 6 < 3 ? n % 3 : (n % 3 + 2) % 4];
    for (int i = 0; i < 3; i++) {
      double x = pose->translation[i];
      for (int k = 0; k < 3; k++) {
        x += pose->rotation[i][k] * side[k] * ((corner >> k & 1) - 0.5);
      }
      mesh.facet[n / 3].v[n % 3][i] = x;
    }
  }
  return mesh;
}

/* All of a cuboid: its root's box is the cuboid, however it is turned. */
CASE(a_cuboid_has_its_own_box) {
  for (int n = 0; n < TURNS; n++) {
    const double *side = sides[n % (int)LENGTH(sides)];
    sepax_pose pose = n < 4 ? turned(1, 0, 0, 0) : turned_and_moved(3);
    sepax_soup mesh = cuboid(side, &pose);
    sepax_body *b;
    assert_works(sepax_body_new(&b, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
    double half[3];
    double centre[3];
    local(b, pose.translation, centre);
    for (int i = 0; i < 3; i++) {
      half[i] = side[i] / 2 / b->scale;
    }
    assert_box(&b->boxes[b->nodes], 0, half, centre);
    sepax_body_free(b);
    sepax_soup_free(&mesh);
  }
}

/* The box of a triangle stands on the edge on which its length and height have the least sum: the
 * edge of `length`, though it is not always the longest. It has no thickness. */
CASE(a_triangle_has_the_box_of_least_length_and_height) {
  for (int n = 0; n < TURNS; n++) {
    sepax_pose pose = turned_and_moved(2);
    double size = n % 2 == 0 ? 1 : 1e-3; /* beside one that is large */
    double length = size * (1.2 + 0.5 * random_unit());
    bool leg = n % 4 > 1; /* a right triangle on its shorter leg */
    double height = length * (leg ? 1.2 + 0.1 * random_unit() : 0.25 + 0.15 * random_unit());
    double foot = leg ? 0 : length * (0.5 + 0.2 * random_unit());
    const double flat[3][2] = {{0, 0}, {length, 0}, {foot, height}};
    sepax_facet facet[2] = {{.v = {{9, 9, 9}, {9, 9, 9}, {9, 9, 9}}}};
    for (int k = 0; k < 9; k++) {
      int i = k % 3;
      const double *p = flat[(k / 3 + n) % 3];
      facet[1].v[k / 3][i] =
          pose.rotation[i][0] * p[0] + pose.rotation[i][1] * p[1] + pose.translation[i];
    }
    sepax_soup mesh = {.facet = facet, .count = 2};
    sepax_body *b;
    assert_works(sepax_body_new(&b, SEPAX_SOUP_MESH(&mesh), NULL, &fault));
    for (int lane = 0; lane < 2; lane++) {
      uint32_t place = b->node[0].child[lane] - BODY_TRIANGLE;
      if (b->number[place] == 0) { /* a point has a box, too */
        for (int i = 0; i < 3; i++) {
          assert_true((double)b->boxes[0].half[i][lane] >= 0x1p-60);
        }
      } else {
        double half[3] = {length / 2 / b->scale, height / 2 / b->scale, 0};
        double middle[3];
        double centre[3];
        for (int i = 0; i < 3; i++) {
          middle[i] = pose.rotation[i][0] * length / 2 + pose.rotation[i][1] * height / 2 +
                      pose.translation[i];
        }
        local(b, middle, centre);
        assert_box(&b->boxes[0], lane, half, centre);
      }
    }
    sepax_body_free(b);
  }
}
