/* SPDX-License-Identifier: MIT */
/* gates.h - the range of designs to which the formula of the gates was fitted (private). */
#ifndef SEPAX_GATES_H
#define SEPAX_GATES_H

#include "sepax_design.h"

/* True if the formula was fitted to designs like this one. */
bool sepax__gates_fitted(const sepax_design *design);

#endif
