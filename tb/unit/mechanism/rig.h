/* SPDX-License-Identifier: MIT */
/* rig.h - machines at random, and what one query for each pair says of them. */
#ifndef RIG_H
#define RIG_H

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

static inline void draw_mechanism(rig *r) {
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

static inline void make_machine(rig *r) {
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

static inline void add_body(rig *r, size_t link, size_t triangles, double size) {
  sepax_body *body;
  sepax_soup *mesh = &r->mesh[r->bodies];
  *mesh = strewn(triangles, 0.5, 0);
  for (size_t n = 0; n < 9 * triangles; n++) {
    mesh->facet[n / 9].v[n / 3 % 3][n % 3] *= size;
  }
  assert_works(sepax_body_new(&body, SEPAX_SOUP_MESH(mesh), NULL, &fault));
  r->body[r->bodies++] = (sepax_machine_body){link, body};
}

static inline void draw_rig(rig *r) {
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

static inline void free_rig(rig *r) {
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
static inline void move(rig *r) {
  double size = random_below(4) == 0 ? 7 : ldexp(1, -random_below(20));
  for (size_t n = 0; n < r->m.joints; n++) {
    if (random_below(2) == 0) {
      r->value[n] = size == 7 ? 7 * random_unit() : r->value[n] + size * random_unit();
    }
  }
}

/* ---------------------------------------------------------------- one pair by itself */

static inline void poses_of(const rig *r, size_t pair, sepax_pose pose[2]) {
  double value[JOINTS_MOST];
  memcpy(value, r->value, sizeof value);
  sepax_mechanism_follow(&r->m, value);
  sepax_chain_poses(&r->chain[pair], &r->m, value, pose);
}

static inline const sepax_machine_body *body_of(const rig *r, size_t pair, int side) {
  return &r->body[r->pair[pair][side]];
}

static inline double distance_of(const rig *r, size_t pair) {
  sepax_pose pose[2];
  sepax_distance_result found;
  poses_of(r, pair, pose);
  assert_works(sepax_bodies_distance(body_of(r, pair, 0)->body, &pose[0], body_of(r, pair, 1)->body,
                                     &pose[1], NULL, &found, &fault));
  return found.min_distance;
}

/* The first pair that is near, by one query for each pair. */
static inline size_t first_near(const rig *r, double clearance) {
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

static inline void assert_triangles(const rig *r, const sepax_machine_answer *answer,
                                    double clearance) {
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
static inline double draw_clearance(const rig *r) {
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
static inline uint64_t assert_verdict(rig *r, double clearance, uint64_t work) {
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

#endif
