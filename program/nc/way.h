/* SPDX-License-Identifier: MIT */
/* way.h - the way of the axes during one motion of a program.
 *
 * A control moves the axes along a line in the space of its nine axes: all axes are functions of
 * one parameter t from 0 to 1. A straight motion is linear in t. On an arc X, Y, Z turn about an
 * axis by an angle that is proportional to t; the radius and the place along the axis change
 * linearly with the angle; all other axes change in proportion to the length of the way. LinuxCNC
 * moves in this manner, rapids included (2.9, "Planner"). How t grows with time does not matter
 * here.
 *
 * The length is proportional to the angle if the radius is constant. Otherwise let r go from r0 to
 * r1. The rate of the length then lies between those of the smallest and the largest radius, m and
 * M, so the share of the length at t differs from t by at most t (1 - t) (M - m) / m <=
 * t (1 - t) |r1 - r0| / min(r0, r1). LinuxCNC computes the length by a quadratic of the angle,
 * which has this form, too. `slip` is twice the factor of t (1 - t). */
#ifndef SEPAX_NC_WAY_H
#define SEPAX_NC_WAY_H

#include "nc/canon.h"
#include "nc/interval.h"

typedef struct {
  double from[NC_AXES], to[NC_AXES];
  bool arc;
  /* Of an arc: centre + (1 + grow t) (cos(angle t) across + sin(angle t) along) + t rise. */
  nc_interval centre[3], across[3], along[3], rise[3], angle, grow;
  double
      slip; /* axes other than X, Y, Z may be ahead or behind by slip t (1 - t) of their motion */
} nc_way;

/* The way of a record NC_DO_MOVE or NC_DO_ARC. Returns NULL, or why the record is no arc. */
const char *nc_way_of(nc_way *way, const double from[NC_AXES], const nc_record *record);

/* The axes for t in an interval within 0 ... 1: they, and their derivatives by t, are contained,
 * without the slip. At t = 0 and t = 1 the values are the ends, exactly. */
void nc_way_at(const nc_way *way, nc_interval t, nc_jet axis[NC_AXES]);

/* A bound of slip t (1 - t) for t in t0 ... t1. */
double nc_way_slip(const nc_way *way, double t0, double t1);

/* At most how far the arc leaves the straight line between its ends, in mm, without a helix's rise;
 * 0 for a straight motion. */
double nc_way_bulge(const nc_way *way);

/* The axis does not move. */
bool nc_way_rests(const nc_way *way, int axis);

#endif
