/* SPDX-License-Identifier: MIT */
/* machine_travel.c - queries of a whole machine for all values within a travel, against positions
 * within the travel in long double. */
#include "mechanism/machine.h"
#include "unit/mechanism/rig.h"

/* Place of each link for values in long double, without rounding of followers. */
static void place_links(const sepax_mechanism *m, const long double *value,
                        place at[JOINTS_MOST + 1]) {
  at[0] = (place){{1, 0, 0, 0}, {0, 0, 0}};
  for (size_t n = 0; n < m->joints; n++) {
    const sepax_joint *joint = &m->joint[n];
    long double q = joint->mimic == SEPAX_NO_JOINT
                        ? value[n]
                        : joint->factor * value[joint->mimic] + joint->offset;
    place step = place_of(joint, q);
    at[n + 1] = after(&at[joint->parent], &step);
  }
}

static void point_at(const place *p, const double v[3], long double to[3]) {
  const long double point[3] = {v[0], v[1], v[2]};
  turn(p->q, point, to);
  for (int i = 0; i < 3; i++) {
    to[i] += p->t[i];
  }
}

static long double way_between(const long double p[3], const long double q[3]) {
  long double square = 0;
  for (int i = 0; i < 3; i++) {
    square += (p[i] - q[i]) * (p[i] - q[i]);
  }
  return sqrtl(square);
}

/* Values within the travel, most of them at its ends. */
static void draw_within(const rig *r, long double *value) {
  for (size_t n = 0; n < r->m.joints; n++) {
    long double part = random_below(3) == 0 ? random_unit() : 2 * random_below(2) - 1;
    value[n] = r->value[n] + part * r->travel[n];
  }
}

/* How much the distance of two vertices changes, at most. */
static double sampled(const rig *r, size_t pair) {
  long double value[2][JOINTS_MOST];
  place at[2][JOINTS_MOST + 1];
  const sepax_soup *mesh[2] = {&r->mesh[r->pair[pair][0]], &r->mesh[r->pair[pair][1]]};
  size_t link[2] = {body_of(r, pair, 0)->link, body_of(r, pair, 1)->link};
  long double most = 0;
  for (size_t n = 0; n < r->m.joints; n++) {
    value[0][n] = r->value[n];
  }
  place_links(&r->m, value[0], at[0]);
  for (int draw = 0; draw < 40; draw++) {
    draw_within(r, value[1]);
    place_links(&r->m, value[1], at[1]);
    for (int points = 0; points < 10; points++) {
      long double p[2][2][3];
      for (int side = 0; side < 2; side++) {
        const double *v =
            mesh[side]->facet[random_below((int)mesh[side]->count)].v[random_below(3)];
        for (int k = 0; k < 2; k++) {
          point_at(&at[k][link[side]], v, p[k][side]);
        }
      }
      most = fmaxl(most, fabsl(way_between(p[1][0], p[1][1]) - way_between(p[0][0], p[0][1])));
    }
  }
  return (double)most;
}

static void draw_travel(rig *r) {
  double size = ldexp(1, 3 - random_below(30));
  for (size_t n = 0; n < r->m.joints; n++) {
    r->travel[n] = random_below(3) == 0 ? 0 : size * fabs(random_unit());
  }
}

/* Both bounds of the motion hold, and the second is the lesser. */
CASE(bounds_of_travel) {
  int lesser = 0;
  double closest = INFINITY;
  for (int n = 0; n < FEWER(1000); n++) {
    rig r;
    draw_rig(&r);
    sepax_machine_answer answer;
    move(&r);
    draw_travel(&r);
    const sepax_machine_query query = {.size = sizeof query, .travel = r.travel};
    assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
    for (size_t pair = 0; pair < r.pairs; pair++) {
      double quick = sepax__pair_motion(r.watch, pair);
      double best = sepax__pair_least_motion(r.watch, pair);
      double way = sampled(&r, pair);
      assert_true(way <= best && best <= quick);
      lesser += best < quick * 0.99;
      closest = way > 1e-7 ? fmin(closest, best / way) : closest;
    }
    free_rig(&r);
  }
  assert_true(lesser > FEWER(200));
  assert_true(closest < 1.02);
}

