/* SPDX-License-Identifier: MIT */
/* text.h - whole files, and decimal numbers in them (private). */
#ifndef SEPAX_UTIL_TEXT_H
#define SEPAX_UTIL_TEXT_H

#include "sepax.h"

typedef struct {
  char *bytes; /* by sepax_allocate, and a '\0' behind them */
  size_t size;
} text_bytes;

/* The whole of a file, or of a pipe, that has `most` bytes at most. On failure *text is zero. */
bool sepax__text_read(text_bytes *text, const char *path, size_t most, sepax_error *error);

/* The whole of a file of CSV, likewise. It has no bytes of zero. *begin is where it begins: behind
 * the byte order mark of UTF-8 that some editors write. */
bool sepax__text_csv(text_bytes *text, size_t *begin, const char *path, size_t most,
                     sepax_error *error);

/* The decimal number at the beginning of the text, which ends with a '\0': sign, digits with a
 * point among them or not, exponent; rounded once, to the nearest double, infinite beyond the
 * largest. The calling thread has the numbers of locale C (plain_numbers.h). Returns the end of it,
 * or NULL where there is none: no blanks, no words, nothing hexadecimal. */
const char *sepax__decimal(const char *text, double *value);

/* The `length` characters, behind which others or a '\0' stand, are one finite decimal number. */
bool sepax__number(const char *word, size_t length, double *number);

#endif
