/* SPDX-License-Identifier: MIT */
/* words.h - the words of one line of the stream (private to program/nc). */
#ifndef SEPAX_NC_WORDS_H
#define SEPAX_NC_WORDS_H

#include "sepax.h"

enum { NC_LINE_MOST = 4096 };

typedef struct {
  const char *name; /* of the stream, in messages */
  size_t line;      /* of the stream, from 1 */
  char *rest;       /* of the line; ends with a '\0' */
  sepax_error *error;
} nc_words;

/* Write one line that names the stream and its line, and return false. */
bool nc_refuse(const nc_words *w, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* The next word, which becomes a string of its own; NULL at the end of the line. Words are
 * separated by exactly one blank, so a word may be empty; an empty word is refused by its taker. */
char *nc_word(nc_words *w);

/* Take the next words as a number within +-1e9, as a whole number from `least` to `most`, as
 * `count` numbers, as text of 1 to NC_NAME - 1 characters, or as the last of a list of names that
 * ends with NULL. `what` names the word in messages. */
bool nc_take_number(nc_words *w, const char *what, double *value);
bool nc_take_whole(nc_words *w, const char *what, long least, long most, long *value);
bool nc_take_numbers(nc_words *w, const char *what, size_t count, double *value);
bool nc_take_name(nc_words *w, const char *what, char *name);
bool nc_take_choice(nc_words *w, const char *what, const char *const names[], int *choice);

/* Take the rest of the line, also if it is empty, as new memory. */
bool nc_take_text(nc_words *w, char **text);

/* The line must have no more words. */
bool nc_take_end(const nc_words *w);

#endif
