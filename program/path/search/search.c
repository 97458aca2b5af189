/* SPDX-License-Identifier: MIT */
/* search.c - decides each pair of bodies in each line of the path, and finds the line in which the
 * bodies of each pair are nearest.
 *
 * The least clearance of a pair is the least of the distances that path_line_measure_alone finds,
 * and its line is the first line with that distance. Both depend on the poses alone, so lines may
 * be asked in any order, by any number of threads. The order saves work:
 *
 * 1. Each line gets a certain lower bound on its distance. A line whose bound is above the
 *    clearance and the warning is free.
 * 2. For each pair, the lines with the least bounds are measured first. After a few lines, few
 *    other lines have a bound that is not above the least distance so far. These lines are measured
 *    in the order of their bounds.
 * 3. The lines that are left are asked one after the other. Where the bounds say nothing, the
 *    least distance so far and the triangles that were nearest in the line before make a search
 *    short.
 *
 * Threads share blocks of lines, not pairs, because one pair often takes most of the time. */
#include "path/search/line.h"
#include "util/error.h"
#include "util/threads.h"

#include <math.h>
#include <pthread.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>

/* Lines of a block. Step 2 measures PROBES lines; if then at most FEW lines are left, then step 2
 * measures these lines, too. Bounds of BOUNDS lines and pairs, or of one pair, are kept at a time.
 */
enum { BLOCK = 256, PROBES = 3, FEW = 64, BOUNDS = 1 << 20 };

/* What is known of a pair in a line. */
typedef struct {
  double least;    /* the distance is at least this */
  bool is_decided; /* the line is no better than the least clearance that is known, or its pose is
                      that of the line before */
  bool overlap;    /* one body may be inside the other */
} path_bound;

typedef struct {
  path_scene *scene;
  const path_question *q;
  cli_progress *progress;
  size_t first;       /* the pair that bound[0] belongs to */
  size_t blocks;      /* blocks of a pair */
  path_bound *bound;  /* of all lines of the first pair, then of the next; NULL if only verdicts are
                         asked for */
  atomic_size_t done; /* lines done, over all pairs */
  atomic_bool stop;
  atomic_flag failing, showing;
  pthread_mutex_t lock; /* for the results of pairs */
  sepax_error *error;
} work;

/* The state of a thread: a pair and some of its lines. */
typedef struct {
  work *all;
  path_pair *pair;
  path_bound *bound; /* of the pair's lines, or NULL */
  path_line at;
  double least; /* the least clearance so far, and its line; other threads may know better */
  size_t least_line;
} asking;

/* `pair` is counted from the first pair at hand. */
static asking begin(work *all, size_t pair, path_bound *bound) {
  asking a = {
      .all = all, .pair = &all->scene->pair[all->first + pair], .bound = bound, .least = INFINITY};
  a.at = path_line_begin(all->scene, all->q, a.pair);
  return a;
}

static path_bound *bounds_of(const work *all, size_t pair) {
  return &all->bound[pair * all->scene->motion.lines];
}

static void fail(work *all, const sepax_error *error) {
  if (!atomic_flag_test_and_set(&all->failing)) {
    *all->error = *error;
  }
  atomic_store(&all->stop, true);
}

/* True if a joint between the two links has moved since the line before, or if that line was not
 * asked. */
static bool has_moved(const path_scene *scene, const path_pair *pair, size_t line) {
  const format_motion *motion = &scene->motion;
  const double *now = &motion->value[line * motion->joints];
  const double *before = now - motion->joints;
  if (!path_line_asked(scene, pair, line - 1)) {
    return true;
  }
  for (size_t n = 0; n < pair->chain.count; n++) {
    size_t joint = pair->chain.joint[n];
    if (now[joint] != before[joint]) {
      return true;
    }
  }
  return false;
}

/* --------------------------------------------------------------------------- bounds */

static bool find_bounds(asking *a, size_t from, size_t end, sepax_error *error) {
  const path_scene *scene = a->all->scene;
  for (size_t line = from; line < end && !atomic_load(&a->all->stop); line++) {
    path_bound *b = &a->bound[line];
    if (!path_line_asked(scene, a->pair, line)) {
      *b = (path_bound){.least = INFINITY, .is_decided = true};
      continue;
    }
    b->is_decided = line > 0 && !has_moved(scene, a->pair, line);
    if (b->is_decided && line > from) {
      b->least = b[-1].least;
      b->overlap = b[-1].overlap;
      continue;
    }
    path_line_pose(&a->at, line);
    b->overlap = !a->all->q->surfaces && path_line_boxes_overlap(&a->at);
    if (!path_line_bound(&a->at, &b->least, error)) {
      return false;
    }
  }
  return true;
}

