/* SPDX-License-Identifier: MIT */
/* closest.c - the distance of two bodies in their poses. */
#include "distance.h"
#include "search.h"
#include "support.h"
#include "body/query.h"
#include "util/options.h"

#include <math.h>
#include <string.h>

enum { KEPT = 64, PROOFS = 16, SOON = 512, WORK_DIRECTION = 8 };

typedef struct {
  uint32_t at[2];
  double least;
} candidate;

/* The state of a search: pairs that may be the nearest, by their boxes; the nearest pair measured
 * so far; and a direction on which it is at its distance. */
typedef struct {
  candidate kept[KEPT];
  int count;
  bool given_up;             /* were there more than fit? */
  bool thorough;             /* in a second search, for pairs that were given up in the first */
  double least;              /* of a first search: no pair is nearer */
  double limit;              /* of the request, or infinite */
  double relative, absolute; /* the tolerance */
  sepax_distance_result *best;
  twofold_vector way;
  double begun; /* the distance for which a proof was begun last; 0: none */
} nearest_pairs;

/* Two triangles are `distance` apart: how near must others be to be looked for? Three quarters of
 * the tolerance, so that rounding does not make the interval wider than the whole. A tolerance that
 * is less than rounding counts as 0. */
static double needed(const nearest_pairs *n, double distance) {
  double tolerance = fmax(n->relative * distance, n->absolute);
  return tolerance > 0x1p-48 * distance ? distance - 0.75 * tolerance : distance;
}

/* A pair beyond the limit of the request does not count: others may be nearer than that limit, but
 * within the tolerance. */
static void lower_limit(search *s, const nearest_pairs *n, double distance) {
  if (distance <= n->limit) {
    s->limit = fmin(s->limit, distance > 0 ? needed(n, distance) : -1);
  }
}

/* Measure two triangles, by their places. True if they are nearer than all pairs before. */
static bool measure(search *s, nearest_pairs *n, const uint32_t place[2]) {
  sepax_distance_result *best = n->best;
  const double(*a)[3] = s->body[0]->triangle[place[0]];
  const double(*b)[3] = s->body[1]->triangle[place[1]];
  const sepax_pose *const *pose = s->at.pose;
  s->work += WORK_EXACT;
  if (isfinite(best->min_distance) &&
      sepax__distance_at_least(a, pose[0], b, pose[1], &n->way, best->min_distance)) {
    return false;
  }
  double nearest[2][3];
  twofold_vector way;
  double distance = sepax__distance_and_way(a, pose[0], b, pose[1], nearest, &way);
  if (distance >= best->min_distance) {
    return false;
  }
  n->way = way;
  best->min_distance = distance;
  memcpy(best->nearest_points, nearest, sizeof nearest);
  for (int k = 0; k < 2; k++) {
    best->pair[k] = s->body[k]->number[place[k]];
  }
  lower_limit(s, n, distance);
  return true;
}

static bool measure_at(search *s, nearest_pairs *n, const uint32_t at[2]) {
  const uint32_t place[2] = {sepax__place_at(s->body[0], at[0]),
                             sepax__place_at(s->body[1], at[1])};
  if (!measure(s, n, place)) {
    return false;
  }
  memcpy(n->best->box, at, sizeof n->best->box);
  return true;
}

static bool out_of_work(const search *s) { return s->work_most > 0 && s->work >= s->work_most; }

/* Measure the kept pairs that may still be the nearest, the most likely one first. */
static void measure_kept(search *s, nearest_pairs *n) {
  while (n->count > 0 && !out_of_work(s)) {
    int first = 0;
    for (int k = 1; k < n->count; k++) {
      first = n->kept[k].least < n->kept[first].least ? k : first;
    }
    candidate c = n->kept[first];
    n->kept[first] = n->kept[--n->count];
    if (c.least <= s->limit) {
      measure_at(s, n, c.at);
    }
  }
}

/* Drop kept pairs that are beyond the limit. */
static void drop_kept(const search *s, nearest_pairs *n) {
  int count = 0;
  for (int k = 0; k < n->count; k++) {
    if (n->kept[k].least <= s->limit) {
      n->kept[count++] = n->kept[k];
    }
  }
  n->count = count;
}

/* Prepare proofs that no pair is nearer than needed, by the direction of the nearest pair so far or
 * the normals of the triangles in boxes `at`. True only if it is proved for these. */
static bool begin_proof(search *s, nearest_pairs *n, const uint32_t at[2]) {
  double best = n->best->min_distance;
  double least = best > n->limit ? n->limit : needed(n, best);
  twofold need = least < best ? twofold_of(least) : product_of(best, 1 - 0x1p-53);
  n->begun = best;
  return best > 0 && isfinite(best) && sepax__proof_begin(s, &n->way, at, need);
}

