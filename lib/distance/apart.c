/* SPDX-License-Identifier: MIT */
/* apart.c - whether two posed bodies are farther apart than a distance. */
#include "search.h"
#include "util/options.h"

typedef struct {
  size_t pair[2];
} first_pair;

static bool record(void *context, size_t a, size_t b) {
  first_pair *first = context;
  first->pair[0] = a;
  first->pair[1] = b;
  return false;
}

bool sepax_bodies_apart(const sepax_body *a, const sepax_pose *pose_a, const sepax_body *b,
                        const sepax_pose *pose_b, double distance,
                        const sepax_apart_request *request, sepax_apart_result *result,
                        sepax_error *error) {
  sepax_apart_request r;
  *result = (sepax_apart_result){0};
  if (!sepax__options(&r, sizeof r, request, "sepax_apart_request", error)) {
    return false;
  }
  first_pair first = {{0, 0}};
  sepax_pairs found;
  const sepax_query query =
      SEPAX_STRUCT(sepax_query, .each = record, .context = &first, .simd = r.simd);
  if (!sepax_bodies_near(a, pose_a, b, pose_b, distance, &query, &found, error)) {
    return false;
  }
  result->verdict = found.count > 0 ? SEPAX_NEAR : SEPAX_APART;
  result->pair[0] = first.pair[0];
  result->pair[1] = first.pair[1];
  result->least = found.count > 0 ? 0 : distance;
  return true;
}
