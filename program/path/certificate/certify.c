/* SPDX-License-Identifier: MIT */
/* certify.c - proves that bodies do not collide between the lines of a path, in parts of the way
 * from line to line (interval.c). docs/reference/mechanisms.md#between-the-lines. */
#include "path/certificate/certify.h"
#include "path/search/interval.h"
#include "util/error.h"
#include "util/threads.h"

#include <math.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Limits of the search for a pair: numbers of parts that are examined. Until a part stays open,
 * these are --intervals plus A_SEGMENT for each segment. After an open part they are BEHIND in its
 * segment, and ALL_BEHIND plus EACH_BEHIND for each segment in all later segments. */
enum { A_SEGMENT = 64, BEHIND = 4096, ALL_BEHIND = 1 << 18, EACH_BEHIND = 16 };

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

/* A pair at hand. */
typedef struct {
  work *all;
  path_pair *pair;
  path_asking now;
  size_t left;     /* how many more parts may be examined until one stays open */
  size_t behind;   /* and in all segments behind that */
  way_part *queue; /* QUEUE entries */
} asking;

enum { QUEUE = 2 * BEHIND + 2 * PATH_LEVELS_MOST + 2 };

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
  proof->interval[proof->count++] = a->now.at;
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

static void keep_collision(asking *a, double part_of_way) {
  path_proof *proof = &a->pair->proof;
  proof->collides = true;
  proof->segment = a->now.at.segment;
  proof->part = part_of_way;
}

/* Keep an open part and its exact distance. `first`: the first pose with a collision that was found
 * in its segment, or infinite. */
static bool keep_open(asking *a, double first, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  if (!path_interval_measure(&a->now, &proof->distance, error)) {
    return false;
  }
  proof->is_open = true;
  proof->open = a->now.at;
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
    if (!path_interval_ask(&a->now, &certified, error)) {
      return false;
    }
    a->left -= a->left > 0;
    if (certified) {
      if (!keep(a, error)) {
        return false;
      }
      more = advance(&a->now.at);
      continue;
    }
    bool possible = true;
    bool yes = false;
    if (!path_interval_collides(&a->now, &yes, error)) {
      return false;
    }
    first = yes ? fmin(first, middle_of(&a->now.at)) : first;
    proof->ended = a->left == 0;
    if (!proof->ended && !path_interval_divide(&a->now, &possible, error)) {
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
    a->now.at.level = a->queue[n].level;
    a->now.at.index = a->queue[n].index;
    if (!path_interval_ask(&a->now, &certified, error)) {
      return false;
    }
    ++*asked;
    bool yes = false;
    if (!certified && !path_interval_collides(&a->now, &yes, error)) {
      return false;
    }
    if (yes) {
      keep_collision(a, middle_of(&a->now.at));
      return true;
    }
    if (!certified && a->now.at.bound > a->all->q->resolution.length &&
        a->now.at.level < PATH_LEVELS_MOST) {
      for (unsigned half = 0; half < 2 && parts < QUEUE; half++) {
        a->queue[parts++] = (way_part){a->now.at.level + 1, 2 * a->now.at.index + half};
      }
    }
  }
  return true;
}

