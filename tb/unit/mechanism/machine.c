/* SPDX-License-Identifier: MIT */
/* machine.c - queries of a whole machine, against one query for each pair, and against positions
 * within the travel in long double. */
#include "mechanism/machine.h"
#include "oracle/distance.h"
#include "unit/body/draws.h"
#include "unit/mechanism/places.h"

enum { JOINTS_MOST = 9, BODIES_MOST = 6, PAIRS_MOST = 12 };

typedef struct {
  sepax_mechanism m;
  sepax_machine_body body[BODIES_MOST];
  sepax_soup mesh[BODIES_MOST];
  sepax_chain chain[PAIRS_MOST];
  size_t pair[PAIRS_MOST][2];
  size_t bodies, pairs;
  double value[JOINTS_MOST], travel[JOINTS_MOST];
  sepax_machine *machine;
  sepax_watch *watch;
} rig;

/* ------------------------------------------------------------------------ drawing */

static void draw_mechanism(rig *r) {
  size_t joints = 1 + (size_t)random_below(JOINTS_MOST);
  r->m = row_of(joints);
  for (size_t n = 0; n < joints; n++) {
    sepax_joint *joint = &r->m.joint[n];
    draw_joint(joint, n + 1);
    if (n > 0 && random_below(5) == 0 && sepax_joint_driven(joint)) {
      size_t leader = (size_t)random_below((int)n);
      if (sepax_joint_driven(&r->m.joint[leader])) {
        joint->mimic = leader;
        joint->factor = 2 * random_unit();
        joint->offset = random_unit();
      }
    }
  }
  assert_works(sepax_mechanism_join(&r->m, &fault));
}

static void make_machine(rig *r) {
  const sepax_machine_parts parts = {.size = sizeof parts,
                                     .mechanism = &r->m,
                                     .body = r->body,
                                     .bodies = r->bodies,
                                     .pair = (const size_t(*)[2])r->pair,
                                     .pairs = r->pairs};
  assert_works(sepax_machine_new(&r->machine, &parts, &fault));
  assert_works(sepax_watch_new(&r->watch, r->machine, &fault));
  for (size_t n = 0; n < r->pairs; n++) {
    assert_works(sepax_chain_find(&r->chain[n], &r->m, r->body[r->pair[n][0]].link,
                                  r->body[r->pair[n][1]].link, &fault));
  }
}

static void add_body(rig *r, size_t link, size_t triangles, double size) {
  sepax_body *body;
  sepax_soup *mesh = &r->mesh[r->bodies];
  *mesh = strewn(triangles, 0.5, 0);
  for (size_t n = 0; n < 9 * triangles; n++) {
    mesh->facet[n / 9].v[n / 3 % 3][n % 3] *= size;
  }
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(mesh), NULL, &fault));
  r->body[r->bodies++] = (sepax_machine_body){link, body};
}

static void draw_rig(rig *r) {
  *r = (rig){0};
  draw_mechanism(r);
  size_t bodies = 2 + (size_t)random_below(BODIES_MOST - 1);
  double size = ldexp(1, -random_below(4));
  for (size_t n = 0; n < bodies; n++) {
    add_body(r, (size_t)random_below((int)r->m.links), 1 + (size_t)random_below(30),
             size * (0.2 + fabs(random_unit())));
  }
  size_t pairs = 1 + (size_t)random_below(PAIRS_MOST);
  for (; r->pairs < pairs; r->pairs++) {
    r->pair[r->pairs][0] = (size_t)random_below((int)bodies);
    r->pair[r->pairs][1] =
        (r->pair[r->pairs][0] + 1 + (size_t)random_below((int)bodies - 1)) % bodies;
  }
  make_machine(r);
}

static void free_rig(rig *r) {
  for (size_t n = 0; n < r->pairs; n++) {
    sepax_chain_free(&r->chain[n]);
  }
  for (size_t n = 0; n < r->bodies; n++) {
    sepax_body_free((sepax_body *)r->body[n].body);
    sepax_soup_free(&r->mesh[n]);
  }
  sepax_watch_free(r->watch);
  sepax_machine_free(r->machine);
  sepax_mechanism_free(&r->m);
}

