/* SPDX-License-Identifier: MIT */
/* folder.h - files that come into a folder all at once, or not at all. */
#ifndef SEPAX_FILES_FOLDER_H
#define SEPAX_FILES_FOLDER_H

#include "emit/text.h"
#include "sepax_design.h"

/* A file: its text, and where it is written to. */
typedef struct {
  char *name;         /* from the folder of the design: "tb/sepax_tb.v" */
  char *path, *aside; /* where it goes; where it is written before */
  emit_text text;
  char *whole;  /* the text, when all of it is there */
  int ticket;   /* of the list of files that a signal removes (util/temporary.h) */
  bool written; /* aside, not yet renamed */
} folder_file;

typedef struct {
  const char *folder, *prefix; /* the caller's, as long as this is used */
  folder_file *file;
  int count, space;
  char *former; /* the list of modules of the design that was in the folder */
} folder_files;

/* Begin with space for `most` files. Without memory nothing can be added, and folder_write fails.
 */
void folder_init(folder_files *o, const char *folder, const char *prefix, int most);

/* A further file; at most `most`. `base` is its name without ending, with the folder in this folder
 * before it (FOLDER_TB ...), and gets the prefix in place of sepax. Returns where to write the text
 * to. Without memory the text goes nowhere, and folder_write fails. */
emit_text *folder_add(folder_files *o, const char *base, const char *ending);

/* In all texts that were added so far, names that begin with sepax_ get the prefix. */
void folder_rename(folder_files *o);

/* Make the folder, with those that it is in, and write the files, each aside and then renamed.
 * Files of a former design go that are not among these: those that its PREFIX.f lists and those
 * with a name that the generator gives, if they begin as generated ones do. All others stay, copies
 * and designs with other prefixes, too. Fails if memory was missing for a text and if a file cannot
 * be written: then no folder was made, and no file changed unless the renaming itself failed. */
bool folder_write(folder_files *o, sepax_error *error);

void folder_free(folder_files *o);

#endif
