/* judge.h - verdicts on pairs of posed triangles (private). */
#ifndef SEPAX_JUDGE_H
#define SEPAX_JUDGE_H

#include "placement.h"

/* Triangle n of body k begins at first[k] + n * stride[k]: three vertices. */
typedef struct {
  const double *first[2];
  size_t stride[2];
  bool strict; /* only pairs that collide strictly */
  bool fast;   /* posed_pairs_fast */
  placement at;
} posed_pairs;

/* A path of this processor that is faster than the portable one, if the caller wants it. */
bool posed_pairs_fast(sepax_path path);

/* Bit n: pair[n], of a triangle of A and one of B, collides. Up to 64 pairs. */
uint64_t judge_posed_pairs(const posed_pairs *p, const uint32_t (*pair)[2], int count);

#endif
