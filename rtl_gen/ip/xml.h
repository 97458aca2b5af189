/* SPDX-License-Identifier: MIT */
/* xml.h - elements of XML, indented. */
#ifndef SEPAX_IP_XML_H
#define SEPAX_IP_XML_H

#include "emit/text.h"

typedef struct {
  emit_text *out;
  const char *space; /* before each name: "ipxact:" */
  int depth;
} xml;

/* The declaration and a comment with the licence and who made the file. */
void xml_begin(xml *x, emit_text *out, const char *space);

/* <name attributes>, and its end, and <name/>. `attributes` is as it is written, or "". */
void xml_open(xml *x, const char *name, const char *attributes);
void xml_close(xml *x, const char *name);
void xml_empty(xml *x, const char *name, const char *attributes);

/* <name>text</name>; &, <, > and quotes of the text are replaced. */
void xml_leaf(xml *x, const char *name, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

#endif
