/* SPDX-License-Identifier: MIT */
/* csv.c - cells of a CSV file. */
#include "report/csv.h"

#include <stdio.h>
#include <string.h>

bool report_csv_text(FILE *out, const char *text) {
  if (strpbrk(text, ",\" ;") == NULL) {
    return fputs(text, out) != EOF;
  }
  bool ok = putc('"', out) != EOF;
  for (const char *c = text; *c != '\0' && ok; c++) {
    ok = (*c != '"' || putc('"', out) != EOF) && putc(*c, out) != EOF;
  }
  return ok && putc('"', out) != EOF;
}
