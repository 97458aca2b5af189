/* SPDX-License-Identifier: MIT */
/* list.c - a list of jobs, as sepax path --jobs writes it, through the engine: each answer is
 * compared with the golden model; a table by the names of the bodies. */
#include "bench.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A pair in all its poses. */
typedef struct {
  uint64_t poses, collide, warn, cycles, worst, mismatches;
  uint32_t first; /* the line of the first that collides */
} answers;

typedef struct {
  const sepax_job_list *list;
  answers *each;
} tally;

static void take(void *context, const sepax_outcome *o, bool right) {
  const tally *t = context;
  if (o->job >= t->list->jobs || o->pose >= t->list->poses) {
    return; /* which compare has told */
  }
  answers *a = &t->each[o->job];
  if ((o->status & SEPAX_TREE_HIT) != 0) {
    a->first = a->collide++ == 0 ? sepax_job_list_line(t->list, o->pose) : a->first;
  } else {
    a->warn += o->warnings > 0;
  }
  a->poses++;
  a->cycles += o->cycles;
  a->worst = o->cycles > a->worst ? o->cycles : a->worst;
  a->mismatches += !right;
}

static void name_pair(char text[96], const sepax_job_list *list, uint32_t job) {
  snprintf(text, 96, "%.40s, %.40s", sepax_job_list_name(list, sepax_job_list_body(list, job, 0)),
           sepax_job_list_name(list, sepax_job_list_body(list, job, 1)));
}

static void print_table(const tally *t) {
  char name[96];
  char first[16];
  int width = 4;
  for (uint32_t n = 0; n < t->list->jobs; n++) {
    name_pair(name, t->list, n);
    width = (int)strlen(name) > width ? (int)strlen(name) : width;
  }
  printf("%-*s %9s %9s %9s %11s %11s %11s %10s\n", width, "pair", "poses", "collide", "warn",
         "first line", "worst", "mean cycles", "mismatches");
  for (uint32_t n = 0; n < t->list->jobs; n++) {
    const answers *a = &t->each[n];
    name_pair(name, t->list, n);
    snprintf(first, sizeof first, "%u", a->first);
    printf("%-*s %9llu %9llu %9llu %11s %11llu %11.0f %10llu\n", width, name,
           (unsigned long long)a->poses, (unsigned long long)a->collide,
           (unsigned long long)a->warn, a->collide > 0 ? first : "-", (unsigned long long)a->worst,
           (double)a->cycles / (a->poses > 0 ? (double)a->poses : 1),
           (unsigned long long)a->mismatches);
  }
}

void bench_list(const char *path, const memory_options *options) {
  sepax_error error = {0};
  sepax_job_list list;
  sepax_tree_device_list placed;
  stop_on(!sepax_job_list_read(&list, path, &error), error.text);
  bench_clear();
  size_t at = bench_space(list.bytes, 4096);
  memcpy(bench_at(at), list.byte, list.bytes);
  stop_on(!sepax_tree_device_place(&device, &placed, bench_at(at), bench_address(at)),
          "the list is for a design of another word or other clearances");
  bench_attach(*options);
  tally t = {&list, calloc(list.jobs, sizeof *t.each)};
  stop_on(t.each == NULL, "out of memory");
  bench_batch batch = {.list = (size_t)(placed.list - bench_base),
                       .jobs = placed.jobs,
                       .stop_at = -1,
                       .told = take,
                       .context = &t};
  uint64_t begin = bus_cycles();
  bench_run(&batch);
  double poses = list.poses;
  double cycles = (double)(bus_cycles() - begin);
  print_table(&t);
  printf("%u lines of %u pairs: %.0f cycles a line, %.0f of them between runs\n", list.poses,
         list.jobs, cycles / poses, (cycles - (double)batch.cycles) / poses);
  uint64_t wanted = (uint64_t)list.poses * list.jobs;
  uint64_t failed = batch.mismatches + (wanted - batch.poses);
  expect("poses", batch.poses, wanted);
  expect("out of range", batch.out_of_range, 0);
  printf("%llu passed, %llu failed\n", (unsigned long long)(wanted - failed),
         (unsigned long long)failed);
  free(t.each);
  sepax_job_list_free(&list);
}
