/* SPDX-License-Identifier: MIT */
/* certify.c - proves that bodies do not collide between the lines of a path: if the bodies are
 * farther apart than any of their points moves, then they do not meet.
 * docs/reference/mechanisms.md#between-the-lines. */
#include "path/certify.h"
#include "distance/swept.h"
#include "mechanism/steps.h"
#include "util/error.h"
#include "util/threads.h"
#include "util/vector.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Limits of the search for a pair: levels of halving (LEVELS_MOST), and numbers of parts that are
 * examined. Until a part stays open, these are --intervals plus A_SEGMENT for each segment. After
 * an open part they are BEHIND in its segment, and ALL_BEHIND plus EACH_BEHIND for each segment in
 * all later segments. */
enum { LEVELS_MOST = 52, A_SEGMENT = 64, BEHIND = 4096, ALL_BEHIND = 1 << 18, EACH_BEHIND = 16 };

typedef struct {
  path_scene *scene;
  const path_question *q;
  cli_progress *progress;
  atomic_size_t done; /* segments done, over all pairs */
  atomic_bool stop;
  atomic_flag failing;
  sepax_error *error;
} work;

typedef struct {
  unsigned level;
  uint64_t index;
} way_part;

/* A pair at hand, and a part of a segment of its way. */
typedef struct {
  work *all;
  path_pair *pair;
  const path_body *body[2];
  sepax_chain back; /* the chain from the second body to the first */
  double *value[3]; /* values of all joints at the beginning, the middle and the end */
  sepax_pose pose[2];
  double extent; /* larger than every coordinate of both bodies */
  sepax_distance_result last;
  bool has_last;
  path_interval at;
  double least, most;    /* the distance at the middle, if it is not large enough */
  int step;              /* how many tolerances the distance has been measured with */
  size_t left;           /* how many more parts may be examined until one stays open */
  size_t behind;         /* and in all segments behind that */
  way_part *queue;       /* QUEUE entries */
  unsigned waits, pause; /* sweeps: not before so many more parts; after the next that fails */
} asking;

enum { QUEUE = 2 * BEHIND + 2 * LEVELS_MOST + 2 };

static void set_values(asking *a) {
  const format_motion *motion = &a->all->scene->motion;
  const double *from = &motion->value[a->at.segment * motion->joints];
  const double *to = from + motion->joints;
  for (int k = 0; k < 3; k++) {
    double part = ldexp((double)(2 * a->at.index + (uint64_t)k), -(int)a->at.level - 1);
    for (size_t n = 0; n < motion->joints; n++) {
      a->value[k][n] = part == 1 ? to[n] : from[n] + (to[n] - from[n]) * part;
    }
  }
}

/* How far the bodies must be apart in each pose of the segment. */
static double clearance_of(const asking *a) {
  const format_step *step = a->all->scene->motion.step;
  return path_bands(a->all->q, a->pair).clearance.length +
         (step != NULL ? step[a->at.segment + 1].deviation : 0);
}

static double bound_of(const asking *a) {
  const sepax_mechanism *m = &a->all->scene->robot.mechanism;
  const sepax_chain *const chain[2] = {&a->pair->chain, &a->back};
  double least = INFINITY;
  for (int side = 0; side < 2; side++) {
    double box[2][3];
    memcpy(box[0], a->body[side]->least, sizeof box[0]);
    memcpy(box[1], a->body[side]->most, sizeof box[1]);
    least =
        fmin(least, sepax_chain_travel(chain[side], m, a->value[0], a->value[1], a->value[2], box));
  }
  return least;
}

/* ----------------------------------------------------------------------------- boxes */

typedef struct {
  double side[2][3]
             [3];    /* half the sides of each box, as vectors in the second body's coordinates */
  double between[3]; /* from the centre of the second box to the centre of the first */
} two_boxes;

