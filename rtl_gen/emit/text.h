/* SPDX-License-Identifier: MIT */
/* text.h - a text that grows as it is written. Without memory it takes no more and remembers that:
 * whoever takes the text finds NULL in its place, so that no writer has to ask. */
#ifndef SEPAX_EMIT_TEXT_H
#define SEPAX_EMIT_TEXT_H

#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

/* All zero: an empty text. */
typedef struct {
  char *bytes; /* with a 0 behind them; NULL as long as there are none */
  size_t length, capacity;
  bool failed; /* there was no memory */
} emit_text;

/* Append as printf does; how many characters that are. */
int text_printf(emit_text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
int text_vprintf(emit_text *t, const char *format, va_list args)
    __attribute__((format(printf, 2, 0)));
void text_puts(emit_text *t, const char *string);
void text_putc(emit_text *t, int character);
void text_put(emit_text *t, const char *bytes, size_t count);

/* Append the other text, which is then empty. */
void text_append(emit_text *t, emit_text *other);

/* What was written so far, "" at first. */
const char *text_so_far(const emit_text *t);

/* The whole text, to be freed; NULL if memory was missing for any of it. *t is then empty. */
char *text_take(emit_text *t);

#endif
