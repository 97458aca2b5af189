/* steps.h - one joint of a mechanism (private). */
#ifndef SEPAX_STEPS_H
#define SEPAX_STEPS_H

#include "sepax_mechanism.h"

/* The child's pose in the parent's coordinates. */
sepax_pose step_of(const sepax_joint *joint, double value);

#endif