static two_boxes posed_boxes(const asking *a) {
  two_boxes t;
  double way[3];
  for (int i = 0; i < 3; i++) {
    way[i] = a->pose[0].translation[i] - a->pose[1].translation[i];
    for (int k = 0; k < 3; k++) {
      way[i] += a->pose[0].rotation[i][k] * (a->body[0]->least[k] / 2 + a->body[0]->most[k] / 2);
    }
  }
  for (int i = 0; i < 3; i++) {
    const double(*b)[3] = a->pose[1].rotation;
    t.between[i] = b[0][i] * way[0] + b[1][i] * way[1] + b[2][i] * way[2] -
                   (a->body[1]->least[i] / 2 + a->body[1]->most[i] / 2);
    for (int k = 0; k < 3; k++) {
      const double(*r)[3] = a->pose[0].rotation;
      t.side[0][k][i] = (b[0][i] * r[0][k] + b[1][i] * r[1][k] + b[2][i] * r[2][k]) *
                        (a->body[0]->most[k] / 2 - a->body[0]->least[k] / 2);
      t.side[1][k][i] = i == k ? a->body[1]->most[k] / 2 - a->body[1]->least[k] / 2 : 0;
    }
  }
  return t;
}

/* The gap between the boxes along an axis, or a negative number if there is none. `axis` becomes a
 * unit vector that points from the second box to the first. */
static double gap_along(const two_boxes *t, double axis[3]) {
  double length = vector_length(axis);
  if (!(length > 0x1p-500)) {
    return -1;
  }
  double way = vector_dot(t->between, axis);
  double reach = 0;
  for (int k = 0; k < 6; k++) {
    reach += fabs(vector_dot(t->side[k / 3][k % 3], axis));
  }
  for (int i = 0; i < 3; i++) {
    axis[i] /= way < 0 ? -length : length;
  }
  return (fabs(way) - reach) / length;
}

/* True if the boxes are more than `need` apart. Then a->at.axis is an axis that proves it. */
static bool boxes_disjoint(asking *a, double need) {
  two_boxes t = posed_boxes(a);
  double most = -1;
  for (int n = 0; n < 15; n++) {
    double axis[3];
    for (int i = 0; i < 3; i++) {
      int j = (i + 1) % 3;
      int k = (i + 2) % 3;
      const double *u = t.side[0][n % 3];
      const double *v = t.side[1][n / 3 % 3];
      axis[i] = n < 9 ? u[j] * v[k] - u[k] * v[j] : t.side[(n - 9) / 3][n % 3][i];
    }
    double gap = gap_along(&t, axis);
    if (gap > most) {
      most = gap;
      memcpy(a->at.axis, axis, sizeof axis);
    }
  }
  return most > need + 0x1p-40 * (a->extent + sqrt(vector_dot(t.between, t.between)));
}

/* -------------------------------------------------------------------------- intervals */

/* A proof needs "farther apart than", not how far. How far decides only how often an interval is
 * halved, so a coarse distance does in most cases. The last tolerance is that of the exact
 * distance. */
static const double tolerances[] = {0x1p-4, 0x1p-10, 0};
enum { TOLERANCES = sizeof tolerances / sizeof *tolerances };

/* Measure the distance at the middle with the next tolerance. */
static bool narrow(asking *a, sepax_error *error) {
  const sepax_distance_request request = {.size = sizeof(sepax_distance_request),
                                          .relative = tolerances[a->step],
                                          .last = a->has_last ? &a->last : NULL};
  sepax_distance_result r;
  if (!sepax_bodies_distance(a->body[0]->body, &a->pose[0], a->body[1]->body, &a->pose[1], &request,
                             &r, error)) {
    return false;
  }
  a->step++;
  a->least = a->step == TOLERANCES ? r.min_distance : r.least;
  a->most = a->step == TOLERANCES ? r.min_distance : r.most;
  if (r.min_distance > 0) {
    a->last = r;
    a->has_last = true;
  }
  return true;
}

/* ----------------------------------------------------------------------------- sweeps */