/* APART holds for positions within the travel; the interval holds their least distance. */
static void assert_travel(rig *r, double clearance) {
  sepax_machine_answer answer;
  const sepax_machine_query query = {.size = sizeof query,
                                     .clearance = clearance,
                                     .travel = r->travel,
                                     .measure = random_below(2) == 0};
  rig other = *r;
  assert_works(sepax_watch_ask(r->watch, r->value, &query, &answer, &fault));
  verdicts[answer.verdict]++;
  size_t expected = first_near(r, clearance);
  if (answer.verdict == SEPAX_NEAR) {
    assert_int_equal(answer.pair, expected);
    assert_triangles(r, &answer, clearance);
  } else {
    assert_int_equal(expected, SEPAX_NO_PAIR);
  }
  for (int draw = 0; draw < 5; draw++) {
    long double value[JOINTS_MOST];
    draw_within(r, value);
    for (size_t n = 0; n < r->m.joints; n++) { /* rounded into the travel */
      double at = (double)value[n];
      other.value[n] = fabsl(at - (long double)r->value[n]) <= r->travel[n] ? at : r->value[n];
    }
    for (size_t pair = 0; pair < r->pairs; pair++) {
      double distance = distance_of(&other, pair);
      const double lost = 1e-13; /* of the poses in doubles */
      assert_true(answer.verdict != SEPAX_APART || distance > clearance - lost);
      assert_true(!query.measure || answer.least <= distance + lost);
    }
  }
}

CASE(verdicts_of_travel) {
  memset(verdicts, 0, sizeof verdicts);
  for (int n = 0; n < FEWER(300); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 10; step++) {
      move(&r);
      draw_travel(&r);
      assert_travel(&r, draw_clearance(&r));
    }
    free_rig(&r);
  }
  for (int v = 0; v < 3; v++) {
    assert_true(verdicts[v] > FEWER(100));
  }
}

/* A slide: the least clearance within the travel is the distance less the travel. */
CASE(travel_of_a_slide) {
  rig r = {.m = row_of(1), .pair = {{0, 1}}, .pairs = 1};
  r.m.joint[0].kind = SEPAX_JOINT_PRISMATIC;
  assert_works(sepax_mechanism_join(&r.m, &fault));
  add_body(&r, 0, 20, 0.5);
  add_body(&r, 1, 20, 0.5);
  make_machine(&r);
  r.value[0] = 10;
  r.travel[0] = 0.25;
  sepax_machine_query query = {.size = sizeof query, .travel = r.travel, .measure = true};
  sepax_machine_answer answer;
  double distance = distance_of(&r, 0);
  assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
  assert_true(answer.least <= distance - 0.25 && answer.least >= distance - 0.25 - 1e-8);
  assert_true(answer.most > distance && answer.most <= distance + 1e-9);
  query.clearance = distance - 0.25 - 1e-8;
  assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
  assert_int_equal(answer.verdict, SEPAX_APART);
  query.clearance = distance - 0.25 + 1e-8;
  assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
  assert_int_equal(answer.verdict, SEPAX_UNDECIDED);
  assert_int_equal(answer.pair, 0);
  query.clearance = stepped(distance, 1);
  assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
  assert_int_equal(answer.verdict, SEPAX_NEAR);
  free_rig(&r);
}

/* A triangle, very small, on an axis of the link. */
static void add_point(rig *r, size_t link, double x, double y) {
  sepax_body *body;
  sepax_soup *mesh = &r->mesh[r->bodies];
  *mesh = strewn(1, 0, 0);
  for (int k = 0; k < 3; k++) {
    mesh->facet[0].v[k][0] = x + (k == 1 ? 1e-9 : 0);
    mesh->facet[0].v[k][1] = y + (k == 2 ? 1e-9 : 0);
    mesh->facet[0].v[k][2] = 0;
  }
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(mesh), NULL, &fault));
  r->body[r->bodies++] = (sepax_machine_body){link, body};
}

