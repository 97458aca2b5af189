/* text.c - see text.h. */
#include "text.h"

#include <stdio.h>
#include <stdlib.h>

const char *text_program = "power";
const char *text_file = "";

void text_fail(const char *what, const char *name) {
  fprintf(stderr, "%s: %s: %s %s\n", text_program, text_file, what, name);
  exit(2);
}

void *text_alloc(size_t count, size_t size) {
  void *p = calloc(count > 0 ? count : 1, size);
  if (p == NULL) {
    text_fail("out of", "memory");
  }
  return p;
}

char *text_read(const char *cure) {
  FILE *in = fopen(text_file, "rb");
  if (in == NULL || fseek(in, 0, SEEK_END) != 0) {
    text_fail("cannot be read;", cure);
  }
  long size = ftell(in);
  rewind(in);
  char *text = text_alloc((size_t)(size > 0 ? size : 0) + 1, 1);
  if (size <= 0 || fread(text, 1, (size_t)size, in) != (size_t)size) {
    text_fail("is", "empty");
  }
  fclose(in);
  return text;
}
