/* SPDX-License-Identifier: MIT */
/* line.c - two bodies in one line of the path. */
#include "path/search/line.h"

#include <math.h>

path_line path_line_begin(const path_scene *scene, const path_question *q, const path_pair *pair) {
  return (path_line){.scene = scene,
                     .q = q,
                     .pair = pair,
                     .body = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]},
                     .bands = path_bands(q, pair),
                     .outer =
                         pair->bare ? 0 : fmax(q->bands.clearance.length, q->bands.warning.length)};
}

void path_line_pose(path_line *l, size_t line) {
  const format_motion *motion = &l->scene->motion;
  sepax_chain_poses(&l->pair->chain, &l->scene->robot.mechanism,
                    &motion->value[line * motion->joints], l->pose);
}

/* ------------------------------------------------------------------------- distances */

static bool ask_apart(const path_line *l, double distance, uint64_t work, sepax_apart_result *r,
                      sepax_error *error) {
  const sepax_apart_request request = {.size = sizeof(sepax_apart_request), .work = work};
  return sepax_bodies_apart(l->body[0]->body, &l->pose[0], l->body[1]->body, &l->pose[1], distance,
                            &request, r, error);
}

bool path_line_bound(const path_line *l, double *least, sepax_error *error) {
  sepax_apart_result r;
  if (!ask_apart(l, 0, 1, &r, error)) {
    return false;
  }
  *least = r.least;
  return true;
}

bool path_line_is_near(const path_line *l, double distance, bool *near, sepax_error *error) {
  if (distance > 0) {
    sepax_apart_result r;
    if (!ask_apart(l, distance, 0, &r, error)) {
      return false;
    }
    *near = r.verdict == SEPAX_NEAR;
    return true;
  }
  const sepax_query query = {.size = sizeof(sepax_query), .only_any = true};
  sepax_pairs found;
  if (!sepax_bodies_collide(l->body[0]->body, &l->pose[0], l->body[1]->body, &l->pose[1], &query,
                            &found, error)) {
    return false;
  }
  *near = found.count > 0;
  sepax_pairs_free(&found);
  return true;
}

static bool find_distance(path_line *l, const sepax_distance_request *request,
                          sepax_distance_result *r, sepax_error *error) {
  l->measured++;
  if (!sepax_bodies_distance(l->body[0]->body, &l->pose[0], l->body[1]->body, &l->pose[1], request,
                             r, error)) {
    return false;
  }
  if (isfinite(r->min_distance) && r->min_distance > 0) {
    l->last = *r;
    l->has_last = true;
  }
  return true;
}

bool path_line_measure(path_line *l, double limit, sepax_distance_result *r, sepax_error *error) {
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                          .limit = isfinite(limit) ? limit : 0,
                                          .last = l->has_last ? &l->last : NULL};
  return find_distance(l, &request, r, error);
}

bool path_line_measure_alone(path_line *l, sepax_distance_result *r, sepax_error *error) {
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request)};
  return find_distance(l, &request, r, error);
}

/* -------------------------------------------------------------------------- verdicts */

/* Is the exact distance at most the limit? What is known of the distance decides, unless the limit
 * is between the bounds or next to one of them: a measured distance is rounded. */
static bool is_within(const path_line *l, const path_range *known, double limit, bool *within,
                      sepax_error *error) {
  static const double doubt = 0x1p-50;
  *within = known->most <= limit * (1 - doubt);
  return *within || known->least > limit * (1 + doubt) ||
         path_line_is_near(l, limit, within, error);
}

/* A warning is longer than a clearance, so most lines need one comparison. */
bool path_line_surfaces(const path_line *l, const path_range *known, report_verdict *verdict,
                        sepax_error *error) {
  const report_bands *bands = &l->bands;
  bool near = false;
  *verdict = VERDICT_FREE;
  if (!is_within(l, known, l->outer, &near, error)) {
    return false;
  }
  if (near && bands->warning.text != NULL) {
    *verdict = VERDICT_WARNING;
    if (!is_within(l, known, bands->clearance.length, &near, error)) {
      return false;
    }
  }
  *verdict = near ? VERDICT_COLLISION : *verdict;
  return true;
}

bool path_line_boxes_overlap(const path_line *l) {
  double middle[2][3];
  double half[2][3];
  for (int side = 0; side < 2; side++) {
    const path_body *b = l->body[side];
    const sepax_pose *p = &l->pose[side];
    for (int i = 0; i < 3; i++) {
      middle[side][i] = p->translation[i];
      half[side][i] = 0;
      for (int k = 0; k < 3; k++) {
        middle[side][i] += p->rotation[i][k] * (b->least[k] / 2 + b->most[k] / 2);
        half[side][i] += fabs(p->rotation[i][k]) * (b->most[k] / 2 - b->least[k] / 2);
      }
    }
  }
  for (int i = 0; i < 3; i++) {
    double gap = fabs(middle[0][i] - middle[1][i]);
    double size = half[0][i] + half[1][i];
    if (gap > size + 1e-9 * (size + fabs(middle[0][i]) + fabs(middle[1][i]))) {
      return false;
    }
  }
  return true;
}

bool path_line_within(const path_line *l, report_verdict *verdict, sepax_error *error) {
  for (size_t i = 0; i < l->body[0]->parts; i++) {
    for (size_t k = 0; k < l->body[1]->parts; k++) {
      sepax_inside within[2];
      if (!sepax_bodies_within(&l->body[0]->part[i].shell, &l->pose[0], &l->body[1]->part[k].shell,
                               &l->pose[1], within, error)) {
        return false;
      }
      for (int side = 0; side < 2; side++) {
        report_verdict v = within[side] == SEPAX_INSIDE           ? VERDICT_COLLISION
                           : within[side] == SEPAX_INSIDE_UNKNOWN ? VERDICT_UNDECIDED
                                                                  : VERDICT_FREE;
        *verdict = v > *verdict ? v : *verdict;
      }
      if (*verdict == VERDICT_COLLISION) {
        return true;
      }
    }
  }
  return true;
}

bool path_line_why(const path_line *l, int *side, sepax_within_reason *why, sepax_error *error) {
  *why = SEPAX_WITHIN_PLAIN;
  for (size_t i = 0; i < l->body[0]->parts; i++) {
    for (size_t k = 0; k < l->body[1]->parts && *why == SEPAX_WITHIN_PLAIN; k++) {
      sepax_inside within[2];
      sepax_within_reason both[2];
      if (!sepax_bodies_within_why(&l->body[0]->part[i].shell, &l->pose[0],
                                   &l->body[1]->part[k].shell, &l->pose[1], within, both, error)) {
        return false;
      }
      *side = within[0] == SEPAX_INSIDE_UNKNOWN ? 0 : 1;
      *why = within[*side] == SEPAX_INSIDE_UNKNOWN ? both[*side] : SEPAX_WITHIN_PLAIN;
    }
  }
  return true;
}
