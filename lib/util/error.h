/* SPDX-License-Identifier: MIT */
/* error.h - how libsepax and the programs on it report failures (private). */
#ifndef SEPAX_ERROR_H
#define SEPAX_ERROR_H

#include "sepax.h"

#include <stdarg.h>
#include <stdio.h>

/* Write the code and a formatted line into *error, unless it is NULL, and return false, so that
 * callers write `return sepax_fail(...)`. Control characters, for example of a file name, become
 * '?'. */
static inline bool __attribute__((format(printf, 3, 4)))
sepax_fail(sepax_error *error, sepax_code code, const char *format, ...) {
  if (error == NULL) {
    return false;
  }
  error->code = code;
  va_list args;
  va_start(args, format);
  vsnprintf(error->text, sizeof error->text, format, args);
  va_end(args);
  for (char *c = error->text; *c != '\0'; c++) {
    *c = (unsigned char)*c < ' ' ? '?' : *c;
  }
  return false;
}

#endif
