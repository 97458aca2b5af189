/* SPDX-License-Identifier: MIT */
/* report.c - how the program ends, and memory. */
#include "report.h"

#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a file says may be in the words: they stay one line. */
static void print_line(FILE *out, const char *before, const char *format, va_list values) {
  char text[1000];
  vsnprintf(text, sizeof text, format, values);
  for (char *at = text; *at != 0; at++) {
    if ((unsigned char)*at < ' ' || *at == 0x7F)
      *at = '?';
  }
  fprintf(out, "%s%s\n", before, text);
}

void reject(const char *format, ...) {
  va_list values;
  va_start(values, format);
  print_line(stdout, "rejected: ", format, values);
  va_end(values);
  exit(1);
}

void cannot(const char *format, ...) {
  va_list values;
  va_start(values, format);
  print_line(stderr, "sepax-certificate-check: ", format, values);
  va_end(values);
  exit(2);
}

void report_at_exit(void) {
  if (fflush(stdout) != 0 || ferror(stdout)) {
    fputs("sepax-certificate-check: standard output cannot be written; free some space\n", stderr);
    _exit(2);
  }
}

void *memory(void *old, size_t count, size_t size) {
  if (count == 0)
    count = 1;
  if (count > (size_t)-1 / 2 / size)
    cannot("no memory");
  void *new = realloc(old, count * size);
  if (new == NULL)
    cannot("no memory");
  return new;
}

char *text_copy(const char *text, size_t length) {
  char *copy = memory(NULL, length + 1, 1);
  memcpy(copy, text, length);
  copy[length] = 0;
  return copy;
}

char *file_read(const char *name, size_t *length) {
  FILE *in = fopen(name, "rb");
  if (in == NULL)
    cannot("%s: cannot be read: %s", name, strerror(errno));
  size_t size = 1 << 16;
  char *text = memory(NULL, size, 1);
  *length = 0;
  size_t got = 0;
  while ((got = fread(text + *length, 1, size - 1 - *length, in)) > 0) {
    *length += got;
    if (*length == size - 1)
      text = memory(text, size *= 2, 1);
  }
  if (ferror(in))
    cannot("%s: cannot be read: %s", name, strerror(errno));
  fclose(in);
  text[*length] = 0;
  return text;
}
