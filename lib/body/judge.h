/* SPDX-License-Identifier: MIT */
/* judge.h - verdicts on pairs of posed triangles (private). */
#ifndef SEPAX_JUDGE_H
#define SEPAX_JUDGE_H

#include "placement.h"

/* Pairs to judge. Triangle n of body k begins at first[k] + n * stride[k] and has three
 * vertices. */
typedef struct {
  const double *first[2];
  size_t stride[2];
  bool strict; /* find only pairs that collide strictly */
  bool rough;  /* leave pairs that only exact arithmetic decides */
  int lanes;   /* from sepax__posed_pairs_lanes */
  placement at;
} posed_pairs;

/* The number of pairs to judge at once: 8 with AVX-512, 4 with AVX2, otherwise 2, as far as the
 * processor has these instructions. */
int sepax__posed_pairs_lanes(sepax_simd simd);

/* Judge up to 64 pairs. Bit n of the result: pair[n], a triangle of A and one of B, collides. Bit n
 * of *exact: only exact arithmetic decides pair[n]; if such pairs are left, they are not in the
 * result. */
uint64_t sepax__judge_posed_pairs(const posed_pairs *p, const uint32_t (*pair)[2], int count,
                                  uint64_t *exact);

#endif
