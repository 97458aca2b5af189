/* bench.h - what the parts of the engine's test bench share. */
#ifndef SEPAX_ENGINE_BENCH_H
#define SEPAX_ENGINE_BENCH_H

#include "bus.h"
#include "sepax_design.h"
#include "sepax_driver.h"
#include "sepax_params.h"
#include "sepax_registers.h"

extern sepax_device device;

/* Count and print what is not as it must be. */
void expect(const char *what, unsigned long long got, unsigned long long wanted);

/* A run over triangles that all hold the middle of the space, in a[count_a], b[count_b];
 * `paced`: its cycles are compared, too. */
void overlap(sepax_tri *a, sepax_tri *b, size_t count_a, size_t count_b, bool paced);

/* After a reset: what cannot be read, written or loaded. Leaves an A of one triangle and a B that
 * fills its memory, of which all pairs collide. */
void refusals(void);

/* With these objects: interrupts, quiet runs, STOP, and results that nobody takes. Then a run
 * in a[], b[]. */
void controls(sepax_tri *a, sepax_tri *b);

#endif
