/* SPDX-License-Identifier: MIT */
/* tree.h - XML, read with libxml2's tree. */
#ifndef CERTIFICATE_TREE_H
#define CERTIFICATE_TREE_H

#include <libxml/tree.h>
#include <stdbool.h>
#include <stddef.h>

/* The root element of a document. One with a document type is refused, because entities could make
 * another document of it. */
xmlNode *tree_root(const char *name, const char *bytes, size_t length);
void tree_free(xmlNode *root);

bool tree_is(const xmlNode *node, const char *name);

/* Of the namespace; NULL: of any. */
bool tree_is_of(const xmlNode *node, const char *name, const char *space);

/* The first element of that name among node and those behind it, or any element; NULL: none. */
xmlNode *tree_from(xmlNode *node, const char *name);
xmlNode *tree_element(xmlNode *node);
xmlNode *tree_child(xmlNode *node, const char *name);

/* The attribute's text, which the caller frees; NULL if it is not there. */
char *tree_attribute(const xmlNode *node, const char *name, const char *space);

long tree_line(const xmlNode *node);

#endif
