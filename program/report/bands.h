/* bands.h - the limits of --clearance and --warning, and how they are told. */
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
  int unit; /* of the lengths: 10^unit metres */
  report_limit clearance, warning;
} report_bands;

/* Fails where --warning has no --clearance, or is not above it. */
bool report_bands_agree(const report_bands *bands, sepax_error *error);

/* On a grid: the limits in steps, and the length of a step in mm. */
typedef struct {
  int clearance, warning;
  double lsb_mm;
} report_steps;

/* "bands  7 free, 9 warning (up to 1 mm), 0 collision (up to 0.5 mm)", without the end of the line;
 * `steps` and `count`, a number for each verdict, may be NULL. */
void report_print_bands(int width, const report_bands *bands, const report_steps *steps,
                        const size_t *count);

/* clearance_mm and warning_mm where they were given, and clearance_lsb, warning_lsb of `steps`. */
void report_set_bands(json_t *to, const report_bands *bands, const report_steps *steps);

#endif