/* Some joints stand, some move a little, and sometimes all jump. */
static void move(rig *r) {
  double size = random_below(4) == 0 ? 7 : ldexp(1, -random_below(20));
  for (size_t n = 0; n < r->m.joints; n++) {
    if (random_below(2) == 0) {
      r->value[n] = size == 7 ? 7 * random_unit() : r->value[n] + size * random_unit();
    }
  }
}

/* ---------------------------------------------------------------- without a travel */

static void poses_of(const rig *r, size_t pair, sepax_pose pose[2]) {
  double value[JOINTS_MOST];
  memcpy(value, r->value, sizeof value);
  sepax_mechanism_follow(&r->m, value);
  sepax_chain_poses(&r->chain[pair], &r->m, value, pose);
}

static const sepax_machine_body *body_of(const rig *r, size_t pair, int side) {
  return &r->body[r->pair[pair][side]];
}

static double distance_of(const rig *r, size_t pair) {
  sepax_pose pose[2];
  sepax_distance_result found;
  poses_of(r, pair, pose);
  assert_works(sepax_bodies_distance(body_of(r, pair, 0)->body, &pose[0], body_of(r, pair, 1)->body,
                                     &pose[1], NULL, &found, &fault));
  return found.min_distance;
}

/* The first pair that is near, by one query for each pair. */
static size_t first_near(const rig *r, double clearance) {
  for (size_t n = 0; n < r->pairs; n++) {
    sepax_pose pose[2];
    sepax_pairs found;
    const sepax_query query = {.size = sizeof query, .only_any = true};
    poses_of(r, n, pose);
    assert_works(sepax_bodies_near(body_of(r, n, 0)->body, &pose[0], body_of(r, n, 1)->body,
                                   &pose[1], clearance, &query, &found, &fault));
    if (found.count > 0) {
      return n;
    }
  }
  return SEPAX_NO_PAIR;
}

static void assert_triangles(const rig *r, const sepax_machine_answer *answer, double clearance) {
  sepax_pose pose[2];
  const size_t *b = r->pair[answer->pair];
  poses_of(r, answer->pair, pose);
  assert_true(answer->triangle[0] < r->mesh[b[0]].count &&
              answer->triangle[1] < r->mesh[b[1]].count);
  assert_true(distance_within_posed(r->mesh[b[0]].facet[answer->triangle[0]].v, &pose[0],
                                    r->mesh[b[1]].facet[answer->triangle[1]].v, &pose[1],
                                    clearance));
}

/* A clearance that decides: of no pair, of a pair exactly, next to that, or any. */
static double draw_clearance(const rig *r) {
  double of_pair = distance_of(r, (size_t)random_below((int)r->pairs));
  int ulps = random_below(3) - 1;
  switch (random_below(4)) {
  case 0:
    return 0;
  case 1:
    return fabs(random_unit());
  default:
    return of_pair > 0 ? stepped(of_pair, ulps) : of_pair;
  }
}

static size_t verdicts[3];

/* Returns the work that the query took. */
static uint64_t assert_verdict(rig *r, double clearance, uint64_t work) {
  sepax_machine_answer answer;
  const sepax_machine_query query = {.size = sizeof query, .clearance = clearance, .work = work};
  assert_works(sepax_watch_ask(r->watch, r->value, &query, &answer, &fault));
  size_t expected = first_near(r, clearance);
  verdicts[answer.verdict]++;
  if (work == 0 || answer.verdict == SEPAX_APART) {
    assert_int_equal(answer.verdict, expected == SEPAX_NO_PAIR ? SEPAX_APART : SEPAX_NEAR);
    assert_int_equal(answer.pair, expected);
  }
  assert_true(work > 0 || answer.work >= r->pairs);
  if (answer.verdict == SEPAX_NEAR) {
    assert_true(answer.pair >= expected);
    assert_triangles(r, &answer, clearance);
  }
  assert_true(answer.verdict != SEPAX_UNDECIDED || answer.pair <= expected);
  return answer.work;
}

