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

/* A random pair of a kind, about `distance` LSB apart, but for kind "family": as far or nearer.
 * Coordinates rounded to LSB fit 12 bits and more. */
real_pair real_pair_make(int kind, double distance, sepax_random *random);

#endif
