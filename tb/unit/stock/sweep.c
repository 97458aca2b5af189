/* SPDX-License-Identifier: MIT */
/* sweep.c - shapes that go straight on: which points and cubes do they reach? Against the solid
 * itself in long double. */
#include "stock/sweep.h"
#include "unit/stock/solids.h"

typedef struct {
  profile solid;
  sepax__stock_shape shape[2]; /* inside, outside */
  sepax__stock_piece piece;
  sweep made[2]; /* inside: surely reached; outside: surely not */
  double error, shrunk;
} sample;

/* How far a point is beyond the shrunk solid on its way. */
static long double beyond_sample(const sample *s, const double p[3]) {
  return beyond_way(&s->solid, &s->piece.at, s->piece.way, p) + s->shrunk;
}

/* Ways along the axis, across it, of no length and in any direction. Half of the shapes are shrunk,
 * some by more than the radius of an arc. */
static sample draw_sample(int kind) {
  sample s = {.solid = draw_profile(kind), .error = 0.001 + 0.05 * fabs(random_unit())};
  assert_works(sepax__stock_shape_make(s.solid.corner, s.solid.count, s.error, &s.shape[0],
                                       &s.shape[1], &fault));
  s.shrunk = random_below(2) == 0 ? 0.45 * fabs(random_unit()) : 0;
  sepax__stock_shape_shrink(&s.shape[0], s.shrunk);
  sepax__stock_shape_shrink(&s.shape[1], s.shrunk);
  s.piece.at = turned_and_moved(10);
  if (random_below(3) == 0) { /* upright */
    const sepax_pose upright = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0.5, 0, 0.25}};
    s.piece.at = upright;
  }
  int way = random_below(4);
  for (int i = 0; i < 3; i++) {
    const double along = s.piece.at.rotation[i][2];
    const double across = s.piece.at.rotation[i][0];
    s.piece.way[i] = way == 0 ? 3 * along : way == 1 ? 5 * across : way == 2 ? 0 : random_unit();
    s.piece.way[i] *= random_below(4) == 0 && way == 3 ? 40 : 1;
  }
  for (int side = 0; side < 2; side++) {
    assert_works(sepax__sweep_make(&s.made[side], &s.shape[side], &s.piece, 0, 2 * side - 1, 100,
                                   1e-3, &fault));
  }
  return s;
}

/* A point around the way. */
static void draw_point(const sample *s, double p[3]) {
  double t = (random_unit() + 1) / 2;
  double size = s->shape[0].radius + 0.5;
  double z = s->shape[0].low + (s->shape[0].high - s->shape[0].low) * (0.55 + 0.6 * random_unit());
  for (int i = 0; i < 3; i++) {
    p[i] = s->piece.at.translation[i] + t * s->piece.way[i] + z * s->piece.at.rotation[i][2] +
           size * random_unit();
  }
}

/* Verdicts on a point; returns which side it is on. */
static int check_point(const sample *s, const double p[3]) {
  double q[3];
  double reach;
  long double beyond = beyond_sample(s, p);
  sweep_point(&s->made[0], p, q);
  sweep_side side = sepax__sweep_locate(&s->made[0], q, 0, &reach);
  if (side == SWEEP_INSIDE) {
    assert_true(beyond <= 0);
    assert_true(-beyond >= reach - 1e-12);
  }
  assert_true(side == SWEEP_INSIDE || beyond > -s->error - 2e-3);
  sweep_point(&s->made[1], p, q);
  side = sepax__sweep_locate(&s->made[1], q, 0, &reach);
  if (side == SWEEP_OUTSIDE) {
    assert_true(beyond > 0);
    double near[3]; /* all points nearer than `reach` are outside, too */
    double in = 0;
    for (int i = 0; i < 3; i++) {
      near[i] = random_unit();
      in += near[i] * near[i];
    }
    for (int i = 0; i < 3; i++) {
      near[i] = p[i] + near[i] / sqrt(in) * reach * 0.999999;
    }
    assert_true(beyond_sample(s, near) > -1e-12);
  }
  assert_true(side == SWEEP_OUTSIDE || beyond < 4 * s->error + 2e-3);
  return beyond > 0;
}

CASE(points_are_on_the_side_that_is_said) {
  int count[2] = {0};
  for (int n = 0; n < FEWER(2000); n++) {
    sample s = draw_sample(n);
    for (int k = 0; k < 20; k++) {
      double p[3];
      draw_point(&s, p);
      count[check_point(&s, p)]++;
    }
  }
  assert_true(count[0] > FEWER(8000) && count[1] > FEWER(8000));
}

