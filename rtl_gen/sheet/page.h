/* SPDX-License-Identifier: MIT */
/* page.h - a page as Markdown or as HTML, by the same calls. Texts have `code` between backticks;
 * all other characters stand for themselves. */
#ifndef SEPAX_SHEET_PAGE_H
#define SEPAX_SHEET_PAGE_H

#include "emit/text.h"

#include <stdbool.h>

typedef struct {
  emit_text *out;
  bool html;
  int columns; /* of the table that is open */
} page;

void page_begin(page *p, emit_text *out, bool html, const char *title);
void page_end(page *p);
void page_section(page *p, const char *title);
void page_text(page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
void page_code(page *p, const char *text);

/* A table: its heads, then rows of as many cells each, then its end. The texts are separated by
 * tabs. */
void page_table(page *p, const char *heads);
void page_row(page *p, const char *format, ...) __attribute__((format(printf, 2, 3)));
void page_table_end(page *p);

/* A picture: in Markdown a link to `file`, in HTML the SVG itself. */
void page_picture(page *p, const char *about, const char *file, const char *svg);

#endif
