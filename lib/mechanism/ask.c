/* SPDX-License-Identifier: MIT */
/* ask.c - is any pair of bodies of a machine near? */
#include "mechanism/ask.h"
#include "util/error.h"
#include "util/options.h"

#include <math.h>
#include <string.h>

static const sepax_body *body_of(const sepax_watch *w, size_t pair, int side) {
  const sepax_machine *m = w->machine;
  return m->body[m->place[m->pair[pair].place[side]].body].body;
}

static const sepax_pose *pose_of(const sepax_watch *w, size_t pair, int side) {
  const sepax_machine *m = w->machine;
  return &w->node[m->place[m->pair[pair].place[side]].node].pose;
}

uint64_t sepax__asking_share(const asking *a, size_t among) {
  uint64_t share = a->left / (among > 0 ? among : 1);
  return share > 0 ? share : 1;
}

void sepax__asking_spend(asking *a, uint64_t work) {
  a->spent += work;
  if (a->left != ASKING_NO_LIMIT) {
    a->left -= work < a->left ? work : a->left;
  }
}

/* ------------------------------------------------------------------------- bounds */

static void note_least(sepax_watch *w, size_t pair, double least) {
  watch_pair *known = &w->pair[pair];
  known->least = least > known->least ? least : known->least;
}

/* A greater distance than this is APART in all positions. */
static double need_of(const asking *a, double motion) {
  return motion > 0 ? (a->query.clearance + motion) * (1 + 0x1p-50) : a->query.clearance;
}

/* Compare by what costs little. */
static void compare(asking *a, size_t pair) {
  sepax_watch *w = a->watch;
  watch_pair *known = &w->pair[pair];
  const machine_pair *p = &w->machine->pair[pair];
  if (w->node[w->machine->place[p->place[0]].node].changed ||
      w->node[w->machine->place[p->place[1]].node].changed) {
    known->beyond = -1;
    known->touching = -1;
  }
  known->state = PAIR_OPEN;
  known->boxed = known->close = known->final = false;
  known->got = 0;
  known->slack = sepax__pair_slack(w, pair);
  known->motion = a->query.travel != NULL ? sepax__pair_motion(w, pair) : 0;
  known->need = need_of(a, known->motion);
  known->least = fmax(0, sepax__pair_ball_gap(w, pair)); /* 0 if the gap is no number */
  note_least(w, pair, known->beyond);
  if (!(known->least > known->need)) {
    known->boxed = true;
    note_least(w, pair, fmax(sepax__pair_kept_gap(w, pair), sepax__pair_box_gap(w, pair)));
  }
  if (!(known->least > known->need) && known->motion > 0) {
    known->motion = sepax__pair_least_motion(w, pair);
    known->need = need_of(a, known->motion);
  }
  if (known->least > known->need || known->beyond >= known->need) {
    known->state = PAIR_APART;
  } else if (known->touching == a->query.clearance) {
    known->state = PAIR_NEAR;
  }
}

/* ------------------------------------------------------------------------- search */

/* Are the bodies farther apart than `distance`? A limit of work of 0 is none. */
static bool search(asking *a, size_t pair, double distance, uint64_t work,
                   sepax_apart_result *found, sepax_error *error) {
  sepax_watch *w = a->watch;
  const sepax_apart_request request = {.size = sizeof(sepax_apart_request),
                                       .work = work,
                                       .simd = a->query.simd,
                                       .front = w->front[pair]};
  if (!sepax_bodies_apart(body_of(w, pair, 0), pose_of(w, pair, 0), body_of(w, pair, 1),
                          pose_of(w, pair, 1), distance, &request, found, error)) {
    return false;
  }
  if (found->verdict != SEPAX_NEAR && found->least > w->pair[pair].least) {
    note_least(w, pair, found->least);
    sepax__pair_keep(w, pair, found->least);
  }
  if (found->verdict == SEPAX_APART) {
    w->pair[pair].beyond = fmax(w->pair[pair].beyond, distance);
  }
  return true;
}

static void find_near(asking *a, size_t pair, const sepax_apart_result *found) {
  watch_pair *known = &a->watch->pair[pair];
  known->state = PAIR_NEAR;
  known->touching = a->query.clearance;
  known->triangle[0] = found->pair[0];
  known->triangle[1] = found->pair[1];
}

/* Decide a pair within a share of the work. With travel two questions may be needed: are the bodies
 * farther apart than the travel can close, and if not, are they near at the values? */
