/* SPDX-License-Identifier: MIT */
/* report.h - ends the program with a line, and allocates memory, which is kept until then. */
#ifndef CERTIFICATE_REPORT_H
#define CERTIFICATE_REPORT_H

#include <stddef.h>
#include <stdio.h>

/* Print one line and exit with status 1: the certificate says something that is wrong or not
 * proved. */
_Noreturn void reject(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* Print one line and exit with status 2: the certificate cannot be checked. */
_Noreturn void cannot(const char *format, ...) __attribute__((format(printf, 1, 2)));

/* For atexit: what was printed must have arrived, or else the status is 2. */
void report_at_exit(void);

void *memory(void *old, size_t count, size_t size);
char *text_copy(const char *text, size_t length);

/* The whole file, with a 0 behind it; *length without that. */
char *file_read(const char *name, size_t *length);

/* One more entry of an array that has count of them; it grows by doubling. */
#define GROW(array, count)                                                                    \
  (((count) & ((count)-1)) == 0                                                               \
       ? ((array) = memory((array), (count) == 0 ? 1 : 2 * (size_t)(count), sizeof *(array))) \
       : (array))

#endif
