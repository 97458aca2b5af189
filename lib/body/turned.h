/* SPDX-License-Identifier: MIT */
/* turned.h - a box in the other body's coordinates (private). */
#ifndef SEPAX_TURNED_H
#define SEPAX_TURNED_H

#include "placement.h"

#include <string.h>

typedef float four_floats __attribute__((vector_size(16)));
typedef double four_reals __attribute__((vector_size(32)));

/* A box in the other body's coordinates. Its centre is centre + rest. The last of four floats is
 * 0. */
typedef struct {
  four_floats centre, rest, axis[3];
  float half[3];
} posed_box;

/* Move one box to the other body's coordinates. */
static inline __attribute__((always_inline)) void turn_box(posed_box *p, const motion *m,
                                                           const body_boxes *from, uint32_t lane) {
  four_reals column[4];
  four_floats turn[3];
  for (int k = 0; k < 3; k++) {
    memcpy(&column[k], m->scaled[k], sizeof column[k]);
    memcpy(&turn[k], m->turn[k], sizeof turn[k]);
  }
  memcpy(&column[3], m->shift, sizeof column[3]);
  four_reals at = column[0] * (double)from->centre[0][lane] +
                  (column[1] * (double)from->centre[1][lane] + column[3]) +
                  column[2] * (double)from->centre[2][lane];
  p->centre = __builtin_convertvector(at, four_floats);
  p->rest =
      __builtin_convertvector(at - __builtin_convertvector(p->centre, four_reals), four_floats);
  for (int k = 0; k < 3; k++) {
    p->half[k] = m->ratio * from->half[k][lane] + m->lost;
    p->axis[k] = turn[0] * from->axis[k][0][lane] + turn[1] * from->axis[k][1][lane] +
                 turn[2] * from->axis[k][2][lane];
  }
}

#endif
