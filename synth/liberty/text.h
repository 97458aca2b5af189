/* SPDX-License-Identifier: MIT */
/* text.h - what the readers of netlists and libraries share: memory, refusals. */
#ifndef SEPAX_TEXT_H
#define SEPAX_TEXT_H

#include <stddef.h>

/* The file that is read; messages name it. */
extern const char *text_file;

/* One line on standard error, "PROGRAM: FILE: what name", and exit status 2. */
void text_fail(const char *what, const char *name) __attribute__((noreturn));

/* Zeroed memory, freed by nobody; ends the program without it. */
void *text_alloc(size_t count, size_t size);

/* A list of `count` elements (NULL: of none) with space for one more; ends the program without
 * memory. For lists that grow by this alone. */
void *text_more(void *list, size_t count, size_t size);

#endif
