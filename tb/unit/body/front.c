/* SPDX-License-Identifier: MIT */
/* front.c - sepax_bodies_apart with a front in memory of the caller. Many verdicts along motions
 * are compared with the truth by tb/pairs/distances. */
#include "harness.h"
#include "unit/body/draws.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static sepax_body *body_of(const sepax_soup *mesh) {
  sepax_body *b;
  assert_works(sepax_body_new(&b, SEPAX_SOUP_MESH(mesh), NULL, &fault));
  return b;
}

static sepax_body *sphere(double radius) {
  const double origin[3] = {0, 0, 0};
  sepax_soup mesh;
  assert_works(sepax_sample(&mesh, "sphere", 2000, origin, 2 * radius, &fault));
  sepax_body *b = body_of(&mesh);
  sepax_soup_free(&mesh);
  return b;
}

static sepax_pose moved(double x, double y, double z) {
  return (sepax_pose){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {x, y, z}};
}

static sepax_apart_result ask(const sepax_body *a, const sepax_pose *p, const sepax_body *b,
                              const sepax_pose *q, double distance, sepax_front *front) {
  const sepax_apart_request request = {.size = sizeof request, .front = front};
  sepax_apart_result found;
  assert_works(sepax_bodies_apart(a, p, b, q, distance, &request, &found, &fault));
  return found;
}

static sepax_front *front_in(void *memory, size_t bytes) {
  sepax_front *front;
  assert_works(sepax_front_begin(&front, memory, bytes, &fault));
  return front;
}

/* ------------------------------------------------------------------------- memory */

CASE(memory_too_small) {
  char memory[2048];
  size_t least = sepax_front_bytes(0);
  sepax_front *front;
  assert_true(least <= 500 && sepax_front_bytes(512) <= 500 + 20 * 512);
  assert_fault(sepax_front_begin(&front, memory, least - 1, &fault), "too few");
  assert_null(front);
  assert_fault(sepax_front_begin(&front, NULL, sizeof memory, &fault), "too few");
  assert_fault(sepax_front_begin(&front, memory, 0, &fault), "too few");
  assert_works(sepax_front_begin(&front, memory, least, &fault));
}

/* In any place, a front of few entries or none leaves the bytes around it alone, and the verdicts
 * are right. */
CASE(memory_of_any_size) {
  enum { AROUND = 64, MOST = 4096 };
  sepax_body *a = sphere(1);
  sepax_body *b = sphere(1);
  unsigned char *memory = malloc(MOST);
  assert_non_null(memory);
  for (size_t n = 0; n < 60; n++) {
    size_t bytes = sepax_front_bytes(n < 20 ? n : 0) + (n < 20 ? 0 : 3 * n);
    size_t at = AROUND + n % 17;
    memset(memory, 0xa5, MOST);
    sepax_front *front = front_in(memory + at, bytes);
    for (int k = 0; k < 40; k++) {
      sepax_pose q = moved(2.3 - 0.01 * k, 0, 0.001 * k);
      sepax_apart_result plain = ask(a, NULL, b, &q, 0.1, NULL);
      assert_int_equal(ask(a, NULL, b, &q, 0.1, front).verdict, plain.verdict);
    }
    for (size_t k = 0; k < MOST; k++) {
      assert_true((k >= at && k < at + bytes) || memory[k] == 0xa5);
    }
  }
  free(memory);
  sepax_body_free(a);
  sepax_body_free(b);
}

/* -------------------------------------------------------------------------- bodies */

/* A front of two bodies is of no use to others, and does no harm. */
CASE(other_bodies) {
  static char memory[1 << 15];
  sepax_body *small = sphere(1);
  sepax_body *large = sphere(1.5);
  sepax_front *front = front_in(memory, sizeof memory);
  sepax_pose q = moved(2.2, 0, 0);
  for (int n = 0; n < 3; n++) {
    assert_int_equal(ask(small, NULL, small, &q, 0.1, front).verdict, SEPAX_APART);
    assert_int_equal(ask(small, NULL, large, &q, 0.1, front).verdict, SEPAX_NEAR);
    assert_int_equal(ask(large, NULL, small, &q, 0.1, front).verdict, SEPAX_NEAR);
  }
  assert_int_equal(ask(small, NULL, small, &q, 0.1, front).verdict, SEPAX_APART);
  assert_int_equal(ask(small, NULL, small, &q, 0.3, front).verdict, SEPAX_NEAR);
  assert_int_equal(ask(small, NULL, small, &q, 0, front).verdict, SEPAX_APART);
  sepax_body_free(small);
  sepax_body_free(large);
}

/* A slow motion takes much less work with a front than without, also where both bodies move far
 * together. */
CASE(slow_motion) {
  static char memory[1 << 15];
  sepax_body *a = sphere(1);
  sepax_body *b = sphere(1);
  for (int together = 0; together < 2; together++) {
    sepax_front *front = front_in(memory, sizeof memory);
    uint64_t work[2] = {0, 0};
    for (int n = 0; n < 500; n++) {
      sepax_pose p = turned(1, 0.3 * together, 0.01 * n * together, 0);
      sepax_pose away = moved(1.17 + 1e-5 * n, 1.17, 1.17);
      sepax_pose q = sepax_pose_compose(&p, &away);
      sepax_apart_result with = ask(a, &p, b, &q, 0.01, front);
      sepax_apart_result without = ask(a, &p, b, &q, 0.01, NULL);
      assert_int_equal(with.verdict, without.verdict);
      work[0] += with.work;
      work[1] += without.work;
    }
    if (work[0] > work[1] / 4) {
      fail_msg("%llu units of work with a front, %llu without", (unsigned long long)work[0],
               (unsigned long long)work[1]);
    }
  }
  sepax_body_free(a);
  sepax_body_free(b);
}

