/* SPDX-License-Identifier: MIT */
/* text.c - see text.h. */
#include "text.h"

#include <err.h>
#include <stdlib.h>

const char *text_file = "";

void text_fail(const char *what, const char *name) { errx(2, "%s: %s %s", text_file, what, name); }

void *text_alloc(size_t count, size_t size) {
  void *p = calloc(count > 0 ? count : 1, size);
  if (p == NULL) {
    text_fail("out of", "memory");
  }
  return p;
}

void *text_more(void *list, size_t count, size_t size) {
  if ((count & (count - 1)) != 0) { /* its space is the next power of two */
    return list;
  }
  list = realloc(list, (count == 0 ? 1 : 2 * count) * size);
  if (list == NULL) {
    text_fail("out of", "memory");
  }
  return list;
}
