/* SPDX-License-Identifier: MIT */
/* vector.h - vectors of three doubles (private). Rounded. */
#ifndef SEPAX_VECTOR_H
#define SEPAX_VECTOR_H

#include <math.h>

static inline double vector_dot(const double p[3], const double q[3]) {
  return p[0] * q[0] + p[1] * q[1] + p[2] * q[2];
}

static inline double vector_length(const double p[3]) { return sqrt(vector_dot(p, p)); }

/* r = p x q; r is neither p nor q. */
static inline void vector_cross(const double p[3], const double q[3], double r[3]) {
  r[0] = p[1] * q[2] - p[2] * q[1];
  r[1] = p[2] * q[0] - p[0] * q[2];
  r[2] = p[0] * q[1] - p[1] * q[0];
}

#endif
