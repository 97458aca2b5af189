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

/* Sets the error to "path: " and the message, whose cure at its end is never cut; false. */
bool sepax__stl_fail(sepax_error *error, sepax_code code, const char *path, const char *format, ...)
    __attribute__((format(printf, 4, 5)));

/* What is wrong with a number that is not finite: "NaN" or "infinite". */
const char *sepax__stl_flaw(double number);

/* sepax_stl_read on the bytes of a file, behind which a '\0' stands; refused where there are more
 * than `most` facets. In the numbers of locale C. */
bool sepax__stl_parse(sepax_soup *soup, const char *bytes, size_t size, const char *path,
                      bool normals, size_t most, sepax_error *error);

#endif
