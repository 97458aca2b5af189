/* SPDX-License-Identifier: MIT */
/* words.c - see words.h. */
#include "layout/files/words.h"
#include "liberty/text.h"

#include <ctype.h>
#include <err.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

words words_open(const char *path) {
  struct stat info;
  FILE *file = fopen(path, "r");
  if (file == NULL || fstat(fileno(file), &info) != 0 || !S_ISREG(info.st_mode)) {
    errx(2, "%s: cannot be read; give another file", path);
  }
  size_t size = (size_t)info.st_size;
  char *text = text_alloc(size + 1, 1);
  if (fread(text, 1, size, file) != size) {
    errx(2, "%s: cannot be read to its end", path);
  }
  fclose(file);
  return (words){path, text, text + size};
}

void words_fail(const words *w, const char *what, const char *name) {
  errx(2, "%s: %s '%s'; give another file", w->path, what, name);
}

/* To the first character of a word; false at the end. */
static bool at_word(words *w) {
  for (;; w->next++) {
    if (w->next < w->end && *w->next == '#') {
      w->next += strcspn(w->next, "\n");
    }
    if (w->next >= w->end) {
      return false;
    }
    if (*w->next != '\0' && !isspace((unsigned char)*w->next)) {
      return true;
    }
  }
}

/* Words end with a zero in the text once they are taken; one that is seen ahead has none yet. */
static char *end_of(const words *w) {
  if (*w->next == '"') {
    char *to = strchr(w->next + 1, '"');
    return to == NULL ? w->end : to + 1;
  }
  return w->next + strcspn(w->next, " \t\r\n");
}

char *word(words *w) {
  if (!at_word(w)) {
    errx(2, "%s: ends too soon; give the whole file", w->path);
  }
  char *it = w->next, *end = end_of(w);
  w->next = end < w->end ? end + 1 : w->end;
  *end = '\0';
  return it;
}

bool word_is(words *w, const char *text) {
  if (!at_word(w)) {
    return false;
  }
  size_t length = strlen(text);
  if (strncmp(w->next, text, length) != 0 || end_of(w) != w->next + length) {
    return false;
  }
  (void)word(w);
  return true;
}

bool words_left(words *w) { return at_word(w); }

void word_want(words *w, const char *text) {
  const char *it = word(w);
  if (strcmp(it, text) != 0) {
    words_fail(w, text, it);
  }
}

double word_number(words *w) {
  const char *it = word(w);
  char *end;
  double value = strtod(it, &end);
  if (end == it || *end != '\0' || !isfinite(value)) {
    words_fail(w, "not a number:", it);
  }
  return value;
}

int word_length(words *w) {
  double units = round(word_number(w) * UNITS);
  if (fabs(units) > 1e9) {
    words_fail(w, "a length", "out of range");
  }
  return (int)units;
}

void words_skip(words *w) {
  while (strcmp(word(w), ";") != 0) {}
}