/* -------------------------------------------------------------------------- bounds */

static void set_triangle(sepax_facet *f, const double v[9]) { memcpy(f->v, v, sizeof f->v); }

/* B's rotation becomes a shear, which a valid pose may be a little. It moves a far part of B, but
 * not what is seen from B: only the allowance for skew tells. */
CASE(skewed_poses) {
  static char memory[1 << 12];
  const double face[9] = {0, -1, -1, 0, 1000, 0, 0, -1, 1};
  const double gap = 1e-4;
  const double near_tip[9] = {gap, 999.5, -1e-3, 1, 999.5, 0, gap, 999.5, 1e-3};
  sepax_facet facet[2];
  set_triangle(&facet[0], near_tip);
  set_triangle(&facet[1], face);
  sepax_soup mesh[2] = {{.facet = &facet[0], .count = 1}, {.facet = &facet[1], .count = 1}};
  sepax_body *a = body_of(&mesh[0]);
  sepax_body *b = body_of(&mesh[1]);
  sepax_pose p = moved(0, 0, 0);
  sepax_pose q = moved(0, 0, 0);
  sepax_front *front = front_in(memory, sizeof memory);
  assert_int_equal(ask(a, &p, b, &q, 0.9 * gap, front).verdict, SEPAX_APART);
  q.rotation[0][1] = 2e-8; /* 2e-5 at the tip */
  assert_int_equal(ask(a, &p, b, &q, 0.9 * gap, NULL).verdict, SEPAX_NEAR);
  assert_int_equal(ask(a, &p, b, &q, 0.9 * gap, front).verdict, SEPAX_NEAR);
  sepax_body_free(a);
  sepax_body_free(b);
}

enum { CELLS = 40 };

/* Cells of a square at height z, beside it others that rise with the slope, and perhaps a pillar
 * above all. */
static sepax_body *plate(double z, double slope, bool pillar) {
  static sepax_facet facet[4 * CELLS * CELLS + 1];
  const double s = 1.0 / 32;
  size_t count = 0;
  for (int n = 0; n < 2 * CELLS * CELLS; n++) {
    const int row = n / CELLS - CELLS;
    double x = n % CELLS * s;
    double y = row * s;
    double low = z + slope * fmax(-y, 0);
    double high = z + slope * fmax(-y - s, 0);
    const double half[2][9] = {{x, y, low, x + s, y, low, x, y + s, high},
                               {x + s, y + s, high, x, y + s, high, x + s, y, low}};
    set_triangle(&facet[count++], half[0]);
    set_triangle(&facet[count++], half[1]);
  }
  if (pillar) {
    const double above[9] = {5, 0, 0, 5, 0, 5, 5, 1, 0};
    set_triangle(&facet[count++], above);
  }
  return body_of(&(sepax_soup){.facet = facet, .count = count});
}

/* Where a direction proves no more than that parts are beyond the distance asked for, the front
 * must not keep more. The upper plate is tilted so that one corner or edge of it comes near. Beside
 * a pillar the direction does for parts of the plates, otherwise for all that is left. */
CASE(parts_proved_by_a_direction) {
  static char memory[1 << 18];
  sepax_body *a[2] = {plate(0, 0, false), plate(0, 0, true)};
  sepax_body *b = plate(1, 0.02, false);
  const double distance = 1 - 0x1p-50;
  const double side = CELLS / 32.0;
  size_t apart = 0;
  for (int n = 0; n < 400; n++) {
    sepax_pose p = turned(1, random_unit(), random_unit(), random_unit());
    sepax_front *front = front_in(memory, sizeof memory);
    apart += ask(a[n % 2], &p, b, &p, distance, front).verdict == SEPAX_APART;
    double about_x = 1e-5 * (n / 3 % 3 - 1) * (1 + n % 24);
    double about_y = 1e-5 * (n % 3 - 1) * (1 + n % 24);
    sepax_pose tilt = turned(1, about_x, about_y, 0);
    double lowest = INFINITY;
    for (int k = 0; k < 4; k++) {
      double corner[3] = {(k & 1) != 0 ? side : 0, (k & 2) != 0 ? side : 0, 1};
      sepax_pose_apply(&tilt, corner, corner);
      lowest = fmin(lowest, corner[2]);
    }
    tilt.translation[2] = 1 - 1e-6 - lowest;
    sepax_pose q = sepax_pose_compose(&p, &tilt);
    assert_int_equal(ask(a[n % 2], &p, b, &q, distance, NULL).verdict, SEPAX_NEAR);
    assert_int_equal(ask(a[n % 2], &p, b, &q, distance, front).verdict, SEPAX_NEAR);
  }
  assert_true(apart >= 200);
  sepax_body_free(a[0]);
  sepax_body_free(a[1]);
  sepax_body_free(b);
}
