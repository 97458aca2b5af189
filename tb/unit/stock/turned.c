/* SPDX-License-Identifier: MIT */
/* turned.c - shapes of turned profiles: does their union enclose the solid, or lie in it? Against
 * the profile's radius at a height. */
#include "stock/sweep.h"
#include "unit/stock/solids.h"

enum { POINTS_MOST = 16 };

typedef struct {
  turned_point point[POINTS_MOST];
  turned_profile profile;
} turning;

static void add(turning *t, double z, double r, double bend) {
  assert_true(t->profile.points < POINTS_MOST);
  t->point[t->profile.points++] = (turned_point){.z = z, .r = r, .bend = bend};
}

/* Ball, bull nose, drill with a step, tapered ball, disc cutter, whole ball, neck with a radius,
 * and a row of any lines. */
static turning draw_turning(int kind) {
  turning t = {0};
  double r = 1 + fabs(random_unit());
  double c = 0.4 * r * (0.5 + 0.4 * random_unit());
  switch (kind % 8) {
  case 0:
    add(&t, 0, 0, 0), add(&t, r, r, r), add(&t, 4, r, 0);
    break;
  case 1:
    add(&t, 0, 0, 0), add(&t, 0, r - c, 0), add(&t, c, r, c), add(&t, 4, r, 0);
    break;
  case 2:
    add(&t, 0, 0, 0), add(&t, 0.6 * r, r, 0), add(&t, 3, r, 0), add(&t, 3, 1.5 * r, 0);
    add(&t, 4, 1.5 * r, 0), add(&t, 4, 0.5, 0), add(&t, 5, 0.5, 0);
    break;
  case 3:
    add(&t, 0, 0, 0), add(&t, r * (1 - sin(0.2)), r * cos(0.2), r);
    add(&t, r * (1 - sin(0.2)) + 3, r * cos(0.2) + 3 * tan(0.2), 0);
    break;
  case 4:
    add(&t, 0, 0, 0), add(&t, 0, r, 0), add(&t, 0.5, r, 0.3), add(&t, 0.5, 0.4, 0);
    add(&t, 4, 0.4, 0);
    break;
  case 5:
    add(&t, -r, 0, 0), add(&t, r, 0, r);
    break;
  case 6:
    add(&t, 0, r, 0), add(&t, 1, r, 0), add(&t, 2, r - 0.8, -1.2), add(&t, 3, r + 0.2, -2);
    add(&t, 4, r - 0.1, 3), add(&t, 4, 0.5, 0);
    break;
  default:
    add(&t, -1, fabs(random_unit()), 0);
    for (int n = 0; n < 8; n++) {
      double dz = n % 3 == 1 ? 0 : 0.2 + fabs(random_unit());
      add(&t, t.point[n].z + dz, 0.01 + 2 * fabs(random_unit()), 0);
    }
  }
  return t;
}

/* The radius of the solid at a height: the greatest one of the elements there. */
static long double radius_at(const turning *t, long double z) {
  long double most = -1;
  for (size_t n = 1; n < t->profile.points; n++) {
    const turned_point *p = &t->point[n - 1];
    if (z < p[0].z || z > p[1].z || p[0].z == p[1].z) {
      continue;
    }
    long double part = (z - p[0].z) / ((long double)p[1].z - p[0].z);
    long double r = p[0].r + part * ((long double)p[1].r - p[0].r);
    if (p[1].bend != 0) {
      long double dr = (long double)p[1].r - p[0].r;
      long double dz = (long double)p[1].z - p[0].z;
      long double chord = hypotl(dr, dz);
      long double bend = fabsl((long double)p[1].bend);
      long double off = sqrtl(fmaxl(0, bend * bend - chord * chord / 4));
      int sign = p[1].bend > 0 ? 1 : -1;
      long double cr = ((long double)p[0].r + p[1].r) / 2 - sign * off * dz / chord;
      long double cz = ((long double)p[0].z + p[1].z) / 2 + sign * off * dr / chord;
      r = cr + sign * sqrtl(fmaxl(0, bend * bend - (z - cz) * (z - cz)));
    }
    most = fmaxl(most, r);
  }
  return most;
}

static bool in_any(const sepax__stock_shapes *shapes, const double p[3], int sure) {
  for (size_t n = 0; n < shapes->count; n++) {
    const sepax__stock_piece still = {.at = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}}};
    sweep s = {.count = 0};
    double q[3];
    double reach;
    assert_works(sepax__sweep_make(&s, &shapes->shape[n], &still, 0, sure, 10, 1e-6, &fault));
    bool boxed = true;
    for (int i = 0; i < 3; i++) {
      boxed = boxed && p[i] >= s.box[0][i] && p[i] <= s.box[1][i];
    }
    sweep_point(&s, p, q);
    sweep_side side = sepax__sweep_locate(&s, q, 0, &reach);
    if (sure > 0 ? side != SWEEP_OUTSIDE && boxed : side == SWEEP_INSIDE) {
      return true;
    }
  }
  return false;
}

