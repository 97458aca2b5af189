/* SPDX-License-Identifier: MIT */
/* bands.h - checks and prints the limits of --clearance and --warning. */
#ifndef SEPAX_REPORT_BANDS_H
#define SEPAX_REPORT_BANDS_H

#include "report/verdict.h"
#include "sepax.h"

#include <jansson.h>

typedef struct {
  const char *text; /* as the user wrote it; NULL: not given */
  double length;    /* in the unit of the scene */
} report_limit;

typedef struct {
  int unit; /* unit of the lengths: 10^unit metres */
  report_limit clearance, warning;
} report_bands;

/* Fails if --warning is given without --clearance or is not above it. */
bool report_bands_agree(const report_bands *bands, sepax_error *error);

/* The limits on a grid, in LSB, and the length of 1 LSB in mm. */
typedef struct {
  int clearance, warning;
  double lsb_mm;
} report_steps;

/* Print "bands  7 free, 9 warning (up to 1 mm), 0 collision (up to 0.5 mm)" without the end of the
 * line. `count` has a number for each verdict. `steps` and `count` may be NULL. */
void report_print_bands(int width, const report_bands *bands, const report_steps *steps,
                        const size_t *count);

/* Set clearance_mm and warning_mm if they were given, and clearance_lsb and warning_lsb if `steps`
 * is not NULL. */
void report_set_bands(json_t *to, const report_bands *bands, const report_steps *steps);

#endif
