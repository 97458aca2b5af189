/* SPDX-License-Identifier: MIT */
/* within.h - what the commands say of one body inside another. */
#ifndef SEPAX_REPORT_WITHIN_H
#define SEPAX_REPORT_WITHIN_H

#include "sepax.h"

/* In JSON, such as "doubled"; NULL if there is nothing to say. */
const char *report_within_name(sepax_within_reason why);

/* Print why it is not known whether `inner` is inside `outer`, and the cure; or, of one that is
 * inside, what was taken for granted. A clause without a line's end. Not for SEPAX_WITHIN_PLAIN. */
void report_print_within(sepax_within_reason why, const char *inner, const char *outer);

#endif
