/* SPDX-License-Identifier: MIT */
/* machine.c - how long a query of a whole machine takes: the 5-axis mill, period by period.
 *   machine FOLDER [PERIODS [PASSES]]   FOLDER has the scene of examples/five-axis. Each of several
 *   questions is asked in so many periods of 1 ms (100,000), PASSES times (2). The time of a period
 *   is the least of its passes, in CPU time of the thread, so that interrupts of the computer do
 *   not count. Exit status 1: a query allocated memory.
 *
 * After these, queries of single pairs of bodies (mill_pairs.c).
 *
 * The motions, in turn: the path, interpolated; jogs in z with all faces parallel, through all
 * heights, and back and forth through the heights at which two bodies are as far apart as the
 * clearance; jogs in x and y at these heights; and jogs of one axis from a random pose. */
#define _GNU_SOURCE // NOLINT(bugprone-reserved-identifier)
#include "benchmark/mill.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/resource.h>

static const double clearance = 0.002; /* metres */

/* -------------------------------------------------------------------------- mill_scene */

static double gap_at(const mill_scene *s, size_t pair, double z) {
  sepax_error error = {0};
  double value[64] = {0};
  sepax_chain chain;
  sepax_pose pose[2];
  sepax_distance_result found;
  const sepax_machine_body *b[2] = {&s->mill.body[s->mill.pair[pair][0]],
                                    &s->mill.body[s->mill.pair[pair][1]]};
  const sepax_distance_request request = {.size = sizeof request, .relative = 1e-12};
  value[s->axis[2]] = z;
  if (!sepax_chain_find(&chain, &s->mill.robot.mechanism, b[0]->link, b[1]->link, &error)) {
    mill_stop("a chain", &error);
  }
  sepax_chain_poses(&chain, &s->mill.robot.mechanism, value, pose);
  if (!sepax_bodies_distance(b[0]->body, &pose[0], b[1]->body, &pose[1], &request, &found,
                             &error)) {
    mill_stop("a distance", &error);
  }
  sepax_chain_free(&chain);
  return found.min_distance;
}

/* The height at which a pair is as far apart as the clearance, if there is one: by halving; and the
 * same in whole micrometres. */
static void add_height(mill_scene *s, size_t pair) {
  const sepax_joint *joint = &s->mill.robot.mechanism.joint[s->axis[2]];
  double low = joint->lower;
  double high = joint->upper;
  if (gap_at(s, pair, low) > clearance || gap_at(s, pair, high) < clearance) {
    return;
  }
  for (int n = 0; n < 60; n++) {
    double middle = low / 2 + high / 2;
    *(gap_at(s, pair, middle) > clearance ? &high : &low) = middle;
  }
  if (s->heights + 2 <= HEIGHTS_MOST) {
    s->height[s->heights++] = low;
    s->height[s->heights++] = round(low * 1e6) * 1e-6;
  }
}

/* ------------------------------------------------------------------------ motions */

static void on_path(const mill_scene *s, size_t period, double *value) {
  const format_motion *p = &s->path;
  double length = p->time[p->lines - 1] - p->time[0];
  double time = p->time[0] + fmod((double)period * 1e-3, length);
  size_t low = 0;
  size_t high = p->lines - 1;
  while (high - low > 1) {
    size_t middle = low + (high - low) / 2;
    *(p->time[middle] <= time ? &low : &high) = middle;
  }
  double part = (time - p->time[low]) / (p->time[high] - p->time[low]);
  for (size_t n = 0; n < p->joints; n++) {
    double from = p->value[low * p->joints + n];
    value[n] = from + (p->value[high * p->joints + n] - from) * part;
  }
}

/* A jog of 500 periods, `at` of them gone. */
static void jog(const mill_scene *s, size_t number, size_t at, double *value) {
  const sepax_mechanism *m = &s->mill.robot.mechanism;
  uint64_t state = number;
  double way = ((double)at - 250) * 5e-5; /* 50 mm/s */
  memset(value, 0, m->joints * sizeof *value);
  for (int n = 0; n < 8; n++) {
    mill_uniform(&state);
  }
  size_t height = (size_t)(mill_uniform(&state) * (double)s->heights);
  switch (number % 4) {
  case 0: { /* z, all heights in 24 jogs */
    const sepax_joint *z = &m->joint[s->axis[2]];
    size_t turn = number / 4;
    value[s->axis[2]] =
        z->lower + fmod((double)turn * 0.025 + (double)at * 5e-5, z->upper - z->lower);
    break;
  }
  case 1: /* z, through a height at which faces are as far apart as the clearance */
    value[s->axis[2]] = s->height[height] + way;
    break;
  case 2: /* x or y at exactly that height */
    value[s->axis[2]] = s->height[height];
    value[s->axis[number / 4 % 2]] = way * 10;
    break;
  default: /* one axis from a random pose near the work */
    for (size_t k = 0; k < AXES; k++) {
      static const double low[AXES] = {-0.15, -0.15, 0.2, -0.5, -0.5};
      static const double high[AXES] = {0.15, 0.15, 0.4, 0.5, 0.5};
      value[s->axis[k]] = low[k] + (high[k] - low[k]) * mill_uniform(&state);
    }
    value[s->axis[number / 4 % AXES]] += way;
  }
}

/* Half of the periods are of the path. */
static void values_of(const mill_scene *s, size_t period, double *value) {
  if (period % 2 == 0) {
    on_path(s, period / 2, value);
  } else {
    jog(s, period / 2 / 500, period / 2 % 500, value);
  }
}

/* -------------------------------------------------------------------- measurement */

