/* SPDX-License-Identifier: MIT */
/* steps.h - the joints of a mechanism (private). */
#ifndef SEPAX_STEPS_H
#define SEPAX_STEPS_H

#include "sepax_mechanism.h"

/* The child's pose in the parent's coordinates. */
sepax_pose sepax__step_of(const sepax_joint *joint, double value);

/* A pose in the coordinates of another one. */
sepax_pose sepax__pose_seen(const sepax_pose *from, const sepax_pose *pose);

/* sepax_mechanism_join; where one joint is at fault, `wrong` gets its number. */
bool sepax__mechanism_join(sepax_mechanism *m, size_t *wrong, sepax_error *error);

/* A bound on how far a point is from the chord of its way. The chord leads from the place of the
 * point in B's coordinates at the values `from` to its place at `to`, at constant speed. No point
 * of the box is ever farther from there. Arguments and rounding are those of sepax_chain_travel.
 * The path bends by at most M (docs/reference/mechanisms.md#the-bound-on-motion), and a path of
 * length 1 in time that bends by M is at most M / 8 from its chord. */
double sepax__chain_bend(const sepax_chain *chain, const sepax_mechanism *m, const double *from,
                         const double *middle, const double *to, const double box[2][3]);

#endif
