/* closest.c - the distance of two bodies in their poses. */
#include "distance.h"
#include "search.h"
#include "util/error.h"

#include <math.h>
#include <string.h>

enum { KEPT = 64 };

typedef struct {
  uint32_t at[2];
  double least;
} candidate;

/* Pairs that may be the nearest; the nearest of those that were measured, and the direction on
 * which it is at that distance. */
typedef struct {
  candidate kept[KEPT];
  int count;
  sepax_distance_result *best;
  twofold_vector way;
} nearest_pairs;

static void measure(search *s, nearest_pairs *n, const candidate *c) {
  sepax_distance_result *best = n->best;
  const double(*a)[3] = s->body[0]->triangle[c->at[0]];
  const double(*b)[3] = s->body[1]->triangle[c->at[1]];
  const sepax_pose *const *pose = s->at.pose;
  if (isfinite(best->min_distance) &&
      distance_at_least(a, pose[0], b, pose[1], &n->way, best->min_distance)) {
    return;
  }
  double nearest[2][3];
  twofold_vector way;
  double distance = distance_and_way(a, pose[0], b, pose[1], nearest, &way);
  if (distance < best->min_distance) {
    n->way = way;
    best->min_distance = distance;
    memcpy(best->nearest_points, nearest, sizeof nearest);
    for (int k = 0; k < 2; k++) {
      best->pair[k] = s->body[k]->number[c->at[k]];
    }
    s->limit = fmin(s->limit, distance);
  }
}

/* Measure what may still be the nearest, the likeliest first. */
static void measure_kept(search *s, nearest_pairs *n) {
  while (n->count > 0) {
    int first = 0;
    for (int k = 1; k < n->count; k++) {
      first = n->kept[k].least < n->kept[first].least ? k : first;
    }
    candidate c = n->kept[first];
    n->kept[first] = n->kept[--n->count];
    if (c.least <= s->limit) {
      measure(s, n, &c);
    }
  }
}

static void keep(search *s, uint32_t i, uint32_t j, double least, double most) {
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
  n->kept[n->count++] = (candidate){{i, j}, least};
}

static uint32_t place_of(const sepax_body *b, size_t number) {
  uint32_t place = 0;
  while (b->number[place] != number) {
    place++;
  }
  return place;
}

bool sepax_bodies_distance(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                           const sepax_pose *pose_b, const sepax_distance_request *request,
                           sepax_distance_result *result, sepax_error *error) {
  static const sepax_distance_request usual = {0};
  const sepax_distance_request *r = request != NULL ? request : &usual;
  const double most = r->limit > 0 ? r->limit : INFINITY;
  const sepax_query any = {.most = 1, .path = r->path};
  sepax_pairs hit;
  *result = (sepax_distance_result){.min_distance = INFINITY};
  if (!(r->limit >= 0)) {
    return sepax_fail(error, "the limit %g of a distance is below 0", r->limit);
  }
  if (!sepax_bodies_collide(a, pose_a, b, pose_b, &any, &hit, error)) {
    return false;
  }
  nearest_pairs n = {.best = result};
  search s = {.body = {a, b}, .take = keep, .context = &n, .limit = most, .batch = 4};
  s.portable = r->path == SEPAX_PATH_PORTABLE;
  if (hit.count > 0) {
    n.kept[n.count++] = (candidate){{place_of(a, hit.pair[0][0]), place_of(b, hit.pair[0][1])}, 0};
    s.at.pose[0] = pose_a;
    s.at.pose[1] = pose_b;
  } else {
    search_pairs(&s, pose_a, pose_b);
  }
  sepax_pairs_free(&hit);
  measure_kept(&s, &n);
  if (result->min_distance > most) {
    *result = (sepax_distance_result){.min_distance = INFINITY};
  }
  return true;
}
