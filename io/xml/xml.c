/* SPDX-License-Identifier: MIT */
/* xml.c - XML files by libxml2, without any document type. */
#include "xml/xml.h"
#include "reader/libraries.h"
#include "util/error.h"
#include "util/text.h"
#include "xml/tag_guard.h"

#include <libxml/SAX2.h>
#include <libxml/parser.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const bool sepax__libxml2_here = true;

/* Files that are no meshes: no longer than this. */
static const size_t XML_BYTES_MOST = (size_t)16 << 20;

static const char blanks[] = " \t\r\n";

long sepax__xml_line(const xmlNode *node) {
  const bool known = node != NULL && node->type == XML_TEXT_NODE && node->_private != NULL;
  return known ? (long)(intptr_t)node->_private : xmlGetLineNo(node);
}

bool sepax__xml_fail(const xml_file *file, const xmlNode *node, sepax_error *error,
                     const char *format, ...) {
  char detail[240];
  va_list args;
  va_start(args, format);
  vsnprintf(detail, sizeof detail, format, args);
  va_end(args);
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%ld: %s", file->path, sepax__xml_line(node),
                    detail);
}

bool sepax__xml_no_memory(const xml_file *file, const xmlNode *node, sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_MEMORY, "%.240s:%ld: no memory to read it", file->path,
                    sepax__xml_line(node));
}

bool sepax__xml_fail_as(const xml_file *file, const xmlNode *node, sepax_error *error,
                        const sepax_error *inner) {
  return inner->code == SEPAX_ERROR_MEMORY
             ? sepax__xml_no_memory(file, node, error)
             : sepax__xml_fail(file, node, error, "%.230s", inner->text);
}

/* ------------------------------------------------------------------------ parsing */

/* A tree takes a hundred times the bytes of the shortest element, so their number has a limit. */
enum { ELEMENTS_MOST = 4000000, DEPTH_MOST = 256 };

/* The state while a file is parsed. */
typedef struct {
  bool has_type, too_many, too_deep;
  int line;        /* line at which it is too deep */
  size_t elements; /* and attributes */
} xml_parse;

static int lines_in(const xmlChar *from, const xmlChar *to) {
  int lines = 0;
  while (from < to && (from = memchr(from, '\n', (size_t)(to - from))) != NULL) {
    from++;
    lines++;
  }
  return lines;
}

/* The parser stands behind the attributes of a tag. No '<' is among them, so the last one begins
 * the tag. */
static int line_of_tag(const xmlParserCtxt *parser) {
  const xmlChar *from = parser->input->cur;
  while (from > parser->input->base && *from != '<') {
    from--;
  }
  return parser->input->line - lines_in(from, parser->input->cur);
}

/* libxml2 has the line in which a text ends, or a piece of it. Keep the line of its first word. */
static void add_text(void *context, const xmlChar *text, int length) {
  const xmlParserCtxt *parser = context;
  int n = 0;
  xmlSAX2Characters(context, text, length);
  xmlNode *last = parser->node != NULL ? parser->node->last : NULL;
  while (n < length && strchr(blanks, text[n]) != NULL) {
    n++;
  }
  if (n < length && last != NULL && last->type == XML_TEXT_NODE && last->_private == NULL) {
    last->_private = (void *)(intptr_t)(parser->input->line - lines_in(text + n, text + length));
  }
}

static void start_element(void *context, const xmlChar *name, const xmlChar *prefix,
                          const xmlChar *space, int space_count, const xmlChar **spaces,
                          int attributes, int defaulted, const xmlChar **attribute) {
  xmlParserCtxt *parser = context;
  xml_parse *parse = parser->_private;
  parse->elements += 1 + (size_t)attributes + (size_t)space_count;
  parse->too_many = parse->elements > ELEMENTS_MOST;
  parse->too_deep = parser->nameNr > DEPTH_MOST;
  parse->line = parser->input->line;
  if (parse->too_many || parse->too_deep) {
    xmlStopParser(parser);
    return;
  }
  xmlSAX2StartElementNs(context, name, prefix, space, space_count, spaces, attributes, defaulted,
                        attribute);
  const int line = line_of_tag(parser);
  if (parser->node != NULL && line < USHRT_MAX) { /* beyond, libxml2 keeps lines in texts */
    parser->node->line = (unsigned short)line;
  }
}

