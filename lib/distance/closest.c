/* SPDX-License-Identifier: MIT */
/* closest.c - the distance of two bodies in their poses. */
#include "distance.h"
#include "search.h"
#include "util/options.h"

#include <math.h>
#include <string.h>

enum { KEPT = 64 };

typedef struct {
  uint32_t at[2];
  double least;
} candidate;

/* The state of a search: pairs that may be the nearest, by their boxes; the nearest pair measured
 * so far; and a direction on which it is at its distance. */
typedef struct {
  candidate kept[KEPT];
  int count;
  sepax_distance_result *best;
  twofold_vector way;
} nearest_pairs;

/* Measure two triangles, by their places. True if they are nearer than all pairs before. */
static bool measure(search *s, nearest_pairs *n, const uint32_t place[2]) {
  sepax_distance_result *best = n->best;
  const double(*a)[3] = s->body[0]->triangle[place[0]];
  const double(*b)[3] = s->body[1]->triangle[place[1]];
  const sepax_pose *const *pose = s->at.pose;
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
  s->limit = fmin(s->limit, distance);
  return true;
}

/* Measure the kept pairs that may still be the nearest, the most likely one first. */
static void measure_kept(search *s, nearest_pairs *n) {
  while (n->count > 0) {
    int first = 0;
    for (int k = 1; k < n->count; k++) {
      first = n->kept[k].least < n->kept[first].least ? k : first;
    }
    candidate c = n->kept[first];
    n->kept[first] = n->kept[--n->count];
    const uint32_t place[2] = {sepax__place_at(s->body[0], c.at[0]),
                               sepax__place_at(s->body[1], c.at[1])};
    if (c.least <= s->limit && measure(s, n, place)) {
      memcpy(n->best->box, c.at, sizeof c.at);
    }
  }
}

static void keep(search *s, const uint32_t at[2], double least, double most) {
  nearest_pairs *n = s->context;
  s->limit = fmin(s->limit, most);
  if (n->count == KEPT) {
    int count = 0;
    for (int k = 0; k < KEPT; k++) {
      if (n->kept[k].least <= s->limit) {
        n->kept[count++] = n->kept[k];
      }
    }
    n->count = count;
    if (count > KEPT / 2) {
      measure_kept(s, n);
    }
  }
  n->kept[n->count++] = (candidate){{at[0], at[1]}, least};
}

static uint32_t place_of(const sepax_body *b, size_t number) {
  uint32_t place = 0;
  while (b->number[place] != number) {
    place++;
  }
  return place;
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

/* Prepare the search and begin at `last`, if it is given. */
static bool begin(search *s, const sepax_distance_request *r, sepax_error *error) {
  const sepax_distance_result *last = r->last;
  if (!(r->limit >= 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a distance has a limit of %g; give 0 for none, or more", r->limit);
  }
  if (!(r->seconds >= 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a search has a limit of %g seconds; give 0 for none, or more", r->seconds);
  }
  s->limit = r->limit > 0 ? r->limit : INFINITY;
  s->portable = r->simd == SEPAX_SIMD_PORTABLE;
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

bool sepax_bodies_distance(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, const sepax_distance_request *request,
                           sepax_distance_result *result, sepax_error *error) {
  sepax_distance_request r;
  if (!sepax__options(&r, sizeof r, request, "sepax_distance_request", error)) {
    *result = (sepax_distance_result){0};
    return false;
  }
  const sepax_query any =
      SEPAX_STRUCT(sepax_query, .most = 1, .seconds = r.seconds, .simd = r.simd);
  sepax_distance_result best = {.min_distance = INFINITY};
  nearest_pairs n = {.best = &best};
  search s = {.body = {a, b}, .take = keep, .context = &n, .batch = 4};
  sepax_pairs hit;
  if (!begin(&s, &r, error) || !sepax_bodies_collide(a, pose_a, b, pose_b, &any, &hit, error)) {
    *result = (sepax_distance_result){0};
    return false;
  }
  if (hit.count == 0 && hit.ended) {
    best.ended = true;
  } else if (hit.count > 0) {
    const uint32_t place[2] = {place_of(a, hit.pair[0][0]), place_of(b, hit.pair[0][1])};
    s.at.pose[0] = pose_a;
    s.at.pose[1] = pose_b;
    measure(&s, &n, place);
  } else {
    s.seconds = r.seconds;
    sepax__search_pairs(&s, pose_a, pose_b);
    measure_kept(&s, &n);
    best.ended = s.ended;
  }
  sepax_pairs_free(&hit);
  if (r.limit > 0 && best.min_distance > r.limit) {
    best = (sepax_distance_result){.min_distance = INFINITY, .ended = best.ended};
  }
  best.least = nextafter(best.min_distance, 0);
  best.most = nextafter(best.min_distance, INFINITY);
  *result = best;
  return true;
}
