/* SPDX-License-Identifier: MIT */
/* tree.h - the statements of a Liberty file, as they stand there. */
#ifndef SEPAX_LIBERTY_TREE_H
#define SEPAX_LIBERTY_TREE_H

#include <stddef.h>

/* A statement: name (args) { child ... } or name : value. Its args or value, without blanks and
 * quotes around them, stand in the text between from and to. */
typedef struct node {
  char *name, *args, *value;
  const char *from, *to;
  struct node *child, *next;
} node;

/* Read the statement `library` of a file, which stays; comments and continued lines become blanks.
 * Exits with status 2 and a message where the file is no Liberty file. */
const node *tree_read(const char *path);

/* The first child of this name, of this name and args; the next of the same name; a child's value,
 * its number. NULL or `other` where there is none. */
const node *tree_child(const node *n, const char *name);
const node *tree_named(const node *n, const char *name, const char *args);
const node *tree_next(const node *n);
const char *tree_value(const node *n, const char *name);
double tree_number(const node *n, const char *name, double other);

/* What a pin is to its cell, a clock gate whose latch opens while the clock is low: "clock",
 * "enable", "test" or "out"; else NULL. */
const char *tree_clock_gate(const node *cell, const node *pin);

/* A unit in SI, "1nW" or "1,pf"; `other` where the text is NULL. */
double tree_unit(const char *text, double other);

/* Copies: of so many characters; of what is between blanks and quotes. */
char *tree_copy(const char *from, size_t length);
char *tree_trimmed(const char *from, const char *to);

#endif
