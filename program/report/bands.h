/* bands.h - the limits of --clearance and --warning, and how they are told. */
#ifndef SEPAX_REPORT_BANDS_H
#define SEPAX_REPORT_BANDS_H

#include "report/verdict.h"
#include "sepax.h"

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

#endif
