/* SPDX-License-Identifier: MIT */
/* estimates.h - an estimate of a design (rtl_gen/estimate.h) as text and as JSON. */
#ifndef SEPAX_COMMANDS_ESTIMATES_H
#define SEPAX_COMMANDS_ESTIMATES_H

#include "estimate.h"

#include <jansson.h>

/* Print a line for each quantity, with its error. */
void estimate_print(const sepax_design *design, const sepax_estimate *estimate);

/* The same as a JSON object, to be freed with json_decref; NULL without memory. What is not known
 * is not in it. */
json_t *estimate_json(const sepax_design *design, const sepax_estimate *estimate);

/* Print this object. */
void estimate_print_json(const sepax_design *design, const sepax_estimate *estimate);

#endif
