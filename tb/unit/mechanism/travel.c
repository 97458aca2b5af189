/* SPDX-License-Identifier: MIT */
/* travel.c - the bound on how far points move, against their ways in long double. */
#include "unit/mechanism/places.h"

enum { JOINTS_MOST = 12, STEPS = 48 };

static place back(const place *p) {
  place r = {{p->q[0], -p->q[1], -p->q[2], -p->q[3]}, {0, 0, 0}};
  turn(r.q, p->t, r.t);
  for (int i = 0; i < 3; i++) {
    r.t[i] = -r.t[i];
  }
  return r;
}

/* Link A in B's coordinates, at a part of the way between two sets of values. */
static place seen(const sepax_mechanism *m, const double *from, const double *to, long double part,
                  size_t a, size_t b) {
  place at[JOINTS_MOST + 1] = {{{1, 0, 0, 0}, {0, 0, 0}}};
  for (size_t n = 0; n < m->joints; n++) {
    place step = place_of(&m->joint[n], from[n] + ((long double)to[n] - from[n]) * part);
    at[n + 1] = after(&at[m->joint[n].parent], &step);
  }
  place from_b = back(&at[b]);
  return after(&from_b, &at[a]);
}

static long double way_between(const place *p, const place *q, const double v[3]) {
  long double point[3] = {v[0], v[1], v[2]};
  long double at[2][3];
  long double square = 0;
  turn(p->q, point, at[0]);
  turn(q->q, point, at[1]);
  for (int i = 0; i < 3; i++) {
    long double d = at[0][i] + p->t[i] - at[1][i] - q->t[i];
    square += d * d;
  }
  return sqrtl(square);
}

typedef struct {
  double box[2][3], from[JOINTS_MOST], middle[JOINTS_MOST], to[JOINTS_MOST];
  size_t a, b;
  sepax_mechanism m;
} motion;

static motion draw_motion(double size) {
  size_t joints = 1 + (size_t)random_below(JOINTS_MOST);
  motion r = {.m = row_of(joints)};
  for (size_t n = 0; n < joints; n++) {
    draw_joint(&r.m.joint[n], n + 1);
    r.from[n] = 7 * random_unit();
    r.to[n] = r.from[n] + size * random_unit();
    r.middle[n] = r.from[n] / 2 + r.to[n] / 2;
  }
  for (int i = 0; i < 3; i++) {
    double ends[2] = {random_unit(), random_unit()};
    r.box[0][i] = fmin(ends[0], ends[1]);
    r.box[1][i] = fmax(ends[0], ends[1]);
  }
  r.a = (size_t)random_below((int)joints + 1);
  r.b = (size_t)random_below((int)joints + 1);
  assert_works(sepax_mechanism_join(&r.m, &fault));
  return r;
}

static double travel_of(const motion *r) {
  sepax_chain chain;
  assert_works(sepax_chain_find(&chain, &r->m, r->a, r->b, &fault));
  double travel = sepax_chain_travel(&chain, &r->m, r->from, r->middle, r->to, r->box);
  sepax_chain_free(&chain);
  return travel;
}

/* The longest way of corners and of points within the box, at steps. */
static double sampled(const motion *r) {
  place middle = seen(&r->m, r->from, r->to, 0.5L, r->a, r->b);
  long double most = 0;
  for (int step = 0; step <= STEPS; step++) {
    place at = seen(&r->m, r->from, r->to, (long double)step / STEPS, r->a, r->b);
    for (int n = 0; n < 12; n++) {
      double v[3];
      for (int i = 0; i < 3; i++) {
        v[i] = n < 8 ? r->box[n >> i & 1][i]
                     : r->box[0][i] + (r->box[1][i] - r->box[0][i]) * fabs(random_unit());
      }
      most = fmaxl(most, way_between(&middle, &at, v));
    }
  }
  return (double)most;
}

/* Never less than the way; close to it where the way is short. */
CASE(test_bound) {
  double worst = 0;
  for (int n = 0; n < FEWER(4000); n++) {
    double size = ldexp(1, random_below(20) - 17);
    motion r = draw_motion(size);
    double travel = travel_of(&r);
    double way = sampled(&r);
    assert_true(way <= travel);
    if (size < 0x1p-9 && way > 1e-6) {
      worst = fmax(worst, travel / way);
    }
    sepax_mechanism_free(&r.m);
  }
  assert_true(worst > 1 && worst < 1.01);
}

static void point_at(const motion *r, long double part, long double at[3]) {
  place p = seen(&r->m, r->from, r->to, part, r->a, r->b);
  long double v[3] = {r->box[0][0], r->box[0][1], r->box[0][2]};
  turn(p.q, v, at);
  for (int i = 0; i < 3; i++) {
    at[i] += p.t[i];
  }
}

