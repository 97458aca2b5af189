/* SPDX-License-Identifier: MIT */
/* inside.h - proves that no part of one body is inside the other.
 *
 * A point p is outside a body if a ray from p shows it in one of two ways:
 *
 *   1. The ray leaves each sheet as often as it enters it. The winding number of a closed surface
 * at p is the sum over its triangles of factor times crossing (+1: the ray leaves, -1: enters). All
 * triangles of a sheet have the same factor, so the sum is 0 for every closed surface that the
 * triangles form: none of them encloses p.
 *   2. p is in a cavity. The sheets that do not cancel so are in parts that are closed, wound alike
 *      and do not touch each other. So these parts enclose each other, and their boxes are nested.
 *      From the outermost part on, their sums are +1, -1, +1, -1 ..., an even number of them: p is
 *      outside the innermost solid, whose wall is turned inwards.
 *
 * Sheets and parts are those of sheets.h. A part whose box does not hold p encloses nothing there
 * and is passed over. What an open part encloses is not known: nothing is proved of a point in the
 * box of all open parts of an element. Elements are solids of their own.
 *
 * Anything else is not proved, and must be taken as inside. */
#ifndef CERTIFICATE_INSIDE_H
#define CERTIFICATE_INSIDE_H

#include "sheets.h"

#include <stdbool.h>

/* The box of an element's open parts, if there are any. */
typedef struct {
  bool any;
  vec low, high;
} open_box;

typedef struct {
  const surface *body;
  sheets of;
  size_t *piece;  /* of each part; NULL: not found yet */
  open_box *open; /* of each element */
  bool any_open;
} shell;

shell shell_of(const surface *s);

/* Of bodies whose surfaces share no point: is each part of a, in the pose `at`, proved to be
 * outside b? As a part touches none of b's triangles, one vertex is enough for all of it. */
bool shell_outside(const shell *a, shell *b, pose at);

#endif
