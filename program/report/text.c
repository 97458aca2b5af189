/* SPDX-License-Identifier: MIT */
/* text.c - lines of text that several commands print. */
#include "report/text.h"

#include <stdio.h>
#include <stdlib.h>

report_number report_exactly(double value) {
  enum { DIGITS_FEWEST = 9, DIGITS_ALL = 17 };
  report_number number;
  int digits = DIGITS_FEWEST;
  do {
    snprintf(number.text, sizeof number.text, "%.*g", digits, value);
  } while (strtod(number.text, NULL) != value && ++digits <= DIGITS_ALL);
  return number;
}

double report_mm(double length, int unit) {
  static const int millimetres = -3;
  double scale = 1;
  for (; unit > millimetres; unit--) {
    scale *= 10;
  }
  return scale * length;
}

void report_print_count(size_t count, const char *what) {
  printf("%zu %s%s", count, what, count == 1 ? "" : "s");
}

void report_print_grid(int width, const sepax_grid *grid) {
  printf("%-*sW = %d, 1 LSB = %s mm, origin %s,%s,%s mm\n", width, "grid", grid->word,
         report_exactly(grid->resolution).text, report_exactly(grid->offset[0]).text,
         report_exactly(grid->offset[1]).text, report_exactly(grid->offset[2]).text);
}
