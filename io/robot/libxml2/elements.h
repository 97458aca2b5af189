/* SPDX-License-Identifier: MIT */
/* elements.h - the table of a format's elements and attributes (private). */
#ifndef SEPAX_ELEMENTS_H
#define SEPAX_ELEMENTS_H

#include "robot/robot.h"
#include "xml/xml.h"

/* A row of the table: an element that is read. Lists are words separated by blanks. */
typedef struct {
  const char *name;
  const char *attributes; /* attributes that are read */
  const char *idle;       /* attributes that are known to say nothing of collision geometry */
  const char *children;   /* children that are read; each is a row of the table */
  const char *passed;     /* children that are known to say nothing of it */
  bool open;              /* children of other names belong to other programs */
} element_row;

/* Check all elements from the root on against the table, whose first row is the root's, and which
 * ends with a row without a name. Children that are passed over are counted in `others` and leave
 * the tree, so that no reader takes them; so do children and attributes with a namespace prefix,
 * which are counted as PREFIX:NAME. Errors: an unknown attribute; an unknown child where the
 * element is not open, or whose name is nearly one of the table; a child of the table in a place
 * that is not its own; text; what xacro has left. */
bool sepax__elements_check(xml_file *file, const element_row *table, sepax_robot_others *others,
                           sepax_error *error);

#endif
