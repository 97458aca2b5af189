/* SPDX-License-Identifier: MIT */
/* stl.h - STL files as bytes (private). */
#ifndef SEPAX_STL_H
#define SEPAX_STL_H

#include "sepax.h"

/* A binary file: a title, the number of facets, then for each facet 12 numbers in binary32 (normal,
 * vertices) and two bytes of attributes; all little-endian. */
enum { STL_TITLE_BYTES = 80, STL_HEAD_BYTES = 84, STL_FACET_BYTES = 50, STL_FACET_NUMBERS = 12 };

/* The numbers of a facet in the order of the file: its normal, its vertices. */
typedef struct {
  double of[STL_FACET_NUMBERS];
} stl_numbers;

/* Set the error to "path: message" and return false. The path is cut if necessary, so that the cure
 * at the end of the message never is. */
bool sepax__stl_fail(sepax_error *error, sepax_code code, const char *path, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* "NaN" or "infinite", for a number that is not finite. */
const char *sepax__stl_flaw(double number);

/* Like sepax_stl_read, but on the bytes of a file, followed by a '\0'. Files with more than `most`
 * facets are refused. The caller has set the numbers of locale C. */
bool sepax__stl_parse(sepax_soup *soup, const char *bytes, size_t size, const char *path,
                      bool normals, size_t most, sepax_error *error);

#endif
