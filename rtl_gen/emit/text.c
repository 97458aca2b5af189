/* SPDX-License-Identifier: MIT */
/* text.c - see text.h. */
#include "text.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Space for `count` bytes and the 0 behind them. */
static bool reserve(emit_text *t, size_t count) {
  size_t needed = t->length + count + 1;
  if (t->failed || needed <= t->capacity) {
    return !t->failed;
  }
  size_t more = needed > 2 * t->capacity ? needed : 2 * t->capacity;
  char *grown = realloc(t->bytes, more);
  if (grown == NULL) {
    t->failed = true;
    return false;
  }
  t->bytes = grown;
  t->capacity = more;
  return true;
}

void text_put(emit_text *t, const char *bytes, size_t count) {
  if (reserve(t, count)) {
    memcpy(t->bytes + t->length, bytes, count);
    t->length += count;
    t->bytes[t->length] = '\0';
  }
}

void text_puts(emit_text *t, const char *string) { text_put(t, string, strlen(string)); }

void text_putc(emit_text *t, int character) {
  char c = (char)character;
  text_put(t, &c, 1);
}

int text_vprintf(emit_text *t, const char *format, va_list args) {
  va_list again;
  va_copy(again, args);
  int count = vsnprintf(NULL, 0, format, args);
  if (count >= 0 && reserve(t, (size_t)count)) {
    vsnprintf(t->bytes + t->length, (size_t)count + 1, format, again);
    t->length += (size_t)count;
  }
  va_end(again);
  return count;
}

int text_printf(emit_text *t, const char *format, ...) {
  va_list args;
  va_start(args, format);
  int count = text_vprintf(t, format, args);
  va_end(args);
  return count;
}

void text_append(emit_text *t, emit_text *other) {
  text_put(t, text_so_far(other), other->length);
  t->failed = t->failed || other->failed;
  free(other->bytes);
  *other = (emit_text){.bytes = NULL};
}

const char *text_so_far(const emit_text *t) { return t->bytes != NULL ? t->bytes : ""; }

char *text_take(emit_text *t) {
  text_put(t, "", 0);
  char *whole = t->failed ? NULL : t->bytes;
  if (t->failed) {
    free(t->bytes);
  }
  *t = (emit_text){.bytes = NULL};
  return whole;
}