CASE(verdicts_of_values) {
  memset(verdicts, 0, sizeof verdicts);
  for (int n = 0; n < FEWER(400); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 20; step++) {
      move(&r);
      double clearance = draw_clearance(&r);
      assert_verdict(&r, clearance, 0);
      if (random_below(4) == 0) { /* nothing moved: all is known */
        assert_int_equal(assert_verdict(&r, clearance, 0), r.pairs);
        assert_verdict(&r, draw_clearance(&r), 0);
      }
    }
    free_rig(&r);
  }
  assert_true(verdicts[SEPAX_NEAR] > FEWER(1000) && verdicts[SEPAX_APART] > FEWER(1000));
  assert_int_equal(verdicts[SEPAX_UNDECIDED], 0);
}

/* With a limit of work the verdict is right or not given. */
CASE(limits_of_work) {
  memset(verdicts, 0, sizeof verdicts);
  for (int n = 0; n < FEWER(200); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 20; step++) {
      move(&r);
      assert_verdict(&r, draw_clearance(&r), 1 + (uint64_t)random_below(1 << random_below(12)));
    }
    free_rig(&r);
  }
  assert_true(verdicts[SEPAX_NEAR] > FEWER(100) && verdicts[SEPAX_APART] > FEWER(100));
  assert_true(verdicts[SEPAX_UNDECIDED] > FEWER(100));
}

/* -------------------------------------------------------------------- measurement */

static void assert_measured(rig *r, double relative) {
  sepax_machine_answer answer;
  double least = INFINITY;
  const sepax_machine_query query = {
      .size = sizeof query, .measure = true, .relative = relative, .clearance = 0.1};
  assert_works(sepax_watch_ask(r->watch, r->value, &query, &answer, &fault));
  for (size_t n = 0; n < r->pairs; n++) {
    least = fmin(least, distance_of(r, n));
  }
  double ulp = stepped(least, 1) - least;
  assert_true(answer.least <= least + ulp && answer.most >= least - ulp);
  assert_true(answer.most - answer.least <= relative * answer.most + 3 * ulp);
  double nearest = distance_of(r, answer.nearest);
  assert_true(nearest >= least && nearest <= answer.most);
}

CASE(least_clearance) {
  static const double tolerances[] = {0, 1e-12, 1e-6, 0.1};
  for (int n = 0; n < FEWER(200); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 10; step++) {
      move(&r);
      assert_measured(&r, tolerances[random_below(4)]);
    }
    free_rig(&r);
  }
}

/* The interval is certain however little work is allowed. */
CASE(least_clearance_with_limits) {
  for (int n = 0; n < FEWER(200); n++) {
    rig r;
    draw_rig(&r);
    for (int step = 0; step < 10; step++) {
      move(&r);
      sepax_machine_answer answer;
      double least = INFINITY;
      const sepax_machine_query query = {.size = sizeof query,
                                         .measure = true,
                                         .work = 1 + (uint64_t)random_below(1 << random_below(12))};
      assert_works(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault));
      for (size_t k = 0; k < r.pairs; k++) {
        least = fmin(least, distance_of(&r, k));
      }
      double ulp = stepped(least, 1) - least;
      assert_true(answer.least <= least + ulp && answer.most >= least - ulp);
    }
    free_rig(&r);
  }
}

/* ------------------------------------------------------------------------- travel */

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

/* ------------------------------------------------------------------------- errors */