/* A turn of half a circle moves a body by two radii, a turn of more no farther. */
CASE(travel_of_a_turn) {
  for (int more = 0; more < 2; more++) {
    rig r = {.m = row_of(1), .pair = {{0, 1}}, .pairs = 1, .travel = {PI * (1 + 10 * more)}};
    r.m.joint[0].kind = SEPAX_JOINT_REVOLUTE;
    assert_works(sepax_mechanism_join(&r.m, &fault));
    add_point(&r, 0, -1.5, 0);
    add_point(&r, 1, 1, 0);
    make_machine(&r);
    sepax_machine_answer answer;
    const sepax_machine_query query = {.size = sizeof query, .travel = r.travel, .measure = true};
    assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
    assert_true(answer.least <= 0.5 + 1e-8 && answer.least >= 0.5 - 1e-8);
    free_rig(&r);
  }
}

/* Boxes and balls whose gap is the distance exactly, or twice as far: what rounds there may not
 * decide. The bodies are two points, or an edge's ends on axes. */
CASE(gaps_that_are_distances) {
  for (int n = 0; n < FEWER(2000); n++) {
    rig r = {.m = row_of(3), .pair = {{0, 1}}, .pairs = 1};
    for (size_t k = 0; k < 3; k++) {
      draw_joint(&r.m.joint[k], k + 1);
      r.value[k] = 7 * random_unit();
    }
    assert_works(sepax_mechanism_join(&r.m, &fault));
    add_point(&r, 0, random_unit(), random_unit());
    add_point(&r, 3, random_unit(), random_unit());
    for (size_t body = 0; body < 2; body++) { /* truly points */
      sepax_facet *facet = r.mesh[body].facet;
      memcpy(facet->v[1], facet->v[0], sizeof facet->v[0]);
      memcpy(facet->v[2], facet->v[0], sizeof facet->v[0]);
      sepax_body_free((sepax_body *)r.body[body].body);
      sepax_body *made;
      assert_works(sepax_body_new(&made, SEPAX_SOUP_MESH(&r.mesh[body]), NULL, &fault));
      r.body[body].body = made;
    }
    make_machine(&r);
    double distance = distance_of(&r, 0);
    for (int ulps = -1; ulps < 2; ulps++) {
      assert_verdict(&r, distance > 0 ? stepped(distance, ulps) : distance, 0);
    }
    free_rig(&r);
  }
}

/* ------------------------------------------------------------------ very large, small */

/* Lengths of 2^power, where squares overflow or underflow: the verdicts are those of each pair. */
CASE(extreme_sizes) {
  static const int powers[] = {-1000, -520, -450, -300, 300, 440, 460, 520, 900};
  for (size_t n = 0; n < LENGTH(powers); n++) {
    for (int draw = 0; draw < 10; draw++) {
      rig r = {0};
      double size = ldexp(1, powers[n]);
      draw_mechanism(&r);
      for (size_t k = 0; k < r.m.joints; k++) {
        for (int i = 0; i < 3; i++) {
          r.m.joint[k].origin.translation[i] *= size;
        }
      }
      add_body(&r, 0, 10, size / 2);
      add_body(&r, r.m.joints, 10, size / 2);
      r.pair[r.pairs++][1] = 1;
      make_machine(&r);
      for (int step = 0; step < 5; step++) {
        for (size_t k = 0; k < r.m.joints; k++) {
          r.value[k] = random_unit() * (r.m.joint[k].kind == SEPAX_JOINT_PRISMATIC ? size : 1);
          r.travel[k] = fabs(r.value[k]) / 16;
        }
        double clearance = fmin(draw_clearance(&r) * 2, 0x1p1000);
        assert_verdict(&r, clearance, 0);
        assert_travel(&r, clearance);
      }
      free_rig(&r);
    }
  }
}
