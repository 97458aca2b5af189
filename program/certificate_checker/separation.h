/* SPDX-License-Identifier: MIT */
/* separation.h - axes that keep two bodies farther from each other than a distance, all the time.
 */
#ifndef CERTIFICATE_SEPARATION_H
#define CERTIFICATE_SEPARATION_H

#include "boxes.h"
#include "motion.h"

#include <stdbool.h>

/* Is each triangle of a, in all of the motion m, farther than `distance` from each of b? false: not
 * proved. */
bool separated(const box_tree *a, const box_tree *b, const motion *m, double distance);

typedef struct {
  double middle; /* from b's box to a's along the axis, at the middle; no rounding in it */
  double always; /* at any time: no more than what there is, curve and rounding taken off */
} gap;

/* The axis goes from b to a, in b's coordinates; its length does not matter, but is not 0. */
gap gap_along(const surface *a, const surface *b, const motion *m, vec axis);

#endif
