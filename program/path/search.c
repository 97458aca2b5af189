/* SPDX-License-Identifier: MIT */
/* search.c - decides each pair of bodies in each line of the path. */
#include "path/parts.h"
#include "util/error.h"
#include "util/threads.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

typedef struct {
  path_scene *scene;
  const path_question *q;
  cli_progress *progress;
  atomic_size_t done; /* lines done, over all pairs */
  atomic_bool stop;
  atomic_flag failing, showing;
  sepax_error *error;
} work;

/* The state of a thread: the pair that it decides. */
typedef struct {
  const work *all;
  path_pair *pair;
  const path_body *body[2];
  sepax_pose pose[2];
  sepax_distance_result last;
  bool has_last;
  size_t line;
} asking;

/* ------------------------------------------------------------------------- verdicts */

static bool any_near(const asking *a, double length, bool *near, sepax_error *error) {
  const sepax_query query = {.size = sizeof(sepax_query), .only_any = true};
  sepax_pairs found;
  const sepax_body *const body[2] = {a->body[0]->body, a->body[1]->body};
  if (!(length > 0 ? sepax_bodies_near(body[0], &a->pose[0], body[1], &a->pose[1], length, &query,
                                       &found, error)
                   : sepax_bodies_collide(body[0], &a->pose[0], body[1], &a->pose[1], &query,
                                          &found, error))) {
    return false;
  }
  *near = found.count > 0;
  sepax_pairs_free(&found);
  return true;
}

/* Is the exact distance at most the limit? `distance` is the exact distance rounded, wrong by less
 * than one unit in the last place. */
static bool within_limit(const asking *a, double distance, double limit, bool *near,
                         sepax_error *error) {
  static const double doubt = 0x1p-50;
  *near = distance <= limit;
  if (limit == 0 || fabs(distance - limit) > doubt * limit) {
    return true;
  }
  return any_near(a, limit, near, error);
}

static bool find_distance(asking *a, double *distance, sepax_error *error) {
  path_pair *pair = a->pair;
  double asked = fmax(a->all->q->bands.clearance.length, a->all->q->bands.warning.length);
  double limit = fmax(pair->least, asked * (1 + 0x1p-49));
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                          .limit = isfinite(limit) ? limit : 0,
                                          .last = a->has_last ? &a->last : NULL};
  sepax_distance_result r;
  if (!sepax_bodies_distance(a->body[0]->body, &a->pose[0], a->body[1]->body, &a->pose[1], &request,
                             &r, error)) {
    return false;
  }
  *distance = r.min_distance;
  if (isfinite(r.min_distance) && r.min_distance > 0) {
    a->last = r;
    a->has_last = true;
  }
  if (r.min_distance < pair->least) {
    pair->least = r.min_distance;
    pair->least_line = a->line;
    memcpy(pair->point, r.nearest_points, sizeof pair->point);
  }
  return true;
}

/* The verdict on the surfaces. While a smaller least clearance may be found, the distance decides;
 * otherwise the search ends as soon as the band is known. */
static bool ask_surfaces(asking *a, report_verdict *verdict, sepax_error *error) {
  const path_question *q = a->all->q;
  const report_limit *limits[] = {&q->bands.clearance, &q->bands.warning};
  static const report_verdict bands[] = {VERDICT_COLLISION, VERDICT_WARNING};
  double distance = 0;
  bool measured = !q->no_distance && a->pair->least > 0;
  if (measured && !find_distance(a, &distance, error)) {
    return false;
  }
  *verdict = VERDICT_FREE;
  for (int i = 0; i < (q->bands.warning.text != NULL ? 2 : 1) && *verdict == VERDICT_FREE; i++) {
    double limit = limits[i]->length;
    bool near = false;
    if (!(measured ? within_limit(a, distance, limit, &near, error)
                   : any_near(a, limit, &near, error))) {
      return false;
    }
    *verdict = near ? bands[i] : VERDICT_FREE;
  }
  return true;
}

/* May one body be inside the other? Only if their posed boxes overlap, with an allowance for
 * rounding. */
