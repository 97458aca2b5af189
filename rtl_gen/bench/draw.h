/* SPDX-License-Identifier: MIT */
/* draw.h - the pairs of test benches. */
#ifndef SEPAX_BENCH_DRAW_H
#define SEPAX_BENCH_DRAW_H

#include "sepax_vectors.h"

/* Pair n of the bench of a design, from 0 on: families of hard pairs in turn, some of them in a
 * plane, at a margin of their AABBs, near a clearance, beyond an extent, of unit size. */
sepax_pair bench_draw(const sepax_design *d, int n, sepax_random *random);

/* Pair n, from 0 on, of unit size, of an exact design without a clearance: separated, but a
 * collision if one orient3d, which is 1 or -1, were 0. The 15 orient3d take turns, each as 1 and as
 * -1. Every other two pairs have coordinates of -1 ... 1, the others are anywhere in the word.
 * False, and *pair as before, if none is found: if each such pair exceeds an extent of 1. Cost:
 * up to some milliseconds, and 10 ms if none is found. */
bool bench_draw_unit(const sepax_design *d, int n, sepax_pair *pair, sepax_random *random);

#endif
