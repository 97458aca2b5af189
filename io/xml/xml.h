/* SPDX-License-Identifier: MIT */
/* xml.h - XML files by libxml2, without any document type (private). */
#ifndef SEPAX_XML_H
#define SEPAX_XML_H

#include "sepax.h"

#include <libxml/tree.h>
#include <stdio.h>

/* An XML file: its path for messages, and its root. */
typedef struct {
  const char *path;
  xmlDoc *doc;
  xmlNode *root;
} xml_file;

/* No document type is accepted, so no entity, and nothing is fetched. Fails also where the root is
 * no <root>. Free with xml_close. */
bool sepax__xml_open(xml_file *file, const char *path, const char *root, sepax_error *error);
/* The same of bytes that were read, however many. */
bool sepax__xml_parse(xml_file *file, const char *path, const char *bytes, size_t size,
                      const char *root, sepax_error *error);
void sepax__xml_close(xml_file *file);

/* The line of the file in which an element's tag begins, or in which a text has its first word. */
long sepax__xml_line(const xmlNode *node);

/* "PATH:LINE: ..."; false. */
bool sepax__xml_fail(const xml_file *file, const xmlNode *node, sepax_error *error,
                     const char *format, ...) __attribute__((format(printf, 4, 5)));

/* The same, of a lack of memory. */
bool sepax__xml_no_memory(const xml_file *file, const xmlNode *node, sepax_error *error);
/* The same, of what another function says. */
bool sepax__xml_fail_as(const xml_file *file, const xmlNode *node, sepax_error *error,
                        const sepax_error *inner);

/* The first element of this name below the node, and the next one of this name after a node. NULL
 * means any name. */
xmlNode *sepax__xml_child(const xmlNode *node, const char *name);
xmlNode *sepax__xml_next(const xmlNode *node, const char *name);
bool sepax__xml_is(const xmlNode *node, const char *name);

/* The only element of this name below the node; NULL if there is none. Fails if there are two. */
bool sepax__xml_single(const xml_file *file, const xmlNode *node, const char *name,
                       xmlNode **single, sepax_error *error);

/* A copy of the attribute, by sepax_allocate; it is printable and not empty. Fails if it is
 * missing. */
bool sepax__xml_name(const xml_file *file, const xmlNode *node, const char *attribute, char **name,
                     sepax_error *error);

/* Read the `count` numbers of the attribute. Without the attribute the values stay. */
bool sepax__xml_numbers(const xml_file *file, const xmlNode *node, const char *attribute,
                        double *number, int count, sepax_error *error);
bool sepax__xml_has(const xmlNode *node, const char *attribute);

#endif
