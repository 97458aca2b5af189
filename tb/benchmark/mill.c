/* SPDX-License-Identifier: MIT */
/* mill.c - loads the 5-axis mill of examples/five-axis, and prints times of queries on it. */
#include "benchmark/mill.h"

#include <stdio.h>
#include <stdlib.h>
#include <time.h>

_Noreturn void mill_stop(const char *what, const sepax_error *error) {
  fprintf(stderr, "machine: %s: %s\n", what, error != NULL ? error->text : "no memory");
  exit(2);
}

void mill_load(mill_scene *s, const char *folder) {
  static const char *const names[AXES] = {"x", "y", "z", "b", "a"};
  const format_motion_rules rules = {0};
  sepax_error error = {0};
  char name[3][4096];
  *s = (mill_scene){0};
  snprintf(name[0], sizeof name[0], "%s/mill.urdf", folder);
  snprintf(name[1], sizeof name[1], "%s/mill.srdf", folder);
  snprintf(name[2], sizeof name[2], "%s/path.csv", folder);
  if (!sepax_robot_machine_read(&s->mill, name[0], name[1], NULL, &error) ||
      !format_motion_read(&s->path, &s->mill.robot.mechanism, &rules, name[2], &error)) {
    mill_stop(folder, &error);
  }
  for (size_t k = 0; k < AXES; k++) {
    s->axis[k] = sepax_robot_joint(&s->mill.robot, names[k]);
  }
}

double mill_uniform(uint64_t *state) {
  *state = *state * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
  return (double)(*state >> 11) * 0x1p-53;
}

double mill_seconds(void) {
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

static int by_size(const void *p, const void *q) {
  float a = *(const float *)p;
  float b = *(const float *)q;
  return (a > b) - (a < b);
}

void mill_print_times(const char *name, float *time, size_t count) {
  static const double parts[] = {0.99, 0.999, 0.9999};
  double sum = 0;
  for (size_t n = 0; n < count; n++) {
    sum += (double)time[n];
  }
  qsort(time, count, sizeof *time, by_size);
  printf("  %-16s %8.2f", name, sum / (double)count * 1e6);
  for (int k = 0; k < 3; k++) {
    printf(" %8.2f", (double)time[(size_t)(parts[k] * (double)(count - 1))] * 1e6);
  }
  printf(" %8.2f\n", (double)time[count - 1] * 1e6);
}
