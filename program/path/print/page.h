/* SPDX-License-Identifier: MIT */
/* page.h - what page.c and page_program.c share. */
#ifndef SEPAX_PATH_PAGE_H
#define SEPAX_PATH_PAGE_H

#include "path/common/parts.h"
#include "util/text.h"

#include <stdio.h>

enum { PROGRAMS = 2, PATH_PAGE_TEXT = 16 << 20 };

typedef struct {
  const path_scene *scene;
  const path_question *q;
  text_bytes program[PROGRAMS];
  path_moment
      *step; /* the lines, and the moments between lines that are not free, in the order of time */
  size_t steps;
} page;

/* A callback of jansson: write JSON that stands between <script> and </script>, so its strings must
 * not contain "<". */
int path_page_put(const char *text, size_t length, void *out);

/* Write what the path says of the program that it comes from, and the text of the program. */
void path_page_program(FILE *out, const page *p);

#endif