static void bound_block(void *context, size_t part) {
  work *all = context;
  sepax_error error = {0};
  size_t lines = all->scene->motion.lines;
  size_t from = part % all->blocks * BLOCK;
  asking a = begin(all, part / all->blocks, bounds_of(all, part / all->blocks));
  if (!find_bounds(&a, from, from + BLOCK < lines ? from + BLOCK : lines, &error)) {
    fail(all, &error);
  }
}

/* ------------------------------------------------------------------ least clearance */

/* Learn what other threads know. */
static void learn(asking *a) {
  pthread_mutex_lock(&a->all->lock);
  a->least = a->pair->least;
  a->least_line = a->pair->least_line;
  pthread_mutex_unlock(&a->all->lock);
}

/* Take the clearance of a line if it is the least. `r`: the distance of the surfaces; NULL if one
 * body is inside the other. */
static void offer(asking *a, size_t line, const sepax_distance_result *r) {
  path_pair *pair = a->pair;
  double distance = r != NULL ? r->min_distance : 0;
  pthread_mutex_lock(&a->all->lock);
  if (distance < pair->least || (distance == pair->least && line < pair->least_line)) {
    pair->least = distance;
    pair->least_line = line;
    pair->inside = r == NULL;
    pair->interval[0] = r != NULL ? r->least : 0;
    pair->interval[1] = r != NULL ? r->most : 0;
    if (r != NULL) {
      memcpy(pair->point, r->nearest_points, sizeof pair->point);
    }
  }
  a->least = pair->least;
  a->least_line = pair->least_line;
  pthread_mutex_unlock(&a->all->lock);
}

/* Distances up to this may be the least: two measured distances of the same bodies in the same
 * poses differ by at most two units in the last place. */
static double least_with_doubt(const asking *a) { return a->least * (1 + 0x1p-50); }

/* May this line have the least clearance, or the same clearance as a later line? */
static bool may_be_least(const asking *a, size_t line) {
  const path_bound *b = &a->bound[line];
  return !b->is_decided &&
         (a->least > 0 ? b->least <= least_with_doubt(a) : b->least <= 0 && line < a->least_line);
}

/* Measure a line, in which the bodies are posed, and take its clearance if it is the least. A
 * distance above the least clearance is not measured to the end. */
static bool measure(asking *a, size_t line, path_range *known, sepax_error *error) {
  sepax_distance_result r;
  path_bound *b = &a->bound[line];
  learn(a);
  double limit = least_with_doubt(a);
  bool alone = isinf(limit) && !a->at.has_last;
  if (!path_line_measure(&a->at, limit, &r, error)) {
    return false;
  }
  *known = isinf(r.min_distance) ? (path_range){fmax(b->least, limit), INFINITY}
                                 : (path_range){r.min_distance, r.min_distance};
  b->is_decided = true;
  b->least = fmax(b->least, r.least);
  if (r.min_distance > limit || (!alone && !path_line_measure_alone(&a->at, &r, error))) {
    return r.min_distance > limit;
  }
  offer(a, line, &r);
  return true;
}

static bool measure_posed(asking *a, size_t line, sepax_error *error) {
  path_range known;
  path_line_pose(&a->at, line);
  return measure(a, line, &known, error);
}

/* The first of the lines with the least bound; PATH_NO_LINE if none is left. *left: number of lines
 * that may have the least clearance. */
static size_t next_line(const asking *a, size_t *left) {
  size_t next = PATH_NO_LINE;
  *left = 0;
  for (size_t line = 0; line < a->all->scene->motion.lines; line++) {
    if (may_be_least(a, line)) {
      ++*left;
      next = next == PATH_NO_LINE || a->bound[line].least < a->bound[next].least ? line : next;
    }
  }
  return next;
}