/* Comparisons of a sweep, and how many parts go by after sweeps that failed. A sweep takes as long
 * as some tens of queries, so it is for bodies that slide along each other. */
enum { SWEEP_WORK = 4096, PAUSE_MOST = 63, SWEEP_FROM = 4 };

/* The pose of the first body as seen from the second. */
static sepax_pose seen(const asking *a, const double *value) {
  sepax_pose pose[2];
  sepax_pose r = {.translation = {0}};
  sepax_chain_poses(&a->pair->chain, &a->all->scene->robot.mechanism, value, pose);
  for (int i = 0; i < 3; i++) {
    for (int k = 0; k < 3; k++) {
      double turned = pose[1].rotation[k][i];
      r.translation[i] += turned * (pose[0].translation[k] - pose[1].translation[k]);
      for (int j = 0; j < 3; j++) {
        r.rotation[i][j] += turned * pose[0].rotation[k][j];
      }
    }
  }
  return r;
}

/* Do the bodies slide along each other far enough apart? The way of each point is straight but for
 * its bend, so what counts is how near the hulls of the ways come (lib/distance/swept.c). */
static bool slides_apart(asking *a) {
  double left = a->least - clearance_of(a);
  double box[2][3];
  if (!(a->at.bound > SWEEP_FROM * left) || !(left > 0)) {
    return false;
  }
  if (a->waits > 0) {
    a->waits--;
    return false;
  }
  memcpy(box[0], a->body[0]->least, sizeof box[0]);
  memcpy(box[1], a->body[0]->most, sizeof box[1]);
  double bend = sepax__chain_bend(&a->pair->chain, &a->all->scene->robot.mechanism, a->value[0],
                                  a->value[1], a->value[2], box);
  if (!(bend < left / 2)) {
    return false;
  }
  sepax_pose from = seen(a, a->value[0]);
  sepax_pose to = seen(a, a->value[2]);
  double need = (clearance_of(a) + bend) * (1 + 0x1p-40);
  bool yes = sepax__swept_apart(a->body[0]->body, &from, &to, a->body[1]->body, need, SWEEP_WORK);
  a->pause = yes ? 0 : a->pause < PAUSE_MOST ? 2 * a->pause + 1 : PAUSE_MOST;
  a->waits = a->pause;
  return yes;
}

/* Certify a part of a segment if possible. If not, the distance at its middle is measured. */
static bool ask(asking *a, bool *certified, sepax_error *error) {
  static const sepax_apart_request request = {.size = sizeof(sepax_apart_request)};
  sepax_apart_result r;
  set_values(a);
  sepax_chain_poses(&a->pair->chain, &a->all->scene->robot.mechanism, a->value[1], a->pose);
  a->at.bound = bound_of(a);
  double need = (a->at.bound + clearance_of(a)) * (1 + 0x1p-48);
  a->at.by_axis = boxes_disjoint(a, need);
  *certified = a->at.by_axis;
  if (*certified) {
    return true;
  }
  if (!sepax_bodies_apart(a->body[0]->body, &a->pose[0], a->body[1]->body, &a->pose[1], need,
                          &request, &r, error)) {
    return false;
  }
  a->step = 0;
  *certified = r.verdict == SEPAX_APART;
  if (*certified) {
    return true;
  }
  if (!narrow(a, error)) {
    return false;
  }
  *certified = slides_apart(a);
  return true;
}

static bool keep(asking *a, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  if (proof->count == proof->capacity) {
    size_t capacity = proof->capacity == 0 ? 1024 : 2 * proof->capacity;
    path_interval *grown = realloc(proof->interval, capacity * sizeof *grown);
    if (grown == NULL) {
      return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu intervals", capacity);
    }
    proof->interval = grown;
    proof->capacity = capacity;
  }
  proof->interval[proof->count++] = a->at;
  return true;
}