/* Is it proved that a pair is not nearer than needed, by the direction at hand or one of its own?
 * Bodies may touch on several sides. Without a tolerance no direction of its own is tried: a unit
 * in the last place of such a distance is less than the error of a proof. */
static bool is_beyond(search *s, nearest_pairs *n, const uint32_t at[2]) {
  const uint32_t child[2] = {child_at(s->body[0], at[0]), child_at(s->body[1], at[1])};
  hindrance by;
  if (s->proof.possible && sepax__prove_apart(s, child, &by)) {
    return true;
  }
  if (!(n->relative > 0 || n->absolute > 0)) {
    return false;
  }
  const direction_proof before = s->proof;
  const double begun = n->begun;
  s->work += WORK_DIRECTION;
  if (begin_proof(s, n, at)) {
    return true;
  }
  s->proof = before;
  n->begun = begun;
  return false;
}

/* Settle a pair that doubles do not tell from a collision. It is measured at once if no direction
 * does for it: while it is open nothing is certain, and only the distance of such a pair makes the
 * limit as small as it. False without work left. */
static bool settle_contact(search *s, nearest_pairs *n, const uint32_t at[2], double most) {
  if (n->best->min_distance <= most && is_beyond(s, n, at)) {
    return true;
  }
  if (out_of_work(s)) {
    return false;
  }
  if (measure_at(s, n, at)) {
    s->prove_soon = begin_proof(s, n, at);
  }
  return true;
}

/* Keep a pair that may be the nearest. Where work or time is limited, pairs beyond those that fit
 * are given up at first, rather than measured, because other pairs say more about the least
 * distance. */
static void keep(search *s, const uint32_t at[2], double least, double most) {
  nearest_pairs *n = s->context;
  lower_limit(s, n, most);
  if (!(least > 0) && settle_contact(s, n, at, most)) {
    return;
  }
  if (n->count == KEPT) {
    drop_kept(s, n);
    if (n->count > KEPT / 2 && (n->thorough || !s->best_first)) {
      measure_kept(s, n);
    }
  }
  if (n->count == KEPT) {
    n->given_up = true;
    s->open = fmin(s->open, least);
  } else {
    n->kept[n->count++] = (candidate){{at[0], at[1]}, least};
  }
}

/* Measure a triangle that hindered a proof, with the nearest one of the other body. */
static bool measure_hindrance(search *s, nearest_pairs *n, const hindrance *by) {
  uint32_t at[2];
  memcpy(at, n->best->box, sizeof at);
  at[by->body] = by->at;
  return measure_at(s, n, at);
}

/* Prove by one direction that no pair is nearer than needed. */
static bool prove(search *s) {
  static const uint32_t roots[2] = {0, 0};
  nearest_pairs *n = s->context;
  if (n->best->min_distance > s->shortest / s->unit) {
    measure_at(s, n, s->nearest.at);
  }
  for (int turn = 0; turn < PROOFS && !out_of_work(s); turn++) {
    hindrance by;
    bool begun = s->proof.possible && n->begun == n->best->min_distance;
    if (!begun && !begin_proof(s, n, n->best->box)) {
      return false;
    }
    if (sepax__prove_apart(s, roots, &by)) {
      n->count = 0;
      n->given_up = false;
      s->open = INFINITY;
      return true;
    }
    if (by.body < 0 || !measure_hindrance(s, n, &by)) {
      return false;
    }
  }
  return false;
}

static bool is_triangle(const sepax_body *b, uint32_t at, size_t number) {
  return at < BODY_WIDE * b->nodes && sepax__place_at(b, at) < b->count &&
         b->number[sepax__place_at(b, at)] == number;
}

/* True if a result names boxes. It does not after a collision, nor if the distance was above the
 * limit. */
static bool names_boxes(const sepax_distance_result *last) {
  return last->min_distance > 0 && isfinite(last->min_distance);
}

static bool is_distance(const search *s, const sepax_distance_result *last) {
  bool ok = last->min_distance >= 0;
  for (int i = 0; ok && i < 2; i++) {
    ok = last->pair[i] < s->body[i]->count &&
         (!names_boxes(last) || is_triangle(s->body[i], last->box[i], last->pair[i]));
  }
  return ok;
}

