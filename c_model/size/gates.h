/* gates.h - what the formula of the gates is for (private). */
#ifndef SEPAX_GATES_H
#define SEPAX_GATES_H

#include "sepax_design.h"

/* It was fitted to designs like this one. */
bool sepax__gates_fitted(const sepax_design *design);

#endif
