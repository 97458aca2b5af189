/* SPDX-License-Identifier: MIT */
/* tree.c - XML, read with libxml2's tree. */
#include "tree.h"

#include "report.h"

#include <libxml/parser.h>
#include <limits.h>
#include <string.h>

/* What libxml2 would print. */
static void be_silent(void *unused, const char *format, ...) {
  (void)unused;
  (void)format;
}

/* XML_PARSE_HUGE lifts the limit on the length of a text, which large meshes exceed. Without a
 * document type there are no entities, so no text becomes longer than the file. */
xmlNode *tree_root(const char *name, const char *bytes, size_t length) {
  if (length > INT_MAX)
    cannot("%s: is longer than 2 GiB", name);
  if (memchr(bytes, 0, length) != NULL)
    cannot("%s: is no XML: a byte 0 (only UTF-8 is read)", name);
  if (strstr(bytes, "<!DOCTYPE") != NULL)
    cannot("%s: has a document type", name);
  xmlSetGenericErrorFunc(NULL, be_silent);
  const int options = XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING | XML_PARSE_HUGE |
                      XML_PARSE_COMPACT | XML_PARSE_NOBLANKS | XML_PARSE_BIG_LINES;
  xmlDoc *doc = xmlReadMemory(bytes, (int)length, name, NULL, options);
  const xmlError *wrong = doc == NULL ? xmlGetLastError() : NULL;
  const char *why = wrong != NULL && wrong->message != NULL ? wrong->message : "";
  if (doc == NULL)
    cannot("%s:%d: is no XML: %.*s", name, wrong != NULL ? wrong->line : 1, (int)strcspn(why, "\n"),
           why);
  if (doc->intSubset != NULL || doc->extSubset != NULL)
    cannot("%s: has a document type", name);
  xmlNode *root = xmlDocGetRootElement(doc);
  if (root == NULL)
    cannot("%s: has no element", name);
  return root;
}

void tree_free(xmlNode *root) { xmlFreeDoc(root->doc); }

bool tree_is_of(const xmlNode *node, const char *name, const char *space) {
  return node->type == XML_ELEMENT_NODE && strcmp((const char *)node->name, name) == 0 &&
         (space == NULL || (node->ns != NULL && strcmp((const char *)node->ns->href, space) == 0));
}

bool tree_is(const xmlNode *node, const char *name) { return tree_is_of(node, name, NULL); }

xmlNode *tree_from(xmlNode *node, const char *name) {
  while (node != NULL && !tree_is(node, name))
    node = node->next;
  return node;
}

xmlNode *tree_element(xmlNode *node) {
  while (node != NULL && node->type != XML_ELEMENT_NODE)
    node = node->next;
  return node;
}

xmlNode *tree_child(xmlNode *node, const char *name) {
  return node == NULL ? NULL : tree_from(node->children, name);
}

char *tree_attribute(const xmlNode *node, const char *name, const char *space) {
  return (char *)(space == NULL
                      ? xmlGetNoNsProp(node, (const xmlChar *)name)
                      : xmlGetNsProp(node, (const xmlChar *)name, (const xmlChar *)space));
}

long tree_line(const xmlNode *node) { return xmlGetLineNo(node); }