static bool measure_best_first(asking *a, sepax_error *error) {
  size_t left;
  size_t line = next_line(a, &left);
  for (int n = 0; line != PATH_NO_LINE && (n < PROBES || left <= FEW); n++) {
    if (!measure_posed(a, line, error)) {
      return false;
    }
    line = next_line(a, &left);
  }
  return true;
}

static void measure_pair(void *context, size_t part) {
  work *all = context;
  sepax_error error = {0};
  asking a = begin(all, part, bounds_of(all, part));
  if (!measure_best_first(&a, &error)) {
    fail(all, &error);
  }
  a.pair->measured += a.at.measured;
}

/* ------------------------------------------------------------------------- verdicts */

/* The least clearance is 0 in a later line. Is it 0 in this line, too? */
static bool ask_touching(asking *a, size_t line, sepax_error *error) {
  bool near = true;
  sepax_distance_result r;
  if (a->at.bands.clearance.length > 0 && !path_line_is_near(&a->at, 0, &near, error)) {
    return false;
  }
  if (near) {
    if (!path_line_measure_alone(&a->at, &r, error)) {
      return false;
    }
    offer(a, line, &r);
  }
  return true;
}

/* The verdict on the surfaces; it shares its search with the least clearance. */
static bool ask_surfaces(asking *a, size_t line, bool is_far, report_verdict *verdict,
                         sepax_error *error) {
  path_range known = {a->bound != NULL ? a->bound[line].least : 0, INFINITY};
  bool may = a->bound != NULL && may_be_least(a, line);
  bool measured = may && a->least > 0;
  *verdict = VERDICT_FREE;
  if ((measured && !measure(a, line, &known, error)) ||
      (!is_far && !path_line_surfaces(&a->at, &known, verdict, error))) {
    return false;
  }
  return !may || measured || *verdict != VERDICT_COLLISION || ask_touching(a, line, error);
}

static bool ask(asking *a, size_t line, report_verdict *verdict, sepax_error *error) {
  const path_bound *b = a->bound != NULL ? &a->bound[line] : NULL;
  bool is_far = b != NULL && b->least > a->at.outer;
  *verdict = VERDICT_FREE;
  if (is_far && !b->overlap && !may_be_least(a, line)) {
    return true;
  }
  path_line_pose(&a->at, line);
  if (!ask_surfaces(a, line, is_far, verdict, error)) {
    return false;
  }
  bool overlap = b != NULL ? b->overlap : !a->all->q->surfaces && path_line_boxes_overlap(&a->at);
  if (*verdict == VERDICT_COLLISION || !overlap) {
    return true;
  }
  if (!path_line_within(&a->at, verdict, error)) {
    return false;
  }
  if (*verdict == VERDICT_COLLISION && b != NULL) {
    offer(a, line, NULL);
  }
  return true;
}

/* ---------------------------------------------------------------------------- lines */

/* The verdicts of a block: how many lines have each, and the first of them. */
typedef struct {
  size_t lines[VERDICTS], first[VERDICTS];
} counts;

static void add_counts(asking *a, const counts *c) {
  path_pair *pair = a->pair;
  pthread_mutex_lock(&a->all->lock);
  for (int v = 0; v < VERDICTS; v++) {
    pair->lines[v] += c->lines[v];
    if (c->lines[v] > 0 && c->first[v] < pair->first[v]) {
      pair->first[v] = c->first[v];
    }
  }
  pair->measured += a->at.measured;
  pthread_mutex_unlock(&a->all->lock);
}

static bool ask_lines(asking *a, size_t from, size_t end, sepax_error *error) {
  work *all = a->all;
  counts c = {.lines = {0}};
  report_verdict verdict = VERDICT_FREE;
  learn(a);
  for (size_t line = from; line < end && !atomic_load(&all->stop); line++) {
    if (!path_line_asked(all->scene, a->pair, line)) {
      continue;
    }
    if ((line == from || has_moved(all->scene, a->pair, line)) && !ask(a, line, &verdict, error)) {
      return false;
    }
    if (c.lines[verdict]++ == 0) {
      c.first[verdict] = line;
    }
    if (a->pair->verdict != NULL) {
      a->pair->verdict[line] = (unsigned char)verdict;
    }
    if (verdict == VERDICT_COLLISION && path_status_only(all->q)) {
      atomic_store(&all->stop, true);
    }
  }
  add_counts(a, &c);
  size_t done = atomic_fetch_add(&all->done, end - from) + end - from;
  if (!atomic_flag_test_and_set(&all->showing)) {
    cli_progress_show(all->progress, done);
    atomic_flag_clear(&all->showing);
  }
  return true;
}

