/* error.h - how libsepax reports failures (private). */
#ifndef SEPAX_ERROR_H
#define SEPAX_ERROR_H

#include "sepax.h"

/* Format one line into *error and return false, for `return sepax_fail(...)`. */
bool sepax_fail(sepax_error *error, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
