/* SPDX-License-Identifier: MIT */
/* real_pairs.h - pairs of real triangles near one another, and what rounding makes of them.
 *
 * A real coordinate is a multiple of 2^-fraction LSB; the model gets it rounded to nearest. */
#ifndef REAL_PAIRS_H
#define REAL_PAIRS_H

#include "sepax_vectors.h"

enum { REAL_KINDS = 12 };

typedef struct {
  sepax_tri a, b; /* real, in 2^-fraction LSB */
  sepax_tri rounded_a, rounded_b;
  int fraction, kind; /* fraction: 10 ... 20 bits */
} real_pair;

/* What touches what where the triangles come nearest, or what the kind is otherwise. */
const char *real_kind_name(int kind);

/* low ... high, uniformly. */
double uniform(sepax_random *random, double low, double high);

/* A random pair of a kind at about `distance` LSB, but for kind "family": at most that.
 * Coordinates rounded to LSB fit 12 bits and more. */
real_pair real_pair_make(int kind, double distance, sepax_random *random);

#endif
