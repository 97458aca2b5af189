/* SPDX-License-Identifier: MIT */
/* ears.h - the ears of a polygon in the plane (private). */
#ifndef SEPAX_EARS_H
#define SEPAX_EARS_H

#include "reader/polygon.h"

/* Divide a polygon by rule 2 of polygon.h, as seen along the axis. `right`: the side to try first:
 * its inside is on the right of its edges. `flat`: its corners are in a common plane, which is not
 * seen from its side; then it may have no area. Signs are exact, and the sum of triangles that all
 * turn the same way is the polygon wherever this covers no point twice. */
polygon_result sepax__cut_ears(const double (*corner)[3], size_t count, int axis, bool right,
                               bool flat, size_t (*triangle)[3]);

#endif
