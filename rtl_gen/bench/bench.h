/* SPDX-License-Identifier: MIT */
/* bench.h - a self-checking test bench of a design, which needs neither this program nor a certain
 * simulator: pairs and the verdicts of the golden model stand in its text. */
#ifndef SEPAX_BENCH_H
#define SEPAX_BENCH_H

#include "emit/template.h"

enum { BENCH_VECTORS = 256, BENCH_VECTORS_MOST = 100000 };

/* Append the test bench sepax_tb of the emitter's design, whose latency is known, with so many
 * pairs, 1 ... BENCH_VECTORS_MOST. It tests sepax_top, or sepax_stream if the design has it; of an
 * engine the core in it. The pairs are seeded and the same for the same design: hard pairs of all
 * families; within and beyond the extents; pairs near a clearance; pairs of unit size.
 * Cost: some microseconds a pair, but up to some milliseconds of one of unit size. An error is the
 * emitter's. */
void bench_write(emitter *e, int vectors, emit_text *out);

/* Append the test bench sepax_engine_tb of an object engine: two small objects, and the results of
 * two runs. */
void bench_write_object(emitter *e, emit_text *out);

#endif
