/* SPDX-License-Identifier: MIT */
/* words.h - the words of a LEF or DEF file, one after the other. */
#ifndef SEPAX_LAYOUT_WORDS_H
#define SEPAX_LAYOUT_WORDS_H

#include <stdbool.h>

typedef struct {
  const char *path;
  char *next, *end; /* what is left of the text */
} words;

/* Coordinates are in units of half a nanometre: 2000 a micrometre, as DEF files say it. */
enum { UNITS = 2000 };

/* Open a text, which stays; exits with status 2 and a message where it cannot be read. */
words words_open(const char *path);

/* The next word; a message and exit status 2 at the end of the file. */
char *word(words *w);

/* Whether there is another word. */
bool words_left(words *w);

/* Take the next word if it is this one. */
bool word_is(words *w, const char *text);

/* The next word, which must be this one; a number; micrometres, in units. */
void word_want(words *w, const char *text);
double word_number(words *w);
int word_length(words *w);

/* Pass over all up to and with the next ";". */
void words_skip(words *w);

/* One line on standard error: the file, what is wrong; exit status 2. */
void words_fail(const words *w, const char *what, const char *name) __attribute__((noreturn));

#endif
