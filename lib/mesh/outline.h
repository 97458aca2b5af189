/* SPDX-License-Identifier: MIT */
/* outline.h - polylines in the half plane (z, r) beside an axis (private to revolve.c).
 *
 * An outline is a list of points with z that never falls. It stands for the region between itself,
 * the axis, and straight lines to the axis at both ends: 0 <= r <= R(z). Where R(z) < 0 the region
 * is empty. */
#ifndef SEPAX_OUTLINE_H
#define SEPAX_OUTLINE_H

#include "revolve.h"

typedef struct {
  double z, r;
} spot;

typedef struct {
  spot *at;
  size_t count, capacity;
} outline;

typedef enum { AROUND, WITHIN } outline_side;

void sepax__outline_free(outline *o);
/* False without memory. */
bool sepax__outline_add(outline *o, double z, double r);

/* The distance of a point, or of a segment, from a segment; rounded, wrong by 1e-11 at most for
 * coordinates up to 2e4. Two segments that cross have the distance 0. */
double sepax__spot_distance(spot p, spot a, spot b);
double sepax__segment_distance(spot a, spot b, spot c, spot d);

/* Replace the arcs of a profile by tangents and chords, so that the region of the outline is around
 * the region of the profile, or within it. No point of an arc is farther from the outline than
 * `sagitta`. The height of the last point grows by `above`. False without memory. */
bool sepax__outline_of(outline *o, const turned_profile *profile, outline_side side, double sagitta,
                       double above);

/* The region whose points are at least `depth` deep in the region of `from`, as in space around the
 * axis; a negative depth adds the points that are at most that far from it. Arcs of the exact
 * result are replaced on the side that is asked for, by a polygon that is at most `sagitta` away,
 * and for a negative depth at most 0.42 |depth|. Where nothing is left, the result runs along the
 * axis; it has no points if nothing is left at any height. Errors: LIMIT if the
 * outline has too many points; MEMORY. */
bool sepax__outline_offset(outline *o, const outline *from, double depth, outline_side side,
                           double sagitta, sepax_error *error);

/* Checks of what sepax__outline_offset made. Each returns true only if the statement holds, but for
 * 1e-10. The ends of an outline at the axis are part of it.
 *   - apart: every point of `o` is farther than `distance` from every point of `from`. Stretches of
 *     `o` along the axis are left out.
 *   - covered: no point of `o`, nor any at the same height and farther from the axis, is more than
 *     `depth` deep in the region of `from`.
 *   - reaches: every point of the region of `o` is at most `gap` from the region of `inner`. The
 *     flags say if stretches along the axis belong to the regions: a profile has such points, a
 *     mesh has no triangles there. */
bool sepax__outline_apart(const outline *o, const outline *from, double distance);
bool sepax__outline_covered(const outline *o, const outline *from, double depth);
bool sepax__outline_reaches(const outline *o, bool o_axis, const outline *inner, bool inner_axis,
                            double gap);

#endif