/* A document type is where entities come from: the parser ends before it reads one. */
static void refuse_type(void *context, const xmlChar *name, const xmlChar *external,
                        const xmlChar *system) {
  xmlParserCtxt *parser = context;
  (void)name;
  (void)external;
  (void)system;
  ((xml_parse *)parser->_private)->has_type = true;
  xmlStopParser(parser);
}

/* It would go on behind an error, and take its time. Without memory it ends by itself; to stop it
 * then would free what the element at hand is made of. */
static void end_at_error(void *context, xmlError *error) {
  if (error->level == XML_ERR_FATAL && error->code != XML_ERR_NO_MEMORY) {
    xmlStopParser(context);
  }
}

static bool fail_parser(xmlParserCtxt *parser, const char *path, const xml_parse *parse,
                        sepax_error *error) {
  if (parse->has_type) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT,
                      "%.240s: it has a document type (<!DOCTYPE>); take it out", path);
  }
  if (parse->too_deep) {
    return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%d: deeper than %d elements; flatten it",
                      path, parse->line, (int)DEPTH_MOST);
  }
  if (parse->too_many) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "%.240s:%d: more than %d elements and attributes; simplify it", path,
                      parse->line, (int)ELEMENTS_MOST);
  }
  const xmlError *last = xmlCtxtGetLastError(parser);
  const char *text = last != NULL && last->message != NULL ? last->message : "no XML";
  return sepax_fail(error, SEPAX_ERROR_FORMAT, "%.240s:%d: %.*s; mend the XML", path,
                    last != NULL ? last->line : 1, (int)strcspn(text, "\n"), text);
}

bool sepax__xml_parse(xml_file *file, const char *path, const char *bytes, size_t size,
                      const char *root, sepax_error *error) {
  /* Without the limits of libxml2 on the length of a text, which a long mesh exceeds. Entities,
   * against which they are, need a document type. Comments are no text, so they make no nodes, and
   * what an element has is one text. */
  int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_NOENT |
                XML_PARSE_NOCDATA | XML_PARSE_BIG_LINES | XML_PARSE_HUGE;
  xml_parse parse = {0};
  tag_guard guard = {0};
  *file = (xml_file){.path = path};
  if (!sepax__tag_guard(&guard, bytes, size)) {
    return sepax_fail(
        error, SEPAX_ERROR_LIMIT,
        "%.240s, byte %zu: a tag or comment of more than %d attributes or 1 MiB; simplify it", path,
        guard.offset, (int)TAG_ATTRIBUTES_MOST);
  }
  xmlParserCtxt *parser = xmlNewParserCtxt();
  bool ok = false;
  if (parser != NULL) {
    parser->_private = &parse;
    parser->sax->internalSubset = refuse_type;
    parser->sax->startElementNs = start_element;
    parser->sax->characters = add_text;
    parser->sax->serror = end_at_error;
    parser->sax->comment = NULL;
    parser->sax->processingInstruction = NULL;
    file->doc = xmlCtxtReadMemory(parser, bytes, (int)size, NULL, NULL, options);
    ok = (file->doc != NULL && !parse.has_type && !parse.too_deep && !parse.too_many) ||
         fail_parser(parser, path, &parse, error);
    xmlFreeParserCtxt(parser);
  } else {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "%.300s: no memory to read it", path);
  }
  file->root = ok ? xmlDocGetRootElement(file->doc) : NULL;
  if (ok && (file->root == NULL || !sepax__xml_is(file->root, root))) {
    ok = sepax_fail(error, SEPAX_ERROR_FORMAT, "%.300s: its root is no <%s>; give another file",
                    path, root);
  }
  if (!ok) {
    sepax__xml_close(file);
  }
  return ok;
}

