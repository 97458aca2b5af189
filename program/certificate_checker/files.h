/* SPDX-License-Identifier: MIT */
/* files.h - the files that a certificate names, and their checks. */
#ifndef CERTIFICATE_FILES_H
#define CERTIFICATE_FILES_H

#include <jansson.h>
#include <stdbool.h>
#include <stddef.h>

typedef struct {
  json_t *list; /* an array of objects */
  bool *used;
} files;

/* `list` stays in use. */
files files_of(const char *certificate, json_t *list);

/* Reads the file `name`, which the certificate calls `as`. It must be among the files, with its
 * length and SHA-256; from then on the file is the one that `of` is about. */
char *files_read(files *f, const char *name, const char *as, size_t *length);

/* Does the certificate say this of a file? */
bool files_has(const files *f, const char *as, const char *what);

/* Check that a number or a text of a file, read as `as`, is what the certificate says. */
void files_count(const files *f, const char *as, const char *what, long double count);
void files_text(const files *f, const char *as, const char *what, const char *text);

/* Check that each file of the certificate was read. */
void files_finish(const files *f);

#endif