static long page_faults(void) {
  struct rusage usage;
  getrusage(RUSAGE_THREAD, &usage);
  return usage.ru_minflt + usage.ru_majflt;
}

/* An allocator that counts. */
static size_t allocations;
static void *counted_allocate(void *context, size_t bytes) {
  (void)context;
  allocations++;
  return malloc(bytes);
}
static void *counted_resize(void *context, void *memory, size_t bytes) {
  (void)context;
  allocations++;
  return realloc(memory, bytes);
}
static void counted_release(void *context, void *memory) {
  (void)context;
  free(memory);
}

typedef struct {
  size_t verdicts[3];
  uint64_t most_work;
  size_t allocations;
  long faults;
} tally;

/* Periods of the path and of jogs follow each other in a row, not in turn. */
static size_t in_row(size_t n, size_t periods) {
  size_t half = (periods + 1) / 2;
  return n < half ? 2 * n : 2 * (n - half) + 1;
}

static void run(const mill_scene *s, const sepax_machine_query *query, size_t periods, float *time,
                bool first, tally *t) {
  sepax_error error = {0};
  double value[64] = {0};
  sepax_watch *watch;
  sepax_machine_answer answer;
  if (!sepax_watch_new(&watch, s->mill.machine, &error)) {
    mill_stop("a watch", &error);
  }
  for (size_t n = 0; n < 100; n++) { /* the program's own pages and symbols */
    values_of(s, in_row(n * periods / 100, periods), value);
    if (!sepax_watch_ask(watch, value, query, &answer, &error)) {
      mill_stop("a query", &error);
    }
  }
  *t = (tally){.allocations = allocations, .faults = page_faults()};
  for (size_t n = 0; n < periods; n++) {
    values_of(s, in_row(n, periods), value);
    double begin = mill_seconds();
    bool ok = sepax_watch_ask(watch, value, query, &answer, &error);
    float taken = (float)(mill_seconds() - begin);
    if (!ok) {
      mill_stop("a query", &error);
    }
    time[n] = first || taken < time[n] ? taken : time[n];
    t->verdicts[answer.verdict]++;
    t->most_work = answer.work > t->most_work ? answer.work : t->most_work;
  }
  t->allocations = allocations - t->allocations;
  t->faults = page_faults() - t->faults;
  sepax_watch_free(watch);
}

/* False if a query allocated. */
static bool report(const mill_scene *s, const char *name, const sepax_machine_query *query,
                   size_t periods, int passes, float *time) {
  tally t = {0};
  for (int pass = 0; pass < passes; pass++) {
    run(s, query, periods, time, pass == 0, &t);
  }
  size_t half = (periods + 1) / 2;
  printf("%s: %zu apart, %zu near, %zu undecided; %zu allocations, %ld page faults, %llu units at "
         "most\n",
         name, t.verdicts[SEPAX_APART], t.verdicts[SEPAX_NEAR], t.verdicts[SEPAX_UNDECIDED],
         t.allocations, t.faults, (unsigned long long)t.most_work);
  printf("  us of CPU            mean     99 %%   99.9 %%  99.99 %%    worst\n");
  mill_print_times("path", time, half);
  mill_print_times("jogs", time + half, periods - half);
  mill_print_times("all", time, periods);
  return t.allocations == 0;
}

int main(int argc, char **argv) {
  static const sepax_allocator counted = {counted_allocate, counted_resize, counted_release, NULL};
  mill_scene s;
  if (argc < 2 || argc > 4) {
    fprintf(stderr, "machine: give FOLDER [PERIODS [PASSES]]\n");
    return 2;
  }
  size_t periods = argc > 2 ? (size_t)atoll(argv[2]) : 100000;
  int passes = argc > 3 ? atoi(argv[3]) : 2;
  if (periods < 1000) {
    fputs("machine: give 1000 periods or more\n", stderr);
    return 2;
  }
  sepax_set_allocator(&counted);
  mill_load(&s, argv[1]);
  for (size_t n = 0; n < s.mill.pairs.count; n++) {
    add_height(&s, n);
  }
  float *time = calloc(periods + 1, sizeof *time);
  if (time == NULL) {
    mill_stop("periods", NULL);
    return 2;
  }
  memset(time, 1, periods * sizeof *time);
  mlockall(MCL_CURRENT | MCL_FUTURE); /* without the right to, the pages are written by now */
  double travel[64] = {0};
  for (size_t k = 0; k < AXES; k++) { /* what the axes move in 1 ms at their speed */
    travel[s.axis[k]] = k < 3 ? 0.5e-3 : 1e-3;
  }
  sepax_machine_query q = {.size = sizeof q, .clearance = clearance};
  printf("%zu bodies, %zu pairs, %zu heights, clearance %g mm\n", s.mill.bodies, s.mill.pairs.count,
         s.heights, clearance * 1e3);
  static const uint64_t work[] = {0, 500, 1000, 2000};
  char name[80];
  bool ok = true;
  for (size_t k = 0; k < sizeof work / sizeof work[0]; k++) {
    q.work = work[k];
    snprintf(name, sizeof name, "verdict, %llu units", (unsigned long long)work[k]);
    ok = report(&s, work[k] == 0 ? "verdict" : name, &q, periods, passes, time) && ok;
  }
  q.work = 1000;
  q.travel = travel;
  ok = report(&s, "travel of 1 ms, 1000 units", &q, periods, passes, time) && ok;
  q.measure = true;
  q.relative = 1e-6;
  ok = report(&s, "travel, measured to 1e-6, 1000 units", &q, periods, passes, time) && ok;
  mill_report_pairs(&s, periods / 20, passes);
  return ok ? 0 : 1;
}
