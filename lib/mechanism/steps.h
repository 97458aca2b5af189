/* SPDX-License-Identifier: MIT */
/* steps.h - the joints of a mechanism (private). */
#ifndef SEPAX_STEPS_H
#define SEPAX_STEPS_H

#include "sepax_mechanism.h"

/* The child's pose in the parent's coordinates. */
sepax_pose sepax__step_of(const sepax_joint *joint, double value);

/* sepax_mechanism_join; where one joint is at fault, `wrong` gets its number. */
bool sepax__mechanism_join(sepax_mechanism *m, size_t *wrong, sepax_error *error);

#endif
