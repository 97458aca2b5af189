/* SPDX-License-Identifier: MIT */
/* bodies.c - answers for sepax check on the bodies as their files have them, in one pose or in
 * many. */
#include "check/parts.h"
#include "util/error.h"
#include "util/threads.h"

#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int compare_pairs(const void *p, const void *q) {
  const size_t *a = p;
  const size_t *b = q;
  int first = (a[0] > b[0]) - (a[0] < b[0]);
  return first != 0 ? first : (a[1] > b[1]) - (a[1] < b[1]);
}

static void put_in_order(sepax_pairs *pairs) {
  if (pairs->count > 1) {
    qsort(pairs->pair, pairs->count, sizeof *pairs->pair, compare_pairs);
  }
}

typedef struct {
  sepax_body *body[2];
  sepax_shell shell[2];
} solids;

static bool ask_within(const solids *s, const sepax_pose *pose, check_answer *answer,
                       sepax_error *error) {
  if (!sepax_bodies_within_why(&s->shell[0], NULL, &s->shell[1], pose, answer->within, answer->why,
                               error)) {
    return false;
  }
  answer->within_asked = true;
  for (int i = 0; i < 2; i++) {
    report_verdict verdict = answer->within[i] == SEPAX_INSIDE           ? VERDICT_COLLISION
                             : answer->within[i] == SEPAX_INSIDE_UNKNOWN ? VERDICT_UNDECIDED
                                                                         : VERDICT_FREE;
    answer->verdict = report_worse(answer->verdict, verdict);
  }
  return true;
}

/* Find the pairs whose distance is at most the limit, or without a limit the colliding pairs. */
static bool find(const check_question *q, const solids *s, const sepax_pose *pose,
                 const report_limit *limit, sepax_pairs *found, sepax_error *error) {
  const sepax_query query = {
      .size = sizeof(sepax_query), .most = q->first ? 1 : 0, .only_any = check_any_is_enough(q)};
  bool ok = limit->length > 0
                ? sepax_bodies_near(s->body[0], NULL, s->body[1], pose, limit->length, &query,
                                    found, error)
                : sepax_bodies_collide(s->body[0], NULL, s->body[1], pose, &query, found, error);
  put_in_order(found);
  return ok;
}

/* Remove the colliding pairs from all near pairs. Both lists are sorted. */
static void take_out(sepax_pairs *all, const sepax_pairs *colliding) {
  size_t left = 0;
  for (size_t k = 0, taken = 0; k < all->count; k++) {
    if (taken < colliding->count && compare_pairs(all->pair[k], colliding->pair[taken]) == 0) {
      taken++;
    } else {
      memmove(all->pair[left++], all->pair[k], sizeof *all->pair);
    }
  }
  all->count = left;
}

/* Answer for B in one pose; NULL means as the file has it. */
static bool decide(const check_question *q, const solids *s, const sepax_pose *pose,
                   check_answer *answer, sepax_error *error) {
  if (!find(q, s, pose, &q->bands.clearance, &answer->colliding, error)) {
    return false;
  }
  answer->verdict = answer->colliding.count > 0 ? VERDICT_COLLISION : VERDICT_FREE;
  if (answer->verdict != VERDICT_COLLISION && !q->surfaces && !ask_within(s, pose, answer, error)) {
    return false;
  }
  bool one = q->first || check_any_is_enough(q);
  if (q->bands.warning.text == NULL || (one && answer->verdict == VERDICT_COLLISION)) {
    return true;
  }
  if (!find(q, s, pose, &q->bands.warning, &answer->warned, error)) {
    return false;
  }
  if (!one) {
    take_out(&answer->warned, &answer->colliding);
  }
  if (answer->verdict == VERDICT_FREE && answer->warned.count > 0) {
    answer->verdict = VERDICT_WARNING;
  }
  return true;
}

/* ----------------------------------------------------------------- many poses */

typedef struct {
  const check_question *q;
  solids solids;
  sepax_poses poses;
  check_answer *answer;
  atomic_size_t next;
  atomic_bool stop;
} work;

typedef struct {
  work *all;
  sepax_error error;
  bool failed;
  cli_progress *progress; /* only the first thread reports; NULL for the others */
} worker;

/* With many poses, keep the counts, and only those lists that are printed or written. */
static void forget(const check_question *q, check_answer *answer) {
  sepax_pairs *lists[] = {&answer->colliding, &answer->warned};
  for (int i = 0; i < 2; i++) {
    if (!q->first && (i == 1 || q->pairs_path == NULL)) {
      free(lists[i]->pair);
      lists[i]->pair = NULL;
    }
  }
}

