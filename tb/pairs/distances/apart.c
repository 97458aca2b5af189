/* SPDX-License-Identifier: MIT */
/* apart.c - whether sepax_bodies_apart says the truth, also with fronts along motions. */
#include "benchmark/columns.h"
#include "checks.h"

#include <assert.h>
#include <string.h>

/* ------------------------------------------------------------------------------- apart */

static sepax_apart_result ask_apart(const situation *s, double distance,
                                    const sepax_apart_request *request) {
  sepax_apart_result result;
  sepax_error error;
  if (!sepax_bodies_apart(s->body[0], s->given[0], s->body[1], s->given[1], distance, request,
                          &result, &error)) {
    bench_fail(&error);
  }
  counted->answers++;
  return result;
}

static void check_near(const situation *s, double distance, const sepax_apart_result *a) {
  if (a->pair[0] >= s->count[0] || a->pair[1] >= s->count[1]) {
    wrong("there is no near pair %zu, %zu", a->pair[0], a->pair[1]);
    return;
  }
  exact_square square;
  exact_square_init(&square);
  find_pair_square(s, a->pair, &square);
  if (exact_square_compare_length(&square, distance) > 0) {
    wrong("pair %zu, %zu is not within %a", a->pair[0], a->pair[1], distance);
  }
  exact_square_clear(&square);
}

static void check_apart(const situation *s, double distance, sepax_random *r) {
  sepax_apart_request q = SEPAX_STRUCT(sepax_apart_request, .work = 0);
  q.work = one_in(r, 2) ? draw_budget(r) : 0;
  q.simd = one_in(r, 2) ? SEPAX_SIMD_BEST : SEPAX_SIMD_PORTABLE;
  sepax_apart_result a = ask_apart(s, distance, &q);
  sepax_apart_result again = ask_apart(s, distance, &q);
  if (again.verdict != a.verdict || again.work != a.work || again.pair[0] != a.pair[0] ||
      again.pair[1] != a.pair[1] || bits_of(again.least) != bits_of(a.least)) {
    wrong("the same arguments%s gave two answers: is it farther than %a?", said(q.simd), distance);
  }
  if (planted == WRONG_APART && a.verdict != SEPAX_UNDECIDED) {
    a.verdict = a.verdict == SEPAX_APART ? SEPAX_NEAR : SEPAX_APART;
  }
  a.least = planted == LEAST_ABOVE ? up(s->below) : a.least;
  a.work = planted == TOO_MUCH ? q.work + OVERSHOOT + 1 : a.work;
  counted->ended += a.verdict == SEPAX_UNDECIDED;
  /* Of large bodies the truth may be an ulp less. */
  bool far = order(s, distance) > 0;
  bool unsure = s->slack_ulps > 0 && distance >= down(s->below) && distance <= s->below;
  if (a.verdict == SEPAX_UNDECIDED ? q.work == 0 || a.work < q.work
                                   : (a.verdict == SEPAX_APART) != far && !unsure) {
    wrong("%s farther than %a, at a distance near %a, work %" PRIu64 " of %" PRIu64,
          a.verdict == SEPAX_UNDECIDED ? "undecided whether it is"
          : a.verdict == SEPAX_APART   ? "it is not"
                                       : "it is",
          distance, s->below, a.work, q.work);
  }
  if (!(a.least >= 0) || order(s, a.least) < 0 ||
      (a.verdict == SEPAX_APART && a.least < distance)) {
    wrong("least is %a, asked about %a, at a distance near %a", a.least, distance, s->below);
  }
  if (q.work > 0 && a.work > q.work + OVERSHOOT) {
    wrong("%" PRIu64 " units of work within a budget of %" PRIu64, a.work, q.work);
  }
  if (a.verdict == SEPAX_NEAR) {
    check_near(s, distance, &a);
  }
}

void check_all_apart(const situation *s, sepax_random *r) {
  const double next[] = {s->below, down(s->below), up(s->below)};
  for (int n = 0; n < REQUESTS; n++) {
    check_apart(s, n < 3 ? next[n] : one_in(r, 4) ? 0 : draw_length(s, r), r);
  }
}

/* ------------------------------------------------------------------------------ fronts */

enum { STEPS = 8, FRONT_MOST = 600 };

/* A rotation by a small angle about any axis. */
static sepax_pose small_turn(double angle, sepax_random *r) {
  const double x = 0.5 * angle * uniform(r, -1, 1);
  const double y = 0.5 * angle * uniform(r, -1, 1);
  const double z = 0.5 * angle * uniform(r, -1, 1);
  const double n = 2 / (1 + x * x + y * y + z * z);
  return (sepax_pose){{{1 - n * (y * y + z * z), n * (x * y - z), n * (x * z + y)},
                       {n * (x * y + z), 1 - n * (x * x + z * z), n * (y * z - x)},
                       {n * (x * z - y), n * (y * z + x), 1 - n * (x * x + y * y)}},
                      {0, 0, 0}};
}

