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
  const char *stray;      /* attributes of other elements, which mean nothing here */
  const char *children;   /* children that are read; each is a row of the table */
  const char *passed;     /* children that are known to say nothing of it */
  bool open;              /* children of other names belong to other programs */
} element_row;

/* Check all elements from the root on against the table, whose first row is the root's, and which
 * ends with a row without a name. The rule: what the usual readers of the format pass over is
 * passed over and counted in `others`, unless it may be meant as something that is read; then it is
 * an error.
 *   - Children that are passed over leave the tree, so that no reader takes them. So do children
 * and attributes with a namespace prefix, which are counted as PREFIX:NAME. Errors: an unknown
 * child where the element is not open, or whose name is nearly one of the table; a child of the
 * table in a place that is not its own; what xacro has left.
 *   - Stray attributes are passed over beside an attribute that is read. Errors: all other unknown
 *     attributes, which may be misspelt.
 *   - Text between elements is passed over. Errors: text with a digit, a '$' or a word that is
 *     nearly a name of the table; text in an element without children, which may be its value. */
bool sepax__elements_check(xml_file *file, const element_row *table, sepax_robot_others *others,
                           sepax_error *error);

#endif