static double middle_of(const path_interval *at) {
  return ldexp((double)(2 * at->index + 1), -(int)at->level - 1);
}

/* Go to the next part of the segment, twice as long if possible. False after the last part. */
static bool advance(path_interval *at) {
  at->index++;
  if (at->level > 0 && at->index % 2 == 0) {
    at->level--;
    at->index /= 2;
  }
  return at->index < (uint64_t)1 << at->level;
}

/* How often a part is halved if this is its distance; at least once. */
static int halvings(const asking *a, double distance) {
  const path_question *q = a->all->q;
  double left = fmax(distance - clearance_of(a), q->resolution.length);
  int times = (int)floor(log2(a->at.bound / left));
  return times < 1 ? 1 : times > 8 ? 8 : times;
}

/* Halve the part as often as its distance requires. *possible: false if its motion is already as
 * short as the resolution. */
static bool divide(asking *a, bool *possible, sepax_error *error) {
  *possible = a->at.bound > a->all->q->resolution.length;
  if (!*possible) {
    return true;
  }
  int times = halvings(a, a->least);
  while (times != halvings(a, a->most)) {
    if (!narrow(a, error)) {
      return false;
    }
    times = halvings(a, a->least);
  }
  *possible = (int)a->at.level + times <= LEVELS_MOST;
  if (*possible) {
    a->at.level += (unsigned)times;
    a->at.index <<= times;
  }
  return true;
}

/* Do the bodies collide at the middle? The comparison leaves room for the rounding of the
 * distance. */
static bool collides(asking *a, bool *yes, sepax_error *error) {
  double limit = path_bands(a->all->q, a->pair).clearance.length * (1 - 0x1p-50);
  while (a->least <= limit && limit < a->most) {
    if (!narrow(a, error)) {
      return false;
    }
  }
  *yes = a->most <= limit;
  return true;
}

static void keep_collision(asking *a, double part_of_way) {
  path_proof *proof = &a->pair->proof;
  proof->collides = true;
  proof->segment = a->at.segment;
  proof->part = part_of_way;
}

/* Keep an open part and its exact distance. `first`: the first pose with a collision that was found
 * in its segment, or infinite. */
static bool keep_open(asking *a, double first, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  while (a->step < TOLERANCES) {
    if (!narrow(a, error)) {
      return false;
    }
  }
  proof->is_open = true;
  proof->open = a->at;
  proof->distance = a->least;
  if (isfinite(first)) {
    keep_collision(a, first);
  }
  return true;
}

/* Certify a segment. False only on an error. The first segment that is not certified is kept in
 * pair->proof. */
static bool certify_segment(asking *a, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  double first = INFINITY;
  for (bool more = true; more;) {
    bool certified = false;
    if (!ask(a, &certified, error)) {
      return false;
    }
    a->left -= a->left > 0;
    if (certified) {
      if (!keep(a, error)) {
        return false;
      }
      more = advance(&a->at);
      continue;
    }
    bool possible = true;
    bool yes = false;
    if (!collides(a, &yes, error)) {
      return false;
    }
    first = yes ? fmin(first, middle_of(&a->at)) : first;
    proof->ended = a->left == 0;
    if (!proof->ended && !divide(a, &possible, error)) {
      return false;
    }
    if (proof->ended || !possible) {
      return keep_open(a, first, error);
    }
  }
  return true;
}

/* Search the parts of a segment for a pose in which the bodies collide. The longest parts are
 * examined first, `most` parts at most. */
static bool search(asking *a, size_t parts, size_t most, size_t *asked, sepax_error *error) {
  for (size_t n = 0; n < parts && n < most; n++) {
    bool certified = false;
    a->at.level = a->queue[n].level;
    a->at.index = a->queue[n].index;
    if (!ask(a, &certified, error)) {
      return false;
    }
    ++*asked;
    bool yes = false;
    if (!certified && !collides(a, &yes, error)) {
      return false;
    }
    if (yes) {
      keep_collision(a, middle_of(&a->at));
      return true;
    }
    if (!certified && a->at.bound > a->all->q->resolution.length && a->at.level < LEVELS_MOST) {
      for (unsigned half = 0; half < 2 && parts < QUEUE; half++) {
        a->queue[parts++] = (way_part){a->at.level + 1, 2 * a->at.index + half};
      }
    }
  }
  return true;
}