CASE(refused_parts) {
  rig r = {0};
  sepax_machine *machine;
  draw_mechanism(&r);
  add_body(&r, 0, 3, 1);
  add_body(&r, 0, 3, 1);
  static const size_t pair[3][2] = {{0, 1}, {0, 2}, {0, 0}};
  const sepax_machine_parts right = {sizeof right, &r.m, r.body, 2, pair, 1};
  sepax_machine_parts parts = right;
  parts.pairs = 0;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "no pairs");
  assert_null(machine);
  parts.pairs = 2;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "pair 1 names the bodies 0 and 2");
  parts = right;
  parts.pair = &pair[2];
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "two different ones");
  r.body[1].link = r.m.links;
  assert_fault(sepax_machine_new(&machine, &right, &fault), "body 1 is missing or names link");
  r.body[1].link = 0;
  assert_fault(sepax_machine_new(&machine, NULL, &fault), "no mechanism");
  sepax_mechanism unjoined = r.m;
  unjoined.order = NULL;
  parts = right;
  parts.mechanism = &unjoined;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "after sepax_mechanism_join");
  parts = right;
  parts.size = 0;
  assert_fault(sepax_machine_new(&machine, &parts, &fault), "has no size");
  free_rig(&r);
}

/* After an error the watch is as good as new. */
CASE(refused_queries) {
  for (int n = 0; n < FEWER(100); n++) {
    rig r;
    draw_rig(&r);
    sepax_machine_answer answer;
    size_t driven = SIZE_MAX;
    for (size_t k = 0; k < r.m.joints; k++) {
      driven = sepax_joint_driven(&r.m.joint[k]) ? k : driven;
    }
    move(&r);
    assert_verdict(&r, 0.1, 0);
    sepax_machine_query query = {.size = sizeof query, .clearance = -1};
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "clearance");
    query.clearance = NAN;
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "clearance");
    query = (sepax_machine_query){.size = sizeof query, .relative = -1};
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "tolerance");
    query.relative = 1; /* also if nothing is measured */
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "tolerance of 1");
    query.relative = 0;
    query.absolute = INFINITY;
    assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "tolerance of 0");
    query.absolute = 0;
    if (driven != SIZE_MAX) {
      static const double bad[] = {NAN, INFINITY, -INFINITY};
      double kept = r.value[driven];
      query = (sepax_machine_query){.size = sizeof query};
      r.value[driven] = bad[random_below(3)];
      assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "finite");
      assert_int_equal(answer.verdict, SEPAX_UNDECIDED);
      r.value[driven] = kept;
      query.travel = r.travel;
      r.travel[driven] = random_below(2) == 0 ? -1 : NAN;
      assert_fault(sepax_watch_ask(r.watch, r.value, &query, &answer, &fault), "travel");
      r.travel[driven] = 0;
    }
    assert_verdict(&r, 0.1, 0);
    free_rig(&r);
  }
}

CASE(links_beyond_limits) {
  rig r = {.m = row_of(1), .pair = {{0, 1}}, .pairs = 1};
  sepax_machine_answer answer;
  r.m.joint[0].kind = SEPAX_JOINT_PRISMATIC;
  assert_works(sepax_mechanism_join(&r.m, &fault));
  add_body(&r, 0, 3, 1);
  add_body(&r, 1, 3, 1);
  make_machine(&r);
  r.value[0] = 0x1p1001;
  assert_fault(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault), "beyond 2^1000");
  r.value[0] = 0x1p999;
  assert_works(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault));
  assert_int_equal(answer.verdict, SEPAX_APART);
  free_rig(&r);
}

/* A query that fails halfway leaves no pose behind: links on two slides, of which the first fails.
 */
CASE(error_halfway) {
  rig r = {.m = row_of(2), .pair = {{0, 1}}, .pairs = 1};
  sepax_machine_answer answer;
  for (size_t n = 0; n < 2; n++) {
    r.m.joint[n].kind = SEPAX_JOINT_PRISMATIC;
    r.m.joint[n].parent = 0;
  }
  assert_works(sepax_mechanism_join(&r.m, &fault));
  add_body(&r, 1, 3, 1);
  add_body(&r, 2, 3, 1);
  make_machine(&r);
  assert_works(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault));
  r.value[0] = 0x1p1001;
  r.value[1] = 100;
  assert_fault(sepax_watch_ask(r.watch, r.value, NULL, &answer, &fault), "beyond 2^1000");
  r.value[0] = 100;
  assert_verdict(&r, stepped(distance_of(&r, 0), 1), 0);
  assert_verdict(&r, stepped(distance_of(&r, 0), -1), 0);
  free_rig(&r);
}
