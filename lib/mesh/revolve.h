/* SPDX-License-Identifier: MIT */
/* revolve.h - solids of revolution: meshes around the true solid and inside it, with proof
 * (private). Lengths are in one unit, which the caller chooses; "mm" stands for it here. */
#ifndef SEPAX_REVOLVE_H
#define SEPAX_REVOLVE_H

#include "sepax.h"

/* A point of a profile at height z on the axis, at distance r from the axis. `bend` describes the
 * way from the point before: 0 is a straight line, +R is an arc of radius R that bulges away from
 * the axis, -R is an arc of radius R that bulges towards the axis. An arc spans at most half a
 * circle, and of the two arcs with that radius it is the short one. */
typedef struct {
  double z, r, bend;
} turned_point;

/* The solid {(x, y, z): sqrt(x^2 + y^2) <= R(z)}, where R follows the points from the lowest to the
 * highest z. Flat faces close the solid at both ends. Legal: 2 ... TURNED_POINTS_MOST points;
 * numbers are finite; 0 <= r, |z|, |bend| <= TURNED_SIZE_MOST; z never falls, not even within an
 * arc; not all z are equal and not all r are 0. A step in R is two points with one z. */
typedef struct {
  turned_point *point; /* by sepax_allocate */
  size_t points;
} turned_profile;

enum { TURNED_POINTS_MOST = 256 };
#define TURNED_SIZE_MOST 1e4
#define TURNED_GAP_LEAST 1e-4

typedef struct {
  /* Of the outer mesh no point is farther than `gap` from the solid, and of the solid no point is
   * farther than `gap` from the inner mesh, as solids. TURNED_GAP_LEAST or more. */
  double gap;
  /* The solid is first shrunk by this length, 0 or more: what stays are the points that are at
   * least `shrink` deep. The meshes are around and inside of this shrunk solid. */
  double shrink;
  /* The highest face is no surface, because the tool goes on there: the solid is shrunk as if it
   * went on with the same radius, and ends at the same height as before. */
  bool keep_top;
} revolve_how;

/* Make the outer mesh, the inner mesh, or both; NULL: not asked for. Meshes are closed and
 * consistent (sepax_shell), with triangles counterclockwise seen from outside, none without area. A
 * mesh has no triangles if nothing is left of the solid. The outer mesh contains every point of the
 * solid, and the solid contains every point of the inner mesh, for the meshes as they are in
 * doubles; revolve.c has the proof, which holds, too, if the caller then multiplies all coordinates
 * by one number in doubles. Cost: some milliseconds. The count of triangles follows from the gap: a
 * cylinder of diameter 10 at 0.005 has 416.
 *
 * Errors: ARGUMENT if the profile or an option is out of range; LIMIT if the gap is too small for
 * the size of the solid, or cannot be kept because the solid has parts or edges that are too thin
 * (not for an outer mesh alone without shrinking); MEMORY. */
bool sepax__revolve(sepax_soup *outer, sepax_soup *inner, const turned_profile *profile,
                    const revolve_how *how, sepax_error *error);

/* Check that a profile is legal, as above; ARGUMENT with the number of the point otherwise. */
bool sepax__turned_check(const turned_profile *profile, sepax_error *error);

#endif
