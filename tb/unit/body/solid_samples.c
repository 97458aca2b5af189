/* SPDX-License-Identifier: MIT */
/* solid_samples.c - sample bodies as solids against the solid angle under which a point sees them,
 * and bodies that are in one file twice. */
#include "solid_meshes.h"

#include <math.h>

/* The solid angle under which p sees a triangle (van Oosterom and Strackee). */
static double solid_angle(const double p[3], const double t[3][3]) {
  double r[3][3];
  double length[3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      r[k][i] = t[k][i] - p[i];
    }
    length[k] = sqrt(r[k][0] * r[k][0] + r[k][1] * r[k][1] + r[k][2] * r[k][2]);
  }
  double sum = length[0] * length[1] * length[2];
  double volume = 0;
  for (int k = 0; k < 3; k++) {
    const double *u = r[(k + 1) % 3];
    sum += (r[k][0] * u[0] + r[k][1] * u[1] + r[k][2] * u[2]) * length[(k + 2) % 3];
    volume +=
        r[0][k] * (r[1][(k + 1) % 3] * r[2][(k + 2) % 3] - r[1][(k + 2) % 3] * r[2][(k + 1) % 3]);
  }
  return 2 * atan2(volume, sum);
}

/* Its coordinates even, so that points between have rays through its edges. */
static sepax_soup sample(const char *shape, size_t triangles) {
  static const double origin[3] = {0, 0, 0};
  sepax_soup mesh;
  assert_works(sepax_sample(&mesh, shape, triangles, origin, 0, &fault));
  for (size_t k = 0; k < 9 * mesh.count; k++) {
    double *x = &mesh.facet[k / 9].v[k / 3 % 3][k % 3];
    *x = 2 * round(*x / 2);
  }
  return mesh;
}

typedef struct {
  sepax_body *body;
  sepax_shell shell;
} solid;

static void make(solid *s, const sepax_soup *mesh) {
  assert_works(sepax_body_new(&s->body, SEPAX_SOUP_MESH(mesh), NULL, &fault));
  assert_works(sepax_shell_find(&s->shell, s->body, &fault));
  assert_true(s->shell.closed);
}

static void drop(solid *s) {
  sepax_shell_free(&s->shell);
  sepax_body_free(s->body);
}

/* A tetrahedron of side 1 at p. */
static sepax_soup tiny(const double p[3]) {
  sepax_soup m = {0};
  double v[4][3];
  for (int k = 0; k < 4; k++) {
    memcpy(v[k], p, sizeof v[k]);
    if (k > 0) {
      v[k][k - 1] += 1;
    }
  }
  for (int k = 0; k < 4; k++) {
    add_triangle(&m, v[k], v[(k + 1) % 4], v[(k + 2) % 4]);
  }
  return m;
}

CASE(by_solid_angle) {
  static const char *const shape[] = {"sphere", "pocket", "ball-end", "box"};
  enum { TRIANGLES = 200 };
  size_t seen[2] = {0};
  for (size_t s = 0; s < LENGTH(shape); s++) {
    sepax_soup mesh = sample(shape[s], TRIANGLES);
    sepax_soup turned = {.facet = calloc(TRIANGLES, sizeof(sepax_facet)), .count = TRIANGLES};
    solid whole;
    solid whatever; /* the same with triangles turned round */
    assert_non_null(turned.facet);
    memcpy(turned.facet, mesh.facet, TRIANGLES * sizeof *mesh.facet);
    for (int k = 0; k < TRIANGLES; k += 1 + random_below(3)) {
      turn_round(&turned.facet[k]);
    }
    make(&whole, &mesh);
    make(&whatever, &turned);
    assert_true(whole.shell.consistent && !whatever.shell.consistent);
    for (int n = 0; n < 1000; n++) {
      double p[3];
      double angle = 0;
      for (int i = 0; i < 3; i++) {
        p[i] = mesh.facet[random_below(TRIANGLES)].v[0][i] + random_below(25) - 12;
      }
      for (int k = 0; k < TRIANGLES; k++) {
        angle += solid_angle(p, mesh.facet[k].v);
      }
      sepax_soup m = tiny(p);
      sepax_query query = {.size = sizeof(sepax_query), .only_any = true};
      sepax_pairs found;
      solid small;
      make(&small, &m);
      assert_works(
          sepax_bodies_collide(small.body, NULL, whole.body, NULL, &query, &found, &fault));
      if (found.count == 0) {
        sepax_inside within[2];
        assert_works(sepax_bodies_within(&small.shell, NULL, &whole.shell, NULL, within, &fault));
        assert_int_equal(within[1], SEPAX_OUTSIDE);
        assert_int_equal(within[0], fabs(angle) > 2 * PI ? SEPAX_INSIDE : SEPAX_OUTSIDE);
        seen[within[0] == SEPAX_INSIDE]++;
        assert_works(
            sepax_bodies_within(&whatever.shell, NULL, &small.shell, NULL, within, &fault));
        assert_int_equal(within[1], fabs(angle) > 2 * PI ? SEPAX_INSIDE : SEPAX_OUTSIDE);
      }
      drop(&small);
      sepax_soup_free(&m);
    }
    drop(&whole);
    drop(&whatever);
    sepax_soup_free(&mesh);
    sepax_soup_free(&turned);
  }
  assert_true(seen[0] > 500 && seen[1] > 300);
}

/* A block and one that is moved, or the same once more, maybe split along other diagonals: what is
 * in both is inside, unless one of them is inside out. */
CASE(twice) {
  const double low[3] = {0, 0, 0};
  const double high[3] = {20, 20, 20};
  const double p[3] = {13, 14, 15};
  for (int n = 0; n < 60; n++) {
    double from[3];
    double to[3];
    for (int i = 0; i < 3; i++) {
      from[i] = n % 3 == 0 ? 0 : random_below(12);
      to[i] = from[i] + 20;
    }
    bool other_part = from[0] != 0 && from[1] != 0 && from[2] != 0;
    sepax_soup m = {0};
    add_block(&m, low, high, n % 2 == 0);
    const bool turned = other_part ? random_below(2) == 0 : n % 2 == 0;
    add_block(&m, from, to, turned);
    sepax_soup small = tiny(p);
    solid both;
    solid one;
    sepax_inside within[2];
    make(&both, &m);
    make(&one, &small);
    assert_works(sepax_bodies_within(&one.shell, NULL, &both.shell, NULL, within, &fault));
    assert_int_equal(within[0], turned == (n % 2 == 0) ? SEPAX_INSIDE : SEPAX_INSIDE_UNKNOWN);
    assert_int_equal(within[1], SEPAX_OUTSIDE);
    drop(&both);
    drop(&one);
    sepax_soup_free(&m);
    sepax_soup_free(&small);
  }
}
