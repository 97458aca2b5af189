/* SPDX-License-Identifier: MIT */
/* blends.c - positions of a control that blends two straight motions are near the motions, as
 * blend.h says: random blends that keep the manual's word, in wide numbers. */
#include "nc/blend.h"
#include "streams.h"

enum { STEPS = 40 };

static struct {
  wide worst; /* the largest share of the bound that is needed */
  size_t count;
} found;

/* Two motions that meet in the corner. */
typedef struct {
  nc_way way[2];
  double length[2]; /* in X, Y, Z */
} corner;

static corner random_corner(bool turns) {
  corner c = {0};
  double near = pow(10, -3 * fabs(random_unit()));
  for (int i = 0; i < NC_AXES; i++) {
    double to = i >= 3 && !turns ? 0 : 30 * random_unit();
    double on = i >= 3 && !turns ? 0 : 30 * random_unit();
    /* A third of the corners are nearly straight, a third are nearly reversals. */
    int kind = random_below(3);
    on = kind == 0 ? on : (kind == 1 ? to : -to) + near * on;
    c.way[0].to[i] = c.way[1].from[i] = 100 * random_unit();
    c.way[0].from[i] = c.way[0].to[i] - to;
    c.way[1].to[i] = c.way[1].from[i] + on;
  }
  for (int k = 0; k < 2; k++) {
    wide sum = 0;
    for (int i = 0; i < 3; i++) {
      wide d = (wide)c.way[k].to[i] - c.way[k].from[i];
      sum += d * d;
    }
    c.length[k] = (double)sqrtl(sum);
  }
  return c;
}

/* The position with the shares a of the first motion left and b of the second done. */
static void position(const corner *c, wide a, wide b, wide x[NC_AXES]) {
  for (int i = 0; i < NC_AXES; i++) {
    wide p = c->way[0].to[i];
    x[i] = p - a * (p - c->way[0].from[i]) + b * (c->way[1].to[i] - p);
  }
}

static wide from_corner(const corner *c, const wide x[NC_AXES]) {
  wide sum = 0;
  for (int i = 0; i < 3; i++) {
    sum += (x[i] - c->way[0].to[i]) * (x[i] - c->way[0].to[i]);
  }
  return sqrtl(sum);
}

/* A blend: a falls from `most` to 0 and b rises from 0 to `most`, each at a rate of its own. */
typedef struct {
  wide most, bend[2];
} blend;

static void at_step(const blend *s, int step, wide *a, wide *b) {
  wide t = (wide)step / STEPS;
  *a = s->most * powl(1 - t, s->bend[0]);
  *b = s->most * powl(t, s->bend[1]);
}

/* The least distance from the corner, in X, Y, Z. */
static wide passes_at(const corner *c, const blend *s) {
  wide least = INFINITY, x[NC_AXES], a, b;
  for (int step = 0; step <= STEPS; step++) {
    at_step(s, step, &a, &b);
    position(c, a, b, x);
    least = fminl(least, from_corner(c, x));
  }
  return least;
}

/* The least factor on `off` by which a point of the motion is near x, and its share t. */
static wide needed(const nc_way *way, const wide x[NC_AXES], const double off[NC_AXES], wide *t) {
  wide low = 0, high = 64;
  for (int round = 0; round < 34; round++) {
    wide by = (low + high) / 2, from = 0, to = 1;
    for (int i = 0; i < NC_AXES; i++) {
      wide d = (wide)way->to[i] - way->from[i], e = x[i] - way->from[i], w = by * off[i] + 1e-15L;
      if (fabsl(d) < 1e-18L) {
        to = fabsl(e) <= w ? to : -1;
        continue;
      }
      wide p = (e - w) / d, q = (e + w) / d;
      from = fmaxl(from, fminl(p, q));
      to = fminl(to, fmaxl(p, q));
    }
    if (from <= to) {
      high = by;
      *t = (from + to) / 2;
    } else {
      low = by;
    }
  }
  return high;
}

