/* SPDX-License-Identifier: MIT */
/* words.h - words and numbers of a text, line by line (private). */
#ifndef SEPAX_WORDS_H
#define SEPAX_WORDS_H

#include "reader/builder.h"
#include "util/text.h"

#include <math.h>
#include <string.h>
#include <strings.h>

/* A place in the bytes of a builder. A line ends with LF, CR LF or CR. */
typedef struct {
  const mesh_builder *b;
  const char *at, *end;
  size_t line;
  bool joins; /* a backslash at the end of a line joins it with the next */
} words;

static inline words words_begin(const mesh_builder *b, bool joins) {
  static const char mark[] = "\xef\xbb\xbf"; /* of UTF-8 */
  size_t skip = b->size >= 3 && memcmp(b->bytes, mark, 3) == 0 ? 3 : 0;
  return (words){b, b->bytes + skip, b->bytes + b->size, 1, joins};
}

/* The length of the line's end at c, or 0. */
static inline size_t words_line_end(const char *c) {
  return *c == '\n' ? 1 : *c != '\r' ? 0 : c[1] == '\n' ? 2 : 1;
}

static inline bool words_joined(const words *w) {
  return w->joins && *w->at == '\\' && words_line_end(w->at + 1) > 0;
}

/* To the next word of the line; false at its end. */
static inline bool words_next(words *w) {
  for (;;) {
    while (*w->at == ' ' || *w->at == '\t' || *w->at == '\v' || *w->at == '\f') {
      w->at++;
    }
    if (!words_joined(w)) {
      return w->at < w->end && *w->at != '\n' && *w->at != '\r';
    }
    w->at += 1 + words_line_end(w->at + 1);
    w->line++;
  }
}

static inline bool words_is_end(const words *w, const char *c) {
  return *c == ' ' || (*c >= '\t' && *c <= '\r') || c == w->end ||
         (w->joins && *c == '\\' && words_line_end(c + 1) > 0);
}

/* The length of the word at hand. */
static inline size_t words_length(const words *w) {
  const char *c = w->at;
  while (!words_is_end(w, c)) {
    c++;
  }
  return (size_t)(c - w->at);
}

/* The word at hand as text for messages. */
typedef struct {
  char text[32];
} words_shown;

static inline words_shown words_show(const words *w) {
  words_shown shown = {""};
  size_t length = words_length(w);
  for (size_t n = 0; n < length && n < sizeof shown.text - 1; n++) {
    shown.text[n] = w->at[n] > ' ' && w->at[n] <= '~' ? w->at[n] : '?';
  }
  return shown;
}

/* Behind the end of the line, or behind a backslash that joins it with the next: true then. */
static inline bool words_skip_part(words *w) {
  const char *c = w->at;
  while (c < w->end && *c != '\n' && *c != '\r' &&
         !(w->joins && *c == '\\' && words_line_end(c + 1) > 0)) {
    c++;
  }
  bool joined = c < w->end && *c == '\\';
  c += joined;
  w->line += c < w->end;
  w->at = c < w->end ? c + words_line_end(c) : c;
  return joined;
}

/* Behind the end of the line, what is left of it unread. */
static inline void words_skip_line(words *w) {
  while (words_skip_part(w)) {}
}

/* The word at hand is a number, or one that is none, as nan: *number is NaN then. The place is
 * behind it. */
static inline bool words_any_number(words *w, double *number) {
  const char *end = sepax__decimal(w->at, number);
  if (end == NULL || !words_is_end(w, end)) {
    const char *word = w->at + (*w->at == '-' || *w->at == '+');
    if (strncasecmp(word, "nan", 3) != 0 && strncasecmp(word, "inf", 3) != 0) {
      return sepax__builder_fail_line(w->b, w->line, "'%s' is no number; mend it",
                                      words_show(w).text);
    }
    *number = NAN;
    end = w->at + words_length(w);
  }
  w->at = end;
  return true;
}

/* The word at hand is one finite number, and the place is behind it then. */
static inline bool words_number(words *w, double *number) {
  const char *c = sepax__decimal(w->at, number);
  if (c == NULL || !words_is_end(w, c) || !isfinite(*number)) {
    return sepax__builder_fail_line(w->b, w->line, "'%s' is no finite number; mend it",
                                    words_show(w).text);
  }
  w->at = c;
  return true;
}

#endif
