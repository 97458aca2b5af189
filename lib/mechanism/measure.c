/* SPDX-License-Identifier: MIT */
/* measure.c - the least clearance of a machine, best first: a heap has the pairs in the order of
 * certain bounds of their clearance within the travel. The bound of the first pair is raised, by
 * the boxes and then by a search, until the first pair is known as well as the tolerance asks. */
#include "mechanism/ask.h"

#include <math.h>
#include <string.h>

/* --------------------------------------------------------------------------- heap */

/* queue[0] has the least key of `count`. A pair may only stand too low at `at`. */
static void sift(const sepax_watch *w, size_t at, size_t count) {
  size_t *q = w->queue;
  for (;;) {
    size_t least = at;
    for (size_t child = 2 * at + 1; child <= 2 * at + 2 && child < count; child++) {
      least = w->key[q[child]] < w->key[q[least]] ? child : least;
    }
    if (least == at) {
      return;
    }
    size_t pair = q[at];
    q[at] = q[least];
    q[least] = pair;
    at = least;
  }
}

/* A bound of the clearance of a pair in all positions; rounded down. */
static void find_key(sepax_watch *w, size_t pair) {
  const watch_pair *known = &w->pair[pair];
  w->key[pair] =
      known->motion > 0 ? fmax(0, (known->least - known->motion) * (1 - 0x1p-50)) : known->least;
}

/* -------------------------------------------------------------------- measurement */

typedef struct {
  asking *a;
  sepax_machine_answer *answer;
  double reached; /* the least key of the pairs that are final */
} measuring;

/* Measure a pair. A longer distance than one that changes the answer is not looked for. */
static bool measure(measuring *m, size_t pair, uint64_t work, sepax_error *error) {
  sepax_watch *w = m->a->watch;
  watch_pair *known = &w->pair[pair];
  const sepax_machine *machine = w->machine;
  const machine_pair *p = &machine->pair[pair];
  const sepax_body *body[2];
  const sepax_pose *pose[2];
  for (int side = 0; side < 2; side++) {
    const machine_place *place = &machine->place[p->place[side]];
    body[side] = machine->body[place->body].body;
    pose[side] = &w->node[place->node].pose;
  }
  double limit = fmax(m->reached + known->motion, m->answer->most) * (1 + 0x1p-50);
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                          .limit = limit < INFINITY ? limit : 0,
                                          .relative = m->a->query.relative,
                                          .absolute = m->a->query.absolute,
                                          .last = w->has_last[pair] ? &w->last[pair] : NULL,
                                          .work = work,
                                          .simd = m->a->query.simd};
  sepax_distance_result found;
  if (!sepax_bodies_distance(body[0], pose[0], body[1], pose[1], &request, &found, error)) {
    return false;
  }
  sepax__asking_spend(m->a, found.work);
  if (found.least > known->least) {
    known->least = found.least;
    sepax__pair_keep(w, pair, found.least);
  }
  find_key(w, pair);
  if (found.min_distance < INFINITY && found.min_distance > 0) {
    w->last[pair] = found;
    w->has_last[pair] = true;
  }
  double most = found.most + (known->motion > 0 ? known->slack * (1 + 0x1p-50) : 0);
  if (most < m->answer->most) { /* with travel, for the exact poses */
    m->answer->most = most;
    m->answer->nearest = pair;
  }
  known->final = !found.ended;
  if (known->final && w->key[pair] < m->reached) {
    m->reached = w->key[pair];
  }
  return true;
}

/* Raise the bound of the first pair, the lesser half of the work at most. False if nothing is left
 * to be done, or on an error. */
static bool raise_first(measuring *m, bool *ok, sepax_error *error) {
  asking *a = m->a;
  sepax_watch *w = a->watch;
  size_t pair = w->queue[0];
  watch_pair *known = &w->pair[pair];
  if (known->final || w->key[pair] >= m->reached) {
    return false;
  }
  if (!known->boxed) {
    known->boxed = true;
    double gap = fmax(sepax__pair_box_gap(w, pair), sepax__pair_kept_gap(w, pair));
    known->least = gap > known->least ? gap : known->least;
    find_key(w, pair);
    return true;
  }
  if (a->left == 0) {
    return false;
  }
  *ok = measure(m, pair, a->left == ASKING_NO_LIMIT ? 0 : sepax__asking_share(a, 2), error);
  return *ok;
}

bool sepax__asking_measure(asking *a, sepax_machine_answer *answer, sepax_error *error) {
  sepax_watch *w = a->watch;
  const size_t pairs = w->machine->pairs;
  measuring m = {a, answer, INFINITY};
  answer->most = INFINITY;
  for (size_t n = 0; n < pairs; n++) {
    w->queue[n] = n;
    find_key(w, n);
  }
  bool ok = true;
  if (w->least_before < SEPAX_NO_PAIR && a->left > 0) {
    ok = measure(&m, w->least_before, a->left == ASKING_NO_LIMIT ? 0 : sepax__asking_share(a, 2),
                 error);
  }
  for (size_t n = pairs; n-- > 0;) {
    sift(w, n, pairs);
  }
  while (ok && raise_first(&m, &ok, error)) {
    sift(w, 0, pairs);
  }
  answer->least = w->key[w->queue[0]];
  w->least_before = answer->nearest < SEPAX_NO_PAIR ? answer->nearest : w->least_before;
  return ok;
}
