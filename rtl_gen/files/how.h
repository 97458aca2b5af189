/* SPDX-License-Identifier: MIT */
/* how.h - what a user says about the files of a design, but not about the design. */
#ifndef SEPAX_FILES_HOW_H
#define SEPAX_FILES_HOW_H

#include <stdbool.h>

/* How a design is written. All zero: as usual. */
typedef struct {
  const char *prefix; /* of modules, files and macros, in place of sepax; NULL: sepax */
  bool single_file;   /* all modules in the file of the top */
  bool absolute;      /* also PREFIX_absolute.f, the list of modules with absolute paths */
  int vectors;        /* pairs of the test bench; 0: as many as usual, -1: no test bench */
} sepax_output;

#endif