/* The joints at x are within `joint` of those at the share t of a motion. */
static void look_at_joints(const mill *m, const nc_way *way, const wide x[NC_AXES], wide t,
                           const double joint[NC_JOINTS_MOST]) {
  wide on[NC_AXES], a[NC_AXES], b[NC_AXES];
  for (int i = 0; i < NC_AXES; i++) {
    on[i] = way->from[i] + ((wide)way->to[i] - way->from[i]) * t;
  }
  wide_metric(m, "XYZAC", x, a);
  wide_metric(m, "XYZAC", on, b);
  for (int n = 0; n < 5; n++) {
    assert_true(fabsl(a[n] - b[n]) <= joint[n] * (1 + 1e-12L) + 1e-16L);
  }
}

static nc_kinematics kinematics_of(const mill *m) {
  nc_kinematics k = {.module = NC_XYZAC, .joints = 5, .joint_axis = {0, 1, 2, NC_A, NC_C}};
  for (int i = 0; i < 3; i++) {
    k.value[NC_POINT + i] = m->point[i];
    k.value[NC_OFFSET + i] = m->offset[i];
  }
  k.value[NC_TOOL_OFFSET] = m->tool;
  return k;
}

static nc_leg leg_of(const nc_way *way) {
  nc_leg leg = {.way = way};
  for (int i = 0; i < NC_AXES; i++) {
    leg.moves[i] = way->from[i] != way->to[i];
  }
  return leg;
}

static void look_at(const corner *c, const blend *s, nc_blend kind, double within) {
  mill m = {.module = 'A', .point = {3, -2, 70}, .offset = {0, 20, 10}, .tool = 42};
  nc_kinematics k = kinematics_of(&m);
  nc_leg first = leg_of(&c->way[0]), second = leg_of(&c->way[1]);
  double off[NC_AXES], joint[NC_JOINTS_MOST];
  nc_blend_corner(&first, &second, kind, within, 0, off);
  nc_blend_joints(&k, &c->way[0], &c->way[1], off, joint);
  for (int step = 0; step <= STEPS; step++) {
    wide x[NC_AXES], a, b, t[2] = {0, 0};
    at_step(s, step, &a, &b);
    position(c, a, b, x);
    wide by[2] = {needed(&c->way[0], x, off, &t[0]), needed(&c->way[1], x, off, &t[1])};
    int near = by[0] < by[1] ? 0 : 1;
    if (!(by[near] <= 1 + 1e-7L)) {
      fail_msg("a position is at %Lg times the bound", by[near]);
    }
    found.worst = fmaxl(found.worst, by[near]);
    found.count++;
    look_at_joints(&m, &c->way[near], x, t[near], joint);
  }
}

static blend random_blend(void) {
  return (blend){1, {powl(4, random_unit()), powl(4, random_unit())}};
}

static void assert_found(void) {
  print_message("%zu positions: worst %.4Lf of the bound\n", found.count, found.worst);
  assert_true(found.count > 0);
  assert_true(found.worst > 0.5L);
}

/* Blends as long as the tolerance allows. */
static void look_at_tolerances(bool turns) {
  memset(&found, 0, sizeof found);
  for (int n = 0; n < FEWER(300); n++) {
    corner c = random_corner(turns);
    double within = pow(10, -1 + 2 * random_unit());
    blend s = random_blend();
    wide low = 0, high = 1;
    if (passes_at(&c, &s) > within) {
      for (int round = 0; round < 34; round++) {
        s.most = (low + high) / 2;
        *(passes_at(&c, &s) <= within ? &low : &high) = s.most;
      }
      s.most = low;
    }
    look_at(&c, &s, NC_WITHIN, within);
  }
  assert_found();
}

CASE(test_tolerance) { look_at_tolerances(false); }

CASE(test_tolerance_with_turns) { look_at_tolerances(true); }

/* Without a tolerance a blend may be as long as both motions. */
CASE(test_unbounded) {
  memset(&found, 0, sizeof found);
  for (int n = 0; n < FEWER(300); n++) {
    corner c = random_corner(n % 2 == 0);
    blend s = random_blend();
    look_at(&c, &s, NC_UNBOUNDED, 0);
  }
  assert_found();
}

