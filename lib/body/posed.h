/* posed.h - posed triangles in integers of any size (private). */
#ifndef SEPAX_POSED_H
#define SEPAX_POSED_H

#include "body/big.h"
#include "sepax.h"

/* c[axis][vertex]: vertices 0 ... 2 are A's, 3 ... 5 B's, counted from A_0. */
typedef struct {
  big c[3][6];
} posed_points;

/* The vertices times a power of two; its exponent e: c[axis][v] * 2^e is the exact coordinate. */
int sepax__find_posed_points(posed_points *p, const double a[3][3], const sepax_pose *pose_a,
                             const double b[3][3], const sepax_pose *pose_b);

#endif