static void work_on(void *workers, size_t part) {
  worker *w = (worker *)workers + part;
  work *all = w->all;
  size_t n;
  while (!atomic_load(&all->stop) && (n = atomic_fetch_add(&all->next, 1)) < all->poses.count) {
    check_answer *answer = &all->answer[n];
    if (!decide(all->q, &all->solids, &all->poses.pose[n], answer, &w->error)) {
      w->failed = true;
    }
    if (w->failed || (check_any_is_enough(all->q) && answer->verdict == VERDICT_COLLISION)) {
      atomic_store(&all->stop, true);
    }
    forget(all->q, answer);
    if (w->progress != NULL) {
      cli_progress_show(w->progress, n);
    }
  }
}

static bool decide_all(work *all, cli_progress *progress, sepax_error *error) {
  size_t wanted = all->q->threads > 0 ? (size_t)all->q->threads : sepax__threads_here();
  size_t threads = wanted < all->poses.count ? wanted : all->poses.count;
  worker *workers = calloc(threads, sizeof *workers);
  if (workers == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for %zu threads; give --threads=1",
                      threads);
  }
  for (size_t k = 0; k < threads; k++) {
    workers[k].all = all;
  }
  workers[0].progress = progress;
  sepax__threads_run(threads, threads, work_on, workers);
  bool ok = true;
  for (size_t k = 0; k < threads; k++) {
    if (workers[k].failed) {
      *error = workers[k].error;
      ok = false;
    }
  }
  free(workers);
  return ok;
}

/* --------------------------------------------------------------------- the job */

static bool build_solid(const check_question *q, int i, check_report *report, solids *s,
                        sepax_error *error) {
  sepax_soup *mesh = &report->mesh[i];
  sepax_shell *shell = &s->shell[i];
  report->triangles[i] = mesh->count;
  if (!sepax_body_new(&s->body[i], SEPAX_SOUP_MESH(mesh), NULL, error) ||
      !sepax_shell_find(shell, s->body[i], error)) {
    sepax_error inner = *error;
    return sepax_fail(error, inner.code, "%.240s: %.240s", q->path[i], inner.text);
  }
  report->surface[i] = (check_surface){shell->closed, shell->consistent, shell->facet};
  if (q->ply_path == NULL) {
    sepax_soup_free(mesh);
  }
  return true;
}

static bool build_solids(const check_question *q, check_report *report, solids *s,
                         sepax_error *error) {
  cli_progress progress = cli_progress_begin("trees", 2);
  bool ok = true;
  for (int i = 0; i < 2 && ok; i++) {
    cli_progress_show(&progress, (uint64_t)i);
    ok = build_solid(q, i, report, s, error);
  }
  cli_progress_end(&progress);
  return ok;
}

static bool decide_one(work *all, sepax_error *error) {
  return decide(all->q, &all->solids, NULL, all->answer, error);
}

/* If the matrices have too few decimals, then the error names the option that accepts them. */
static bool read_poses(const check_question *q, sepax_poses *poses, double *moved,
                       sepax_error *error) {
  if (q->nearest) {
    return sepax_poses_read_nearest(poses, moved, q->poses_path, error);
  }
  if (sepax_poses_read(poses, q->poses_path, error)) {
    return true;
  }
  sepax_error other = {0};
  sepax_poses rounded;
  double way;
  if (sepax_poses_read_nearest(&rounded, &way, q->poses_path, &other)) {
    sepax_poses_free(&rounded);
    size_t length = strlen(error->text);
    snprintf(error->text + length, sizeof error->text - length,
             ", or give --nearest-rotation: entries then change by at most %.2g", way);
  }
  return false;
}

bool check_bodies(const check_question *q, check_report *report, sepax_error *error) {
  work all = {.q = q};
  sepax_soup *mesh = report->mesh;
  if ((q->poses_path != NULL && !read_poses(q, &all.poses, &report->moved, error)) ||
      !cli_mesh_read(&mesh[0], &report->file[0], q->path[0], &q->meshes, error) ||
      !cli_mesh_read(&mesh[1], &report->file[1], q->path[1], &q->meshes, error)) {
    sepax_poses_free(&all.poses);
    return false;
  }
  size_t answers = q->poses_path != NULL ? all.poses.count : 1;
  report->answer = calloc(answers, sizeof *report->answer);
  report->answers = report->answer != NULL ? answers : 0;
  all.answer = report->answer;
  atomic_init(&all.next, 0);
  atomic_init(&all.stop, false);
  cli_progress progress = cli_progress_begin("poses", answers);
  bool ok = (all.answer != NULL || sepax_fail(error, SEPAX_ERROR_MEMORY,
                                              "no memory for verdicts in %zu poses", answers)) &&
            build_solids(q, report, &all.solids, error) &&
            (q->poses_path != NULL ? decide_all(&all, &progress, error) : decide_one(&all, error));
  report->seconds = cli_progress_end(&progress);
  sepax_poses_free(&all.poses);
  for (int i = 0; i < 2; i++) {
    sepax_shell_free(&all.solids.shell[i]);
    sepax_body_free(all.solids.body[i]);
  }
  return ok;
}
