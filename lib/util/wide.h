/* SPDX-License-Identifier: MIT */
/* wide.h - vectors of three 128-bit integers (private). No operation checks for overflow: a caller
 * states why its values fit. */
#ifndef SEPAX_WIDE_H
#define SEPAX_WIDE_H

#include "sepax_grid.h"

typedef __int128 wide;

typedef struct {
  wide c[3];
} wide_vec;

static inline wide_vec wide_from(sepax_vec v) { return (wide_vec){{v.x, v.y, v.z}}; }

static inline wide_vec wide_sub(wide_vec p, wide_vec q) {
  return (wide_vec){{p.c[0] - q.c[0], p.c[1] - q.c[1], p.c[2] - q.c[2]}};
}

static inline wide wide_dot(wide_vec p, wide_vec q) {
  return p.c[0] * q.c[0] + p.c[1] * q.c[1] + p.c[2] * q.c[2];
}

static inline wide_vec wide_cross(wide_vec p, wide_vec q) {
  return (wide_vec){{p.c[1] * q.c[2] - p.c[2] * q.c[1], p.c[2] * q.c[0] - p.c[0] * q.c[2],
                     p.c[0] * q.c[1] - p.c[1] * q.c[0]}};
}

static inline bool wide_is_zero(wide_vec p) { return p.c[0] == 0 && p.c[1] == 0 && p.c[2] == 0; }

static inline wide wide_magnitude(wide x) { return x < 0 ? -x : x; }

#endif