static bool boxes_overlap(const asking *a) {
  double middle[2][3];
  double half[2][3];
  for (int side = 0; side < 2; side++) {
    const path_body *b = a->body[side];
    const sepax_pose *p = &a->pose[side];
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

/* Is a part of one body inside a part of the other? */
static bool ask_within(const asking *a, report_verdict *verdict, sepax_error *error) {
  for (size_t i = 0; i < a->body[0]->parts; i++) {
    for (size_t k = 0; k < a->body[1]->parts; k++) {
      sepax_inside within[2];
      if (!sepax_bodies_within(&a->body[0]->part[i].shell, &a->pose[0], &a->body[1]->part[k].shell,
                               &a->pose[1], within, error)) {
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

static bool ask(asking *a, report_verdict *verdict, sepax_error *error) {
  path_pair *pair = a->pair;
  if (!ask_surfaces(a, verdict, error)) {
    return false;
  }
  if (*verdict == VERDICT_COLLISION || a->all->q->surfaces || !boxes_overlap(a)) {
    return true;
  }
  if (!ask_within(a, verdict, error)) {
    return false;
  }
  if (*verdict == VERDICT_COLLISION && pair->least > 0) {
    pair->least = 0;
    pair->least_line = a->line;
    pair->inside = true;
  }
  return true;
}

/* ---------------------------------------------------------------------------- lines */

/* True if a joint between the two links has moved since the line before. */
static bool has_moved(const path_scene *scene, const path_pair *pair, size_t line) {
  const format_motion *motion = &scene->motion;
  const double *now = &motion->value[line * motion->joints];
  const double *before = now - motion->joints;
  for (size_t n = 0; n < pair->chain.count; n++) {
    size_t joint = pair->chain.joint[n];
    if (now[joint] != before[joint]) {
      return true;
    }
  }
  return false;
}

static bool ask_lines(work *all, path_pair *pair, sepax_error *error) {
  const path_scene *scene = all->scene;
  const format_motion *motion = &scene->motion;
  report_verdict verdict = VERDICT_FREE;
  asking a = {
      .all = all, .pair = pair, .body = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]}};
  for (size_t line = 0; line < motion->lines && !atomic_load(&all->stop); line++) {
    a.line = line;
    if (line == 0 || has_moved(scene, pair, line)) {
      sepax_chain_poses(&pair->chain, &scene->robot.mechanism,
                        &motion->value[line * motion->joints], a.pose);
      if (!ask(&a, &verdict, error)) {
        return false;
      }
    }
    pair->lines[verdict]++;
    if (pair->first[verdict] == PATH_NO_LINE) {
      pair->first[verdict] = line;
    }
    if (pair->verdict != NULL) {
      pair->verdict[line] = (unsigned char)verdict;
    }
    size_t done = atomic_fetch_add(&all->done, 1) + 1;
    if (!atomic_flag_test_and_set(&all->showing)) {
      cli_progress_show(all->progress, done);
      atomic_flag_clear(&all->showing);
    }
    if (verdict == VERDICT_COLLISION && path_status_only(all->q)) {
      atomic_store(&all->stop, true);
    }
  }
  return true;
}

static void work_on(void *context, size_t part) {
  work *all = context;
  sepax_error error = {0};
  if (!ask_lines(all, &all->scene->pair[part], &error)) {
    if (!atomic_flag_test_and_set(&all->failing)) {
      *all->error = error;
    }
    atomic_store(&all->stop, true);
  }
}

bool path_status_only(const path_question *q) {
  return q->output.quiet && q->csv == NULL && q->picture == NULL && q->page == NULL;
}

bool path_search(path_scene *scene, const path_question *q, sepax_error *error) {
  size_t lines = scene->motion.lines;
  cli_progress progress = cli_progress_begin("lines of all pairs", lines * scene->pairs);
  work all = {.scene = scene,
              .q = q,
              .progress = &progress,
              .failing = ATOMIC_FLAG_INIT,
              .showing = ATOMIC_FLAG_INIT,
              .error = error};
  atomic_init(&all.done, 0);
  atomic_init(&all.stop, false);
  for (size_t n = 0; n < scene->pairs && (q->csv != NULL || q->page != NULL); n++) {
    scene->pair[n].verdict = calloc(lines, 1);
    if (scene->pair[n].verdict == NULL) {
      return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for verdicts of %zu lines", lines);
    }
  }
  size_t threads = q->threads > 0 ? (size_t)q->threads : sepax__threads_here();
  sepax__threads_run(threads, scene->pairs, work_on, &all);
  scene->seconds = cli_progress_end(&progress);
  return !atomic_flag_test_and_set(&all.failing);
}
