/* derive.h - a slower, less leaky variant of a cell library, by stated factors. */
#ifndef SEPAX_LIBERTY_DERIVE_H
#define SEPAX_LIBERTY_DERIVE_H

#include "tree.h"

typedef struct {
  const char *delay, *leakage, *suffix; /* factors as text, behind each cell's name */
} derivation;

/* Print the library whose text stands at `text` and whose statements are `library`: each cell gets
 * the suffix, its delays, output slopes, setup and hold times are multiplied by `delay`, its
 * leakage by `leakage`. Areas, capacitances, functions and energies stay. */
void derive(const char *text, const char *origin, const node *library, const derivation *how);

#endif
