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
 * How much of two motions is in the blend. LinuxCNC begins the second when the first is in its last
 * deceleration, and in a blend each has half of its acceleration. Let n be the greatest rate of a
 * straight motion, that is, the greatest share of it in a second, and g the greatest change of the
 * rate in a second: the limits of the axes divided by their ways. Then at most n1^2 / g1 is left of
 * the first motion, and it takes at most t = 2 n1 / g1 more. In this time the second does at most
 * min(n2 t, g2 t^2 / 2). If the first is merged of others, then its way is not known; but n1 = v_i
 * / way_i at most for the axis i that g1 is of, so t is at most 2 v_i / a_i of some axis that
 * moves. On an arc the speed is at most the root of 3 times the greatest of its axes, and half of
 * the least acceleration is left along the way. All is raised by a twentieth and by two periods of
 * the servo. The simulator's joints are compared with this (tb/nc/rows_simulated).
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
  double rate, gain; /* of a motion that is straight and not merged, 1/s and 1/s^2; 0: not known */
  double brake;      /* s, of its last deceleration in a blend; 0: not known */
} nc_leg;

/* Fill in the last three fields of a leg whose other fields are there. */
void nc_blend_pace(nc_leg *leg, const nc_limits limits[NC_AXES]);

/* The blend of two motions that follow each other: per axis, how far the control may be from a
 * point of these motions, in mm and degrees. `within` is in mm; it counts if blend is NC_WITHIN.
 * `servo`: its period, s. */
void nc_blend_corner(const nc_leg *first, const nc_leg *second, nc_blend blend, double within,
                     double servo, double off[NC_AXES]);

/* The same per joint, in m and rad: the axes are at most `off` away from a point of both ways. By
 * the mean value theorem a joint then differs by at most the sum over the axes of `off` times the
 * largest derivative in the box of all positions. */
void nc_blend_joints(const nc_kinematics *k, const nc_way *first, const nc_way *second,
                     const double off[NC_AXES], double joint[NC_JOINTS_MOST]);

#endif
