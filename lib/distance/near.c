/* SPDX-License-Identifier: MIT */
/* near.c - finds the pairs of triangles of two posed bodies within a distance. */
#include "distance.h"
#include "search.h"
#include "util/options.h"
#include "util/list.h"

typedef struct {
  const sepax_query *query;
  double distance;
  sepax_pairs *found;
  size_t capacity;
  bool no_memory;
} near_pairs;

static void record(search *s, const uint32_t at[2], double least, double most) {
  const uint32_t i = sepax__place_at(s->body[0], at[0]);
  const uint32_t j = sepax__place_at(s->body[1], at[1]);
  near_pairs *n = s->context;
  const sepax_query *q = n->query;
  (void)least;
  if (!(most < n->distance)) {
    int order = sepax__distance_compare(s->body[0]->triangle[i], s->at.pose[0],
                                        s->body[1]->triangle[j], s->at.pose[1], n->distance);
    if (order > 0 || (order == 0 && q->strict)) {
      return;
    }
  }
  size_t a = s->body[0]->number[i];
  size_t b = s->body[1]->number[j];
  if (q->each != NULL || q->only_any) {
    n->found->count++;
    s->ended = q->only_any || !q->each(q->context, a, b);
  } else {
    n->no_memory = !list_add_pair(n->found, &n->capacity, a, b);
  }
  s->ended = s->ended || n->no_memory || (q->most > 0 && n->found->count == q->most);
}

bool sepax__distance_valid(double distance, sepax_error *error) {
  return (distance >= 0 && distance <= 0x1p1000) ||
         sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                    "the distance %g is not within 0 ... 2^1000; give one that is", distance);
}

bool sepax_bodies_near(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                       const sepax_pose *pose_b, double distance, const sepax_query *query,
                       sepax_pairs *found, sepax_error *error) {
  sepax_query q;
  *found = (sepax_pairs){0};
  if (!sepax__options(&q, sizeof q, query, "sepax_query", error)) {
    return false;
  }
  if (!sepax__distance_valid(distance, error) || !sepax__poses_valid(pose_a, pose_b, error)) {
    return false;
  }
  if (!(q.seconds >= 0)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "a search has a limit of %g seconds; give 0 for none, or more", q.seconds);
  }
  if (distance == 0) {
    return sepax_bodies_collide(a, pose_a, b, pose_b, query, found, error);
  }
  near_pairs n = {.query = &q, .distance = distance, .found = found};
  search s = {.body = {a, b},
              .take = record,
              .prove = sepax__prove_beyond_limit,
              .context = &n,
              .limit = distance,
              .batch = 4};
  s.portable = q.simd == SEPAX_SIMD_PORTABLE;
  s.seconds = q.seconds;
  if (!(sepax__search_begin(&s, pose_a, pose_b) > distance)) {
    sepax__search_pairs(&s);
  }
  found->ended = s.ended;
  if (n.no_memory) {
    sepax_pairs_free(found);
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the near pairs");
  }
  return true;
}
