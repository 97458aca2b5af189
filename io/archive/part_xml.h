/* SPDX-License-Identifier: MIT */
/* part_xml.h - a part of a package as XML, element by element (private). */
#ifndef SEPAX_PART_XML_H
#define SEPAX_PART_XML_H

#include "archive/package.h"
#include "xml/tag_guard.h"

#include <libxml/parser.h>

/* An attribute; its value has no '\0' behind it. */
typedef struct {
  const char *name, *prefix, *space; /* prefix and namespace NULL: none */
  const char *value;
  size_t length;
} part_attribute;

typedef struct {
  const char *name, *prefix, *space;
  const xmlChar **spaces; /* pairs of prefix (NULL: default) and namespace declared here */
  int space_count;
  const xmlChar **attribute; /* five pointers each, as libxml2 has them */
  int attributes;
} part_element;

typedef struct part_xml part_xml;
struct part_xml {
  package *p;
  size_t part;
  /* False: refused, the error is set. */
  bool (*start)(part_xml *x, const part_element *e);
  void (*end)(part_xml *x);
  bool (*text)(part_xml *x); /* of text that is not blank; NULL: not called */
  void *context;
  /* Of part_xml.c: */
  xmlParserCtxt *parser;
  size_t depth;
  bool refused;
  tag_guard guard;
};

/* Parse the part: no document type, so no entities; no depth of more than 256; UTF-8 alone. Memory
 * is that of the longest element. */
bool sepax__part_xml_read(part_xml *x);

part_attribute sepax__part_attribute(const part_element *e, int n);
bool sepax__part_value_is(const part_attribute *a, const char *text);

/* "PATH, part NAME:LINE: ..." of the line where the parser is; false. */
bool sepax__part_xml_fail(const part_xml *x, const char *format, ...)
    __attribute__((format(printf, 2, 3)));

#endif
