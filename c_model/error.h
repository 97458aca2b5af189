/* error.h - how libsepax and the programs on it report failures (private). */
#ifndef SEPAX_ERROR_H
#define SEPAX_ERROR_H

#include "sepax.h"

#include <stdarg.h>

/* Format one line into *error and return false, for `return sepax_fail(...)`. */
static inline bool __attribute__((format(printf, 2, 3)))
sepax_fail(sepax_error *error, const char *format, ...) {
  va_list args;
  va_start(args, format);
  vsnprintf(error->text, sizeof error->text, format, args);
  va_end(args);
  return false;
}

#endif