/* The first motion brakes from its speed with half of its acceleration, the second speeds up with
 * half of its own meanwhile. */
static void look_at_pace(const corner *c, nc_leg leg[2], double share) {
  enum { NEVER = 64 };
  double off[NC_AXES], servo = 0.001;
  wide speed = (wide)share * leg[0].rate, g1 = leg[0].gain / 2, g2 = leg[1].gain / 2;
  speed = fminl(speed, sqrtl(2 * g1)); /* it has not more than all of its way to brake */
  nc_blend_corner(&leg[0], &leg[1], NC_UNBOUNDED, 0, servo, off);
  for (int step = 0; step <= STEPS; step++) {
    wide time = speed / g1 * step / STEPS, x[NC_AXES], t;
    wide a = (speed - g1 * time) * (speed - g1 * time) / (2 * g1);
    wide grows = fminl(time, leg[1].rate / g2);
    wide b = g2 * grows * grows / 2 + leg[1].rate * (time - grows);
    position(c, a, fminl(b, 1), x);
    wide by = fminl(needed(&c->way[0], x, off, &t), needed(&c->way[1], x, off, &t));
    if (!(by <= 1 + 1e-7L)) {
      fail_msg("a position is at %Lg times the bound", by < NEVER ? by : NEVER);
    }
    found.worst = fmaxl(found.worst, by);
    found.count++;
  }
}

CASE(test_pace) {
  memset(&found, 0, sizeof found);
  for (int n = 0; n < FEWER(2000); n++) {
    corner c = random_corner(n % 2 == 0);
    nc_limits limits[NC_AXES];
    nc_leg leg[2] = {leg_of(&c.way[0]), leg_of(&c.way[1])};
    for (int i = 0; i < NC_AXES; i++) {
      limits[i].speed = 10 * pow(10, fabs(random_unit()));
      limits[i].acceleration = 100 * pow(10, fabs(random_unit()));
    }
    nc_blend_pace(&leg[0], limits);
    nc_blend_pace(&leg[1], limits);
    assert_true(leg[0].rate > 0 && leg[1].rate > 0);
    look_at_pace(&c, leg, n % 3 == 0 ? 1 : fabs(random_unit()));
  }
  assert_found();
}

/* Without the limits of an axis that moves nothing is known, and merged motions have no rate. */
CASE(test_pace_not_known) {
  corner c = random_corner(true);
  nc_limits limits[NC_AXES];
  nc_leg leg = leg_of(&c.way[0]);
  for (int i = 0; i < NC_AXES; i++) {
    limits[i] = (nc_limits){30, 300};
  }
  leg.merges = true;
  nc_blend_pace(&leg, limits);
  assert_true(leg.rate == 0 && leg.brake >= 2 * 0.1);
  limits[NC_C] = (nc_limits){0, 0};
  nc_blend_pace(&leg, limits);
  assert_true(leg.rate == 0 && leg.brake == 0);
  leg.merges = false;
  nc_blend_pace(&leg, limits);
  assert_true(leg.rate == 0 && leg.brake == 0);
}

/* In X, Y, Z the bound is no more than the tolerance, and no axis has one that does not move. */
CASE(test_tolerance_is_enough) {
  for (int n = 0; n < FEWER(1000); n++) {
    corner c = random_corner(false);
    double within = pow(10, -1 + 2 * random_unit()), off[NC_AXES];
    int still = random_below(3);
    c.way[0].from[still] = c.way[0].to[still];
    c.way[1].to[still] = c.way[1].from[still];
    nc_leg first = leg_of(&c.way[0]), second = leg_of(&c.way[1]);
    nc_blend_corner(&first, &second, NC_WITHIN, within, 0, off);
    for (int i = 0; i < NC_AXES; i++) {
      assert_true(off[i] <= within * (1 + 1e-9));
      assert_true(off[i] == 0 || (i < 3 && i != still));
    }
  }
}
