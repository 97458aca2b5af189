/* SPDX-License-Identifier: MIT */
/* blend.h - how far a control that blends two motions may be from both of them.
 *
 * nc.h has the model. Let the corner be c = 0, L1 and L2 the lengths of two straight motions in
 * X, Y, Z, u1 and u2 their unit directions, q the angle from u1 to u2, and d1, d2 the motions of
 * all nine axes per unit of these lengths. The position is x = -a d1 + b d2 with lengths a in
 * 0 ... L1 and b in 0 ... L2; a falls and b rises with time.
 *
 * 1. At one moment a = b = s. Before it min(a, b) = b <= s, after it min(a, b) = a <= s.
 * 2. At the moment that P speaks of, |b u2 - a u1| <= P. For a given b this distance is least at
 *    a = b cos q; so if cos q > 0 then a <= P / sin q, and b likewise. If cos q <= 0 then
 *    a <= P and b <= P. As a falls and b rises, s is at most the larger of both: s <= P / sin q, or
 *    s <= P. Besides, s <= min(L1, L2).
 * 3. While a >= b take the point -(a - k b) d1 of the first motion, for any k in 0 ... 1. It
 *    differs from x by b (d2 - k d1). While a < b take the point (b - k a) d2 of the second; it
 *    differs by a (k d2 - d1). So axis i differs by at most s max(|d2 - k d1|, |d1 - k d2|) of
 *    axis i. With k = max(0, cos q) this is at most P along X, Y and Z together.
 *
 * Without P, or if X, Y, Z do not move: x differs from the point -a d1 of the first motion by b d2,
 * which is at most all of the second motion; or the other way round.
 *
 * LinuxCNC merges lines only if they are feeds that move nothing but X, Y, Z. If a motion may be
 * merged, or is an arc, then 2. and 3. do not hold, and the manual's word is taken instead: X, Y, Z
 * stay within P of the way, or within P + Q with merging. An arc may be replaced by two lines
 * before, so the tolerance is taken twice then. The other axes are anywhere in both motions. */
#ifndef SEPAX_NC_BLEND_H
#define SEPAX_NC_BLEND_H

#include "nc/kinematics.h"
#include "nc/way.h"

typedef struct {
  const nc_way *way;
  bool moves[NC_AXES]; /* in this motion, or in one that it may be merged with */
  bool merges;         /* it may be merged with others, or be replaced */
  bool arcs;           /* it is an arc, or may be merged with one */
} nc_leg;

/* The blend of two motions that follow each other: per axis, how far the control may be from a
 * point of these motions, in mm and degrees. `within` is in mm; it counts if blend is NC_WITHIN. */
void nc_blend_corner(const nc_leg *first, const nc_leg *second, nc_blend blend, double within,
                     double off[NC_AXES]);

/* The same per joint, in m and rad: the axes are at most `off` away from a point of both ways. By
 * the mean value theorem a joint then differs by at most the sum over the axes of `off` times the
 * largest derivative in the box of all positions. */
void nc_blend_joints(const nc_kinematics *k, const nc_way *first, const nc_way *second,
                     const double off[NC_AXES], double joint[NC_JOINTS_MOST]);

#endif
