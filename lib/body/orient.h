/* orient.h - on which side of a line or of a plane a point is, exactly (private). */
#ifndef SEPAX_ORIENT_H
#define SEPAX_ORIENT_H

/* 1 if a, b, c turn left, -1 if they turn right, 0 if they are on one line; for all finite doubles.
 * Doubles decide where they are certain, integers of any size otherwise. */
int sepax__orient2d(const double a[2], const double b[2], const double c[2]);

/* The sign of the volume of a, b, c, d; 0 iff one plane holds them. */
int sepax__orient3d(const double a[3], const double b[3], const double c[3], const double d[3]);

#endif