/* A cube that is OUTSIDE has no point of the sweep; one that has its middle in it is not. */
CASE(cubes_outside_have_no_point) {
  int outside = 0;
  for (int n = 0; n < FEWER(2000); n++) {
    sample s = draw_sample(n);
    for (int k = 0; k < 10; k++) {
      double p[3];
      double q[3];
      double reach;
      double half = 0.05 + 0.5 * fabs(random_unit());
      draw_point(&s, p);
      sweep_point(&s.made[1], p, q);
      if (sepax__sweep_locate(&s.made[1], q, half, &reach) == SWEEP_OUTSIDE) {
        outside++;
        for (int corner = 0; corner < 8; corner++) {
          double at[3];
          for (int i = 0; i < 3; i++) {
            at[i] = p[i] + (corner >> i & 1 ? half : -half);
          }
          assert_true(beyond_sample(&s, at) > 0);
        }
      } else {
        double far = sqrt(3) * half + 4 * s.error + 2e-3;
        long double beyond = beyond_sample(&s, p);
        assert_true(beyond < 1.5 * far); /* 1.42: along and around the axis at once */
      }
    }
  }
  assert_true(outside > FEWER(2000));
}

/* A pose that is no perfect rotation is covered, and so is a place far from the origin: the limits
 * have room for both. */
CASE(rounding_is_covered) {
  int asked = 0;
  for (int n = 0; n < FEWER(2000); n++) {
    sample s = draw_sample(n);
    sepax_pose skew = s.piece.at;
    for (int k = 0; k < 9; k++) {
      skew.rotation[k / 3][k % 3] += 1e-7 * random_unit();
    }
    for (int i = 0; i < 3; i++) {
      skew.translation[i] += 1e4;
    }
    s.piece.at = skew;
    sweep made[2];
    for (int side = 0; side < 2; side++) {
      assert_works(sepax__sweep_make(&made[side], &s.shape[side], &s.piece, 0, 2 * side - 1, 1e5,
                                     1e-3, &fault));
    }
    /* a point of the solid by the matrix as it is, on its surface or a little inside or outside */
    double angle = PI * random_unit();
    double z = s.shape[0].low + (s.shape[0].high - s.shape[0].low) * (0.5 + 0.4 * random_unit());
    double rho = s.shape[0].radius;
    for (int k = 0; k < 60; k++) { /* to the surface */
      rho -= (double)fmaxl(0, beyond_solid(&s.solid, rho, z) + s.shrunk);
    }
    if (rho < 0 || beyond_solid(&s.solid, rho, z) + s.shrunk > 1e-12) {
      continue; /* the shrunk solid has no such height, or ends near it */
    }
    asked++;
    double off = 1e-9 * (random_below(2) ? 1 : -1);
    const double v[3] = {(rho + off) * cos(angle), (rho + off) * sin(angle), z};
    double p[3];
    double q[3];
    double reach;
    sepax_pose_apply(&skew, v, p);
    sweep_point(&made[1], p, q);
    assert_true(off > 0 || sepax__sweep_locate(&made[1], q, 0, &reach) != SWEEP_OUTSIDE);
    bool still = s.piece.way[0] == 0 && s.piece.way[1] == 0 && s.piece.way[2] == 0;
    sweep_point(&made[0], p, q);
    assert_true(off < 0 || !still || sepax__sweep_locate(&made[0], q, 0, &reach) != SWEEP_INSIDE);
  }
  assert_true(asked > FEWER(1700));
}

/* Points as near to the surface as doubles can be, at the end of a bisection between one outside
 * and one inside. */
CASE(points_of_the_surface_are_on_the_sure_side) {
  int asked = 0;
  for (int n = 0; n < FEWER(3000); n++) {
    sample s = draw_sample(n);
    double end[2][3];
    const long double side[2] = {1, -1};
    draw_point(&s, end[0]);
    draw_point(&s, end[1]);
    if (beyond_sample(&s, end[0]) * side[0] <= 0 || beyond_sample(&s, end[1]) * side[1] <= 0) {
      continue;
    }
    for (int k = 0; k < 56; k++) {
      double middle[3];
      for (int i = 0; i < 3; i++) {
        middle[i] = end[0][i] / 2 + end[1][i] / 2;
      }
      long double beyond = beyond_sample(&s, middle);
      memcpy(end[beyond > 0 ? 0 : 1], middle, sizeof middle);
      if (k > 40) {
        double q[3];
        double reach;
        asked++;
        sweep_point(&s.made[1], middle, q);
        assert_true(beyond > 0 || sepax__sweep_locate(&s.made[1], q, 0, &reach) != SWEEP_OUTSIDE);
        sweep_point(&s.made[0], middle, q);
        assert_true(beyond <= 0 || sepax__sweep_locate(&s.made[0], q, 0, &reach) != SWEEP_INSIDE);
      }
    }
  }
  assert_true(asked > FEWER(3000));
}

CASE(ways_that_are_no_numbers_are_refused) {
  sample s = draw_sample(0);
  s.piece.way[1] = INFINITY;
  assert_fault(sepax__sweep_make(&s.made[0], &s.shape[0], &s.piece, 0, 1, 100, 1e-3, &fault),
               "not finite");
  s.piece.way[1] = 0;
  assert_fault(sepax__sweep_make(&s.made[0], &s.shape[0], &s.piece, NAN, 1, 100, 1e-3, &fault),
               "not finite");
  s.piece.at.rotation[0][0] = 2;
  assert_false(sepax__sweep_make(&s.made[0], &s.shape[0], &s.piece, 0, 1, 100, 1e-3, &fault));
}
