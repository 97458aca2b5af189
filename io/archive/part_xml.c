/* SPDX-License-Identifier: MIT */
/* part_xml.c - a part of a package as XML, element by element, by libxml2. */
#include "archive/part_xml.h"

#include <stdarg.h>
#include <string.h>

enum { DEPTH_MOST = 256 };

bool sepax__part_xml_fail(const part_xml *x, const char *format, ...) {
  char detail[240];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  int line = x->parser != NULL && x->parser->input != NULL ? x->parser->input->line : 0;
  return sepax__package_fail(x->p, x->part, line, "%s", detail);
}

part_attribute sepax__part_attribute(const part_element *e, int n) {
  const char *const *a = (const char *const *)e->attribute + 5 * n;
  return (part_attribute){a[0], a[1], a[2], a[3], (size_t)(a[4] - a[3])};
}

bool sepax__part_value_is(const part_attribute *a, const char *text) {
  return strlen(text) == a->length && memcmp(text, a->value, a->length) == 0;
}

static void refuse(part_xml *x) {
  x->refused = true;
  xmlStopParser(x->parser);
}

static void start_element(void *context, const xmlChar *name, const xmlChar *prefix,
                          const xmlChar *space, int space_count, const xmlChar **spaces,
                          int attributes, int defaulted, const xmlChar **attribute) {
  part_xml *x = ((xmlParserCtxt *)context)->_private;
  (void)defaulted;
  part_element e = {.name = (const char *)name,
                    .prefix = (const char *)prefix,
                    .space = (const char *)space,
                    .spaces = spaces,
                    .space_count = space_count,
                    .attribute = attribute,
                    .attributes = attributes};
  if (x->refused) {
    return;
  }
  if (++x->depth > DEPTH_MOST) {
    sepax__part_xml_fail(x, "deeper than %d elements; flatten it", (int)DEPTH_MOST);
    refuse(x);
  } else if (!x->start(x, &e)) {
    refuse(x);
  }
}

static void end_element(void *context, const xmlChar *name, const xmlChar *prefix,
                        const xmlChar *space) {
  part_xml *x = ((xmlParserCtxt *)context)->_private;
  (void)name;
  (void)prefix;
  (void)space;
  if (!x->refused) {
    x->depth--;
    x->end(x);
  }
}

static void characters(void *context, const xmlChar *text, int length) {
  part_xml *x = ((xmlParserCtxt *)context)->_private;
  bool blank = true;
  for (int n = 0; n < length; n++) {
    blank = blank && strchr(" \t\r\n", text[n]) != NULL;
  }
  if (!x->refused && !blank && x->text != NULL && !x->text(x)) {
    refuse(x);
  }
}

/* A document type is where entities come from: the parser ends before it reads one. */
static void refuse_type(void *context, const xmlChar *name, const xmlChar *external,
                        const xmlChar *system) {
  part_xml *x = ((xmlParserCtxt *)context)->_private;
  (void)name;
  (void)external;
  (void)system;
  if (!x->refused) {
    sepax__part_xml_fail(x, "it has a document type (<!DOCTYPE>); take it out");
    refuse(x);
  }
}

static void no_message(void *context, const char *format, ...) {
  (void)context;
  (void)format;
}

static bool fail_parser(part_xml *x) {
  const xmlError *last = xmlCtxtGetLastError(x->parser);
  const char *text = last != NULL && last->message != NULL ? last->message : "no XML";
  return sepax__package_fail(x->p, x->part, last != NULL ? last->line : 1, "%.*s; mend the XML",
                             (int)strcspn(text, "\n"), text);
}

/* Made with the first piece, from which libxml2 tells the encoding. */
static bool begin(part_xml *x, const char *piece, size_t size) {
  static xmlSAXHandler handler = {.initialized = XML_SAX2_MAGIC,
                                  .internalSubset = refuse_type,
                                  .startElementNs = start_element,
                                  .endElementNs = end_element,
                                  .characters = characters,
                                  .cdataBlock = characters,
                                  .warning = no_message,
                                  .error = no_message};
  if (size < 4 || memchr(piece, '\0', 4) != NULL) {
    return sepax__package_fail(x->p, x->part, 1, "it is no XML in UTF-8; export it again");
  }
  x->parser = xmlCreatePushParserCtxt(&handler, NULL, piece, 4, NULL);
  if (x->parser == NULL) {
    return sepax__builder_fail_memory(x->p->b);
  }
  x->parser->_private = x;
  /* Without the limits of libxml2 on lengths, as the part is limited. Entities, against which they
   * are, need a document type; NOENT makes &amp; what it stands for. */
  xmlCtxtUseOptions(x->parser, XML_PARSE_NONET | XML_PARSE_HUGE | XML_PARSE_NOENT);
  return true;
}

static bool take(void *context, const char *piece, size_t size) {
  part_xml *x = context;
  size_t used = 0;
  if (!sepax__tag_guard(&x->guard, piece, size)) {
    return sepax__package_fail(
        x->p, x->part, 0,
        "byte %zu: a tag or comment of more than %d attributes or 1 MiB; simplify it",
        x->guard.offset, (int)TAG_ATTRIBUTES_MOST);
  }
  if (x->parser == NULL) {
    if (!begin(x, piece, size)) {
      return false;
    }
    used = 4;
  }
  int error = xmlParseChunk(x->parser, piece + used, (int)(size - used), 0);
  return !x->refused && (error == 0 || fail_parser(x));
}

bool sepax__part_xml_read(part_xml *x) {
  x->parser = NULL;
  x->depth = 0;
  x->refused = false;
  x->guard = (tag_guard){0};
  bool ok = sepax__package_stream(x->p, x->part, take, x);
  if (ok && x->parser == NULL) {
    ok = sepax__package_fail(x->p, x->part, 0, "it is empty; export it again");
  } else if (ok) {
    int error = xmlParseChunk(x->parser, NULL, 0, 1);
    ok = !x->refused && ((error == 0 && x->parser->wellFormed) || fail_parser(x));
  }
  if (x->parser != NULL) {
    xmlFreeParserCtxt(x->parser);
    x->parser = NULL;
  }
  return ok;
}
