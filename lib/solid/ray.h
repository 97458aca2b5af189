/* SPDX-License-Identifier: MIT */
/* ray.h - a ray from a posed point against a triangle, exactly (private). */
#ifndef SEPAX_RAY_H
#define SEPAX_RAY_H

#include "body/big.h"
#include "sepax.h"

/* size * 2^exponent. */
typedef struct {
  big size;
  int exponent;
} scaled;

/* The point c / over; over > 0. */
typedef struct {
  scaled c[3], over;
} exact_point;

/* Point v of a body in pose `own`, in the file coordinates of one in pose `other`. */
void sepax__find_exact_point(exact_point *p, const double v[3], const sepax_pose *own,
                             const sepax_pose *other);

/* The ray from p in direction +axis (way 1) or -axis (way -1) against a triangle, on which p is
 * not: 0 if it does not meet it, else 1 or -1, where the triangle's normal points along +axis or
 * -axis. The ray is moved by something infinitely small along axis + 1 and, even smaller, along
 * axis + 2, so that it meets no edge and of two triangles at an edge the one or the other. */
int sepax__exact_ray_meets(const exact_point *p, int axis, int way, const double t[3][3]);

#endif
