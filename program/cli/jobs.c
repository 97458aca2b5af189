/* SPDX-License-Identifier: MIT */
/* jobs.c - sepax tree on a list of jobs: describes the list, and walks its trees by the golden
 * model of the tree engine. */
#include "cli.h"
#include "cli/jobs.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Sums over all poses of a pair. */
typedef struct {
  uint32_t poses, collide, first; /* first: the first line with a collision */
  uint32_t warn, beyond; /* poses with a warning but no collision; poses with pairs out of range */
  uint64_t worst, cycles;
} answers;

static void take(answers *a, const sepax_job_list *list, const sepax_tree_result *r) {
  if ((r->status & SEPAX_TREE_HIT) != 0) {
    a->first = a->collide++ == 0 ? sepax_job_list_line(list, r->pose) : a->first;
  } else {
    a->warn += r->run.warnings > 0;
  }
  a->beyond += r->run.out_of_range > 0;
  a->poses++;
  a->cycles += r->run.cycles;
  a->worst = r->run.cycles > a->worst ? r->run.cycles : a->worst;
}

static bool walk(answers *each, const sepax_job_list *list, sepax_error *error) {
  const sepax_tree_memory memory = {list->byte, 0, list->bytes};
  sepax_config config = sepax_config_default();
  sepax_design design;
  sepax_job_list_config(list, &config);
  if (!sepax_design_init(&design, &config, error)) {
    return false;
  }
  sepax_tree_batch batch = {
      .design = &design, .memory = &memory, .list = list->list, .jobs = list->jobs};
  cli_progress progress = cli_progress_begin("poses", (uint64_t)list->jobs * list->poses);
  sepax_tree_result r;
  bool more = true;
  bool ok = true;
  for (uint64_t done = 0; more && ok; done++) {
    cli_progress_show(&progress, done);
    ok = sepax_tree_next(&batch, &r, &more, error);
    if (ok && more) {
      take(&each[r.job], list, &r);
    }
  }
  cli_progress_end(&progress);
  return ok;
}

/* "spindle, table" */
static int name_pair(char *text, size_t size, const sepax_job_list *list, uint32_t job) {
  return snprintf(text, size, "%.40s, %.40s",
                  sepax_job_list_name(list, sepax_job_list_body(list, job, 0)),
                  sepax_job_list_name(list, sepax_job_list_body(list, job, 1)));
}

static void print_answers(const answers *each, const sepax_job_list *list) {
  char name[96];
  char first[16];
  int width = 4;
  for (uint32_t n = 0; n < list->jobs; n++) {
    int length = name_pair(name, sizeof name, list, n);
    width = length > width ? length : width;
  }
  printf("%-*s %9s %9s %9s %11s %11s %11s\n", width, "pair", "poses", "collide", "warn",
         "first line", "worst", "mean cycles");
  for (uint32_t n = 0; n < list->jobs; n++) {
    const answers *a = &each[n];
    name_pair(name, sizeof name, list, n);
    snprintf(first, sizeof first, "%u", a->first);
    printf("%-*s %9u %9u %9u %11s %11llu %11.0f\n", width, name, a->poses, a->collide, a->warn,
           a->collide > 0 ? first : "-", (unsigned long long)a->worst,
           (double)a->cycles / a->poses);
    if (a->beyond > 0) {
      printf("%-*s %9u of these poses have pairs out of range: undecided\n", width, "", a->beyond);
    }
  }
}

static void print_list(const char *path, const sepax_job_list *list) {
  sepax_config config = sepax_config_default();
  char text[SEPAX_CONFIG_TEXT];
  printf("%s: %u jobs of %u poses, %u trees, %zu bytes; W = %d, 1 LSB = %.9g mm, clearance %d LSB, "
         "warning %d LSB\n",
         path, list->jobs, list->poses, list->bodies, list->bytes, list->word,
         1e3 * sepax_job_list_resolution(list), list->clearance, list->warning);
  for (uint32_t n = 0; n < list->bodies; n++) {
    printf("body   %s, %u triangles\n", sepax_job_list_name(list, n),
           sepax_job_list_triangles(list, n));
  }
  sepax_job_list_config(list, &config);
  printf("sepax gen %s -o DIR\n", sepax_config_text(&config, text, sizeof text));
}

bool cli_tell_jobs(const char *path, bool walked, sepax_error *error) {
  sepax_job_list list;
  if (!sepax_job_list_read(&list, path, error)) {
    return false;
  }
  answers *each = calloc(list.jobs, sizeof *each);
  bool ok = each != NULL && (!walked || walk(each, &list, error));
  if (ok) {
    print_list(path, &list);
  }
  if (ok && walked) {
    print_answers(each, &list);
  }
  free(each);
  sepax_job_list_free(&list);
  return ok;
}
