/* SPDX-License-Identifier: MIT */
/* csv.h - cells of a CSV file. */
#ifndef SEPAX_REPORT_CSV_H
#define SEPAX_REPORT_CSV_H

#include <stdbool.h>
#include <stdio.h>

/* Write a text, in quotes if it contains commas, semicolons, quotes or blanks. */
bool report_csv_text(FILE *out, const char *text);

#endif
