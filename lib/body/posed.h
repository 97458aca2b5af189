/* SPDX-License-Identifier: MIT */
/* posed.h - posed triangles in integers of any size (private). */
#ifndef SEPAX_POSED_H
#define SEPAX_POSED_H

#include "body/big.h"
#include "sepax.h"

/* c[axis][vertex], relative to A_0. Vertices 0 ... 2 are A's, 3 ... 5 are B's. */
typedef struct {
  big c[3][6];
} posed_points;

/* Find the exact posed vertices as integers. Returns the exponent e: the exact coordinate is
 * c[axis][v] * 2^e. */
int sepax__find_posed_points(posed_points *p, const double a[3][3], const sepax_pose *pose_a,
                             const double b[3][3], const sepax_pose *pose_b);

#endif