/* How much the velocity changes about a part of the way; that velocity. */
static long double acceleration(const motion *r, long double part, long double velocity[3]) {
  const long double h = 0x1p-12L;
  long double at[3][3];
  long double square = 0;
  for (int k = 0; k < 3; k++) {
    point_at(r, part + h * (k - 1), at[k]);
  }
  for (int i = 0; i < 3; i++) {
    long double d = (at[2][i] - 2 * at[1][i] + at[0][i]) / (h * h);
    velocity[i] = (at[2][i] - at[0][i]) / (2 * h);
    square += d * d;
  }
  return sqrtl(square);
}

/* Three joints along x, y, z, and some behind them that move a point: the three take its velocity
 * at the middle away, so that the bound is the chord and 1/32 of the greatest acceleration. */
static motion draw_still(double size) {
  size_t joints = 4 + (size_t)random_below(3);
  motion r = {.m = row_of(joints), .a = joints, .b = 0};
  static const sepax_joint_kind kinds[] = {SEPAX_JOINT_REVOLUTE, SEPAX_JOINT_PRISMATIC};
  bool same = random_below(2) == 0; /* all about one axis, as fast as each other */
  for (size_t n = 0; n < joints; n++) {
    sepax_joint *joint = &r.m.joint[n];
    if (n >= 3 && !same) {
      draw_joint(joint, n + 1);
    }
    joint->parent = n;
    joint->kind = n < 3 ? SEPAX_JOINT_PRISMATIC : same ? kinds[0] : kinds[random_below(2)];
    for (int i = 0; n < 3 && i < 3; i++) {
      joint->axis[i] = i == (int)n;
    }
    r.to[n] = n < 3 ? 0 : size * (same ? 1 : random_unit());
    r.from[n] = -r.to[n];
  }
  for (int i = 0; i < 3; i++) {
    r.box[0][i] = r.box[1][i] = random_unit();
  }
  assert_works(sepax_mechanism_join(&r.m, &fault));
  return r;
}

/* False where the bound may be the sum of all ways instead. */
static bool covers_acceleration(motion *r) {
  long double velocity[3];
  long double most = 0;
  acceleration(r, 0.5L, velocity);
  for (int i = 0; i < 3; i++) {
    r->to[i] = (double)(-velocity[i] / 2);
    r->from[i] = -r->to[i];
  }
  double way = hypot(hypot(r->to[0], r->to[1]), r->to[2]);
  for (int step = 1; step < STEPS; step++) {
    most = fmaxl(most, acceleration(r, (long double)step / STEPS, velocity));
  }
  place at[3];
  for (int k = 0; k < 3; k++) {
    at[k] = seen(&r->m, r->from, r->to, k / 2.0L, r->a, r->b);
  }
  double chord =
      (double)fmaxl(way_between(&at[1], &at[0], r->box[0]), way_between(&at[1], &at[2], r->box[0]));
  if (most * 5 / 32 >= way || most <= 1e-4L) {
    return false;
  }
  assert_true(32 * (travel_of(r) - chord) >= (double)most * (1 - 1e-5));
  return true;
}

CASE(test_acceleration) {
  int tried = 0;
  for (int n = 0; n < FEWER(2000); n++) {
    motion r = draw_still(0.4 * fabs(random_unit()));
    tried += covers_acceleration(&r);
    sepax_mechanism_free(&r.m);
  }
  assert_true(tried > FEWER(500));
}

/* A slide on a turntable, in its centre at the middle: away from that it is farther. */
CASE(test_slide) {
  motion r = {.m = row_of(5), .a = 5};
  for (size_t n = 0; n < 5; n++) {
    sepax_joint *joint = &r.m.joint[n];
    joint->kind = n == 3 ? SEPAX_JOINT_REVOLUTE : SEPAX_JOINT_PRISMATIC;
    joint->axis[2] = n == 2 || n == 3;
    joint->axis[n == 1] = n < 2 || n == 4;
    r.to[n] = n < 3 ? 0 : 0.25;
    r.from[n] = -r.to[n];
  }
  assert_works(sepax_mechanism_join(&r.m, &fault));
  assert_true(covers_acceleration(&r));
  sepax_mechanism_free(&r.m);
}

/* Nothing moves: what is left is rounding. */
CASE(test_stillness) {
  motion r = draw_motion(0);
  while (r.m.joints < 3 || r.a == r.b) {
    sepax_mechanism_free(&r.m);
    r = draw_motion(0);
  }
  double travel = travel_of(&r);
  assert_true(travel > 0 && travel < 1e-9);
  sepax_mechanism_free(&r.m);
}

/* A turn about an axis far from the body, whose chord is far from its arc. */
CASE(test_arc) {
  motion r = {.m = row_of(1), .a = 1, .box = {{-1, 0, 0}, {-1, 0, 0}}, .from = {-1}, .to = {1}};
  r.m.joint[0].kind = SEPAX_JOINT_REVOLUTE;
  assert_works(sepax_mechanism_join(&r.m, &fault));
  double travel = travel_of(&r);
  assert_true(travel >= 2 * sin(0.5) && travel <= 2 * sin(0.5) + 4.0 / 32 + 1e-6);
  sepax_mechanism_free(&r.m);
}
