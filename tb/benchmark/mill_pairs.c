/* SPDX-License-Identifier: MIT */
/* mill_pairs.c - how long queries of single pairs of bodies take: distances within a limit of work,
 * and whether bodies are 40 mm apart.
 *
 * The poses, in turn: any within the limits of the joints; any near the work; x, y and z with all
 * faces parallel; and z alone in whole millimetres, where faces touch and are exactly as far apart
 * as asked. The time of a query is the least of its passes. */
#include "benchmark/mill.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { KINDS = 4, PAIRS_MOST = 16 };

/* A query of all pairs in each pose: of the distance, or, with `apart`, whether they are farther
 * apart than that. */
typedef struct {
  const char *name;
  double apart, relative;
  uint64_t work;
} question;

static const question questions[] = {{"apart 40 mm, no limit", 0.04, 0, 0},
                                     {"apart 40 mm, 3000 units", 0.04, 0, 3000},
                                     {"distance, exact, 3000 units", 0, 0, 3000},
                                     {"distance, exact, 10000 units", 0, 0, 10000},
                                     {"distance to 1e-6, no limit", 0, 1e-6, 0},
                                     {"distance to 1e-6, 3000 units", 0, 1e-6, 3000},
                                     {"distance to 1e-6, 10000 units", 0, 1e-6, 10000}};

typedef struct {
  size_t ended, zero;
  uint64_t most_work;
  double farthest; /* distance of bodies whose least bound is 0, at most */
} tally;

static void draw(const mill_scene *s, size_t pose, double *value) {
  static const double low[AXES] = {-0.15, -0.15, 0.25, -0.5, -0.5};
  static const double high[AXES] = {0.15, 0.15, 0.45, 0.5, 0.5};
  const sepax_mechanism *m = &s->mill.robot.mechanism;
  uint64_t state = pose + 1;
  for (int n = 0; n < 8; n++) {
    mill_uniform(&state);
  }
  for (size_t k = 0; k < AXES; k++) {
    const sepax_joint *joint = &m->joint[s->axis[k]];
    double part = mill_uniform(&state);
    bool near = pose % KINDS == 1;
    bool still = pose % KINDS == 3 ? k != 2 : pose % KINDS == 2 && k > 2;
    double from = near ? low[k] : joint->lower;
    double to = near ? high[k] : joint->upper;
    value[s->axis[k]] = still ? 0 : from + (to - from) * part;
  }
  if (pose % KINDS == 3) {
    value[s->axis[2]] = round(value[s->axis[2]] * 1e3) * 1e-3;
  }
}

/* Ask, and return the seconds that it took. */
static float ask(const question *q, const sepax_body *const body[2], const sepax_pose pose[2],
                 tally *t) {
  sepax_error error = {0};
  sepax_apart_result near = {.verdict = SEPAX_UNDECIDED};
  sepax_distance_result found = {.least = 1};
  const sepax_apart_request apart = {.size = sizeof apart, .work = q->work};
  const sepax_distance_request distance = {
      .size = sizeof distance, .relative = q->relative, .work = q->work};
  double begin = mill_seconds();
  bool ok = q->apart > 0 ? sepax_bodies_apart(body[0], &pose[0], body[1], &pose[1], q->apart,
                                              &apart, &near, &error)
                         : sepax_bodies_distance(body[0], &pose[0], body[1], &pose[1], &distance,
                                                 &found, &error);
  float taken = (float)(mill_seconds() - begin);
  if (!ok) {
    mill_stop("a query", &error);
  }
  uint64_t work = q->apart > 0 ? near.work : found.work;
  t->most_work = work > t->most_work ? work : t->most_work;
  t->ended += q->apart > 0 ? near.verdict == SEPAX_UNDECIDED : found.ended;
  if (!(found.least > 0) && found.ended) {
    t->zero++;
    t->farthest = fmax(t->farthest, found.min_distance);
  }
  return taken;
}

static void report(const mill_scene *s, sepax_chain *chain, const question *q, size_t poses,
                   int passes, float *time) {
  const sepax_mechanism *m = &s->mill.robot.mechanism;
  const size_t pairs = s->mill.pairs.count;
  double value[64] = {0};
  tally t = {0};
  for (int pass = 0; pass < passes; pass++) {
    t = (tally){0};
    for (size_t n = 0; n < poses; n++) {
      draw(s, n, value);
      for (size_t k = 0; k < pairs; k++) {
        const sepax_body *body[2] = {s->mill.body[s->mill.pair[k][0]].body,
                                     s->mill.body[s->mill.pair[k][1]].body};
        sepax_pose pose[2];
        sepax_chain_poses(&chain[k], m, value, pose);
        float taken = ask(q, body, pose, &t);
        float *least = &time[n * pairs + k];
        *least = pass == 0 || taken < *least ? taken : *least;
      }
    }
  }
  printf("%s: %zu of %zu ended by the limit, %llu units at most", q->name, t.ended, poses * pairs,
         (unsigned long long)t.most_work);
  if (t.zero > 0) {
    printf("; least 0 in %zu, which are %.3g m apart at most", t.zero, t.farthest);
  }
  printf("\n  us of CPU            mean     99 %%   99.9 %%  99.99 %%    worst\n");
  mill_print_times("all", time, poses * pairs);
}

void mill_report_pairs(const mill_scene *s, size_t poses, int passes) {
  sepax_error error = {0};
  sepax_chain chain[PAIRS_MOST];
  const size_t pairs = s->mill.pairs.count;
  float *time = calloc(poses * pairs + 1, sizeof *time);
  if (time == NULL || pairs > PAIRS_MOST || poses == 0) {
    mill_stop("poses", NULL);
  }
  for (size_t k = 0; k < pairs; k++) {
    const sepax_machine_body *b = s->mill.body;
    if (!sepax_chain_find(&chain[k], &s->mill.robot.mechanism, b[s->mill.pair[k][0]].link,
                          b[s->mill.pair[k][1]].link, &error)) {
      mill_stop("a chain", &error);
    }
  }
  for (size_t k = 0; k < sizeof questions / sizeof questions[0]; k++) {
    report(s, chain, &questions[k], poses, passes, time);
  }
  for (size_t k = 0; k < pairs; k++) {
    sepax_chain_free(&chain[k]);
  }
  free(time);
}
