/* SPDX-License-Identifier: MIT */
/* urdf.h - elements and attributes of URDF and SRDF. What must be there and is not, or what is not
 * known, ends the program. */
#ifndef CERTIFICATE_URDF_H
#define CERTIFICATE_URDF_H

#include "files.h"
#include "robot.h"

#include <libxml/tree.h>
#include <stdbool.h>

/* A file that is being read. */
typedef struct {
  const char *file;
  const packages *folders;
  files *files;
  bool has_quaternions; /* since 1.1 */
  long collisions;
} urdf_file;

/* One of the words, with blanks between them? */
bool urdf_is_word(const char *words, const char *word);

/* The element of that name, of which there is one, or none (NULL). */
xmlNode *urdf_single(const urdf_file *u, xmlNode *node, const char *name);

/* No attributes or elements but those named, with a blank between the names: one that is misspelt
 * would be lost. An element or attribute with a prefix belongs to another program. */
void urdf_only_attributes(const urdf_file *u, const xmlNode *node, const char *names);
void urdf_only_elements(const urdf_file *u, const xmlNode *node, const char *names);

/* An attribute that must be there. */
char *urdf_attribute(const urdf_file *u, xmlNode *node, const char *name);
long double urdf_number(const urdf_file *u, xmlNode *node, const char *name);

/* Exactly count numbers; the values stay as they are where there is no such attribute. */
void urdf_numbers(const urdf_file *u, xmlNode *node, const char *name, int count,
                  long double *value);

/* Roll about x, then pitch about y, then yaw about z, each of them fixed axes; or, since URDF 1.1,
 * a quaternion, scalar part last. */
pose urdf_origin(const urdf_file *u, xmlNode *node);

#endif
