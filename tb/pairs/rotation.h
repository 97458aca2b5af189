/* SPDX-License-Identifier: MIT */
/* rotation.h - random rotations. */
#ifndef PAIRS_ROTATION_H
#define PAIRS_ROTATION_H

#include "oracle/real_pairs.h"

/* The rotation of a random quaternion, rounded. */
static inline void random_rotation(double r[3][3], sepax_random *random) {
  double q[4];
  double square = 0;
  for (int i = 0; i < 4; i++) {
    q[i] = uniform(random, -1, 1);
    square += q[i] * q[i];
  }
  for (int i = 0; i < 3; i++) {
    int j = (i + 1) % 3;
    int k = (i + 2) % 3;
    r[i][i] = 1 - 2 * (q[j] * q[j] + q[k] * q[k]) / square;
    r[i][j] = 2 * (q[i] * q[j] - q[3] * q[k]) / square;
    r[i][k] = 2 * (q[i] * q[k] + q[3] * q[j]) / square;
  }
}

#endif
