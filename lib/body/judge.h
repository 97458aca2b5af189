/* judge.h - verdicts on pairs of posed triangles (private). */
#ifndef SEPAX_JUDGE_H
#define SEPAX_JUDGE_H

#include "placement.h"

/* Triangle n of body k begins at first[k] + n * stride[k]: three vertices. */
typedef struct {
  const double *first[2];
  size_t stride[2];
  bool strict; /* only pairs that collide strictly */
  int lanes;   /* sepax__posed_pairs_lanes */
  placement at;
} posed_pairs;

/* Pairs at once: 2, 4 with AVX2, 8 with AVX-512, as far as this processor has them. */
int sepax__posed_pairs_lanes(sepax_simd simd);

/* Bit n: pair[n], of a triangle of A and one of B, collides. Up to 64 pairs. */
uint64_t sepax__judge_posed_pairs(const posed_pairs *p, const uint32_t (*pair)[2], int count);

#endif
