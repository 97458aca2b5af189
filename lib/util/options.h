/* SPDX-License-Identifier: MIT */
/* options.h - reads structs of callers that were compiled with another version of the headers
 * (private). */
#ifndef SEPAX_OPTIONS_H
#define SEPAX_OPTIONS_H

#include "util/error.h"

#include <string.h>

/* Copy a struct that begins with its size into *copy, which has the `bytes` that this library
 * knows. Fields that the caller's struct lacks become zero. Fields that only the caller's struct
 * has must be zero. NULL gives zeros. */
static inline bool sepax__options(void *copy, size_t bytes, const void *given, const char *name,
                                  sepax_error *error) {
  memset(copy, 0, bytes);
  if (given == NULL) {
    return true;
  }
  const size_t size = *(const size_t *)given; /* the first member */
  if (size < sizeof size) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "%s has no size; fill it in by SEPAX_STRUCT",
                      name);
  }
  for (size_t n = bytes; n < size; n++) {
    if (((const unsigned char *)given)[n] != 0) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%s has fields that this library does not know; use a newer one", name);
    }
  }
  memcpy(copy, given, size < bytes ? size : bytes);
  return true;
}

#endif