static void ask_block(void *context, size_t part) {
  work *all = context;
  sepax_error error = {0};
  size_t lines = all->scene->motion.lines;
  size_t from = part % all->blocks * BLOCK;
  size_t pair = part / all->blocks;
  asking a = begin(all, pair, all->bound != NULL ? bounds_of(all, pair) : NULL);
  if (!ask_lines(&a, from, from + BLOCK < lines ? from + BLOCK : lines, &error)) {
    fail(all, &error);
  }
}

bool path_status_only(const path_question *q) {
  return q->output.quiet && q->csv == NULL && q->picture == NULL && q->page == NULL &&
         q->stock == NULL; /* a collision with the first stock may be none with what is left */
}

static void search_pairs(work *all, size_t pairs) {
  size_t threads = all->q->threads > 0 ? (size_t)all->q->threads : sepax__threads_here();
  if (all->bound != NULL) {
    sepax__threads_run(threads, pairs * all->blocks, bound_block, all);
    sepax__threads_run(threads, atomic_load(&all->stop) ? 0 : pairs, measure_pair, all);
  }
  sepax__threads_run(threads, atomic_load(&all->stop) ? 0 : pairs * all->blocks, ask_block, all);
}

/* Are the verdicts of lines written to a file, or listed by the lines of a program? */
static bool keeps_verdicts(const path_scene *scene, const path_question *q) {
  return q->csv != NULL || q->page != NULL || (scene->motion.step != NULL && !path_status_only(q));
}

/* Memory for the verdicts that are kept, and for the bounds of `at_once` pairs. */
static bool prepare(work *all, size_t at_once, sepax_error *error) {
  const path_question *q = all->q;
  size_t lines = all->scene->motion.lines;
  for (size_t n = 0; n < all->scene->pairs && keeps_verdicts(all->scene, q); n++) {
    all->scene->pair[n].verdict = calloc(lines, 1);
    if (all->scene->pair[n].verdict == NULL) {
      return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for verdicts of %zu lines", lines);
    }
  }
  all->bound = q->no_distance ? NULL : calloc(at_once * lines, sizeof *all->bound);
  return q->no_distance || all->bound != NULL ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for bounds of %zu lines", lines);
}

/* Find out why the first undecided line of each pair is so. */
static bool find_reasons(path_scene *scene, const path_question *q, sepax_error *error) {
  bool ok = true;
  for (size_t n = 0; n < scene->pairs && ok; n++) {
    path_pair *pair = &scene->pair[n];
    if (pair->lines[VERDICT_UNDECIDED] > 0) {
      path_line l = path_line_begin(scene, q, pair);
      path_line_pose(&l, pair->first[VERDICT_UNDECIDED]);
      ok = path_line_why(&l, &pair->why_of, &pair->why, error);
    }
  }
  return ok;
}

bool path_search(path_scene *scene, const path_question *q, sepax_error *error) {
  size_t lines = scene->motion.lines;
  size_t at_once = BOUNDS / lines > 0 ? BOUNDS / lines : 1;
  at_once = at_once < scene->pairs ? at_once : scene->pairs;
  cli_progress progress = cli_progress_begin("lines of all pairs", lines * scene->pairs);
  work all = {.scene = scene,
              .q = q,
              .progress = &progress,
              .blocks = (lines + BLOCK - 1) / BLOCK,
              .failing = ATOMIC_FLAG_INIT,
              .showing = ATOMIC_FLAG_INIT,
              .lock = PTHREAD_MUTEX_INITIALIZER,
              .error = error};
  atomic_init(&all.done, 0);
  atomic_init(&all.stop, false);
  bool ok = prepare(&all, at_once, error);
  for (; ok && all.first < scene->pairs && !atomic_load(&all.stop); all.first += at_once) {
    size_t left = scene->pairs - all.first;
    search_pairs(&all, left < at_once ? left : at_once);
  }
  free(all.bound);
  scene->seconds = cli_progress_end(&progress);
  return ok && !atomic_flag_test_and_set(&all.failing) && find_reasons(scene, q, error);
}
