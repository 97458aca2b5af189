/* SPDX-License-Identifier: MIT */
/* bench.h - what the parts of the engine's test bench share. */
#ifndef SEPAX_ENGINE_BENCH_H
#define SEPAX_ENGINE_BENCH_H

#include "bus.h"
#include "crowd.h"
#include "sepax_design.h"
#include "sepax_driver.h"
#include "sepax_params.h"
#include "sepax_registers.h"

extern sepax_device device;

typedef struct {
  const sepax_tri *a, *b;
  size_t count_a, count_b;
  int32_t move[3];
  bool first;
} task;

/* Load and run a task and compare; `paced`: nothing held the results up, so that the cycles
 * are compared, too. */
sepax_counts run_task(const task *t, bool paced);
int64_t range(int64_t lo, int64_t hi);

/* A run over triangles that all hold the middle of the space, in a[count_a], b[count_b];
 * `paced`: its cycles are compared, too. */
void overlap(sepax_tri *a, sepax_tri *b, size_t count_a, size_t count_b, bool paced);

/* Objects of `size` and others, in a[], b[], that show one thing each. */
void objects(sepax_tri *a, sepax_tri *b, size_t size, bool paced);

/* Cycles of a run on an ASIC with one core, all results taken at once;
 * AABBs nearer than the margin overlap. */
uint64_t cycles_of_run(const sepax_tri *a, size_t count_a, const sepax_tri *b, size_t count_b,
                       const int32_t move[3], int64_t margin);

/* After a reset: what cannot be read, written or loaded. Leaves an A of one triangle and a B that
 * fills its memory, of which all pairs collide. */
void refusals(void);

/* With these objects: interrupts, quiet runs, STOP, and a run of which nobody takes results for
 * `blocked` cycles; `paced`: nothing else holds a transfer up, and times are compared. Then a run
 * in a[], b[]. */
void controls(sepax_tri *a, sepax_tri *b, uint64_t blocked, bool paced);

#endif
