/* SPDX-License-Identifier: MIT */
/* apart.c - whether two posed bodies are farther apart than a distance. */
#include "body/query.h"
#include "distance.h"
#include "front.h"
#include "search.h"
#include "support.h"
#include "util/options.h"

#include <math.h>

typedef struct {
  sepax_apart_result *result;
  sepax_front *front;
  bool ties; /* a pair was beyond the limit by so little that only an exact test told */
} request_of;

/* Begin proofs by the direction of two triangles. True if it proves that these are beyond the
 * limit. */
static bool begin_proof(search *s, const uint32_t at[2]) {
  double nearest[2][3];
  twofold_vector way;
  s->work += WORK_EXACT;
  sepax__distance_and_way(s->body[0]->triangle[sepax__place_at(s->body[0], at[0])], s->at.pose[0],
                          s->body[1]->triangle[sepax__place_at(s->body[1], at[1])], s->at.pose[1],
                          nearest, &way);
  return sepax__proof_begin(s, &way, at, twofold_of(s->limit));
}

/* Are two triangles beyond the limit, by a direction? Parallel faces have many pairs that doubles
 * do not tell from the limit. The direction of one of them does for the others, so it is sought
 * once a pair was beyond the limit by little. */
static bool is_beyond(search *s, const uint32_t at[2]) {
  const request_of *asked = s->context;
  const uint32_t child[2] = {child_at(s->body[0], at[0]), child_at(s->body[1], at[1])};
  hindrance by;
  if (s->work_most > 0 && s->work >= s->work_most) { /* no more than an exact test */
    return false;
  }
  if (s->proof.possible && sepax__prove_apart(s, child, &by)) {
    return true;
  }
  if (!asked->ties) {
    return false;
  }
  const direction_proof before = s->proof;
  if (begin_proof(s, at)) {
    return true;
  }
  s->proof = before;
  return false;
}

static void consider(search *s, const uint32_t at[2], double least, double most) {
  request_of *asked = s->context;
  sepax_apart_result *result = asked->result;
  const uint32_t place[2] = {sepax__place_at(s->body[0], at[0]),
                             sepax__place_at(s->body[1], at[1])};
  (void)least;
  if (!(most <= s->limit)) {
    if (is_beyond(s, at)) {
      return;
    }
    s->work += WORK_EXACT;
    if (sepax__distance_compare(s->body[0]->triangle[place[0]], s->at.pose[0],
                                s->body[1]->triangle[place[1]], s->at.pose[1], s->limit) > 0) {
      asked->ties = true;
      return;
    }
  }
  result->verdict = SEPAX_NEAR;
  for (int k = 0; k < 2; k++) {
    result->pair[k] = s->body[k]->number[place[k]];
  }
  if (asked->front != NULL) {
    sepax__front_note_near(asked->front, at, fmin(most, s->limit));
  }
  s->ended = true;
}

bool sepax__prove_beyond_limit(search *s) {
  static const uint32_t roots[2] = {0, 0};
  hindrance by;
  return begin_proof(s, s->nearest.at) && sepax__prove_apart(s, roots, &by);
}

/* A search of the trees for two triangles that are within the distance. */
static void find_near(search *s, sepax_apart_result *result) {
  sepax__search_pairs(s);
  if (result->verdict == SEPAX_UNDECIDED) {
    result->verdict = s->ended ? SEPAX_UNDECIDED : SEPAX_APART;
    result->least = s->ended ? fmin(s->open, s->limit) : s->limit;
  }
}

/* ------------------------------------------------------------------------- fronts */

/* Keep that the bodies as a whole are at least this far apart. */
static void keep_whole(sepax_front *f, double least) {
  const front_entry whole = {
      {BODY_WIDE * (uint32_t)f->body[0]->nodes, BODY_WIDE * (uint32_t)f->body[1]->nodes},
      FRONT_CLOSED,
      0};
  sepax__front_clear(f);
  sepax__front_add(f, &whole, least);
  sepax__front_end(f, true, 0);
}

/* Are the triangles that were near last near now? If not, search what may have come near. */
static void find_near_again(search *s, sepax_front *f, sepax_apart_result *result) {
  if (f->has_near && f->near_limit <= s->limit) {
    s->waiting[0] = (box_pair){{f->near[0], f->near[1]}, 0};
    s->count = 1;
    f->has_near = false;
    sepax__search_waiting(s);
  }
  if (s->ended) {
    return;
  }
  s->front = f;
  s->resume = sepax__front_worth(f);
  if (!s->resume) {
    sepax__front_clear(f);
  }
  double whole = result->least;
  find_near(s, result);
  if (result->verdict == SEPAX_UNDECIDED && s->resume) {
    result->least = whole; /* what the search left open is not all */
  }
  if (result->verdict != SEPAX_NEAR) {
    result->least = fmax(result->least, sepax__front_least(f));
  }
}

enum { SOON = 4096 };

/* Find a collision by the search for collisions, if that is soon done. Bodies that nearly touch in
 * many places take it long; the search for distances then decides. */
static void find_collision(search *s, sepax_simd simd, sepax_apart_result *result) {
  uint64_t most = s->work_most > 0 && s->work_most < SOON ? s->work_most : SOON;
  search_limits limits = {.most = most};
  uint32_t place[2];
  bool found = sepax__find_collision(s->body[0], s->at.pose[0], s->body[1], s->at.pose[1], simd,
                                     &limits, place);
  s->work = limits.work;
  for (int k = 0; k < 2 && found; k++) {
    result->pair[k] = s->body[k]->number[place[k]];
  }
  if (found || !limits.ended) {
    result->verdict = found ? SEPAX_NEAR : SEPAX_APART;
  } else if (most == SOON) {
    find_near(s, result);
  }
}

bool sepax_bodies_apart(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                        const sepax_pose *pose_b, double distance,
                        const sepax_apart_request *request, sepax_apart_result *result,
                        sepax_error *error) {
  sepax_apart_request r;
  *result = (sepax_apart_result){0};
  if (!sepax__options(&r, sizeof r, request, "sepax_apart_request", error) ||
      !sepax__distance_valid(distance, error) || !sepax__poses_valid(pose_a, pose_b, error)) {
    return false;
  }
  request_of asked = {result, r.front, false};
  search s = {.body = {a, b},
              .take = consider,
              .prove = sepax__prove_beyond_limit,
              .context = &asked,
              .limit = distance,
              .batch = 4,
              .work_most = r.work,
              .portable = r.simd == SEPAX_SIMD_PORTABLE};
  if (r.front != NULL) {
    sepax__front_move(r.front, a, pose_a, b, pose_b);
    s.work = r.front->used / 64;
    if (sepax__front_beyond(r.front, distance, &result->least)) {
      result->verdict = SEPAX_APART;
      result->work = s.work + 1;
      return true;
    }
  }
  result->least = sepax__search_begin(&s, pose_a, pose_b);
  if (result->least > distance) {
    result->verdict = SEPAX_APART;
    if (r.front != NULL) {
      keep_whole(r.front, result->least);
    }
  } else if (r.front != NULL) {
    find_near_again(&s, r.front, result);
  } else if (distance > 0) {
    find_near(&s, result);
  } else {
    find_collision(&s, r.simd, result);
  }
  result->work = s.work + 1;
  return true;
}
