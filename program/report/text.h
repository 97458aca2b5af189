/* SPDX-License-Identifier: MIT */
/* text.h - lines of text that several commands print. */
#ifndef SEPAX_REPORT_TEXT_H
#define SEPAX_REPORT_TEXT_H

#include "sepax_grid.h"

/* A number with the fewest decimals, at least 9 significant digits, that strtod reads back as the
 * same double. So a grid that is printed can be given again. */
typedef struct {
  char text[32];
} report_number;
report_number report_exactly(double value);

/* A length in mm. Reports have all lengths in mm, whatever the unit of the files is, and JSON keys
 * end in _mm. The argument is in units of 10^unit metres (cli/units.h). */
double report_mm(double length, int unit);

/* "1 line", "2 lines" */
void report_print_count(size_t count, const char *what);

/* Lines of text; the name at the left takes `width` characters. */
void report_print_grid(int width, const sepax_grid *grid); /* of STL files, whose unit is 1 mm */

#endif