/* Search the segment after its open part. */
static bool search_behind(asking *a, sepax_error *error) {
  size_t parts = 0;
  size_t asked = 0;
  while (advance(&a->at)) {
    a->queue[parts++] = (way_part){a->at.level, a->at.index};
  }
  for (size_t n = 0; n < parts / 2; n++) {
    way_part other = a->queue[n];
    a->queue[n] = a->queue[parts - 1 - n];
    a->queue[parts - 1 - n] = other;
  }
  return search(a, parts, BEHIND, &asked, error);
}

/* Search a later segment, `segments` before the end. It may examine its share of the parts that are
 * left. */
static bool search_segment(asking *a, size_t segments, sepax_error *error) {
  size_t share = a->behind / segments;
  size_t most = share < EACH_BEHIND ? EACH_BEHIND : share > BEHIND ? BEHIND : share;
  size_t asked = 0;
  a->queue[0] = (way_part){0, 0};
  bool ok = search(a, 1, most, &asked, error);
  a->behind -= asked < a->behind ? asked : a->behind;
  return ok;
}

static bool stands_still(const asking *a, size_t segment) {
  const format_motion *motion = &a->all->scene->motion;
  const double *from = &motion->value[segment * motion->joints];
  for (size_t n = 0; n < a->pair->chain.count; n++) {
    size_t joint = a->pair->chain.joint[n];
    if (from[joint] != from[joint + motion->joints]) {
      return false;
    }
  }
  return true;
}

static bool deviates_as_before(const asking *a, size_t segment) {
  const format_step *step = a->all->scene->motion.step;
  return step == NULL || step[segment + 1].deviation <= step[segment].deviation;
}

/* Certify the next segment. `level` is the level of the segment before, a good first guess because
 * the bodies are about as near and move about as far. */
static bool certify_next(asking *a, unsigned level, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  size_t n = a->at.segment;
  const path_interval *before = proof->count > 0 ? &proof->interval[proof->count - 1] : NULL;
  bool same = before != NULL && before->segment == n - 1 && stands_still(a, n - 1) &&
              stands_still(a, n) && deviates_as_before(a, n);
  a->at.level = same || level == 0 ? 0 : level - 1;
  a->at.index = 0;
  if (same && before->level == 0) {
    a->at = *before;
    a->at.segment = n;
    return keep(a, error);
  }
  return certify_segment(a, error) &&
         (!proof->is_open || proof->collides || search_behind(a, error));
}

/* Examine a segment, `segments` before the end. */
static bool ask_segment(asking *a, size_t segments, bool undecided, sepax_error *error) {
  const path_proof *proof = &a->pair->proof;
  if (proof->is_open || undecided) {
    return stands_still(a, a->at.segment) || search_segment(a, segments, error);
  }
  return certify_next(a, proof->count > 0 ? proof->interval[proof->count - 1].level : 0, error);
}

/* Examine all segments until the end or until a pose with a collision. A pair that is undecided in
 * a line is not certified. */
static bool ask_segments(asking *a, sepax_error *error) {
  work *all = a->all;
  path_proof *proof = &a->pair->proof;
  size_t segments = all->scene->motion.lines - 1;
  bool undecided = a->pair->lines[VERDICT_UNDECIDED] > 0;
  for (size_t n = 0; n < segments && !proof->collides && !atomic_load(&all->stop); n++) {
    a->at.segment = n;
    if (path_motion_asked(all->scene, a->pair, n) &&
        !ask_segment(a, segments - n, undecided, error)) {
      return false;
    }
    size_t done = atomic_fetch_add(&all->done, 1) + 1;
    if (a->pair == all->scene->pair) { /* the calling thread gets the first pair */
      cli_progress_show(all->progress, done);
    }
  }
  proof->certified = !undecided && !proof->is_open;
  if (proof->collides && path_status_only(all->q)) {
    atomic_store(&all->stop, true);
  }
  return true;
}

