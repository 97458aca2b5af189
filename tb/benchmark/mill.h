/* SPDX-License-Identifier: MIT */
/* mill.h - the 5-axis mill of examples/five-axis, and times of queries on it. */
#ifndef BENCHMARK_MILL_H
#define BENCHMARK_MILL_H

#include "cli/meshes.h"
#include "formats/formats.h"

enum { AXES = 5, HEIGHTS_MOST = 64 };

typedef struct {
  sepax_robot_machine mill;
  format_motion path;
  size_t axis[AXES];           /* the joints x, y, z, b, a */
  double height[HEIGHTS_MOST]; /* of z, where two bodies are as far apart as the clearance */
  size_t heights;
} mill_scene;

void mill_load(mill_scene *s, const char *folder);
_Noreturn void mill_stop(const char *what, const sepax_error *error);
double mill_uniform(uint64_t *state); /* 0 ... 1 */
double mill_seconds(void);            /* CPU time of the thread */

/* Print mean, 99 %, 99.9 %, 99.99 % and worst of times in seconds, and sort them. */
void mill_print_times(const char *name, float *time, size_t count);

/* Time queries of all pairs of bodies in many poses, and print them. */
void mill_report_pairs(const mill_scene *s, size_t poses, int passes);

#endif
