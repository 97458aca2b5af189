/* error.h - how libsepax and the programs on it report failures (private). */
#ifndef SEPAX_ERROR_H
#define SEPAX_ERROR_H

#include "sepax.h"

#include <stdarg.h>

/* Format one line into *error and return false, for `return sepax_fail(...)`. A
 * control character, of a file name say, becomes '?'. */
static inline bool __attribute__((format(printf, 2, 3)))
sepax_fail(sepax_error *error, const char *format, ...) {
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