/* Begin with a pair; `values` and `queue` are to be freed by end_pair, also after a failure. */
static bool begin_pair(asking *a, work *all, path_pair *pair, sepax_error *error) {
  const path_scene *scene = all->scene;
  size_t joints = scene->motion.joints;
  *a = (asking){.all = all,
                .pair = pair,
                .body = {&scene->body[pair->body[0]], &scene->body[pair->body[1]]},
                .left = all->q->intervals + A_SEGMENT * (scene->motion.lines - 1),
                .behind = ALL_BEHIND};
  double *values = malloc(3 * (joints + 1) * sizeof *values);
  a->value[0] = values;
  a->queue = malloc(QUEUE * sizeof *a->queue);
  if (values == NULL || a->queue == NULL) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu joints", joints);
    return false;
  }
  for (int k = 0; k < 3; k++) {
    a->value[k] = values + (size_t)k * joints;
    a->extent += fabs(a->body[0]->least[k]) + fabs(a->body[0]->most[k]) +
                 fabs(a->body[1]->least[k]) + fabs(a->body[1]->most[k]);
  }
  return sepax_chain_find(&a->back, &scene->robot.mechanism, a->body[1]->link, a->body[0]->link,
                          error);
}

static void end_pair(asking *a) {
  sepax_chain_free(&a->back);
  free(a->value[0]);
  free(a->queue);
}

static bool ask_pair(work *all, path_pair *pair, sepax_error *error) {
  asking a;
  bool ok = begin_pair(&a, all, pair, error) && ask_segments(&a, error);
  end_pair(&a);
  return ok;
}

bool path_certify_segment(path_scene *scene, const path_question *q, const path_pair *pair,
                          size_t segment, bool *certified, sepax_error *error) {
  work all = {.scene = scene, .q = q, .failing = ATOMIC_FLAG_INIT, .error = error};
  path_pair own = *pair;
  asking a;
  own.proof = (path_proof){0};
  bool ok = begin_pair(&a, &all, &own, error);
  if (ok) {
    a.at = (path_interval){.segment = segment};
    a.left = A_SEGMENT * A_SEGMENT;
    ok = certify_segment(&a, error);
  }
  *certified = ok && !own.proof.is_open;
  end_pair(&a);
  free(own.proof.interval);
  return ok;
}

static void work_on(void *context, size_t part) {
  work *all = context;
  path_pair *pair = &all->scene->pair[part];
  sepax_error error = {0};
  if (pair->lines[VERDICT_COLLISION] == 0 && !pair->by_cells && !ask_pair(all, pair, &error)) {
    if (!atomic_flag_test_and_set(&all->failing)) {
      *all->error = error;
    }
    atomic_store(&all->stop, true);
  }
}

bool path_certify(path_scene *scene, const path_question *q, sepax_error *error) {
  size_t segments = scene->motion.lines - 1;
  cli_progress progress = cli_progress_begin("segments of all pairs", segments * scene->pairs);
  work all = {
      .scene = scene, .q = q, .progress = &progress, .failing = ATOMIC_FLAG_INIT, .error = error};
  atomic_init(&all.done, 0);
  atomic_init(&all.stop, path_status_only(q) && path_worst(scene) == VERDICT_COLLISION);
  sepax__threads_run(q->threads > 0 ? (size_t)q->threads : sepax__threads_here(), scene->pairs,
                     work_on, &all);
  scene->between = true;
  scene->between_seconds = cli_progress_end(&progress);
  return !atomic_flag_test_and_set(&all.failing);
}
