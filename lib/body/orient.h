/* SPDX-License-Identifier: MIT */
/* orient.h - on which side of a line or of a plane a point is, exactly (private). */
#ifndef SEPAX_ORIENT_H
#define SEPAX_ORIENT_H

/* Returns 1 if a, b, c turn left, -1 if they turn right, and 0 if they are on one line. It is exact
 * for all finite doubles: doubles decide if they are certain, and integers of any size
 * otherwise. */
int sepax__orient2d(const double a[2], const double b[2], const double c[2]);

/* Returns the sign of the volume of a, b, c, d; 0 if and only if one plane holds them. It is
 * exact. */
int sepax__orient3d(const double a[3], const double b[3], const double c[3], const double d[3]);

#endif