/* Check a request, prepare the search and begin at `last`, if it is given. */
static bool begin(search *s, const sepax_distance_request *r, sepax_error *error) {
  const sepax_distance_result *last = r->last;
  if (!(r->limit >= 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a distance has a limit of %g; give 0 for none, or more", r->limit);
  }
  if (!(r->relative >= 0 && r->relative < 1 && r->absolute >= 0 && isfinite(r->absolute))) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "a distance has a tolerance of %g of itself or %g; give 0 ... 1 and 0 or more", r->relative,
        r->absolute);
  }
  if (!(r->seconds >= 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a search has a limit of %g seconds; give 0 for none, or more", r->seconds);
  }
  s->limit = r->limit > 0 ? r->limit : INFINITY;
  s->portable = r->simd == SEPAX_SIMD_PORTABLE;
  s->work_most = r->work;
  s->seconds = r->seconds;
  s->best_first = r->work > 0 || r->seconds > 0;
  if (last != NULL && !is_distance(s, last)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the last distance is not a result for these bodies; give a result of "
                      "sepax_bodies_distance on them, or NULL");
  }
  if (last != NULL && names_boxes(last)) {
    s->waiting[s->count++] = (box_pair){{last->box[0], last->box[1]}, 0};
  }
  return true;
}

/* Find a collision, if that is soon done: bodies that nearly touch in many places take long, and
 * the search for the distance finds a collision, too. It takes at most half of the work and time,
 * and it ends where doubles do not decide: such triangles are likely near, so that the search for
 * the distance begins at them. */
static bool find_collision(search *s, nearest_pairs *n, sepax_simd simd) {
  uint64_t half = (s->work_most + 1) / 2;
  search_limits limits = {
      .most = half > 0 && half < SOON ? half : SOON, .seconds = s->seconds / 2, .rough = true};
  uint32_t pair[2];
  bool found = sepax__find_collision(s->body[0], s->at.pose[0], s->body[1], s->at.pose[1], simd,
                                     &limits, pair);
  s->work += limits.work;
  s->seconds = limits.seconds;
  if (found) {
    measure(s, n, pair);
  } else if (limits.in_doubt) {
    s->waiting[s->count++] = (box_pair){{pair[0], pair[1]}, 0};
  }
  return found;
}

/* No pair is nearer than this, by what the search left. */
static double least_of(const search *s, const nearest_pairs *n) {
  double least = fmin(s->limit, s->open);
  for (int k = 0; k < n->count; k++) {
    least = fmin(least, n->kept[k].least);
  }
  return least;
}

/* Search all pairs; a second time if the first gave up pairs and left work to do. */
static void search_all(search *s, nearest_pairs *n) {
  sepax__search_pairs(s);
  if (n->given_up && !s->ended) {
    n->least = least_of(s, n);
    n->thorough = true;
    n->given_up = false;
    n->count = 0;
    s->open = INFINITY;
    sepax__search_pairs(s);
  }
}

/* The interval that holds the distance, from what the search left. `apart`: a bound found before.
 */
static void set_interval(const search *s, const nearest_pairs *n, double apart) {
  sepax_distance_result *best = n->best;
  double least = fmax(fmax(least_of(s, n), n->least), fmax(apart, 0));
  least = fmin(least, nextafter(best->min_distance, 0));
  best->least = best->min_distance > 0 ? least : 0;
  best->most = best->min_distance > 0 ? nextafter(best->min_distance, INFINITY) : 0;
  best->work = s->work;
  best->ended = s->ended;
}

bool sepax_bodies_distance(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, const sepax_distance_request *request,
                           sepax_distance_result *result, sepax_error *error) {
  sepax_distance_request r;
  *result = (sepax_distance_result){0};
  if (!sepax__options(&r, sizeof r, request, "sepax_distance_request", error)) {
    return false;
  }
  sepax_distance_result best = {.min_distance = INFINITY};
  nearest_pairs n = {.limit = r.limit > 0 ? r.limit : INFINITY,
                     .relative = r.relative,
                     .absolute = r.absolute,
                     .best = &best};
  search s = {.body = {a, b}, .take = keep, .prove = prove, .context = &n, .batch = 4};
  if (!begin(&s, &r, error) || !sepax__poses_valid(pose_a, pose_b, error)) {
    return false;
  }
  double apart = sepax__search_begin(&s, pose_a, pose_b);
  bool collide = !(apart > 0) && find_collision(&s, &n, r.simd);
  if (!collide && !(apart > s.limit)) {
    search_all(&s, &n);
    measure_kept(&s, &n);
    if (best.min_distance > s.shortest / s.unit) {
      measure_at(&s, &n, s.nearest.at);
    }
    drop_kept(&s, &n);
    s.ended = s.ended || n.count > 0 || n.given_up;
  }
  set_interval(&s, &n, apart);
  if (r.limit > 0 && best.min_distance > r.limit) {
    best = (sepax_distance_result){.min_distance = INFINITY,
                                   .least = fmin(best.least, r.limit),
                                   .most = INFINITY,
                                   .work = best.work,
                                   .ended = best.ended};
  }
  *result = best;
  return true;
}
