/* SPDX-License-Identifier: MIT */
/* draw.h - the pairs of test benches. */
#ifndef SEPAX_BENCH_DRAW_H
#define SEPAX_BENCH_DRAW_H

#include "sepax_vectors.h"

/* Pair n of the bench of a design, from 0 on: families of hard pairs in turn, some of them in a
 * plane, at a margin of their AABBs, near a clearance, beyond an extent. */
sepax_pair bench_draw(const sepax_design *d, int n, sepax_random *random);

#endif