static bool decide(asking *a, size_t pair, uint64_t share, sepax_error *error) {
  watch_pair *known = &a->watch->pair[pair];
  const bool limited = a->left != ASKING_NO_LIMIT;
  uint64_t used = 0;
  sepax_apart_result found;
  if (!known->close && known->need <= 0x1p1000) {
    if (!search(a, pair, known->need, limited ? share : 0, &found, error)) {
      return false;
    }
    used = found.work;
    if (found.verdict == SEPAX_APART) {
      known->state = PAIR_APART;
    } else if (found.verdict == SEPAX_NEAR && !(known->motion > 0)) {
      find_near(a, pair, &found);
    }
    known->close = found.verdict == SEPAX_NEAR;
  } else {
    known->close = true;
  }
  if (known->state == PAIR_OPEN && known->close && (!limited || used < share)) {
    if (!search(a, pair, a->query.clearance, limited ? share - used : 0, &found, error)) {
      return false;
    }
    used += found.work;
    if (found.verdict == SEPAX_NEAR) {
      find_near(a, pair, &found);
    } else if (found.verdict == SEPAX_APART) {
      known->state = PAIR_LOOSE;
    }
  }
  known->got = share;
  sepax__asking_spend(a, used);
  return true;
}

/* Ask the open pairs before the first that is near, once each. *more: one of them got work, and
 * some are open still. */
static bool ask_round(asking *a, bool *more, sepax_error *error) {
  sepax_watch *w = a->watch;
  size_t open = 0;
  for (size_t n = 0; n < a->open; n++) {
    size_t pair = w->queue[n];
    if (pair < a->near && w->pair[pair].state == PAIR_OPEN) {
      w->queue[open++] = pair;
    }
  }
  a->open = open;
  *more = false;
  for (size_t n = 0; n < open && a->left > 0; n++) {
    size_t pair = w->queue[n];
    uint64_t share = sepax__asking_share(a, open - n);
    if (pair >= a->near || share / 2 < w->pair[pair].got) {
      continue;
    }
    if (!decide(a, pair, share, error)) {
      return false;
    }
    if (w->pair[pair].state == PAIR_NEAR) {
      a->near = pair;
    }
    *more = true;
  }
  return true;
}

/* Decide the pairs until the first that is near. */
static bool ask_pairs(asking *a, sepax_error *error) {
  sepax_watch *w = a->watch;
  const size_t pairs = w->machine->pairs;
  bool more = true;
  a->open = 0;
  for (size_t n = 0; n < pairs; n++) {
    compare(a, n);
    if (w->pair[n].state == PAIR_OPEN) {
      w->queue[a->open++] = n;
    } else if (n < a->near && w->pair[n].state == PAIR_NEAR) {
      a->near = n;
    }
  }
  sepax__asking_spend(a, pairs);
  size_t before = w->near_before;
  if (before < a->near && a->left > 0 && w->pair[before].state == PAIR_OPEN) {
    if (!decide(a, before, sepax__asking_share(a, a->open), error)) {
      return false;
    }
    a->near = w->pair[before].state == PAIR_NEAR ? before : a->near;
  }
  while (more && a->left > 0) {
    if (!ask_round(a, &more, error)) {
      return false;
    }
  }
  return true;
}

static void tell(const asking *a, sepax_machine_answer *answer) {
  const sepax_watch *w = a->watch;
  answer->pair = SEPAX_NO_PAIR;
  answer->nearest = SEPAX_NO_PAIR;
  answer->verdict = SEPAX_APART;
  if (a->near < SEPAX_NO_PAIR) {
    answer->verdict = SEPAX_NEAR;
    answer->pair = a->near;
    memcpy(answer->triangle, w->pair[a->near].triangle, sizeof answer->triangle);
    return;
  }
  for (size_t n = w->machine->pairs; n-- > 0;) {
    if (w->pair[n].state != PAIR_APART) {
      answer->verdict = SEPAX_UNDECIDED;
      answer->pair = n;
    }
  }
}

/* ---------------------------------------------------------------------- the query */

static bool check(const sepax_machine_query *q, sepax_error *error) {
  if (!(q->clearance >= 0 && q->clearance <= 0x1p1000)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the clearance %g is not within 0 ... 2^1000; give one that is",
                      q->clearance);
  }
  return (q->relative >= 0 && q->relative < 1 && q->absolute >= 0 && isfinite(q->absolute)) ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "a tolerance of %g of the distance or %g; give 0 ... 1 and 0 or more",
                    q->relative, q->absolute);
}

bool sepax_watch_ask(sepax_watch *watch, const double *value, const sepax_machine_query *query,
                     sepax_machine_answer *answer, sepax_error *error) {
  asking a = {.watch = watch, .near = SEPAX_NO_PAIR};
  *answer = (sepax_machine_answer){0};
  if (!sepax__options(&a.query, sizeof a.query, query, "sepax_machine_query", error) ||
      !check(&a.query, error) || !sepax__watch_place(watch, value, a.query.travel, error)) {
    return false;
  }
  if (a.query.travel != NULL) {
    sepax__watch_move(watch);
  }
  a.left = a.query.work > 0 ? a.query.work : ASKING_NO_LIMIT;
  if (!ask_pairs(&a, error)) {
    watch->settled = false;
    return false;
  }
  tell(&a, answer);
  watch->near_before = a.near < SEPAX_NO_PAIR ? a.near : watch->near_before;
  if (a.query.measure && !sepax__asking_measure(&a, answer, error)) {
    watch->settled = false;
    *answer = (sepax_machine_answer){0};
    return false;
  }
  answer->work = a.spent;
  return true;
}
