/* text.c - whole files, and decimal numbers in them. */
#include "formats/formats.h"
#include "util/error.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_stream(format_text *text, FILE *in, size_t most, const char *path,
                        sepax_error *error) {
  size_t capacity = (size_t)1 << 16;
  text->bytes = sepax_allocate(capacity);
  while (text->bytes != NULL) {
    text->size += fread(text->bytes + text->size, 1, capacity - text->size - 1, in);
    text->bytes[text->size] = '\0';
    if (text->size > most) {
      return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: longer than %zu MiB; split it", path,
                        most >> 20);
    }
    if (text->size + 1 < capacity) {
      return ferror(in) == 0 ||
             sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; give a readable file", path,
                        strerror(errno));
    }
    capacity *= 2;
    char *grown = sepax_resize(text->bytes, capacity);
    if (grown == NULL) {
      sepax_release(text->bytes);
    }
    text->bytes = grown;
  }
  return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.300s: no memory for %zu bytes", path, capacity);
}

bool format_text_read(format_text *text, const char *path, size_t most, sepax_error *error) {
  *text = (format_text){NULL, 0};
  FILE *in = fopen(path, "rb");
  if (in == NULL) {
    return sepax_fail(error, SEPAX_ERROR_FILE, "%.300s: %s; give a readable file", path,
                      strerror(errno));
  }
  bool ok = read_stream(text, in, most, path, error);
  fclose(in);
  if (!ok) {
    sepax_release(text->bytes);
    *text = (format_text){NULL, 0};
  }
  return ok;
}

/* strtod reads hexadecimal numbers and words, too. */
bool format_number(const char *word, size_t length, double *number) {
  static const char decimal[] = "+-.0123456789eE";
  enum { DIGITS_MOST = 400 };
  char copy[DIGITS_MOST + 1];
  if (length == 0 || length > DIGITS_MOST || strspn(word, decimal) < length) {
    return false;
  }
  memcpy(copy, word, length);
  copy[length] = '\0';
  char *end;
  *number = strtod(copy, &end);
  return *end == '\0' && end != copy && isfinite(*number);
}