CASE(shapes_enclose_the_solid_and_lie_in_it) {
  int counted[2] = {0};
  for (int n = 0; n < FEWER(400); n++) {
    turning t = draw_turning(n);
    t.profile.point = t.point;
    sepax__stock_shapes side[2];
    double error = n % 2 == 0 ? 0.01 : 0.1;
    const bool open[2] = {false, false};
    assert_works(sepax__stock_shapes_make(&t.profile, open, error, &side[0], &side[1], &fault));
    double low = t.point[0].z;
    double high = t.point[t.profile.points - 1].z;
    for (int k = 0; k < 300; k++) {
      double z = low + (high - low) * (0.5 + 0.55 * random_unit());
      long double r = radius_at(&t, z);
      double off = k % 3 == 0 ? 0 : k % 3 == 1 ? 0.1 * random_unit() : 2 * random_unit();
      const double p[3] = {fmax(0, (double)r + off), 0, z};
      bool in = p[0] <= r;
      assert_true(!in || in_any(&side[1], p, 1));
      assert_true(in || !in_any(&side[0], p, -1));
      counted[in]++;
      /* the solid grown or shrunk by a little more than the error decides */
      const double beyond[3] = {p[0] + 20 * error, 0, z};
      assert_true(r >= 0 || !in_any(&side[1], beyond, 1));
    }
    sepax__stock_shapes_free(&side[0]);
    sepax__stock_shapes_free(&side[1]);
  }
  assert_true(counted[0] > FEWER(10000) && counted[1] > FEWER(10000));
}

/* An arc that ends 2^-21 short of a quarter, before a cone as steep: one round limit, and the
 * widest place of the cone keeps it. */
CASE(a_quarter_but_for_rounding_holds_a_cone) {
  const double lean = 0x1p-21;
  for (int low = 0; low < 2; low++) {
    const double r = 1 + 0.5 * cos(lean);
    const double z = 0.5 * sin(lean);
    const double top = r + 3 * tan(lean);
    turning t = {.profile = {.points = 0}};
    if (low == 1) {
      add(&t, 0, 0, 0), add(&t, 0, 1, 0), add(&t, 0.5 - z, r, 0.5), add(&t, 3.5 - z, top, 0);
    } else {
      add(&t, -3.5 + z, top, 0), add(&t, -0.5 + z, r, 0), add(&t, 0, 1, 0.5), add(&t, 0, 0, 0);
    }
    t.profile.point = t.point;
    sepax__stock_shapes side[2];
    const bool open[2] = {false, false};
    assert_works(sepax__stock_shapes_make(&t.profile, open, 0.01, &side[0], &side[1], &fault));
    assert_int_equal(side[1].count, 1);
    assert_true(side[1].shape[0].count < 6);
    const double widest[3] = {top, 0, low == 1 ? 3.5 - z : -3.5 + z};
    assert_true(in_any(&side[1], widest, 1));
    sepax__stock_shapes_free(&side[0]);
    sepax__stock_shapes_free(&side[1]);
  }
}

/* How many shapes there are, and what volume is between the solid and them. */
CASE(convex_tools_are_one_shape) {
  const size_t shapes[7] = {1, 1, 3, 1, 2, 1, 0};
  for (int n = 0; n < 70; n++) {
    turning t = draw_turning(n % 7 + 8);
    t.profile.point = t.point;
    sepax__stock_shapes side[2];
    const bool open[2] = {false, false};
    assert_works(sepax__stock_shapes_make(&t.profile, open, 0.01, &side[0], &side[1], &fault));
    assert_true(n % 7 == 6 || side[0].count == shapes[n % 7]);
    assert_true(n % 7 == 6 || side[1].count == shapes[n % 7]);
    for (int k = 0; k < 200; k++) { /* what is farther from the surface than the error is decided */
      double z = t.point[0].z +
                 (t.point[t.profile.points - 1].z - t.point[0].z) * (0.5 + 0.499 * random_unit());
      double near = INFINITY; /* least and greatest radius around */
      double far = 0;
      for (int i = -20; i <= 20; i++) {
        double r = (double)radius_at(&t, z + 0.03 * i / 20);
        near = fmin(near, r);
        far = fmax(far, r);
      }
      const double p[2][3] = {{fmax(0, near - 0.03), 0, z}, {far + 0.03, 0, z}};
      assert_true(near < 0.03 || in_any(&side[0], p[0], -1));
      assert_true(!in_any(&side[1], p[1], 1));
    }
    sepax__stock_shapes_free(&side[0]);
    sepax__stock_shapes_free(&side[1]);
  }
}

CASE(faces_between_parts_are_joined) {
  turning t = draw_turning(2);
  t.profile.point = t.point;
  sepax__stock_shapes side[2];
  const bool ends[2] = {false, true};
  assert_works(sepax__stock_shapes_make(&t.profile, ends, 0.01, &side[0], &side[1], &fault));
  int joined = 0;
  for (size_t n = 0; n < side[1].count; n++) {
    for (int k = 0; k < side[1].shape[n].count; k++) {
      joined += side[1].shape[n].limit[k].joined;
    }
  }
  assert_true(joined == 5); /* both sides of two cuts, and the top */
  sepax__stock_shapes_free(&side[0]);
  sepax__stock_shapes_free(&side[1]);
}

CASE(profiles_that_are_not_legal_are_refused) {
  turning t = draw_turning(6);
  t.profile.point = t.point;
  sepax__stock_shapes side[2];
  const bool open[2] = {false, false};
  assert_fault(sepax__stock_shapes_make(&t.profile, open, 0, &side[0], &side[1], &fault),
               "above 0");
  t = draw_turning(3); /* a tapered ball: its arc is no quarter of a circle */
  t.profile.point = t.point;
  assert_fault(sepax__stock_shapes_make(&t.profile, open, 1e-9, &side[0], &side[1], &fault),
               "limits");
  t = draw_turning(1);
  t.profile.point = t.point;
  t.point[2].z = -1;
  assert_false(sepax__stock_shapes_make(&t.profile, open, 0.01, &side[0], &side[1], &fault));
}
