/* SPDX-License-Identifier: MIT */
/* oracle.h - the verdict by another road than the separating axis theorem.
 *
 * Rational arithmetic without rounding (GMP), right for every int32 coordinate and
 * every triangle, also one that is a segment or a point. Slow (microseconds), no
 * state, safe to call from several threads.
 */
#ifndef ORACLE_H
#define ORACLE_H

#include "sepax_models.h"

#ifdef __cplusplus
extern "C" {
#endif

/* True iff the closed triangles have a common point, that is, iff an edge of one
 * meets the other: edge and plane are intersected, the point is located. */
bool oracle_collide(const sepax_tri *a, const sepax_tri *b);

/* The same of triangles of doubles in poses (NULL: as they are), each double the number it is. */
bool oracle_collide_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                          const sepax_pose *pose_b);

/* True iff the planes of both triangles meet in a line and the insides of both (without their
 * edges) share a point of it: the segments in which the triangles meet it overlap. */
bool oracle_strict_posed(const double a[3][3], const sepax_pose *pose_a, const double b[3][3],
                         const sepax_pose *pose_b);

/* True iff one plane holds all six vertices. */
bool oracle_coplanar(const sepax_tri *a, const sepax_tri *b);

#ifdef __cplusplus
}
#endif
#endif