/* About the largest coordinate of a body. */
static double size_of(const situation *s, int body) {
  double most = 0;
  for (size_t n = 0; n<9 * s->count[body]; n += s->count[body]> MOST ? 91 : 1) {
    most = fmax(most, fabs(s->facet[body][n / 9].v[n / 3 % 3][n % 3]));
  }
  return most;
}

/* Move one body by about `way`, or both together by much. */
static void step(situation *s, double way, sepax_random *r) {
  const bool both = one_in(r, 4);
  const int moved = (int)range(r, 0, 1);
  const double angle = fmin(way / fmax(size_of(s, moved), 0x1p-900), 1);
  sepax_pose by =
      both ? any_pose(fmin(16 * way, 0x1p900), r) : small_turn(one_in(r, 3) ? 0 : angle, r);
  for (int i = 0; i < 3 && !both; i++) {
    by.translation[i] = one_in(r, 3) ? 0 : way * uniform(r, -1, 1);
  }
  for (int k = 0; k < 2; k++) {
    s->pose[k] = s->given[k] != NULL ? *s->given[k] : small_turn(0, r);
    if (both || k == moved) {
      s->pose[k] = sepax_pose_compose(&by, &s->pose[k]);
    }
    s->given[k] = &s->pose[k];
  }
}

static bool poses_are_valid(const situation *s) {
  bool ok = true;
  for (int k = 0; k < 2; k++) {
    ok = ok && sepax_pose_valid(&s->pose[k], NULL);
    for (int i = 0; i < 3; i++) {
      ok = ok && fabs(s->pose[k].translation[i]) <= 0x1p1000;
    }
  }
  return ok;
}

/* One query with a front, against a query without and against the truth. */
static void check_front(const situation *s, double distance, sepax_front *front, uint64_t work,
                        sepax_apart_result *before) {
  const sepax_apart_request q = SEPAX_STRUCT(sepax_apart_request, .front = front, .work = work);
  sepax_apart_result a = ask_apart(s, distance, &q);
  if (planted == STALE) {
    sepax_apart_result now = a;
    a = *before;
    *before = now;
  }
  bool far = order(s, distance) > 0;
  bool unsure = s->slack_ulps > 0 && distance >= down(s->below) && distance <= s->below;
  if (a.verdict == SEPAX_UNDECIDED ? work == 0 : (a.verdict == SEPAX_APART) != far && !unsure) {
    wrong("with a front it is %s than %a, at a distance near %a",
          a.verdict == SEPAX_APART ? "farther" : "not farther", distance, s->below);
  }
  if (!(a.least >= 0) || order(s, a.least) < 0 ||
      (a.verdict == SEPAX_APART && a.least < distance)) {
    wrong("with a front, least is %a, asked about %a, at a distance near %a", a.least, distance,
          s->below);
  }
  if (work > 0 && a.work > work + OVERSHOOT) {
    wrong("with a front, %" PRIu64 " units of work within a budget of %" PRIu64, a.work, work);
  }
  if (a.verdict == SEPAX_NEAR) {
    check_near(s, distance, &a);
  }
}

/* The bodies in the other order. */
static situation exchanged(const situation *s) {
  situation other = *s;
  for (int k = 0; k < 2; k++) {
    other.facet[k] = s->facet[!k];
    other.count[k] = s->count[!k];
    other.body[k] = s->body[!k];
    other.given[k] = s->given[!k];
  }
  return other;
}

/* Queries with one front along a walk. */
void check_walk(const situation *s, kind what, sepax_random *r) {
  static char memory[1 << 14];
  static const size_t capacities[] = {0, 1, 8, 40, FRONT_MOST, FRONT_MOST};
  sepax_front *front;
  sepax_error error;
  size_t bytes = sepax_front_bytes(capacities[range(r, 0, 5)]);
  assert(bytes <= sizeof memory);
  if (!sepax_front_begin(&front, memory, bytes, &error)) {
    bench_fail(&error);
  }
  situation at = *s;
  sepax_apart_result before = {SEPAX_UNDECIDED, {0, 0}, 0, 0};
  double way = fmax(s->below, 0x1p-20 * size_of(s, 0)) * little(r, 1, 12);
  double distance = fmin(s->below * (1 - little(r, 0, 12)), 0x1p999);
  for (int n = 0; n < STEPS; n++) {
    uint64_t work = one_in(r, 6) ? draw_budget(r) : 0;
    if (n > 0 && !one_in(r, 5)) {
      step(&at, one_in(r, 12) ? fmin(64 * way, 0x1p900) : way, r);
    }
    if (!poses_are_valid(&at)) {
      return;
    }
    find_truth(&at, what);
    distance = one_in(r, 3) ? draw_length(&at, r) : one_in(r, 12) ? 0 : distance;
    check_front(&at, distance, front, work, &before);
    if (one_in(r, 12)) {
      situation other = exchanged(&at);
      check_front(&other, distance, front, work, &before);
    }
    exact_square_clear(&at.square);
  }
}