bool sepax__xml_open(xml_file *file, const char *path, const char *root, sepax_error *error) {
  text_bytes text;
  *file = (xml_file){.path = path};
  if (!sepax__text_read(&text, path, XML_BYTES_MOST, error)) {
    return false;
  }
  bool ok = sepax__xml_parse(file, path, text.bytes, text.size, root, error);
  sepax_release(text.bytes);
  return ok;
}

void sepax__xml_close(xml_file *file) {
  if (file->doc != NULL) {
    xmlFreeDoc(file->doc);
  }
  *file = (xml_file){.path = file->path};
}

/* ----------------------------------------------------------------------- elements */

bool sepax__xml_is(const xmlNode *node, const char *name) {
  return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0;
}

static xmlNode *first_from(xmlNode *node, const char *name) {
  while (node != NULL &&
         !(node->type == XML_ELEMENT_NODE && (name == NULL || sepax__xml_is(node, name)))) {
    node = node->next;
  }
  return node;
}

xmlNode *sepax__xml_child(const xmlNode *node, const char *name) {
  return node != NULL ? first_from(node->children, name) : NULL;
}

xmlNode *sepax__xml_next(const xmlNode *node, const char *name) {
  return first_from(node->next, name);
}

bool sepax__xml_single(const xml_file *file, const xmlNode *node, const char *name,
                       xmlNode **single, sepax_error *error) {
  *single = sepax__xml_child(node, name);
  const xmlNode *second = *single != NULL ? sepax__xml_next(*single, name) : NULL;
  return second == NULL || sepax__xml_fail(file, second, error,
                                           "a second <%.40s> in one <%.40s>; leave one of them out",
                                           (const char *)second->name, (const char *)node->name);
}

bool sepax__xml_has(const xmlNode *node, const char *attribute) {
  return xmlHasNsProp(node, (const xmlChar *)attribute, NULL) != NULL;
}

static bool is_printable(const char *text) {
  for (const char *c = text; *c != '\0'; c++) {
    if ((unsigned char)*c < ' ' || *c == 0x7f) {
      return false;
    }
  }
  return text[0] != '\0';
}

bool sepax__xml_name(const xml_file *file, const xmlNode *node, const char *attribute, char **name,
                     sepax_error *error) {
  xmlChar *value = node != NULL ? xmlGetNoNsProp(node, (const xmlChar *)attribute) : NULL;
  if (value == NULL) {
    return sepax__xml_fail(file, node, error, "<%.40s> without %s=\"...\"; name it",
                           node != NULL ? (const char *)node->name : "", attribute);
  }
  size_t size = strlen((const char *)value) + 1;
  char *copy = sepax_allocate(size);
  if (copy != NULL) {
    memcpy(copy, value, size);
  }
  xmlFree(value);
  if (copy == NULL) {
    return sepax__xml_no_memory(file, node, error);
  }
  if (!is_printable(copy)) {
    sepax_release(copy);
    return sepax__xml_fail(file, node, error, "%s=\"...\" is empty, or not printable; give a name",
                           attribute);
  }
  *name = copy;
  return true;
}

static int scan_numbers(const char *text, double *number, int count) {
  int found = 0;
  for (const char *word = text + strspn(text, blanks); *word != '\0'; found++) {
    size_t length = strcspn(word, blanks);
    double beyond;
    if (!sepax__number(word, length, found < count ? &number[found] : &beyond)) {
      return -1;
    }
    word += length;
    word += strspn(word, blanks);
  }
  return found;
}

bool sepax__xml_numbers(const xml_file *file, const xmlNode *node, const char *attribute,
                        double *number, int count, sepax_error *error) {
  xmlChar *value = xmlGetNoNsProp(node, (const xmlChar *)attribute);
  if (value == NULL) {
    return !sepax__xml_has(node, attribute) || sepax__xml_no_memory(file, node, error);
  }
  int found = scan_numbers((const char *)value, number, count);
  bool ok = found == count ||
            sepax__xml_fail(file, node, error, "%s=\"%.60s\": give %d finite number%s", attribute,
                            (const char *)value, count, count == 1 ? "" : "s");
  xmlFree(value);
  return ok;
}
