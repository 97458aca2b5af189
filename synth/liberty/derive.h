/* SPDX-License-Identifier: MIT */
/* derive.h - a slower, less leaky variant of a cell library, by stated factors. */
#ifndef SEPAX_LIBERTY_DERIVE_H
#define SEPAX_LIBERTY_DERIVE_H

#include "tree.h"

/* Print the library: each cell's name gets the suffix, its delays, output slopes, setup and hold
 * times are multiplied by `delay`, its leakage by `leakage` (both are numbers as text). Areas,
 * capacitances, functions and energies stay. */
void derive(const node *library, const char *delay, const char *leakage, const char *suffix);

#endif