/* Search the segment after its open part, `most` parts at most. */
static bool search_behind(asking *a, size_t most, sepax_error *error) {
  size_t parts = 0;
  size_t asked = 0;
  while (advance(&a->now.at)) {
    a->queue[parts++] = (way_part){a->now.at.level, a->now.at.index};
  }
  for (size_t n = 0; n < parts / 2; n++) {
    way_part other = a->queue[n];
    a->queue[n] = a->queue[parts - 1 - n];
    a->queue[parts - 1 - n] = other;
  }
  bool ok = search(a, parts, most, &asked, error);
  a->behind -= asked < a->behind ? asked : a->behind;
  return ok;
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

/* Certify the next segment. The level of the interval before is a good first guess, because the
 * bodies are about as near and move about as far. After an open part `most` parts are searched. */
static bool certify_next(asking *a, size_t most, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  size_t n = a->now.at.segment;
  const path_interval *before = proof->count > 0 ? &proof->interval[proof->count - 1] : NULL;
  unsigned level = before != NULL ? before->level : 0;
  bool same = before != NULL && before->segment == n - 1 && stands_still(a, n - 1) &&
              stands_still(a, n) && deviates_as_before(a, n);
  a->now.at.level = same || level == 0 ? 0 : level - 1;
  a->now.at.index = 0;
  if (same && before->level == 0) {
    a->now.at = *before;
    a->now.at.segment = n;
    return keep(a, error);
  }
  return certify_segment(a, error) &&
         (!proof->is_open || proof->collides || search_behind(a, most, error));
}

/* Examine a segment, `segments` before the end. */
static bool ask_segment(asking *a, size_t segments, bool undecided, sepax_error *error) {
  const path_proof *proof = &a->pair->proof;
  if (proof->is_open || undecided) {
    return stands_still(a, a->now.at.segment) || search_segment(a, segments, error);
  }
  return certify_next(a, BEHIND, error);
}

static void tell_progress(asking *a) {
  size_t done = atomic_fetch_add(&a->all->done, 1) + 1;
  if (a->pair == a->all->scene->pair) { /* the calling thread gets the first pair */
    cli_progress_show(a->all->progress, done);
  }
}

/* Examine all segments until the end or until a pose with a collision. A pair that is undecided in
 * a line is not certified. */
static bool ask_segments(asking *a, sepax_error *error) {
  work *all = a->all;
  path_proof *proof = &a->pair->proof;
  size_t segments = all->scene->motion.lines - 1;
  bool undecided = a->pair->lines[VERDICT_UNDECIDED] > 0;
  for (size_t n = 0; n < segments && !proof->collides && !atomic_load(&all->stop); n++) {
    a->now.at.segment = n;
    if (path_motion_asked(all->scene, a->pair, n) &&
        !ask_segment(a, segments - n, undecided, error)) {
      return false;
    }
    tell_progress(a);
  }
  proof->certified = !undecided && !proof->is_open;
  return true;
}

/* ------------------------------------------------------------------------- programs */

/* Certify a segment by itself, whatever was found before it. pair->proof keeps the first open part
 * and the first collision of all segments. */
static bool ask_motion(asking *a, size_t segments, sepax_error *error) {
  path_proof *proof = &a->pair->proof;
  const path_proof before = *proof;
  size_t n = a->now.at.segment;
  size_t share = a->behind / segments;
  proof->is_open = false;
  proof->collides = false;
  if (!certify_next(a, share < EACH_BEHIND ? EACH_BEHIND : share, error)) {
    return false;
  }
  report_verdict verdict = path_between_lines(a->pair);
  a->pair->between[n] = (unsigned char)verdict;
  a->pair->part[n] = verdict != VERDICT_FREE ? path_between_moment(a->pair).part : 0;
  if (before.is_open) {
    proof->is_open = true;
    proof->open = before.open;
    proof->distance = before.distance;
    proof->ended = before.ended;
  }
  if (before.collides) {
    proof->collides = true;
    proof->segment = before.segment;
    proof->part = before.part;
  }
  return true;
}

/* Examine each motion of a program, because each of its lines has a verdict. */
static bool ask_motions(asking *a, sepax_error *error) {
  work *all = a->all;
  path_pair *pair = a->pair;
  size_t segments = all->scene->motion.lines - 1;
  pair->between = calloc(segments + 1, sizeof *pair->between);
  pair->part = calloc(segments + 1, sizeof *pair->part);
  if (pair->between == NULL || pair->part == NULL) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu verdicts", segments);
    return false;
  }
  for (size_t n = 0; n < segments && !atomic_load(&all->stop); n++) {
    a->now.at.segment = n;
    if (path_motion_asked(all->scene, pair, n) && !ask_motion(a, segments - n, error)) {
      return false;
    }
    tell_progress(a);
  }
  pair->proof.certified = !pair->proof.is_open && pair->lines[VERDICT_UNDECIDED] == 0 &&
                          pair->lines[VERDICT_COLLISION] == 0;
  return true;
}

/* Begin with a pair. To be ended, also after a failure. */
static bool begin_pair(asking *a, work *all, path_pair *pair, sepax_error *error) {
  *a = (asking){.all = all,
                .pair = pair,
                .left = all->q->intervals + A_SEGMENT * (all->scene->motion.lines - 1),
                .behind = ALL_BEHIND,
                .queue = malloc(QUEUE * sizeof *a->queue)};
  return path_asking_begin(&a->now, all->scene, all->q, pair, error) &&
         (a->queue != NULL ||
          sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for a queue of parts"));
}

static void end_pair(asking *a) {
  path_asking_end(&a->now);
  free(a->queue);
}

static bool ask_pair(work *all, path_pair *pair, sepax_error *error) {
  bool motions = all->scene->motion.step != NULL;
  if (pair->by_cells || (!motions && pair->lines[VERDICT_COLLISION] > 0)) {
    return true;
  }
  asking a;
  bool ok = begin_pair(&a, all, pair, error) &&
            (motions ? ask_motions(&a, error) : ask_segments(&a, error));
  end_pair(&a);
  if (ok && pair->proof.collides && path_status_only(all->q)) {
    atomic_store(&all->stop, true);
  }
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
    a.now.at = (path_interval){.segment = segment};
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
  if (!ask_pair(all, pair, &error)) {
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
