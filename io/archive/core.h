/* SPDX-License-Identifier: MIT */
/* core.h - the elements of the core specification of 3MF, and their attributes (private). */
#ifndef SEPAX_CORE_H
#define SEPAX_CORE_H

#include "archive/part_xml.h"

#include <string.h>

#define CORE_SPACE "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#define PRODUCTION_SPACE "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
#define ALTERNATIVES_SPACE "http://schemas.openxmlformats.org/markup-compatibility/2006"

/* The elements of the core specification; OUTSIDE is the place of the root. */
typedef enum {
  CORE_OUTSIDE,
  CORE_MODEL,
  CORE_METADATA,
  CORE_RESOURCES,
  CORE_BASEMATERIALS,
  CORE_BASE,
  CORE_OBJECT,
  CORE_METADATAGROUP,
  CORE_MESH,
  CORE_VERTICES,
  CORE_VERTEX,
  CORE_TRIANGLES,
  CORE_TRIANGLE,
  CORE_COMPONENTS,
  CORE_COMPONENT,
  CORE_BUILD,
  CORE_ITEM,
  CORE_ELEMENTS
} core_element;

/* The element of this name in `parent`, or CORE_OUTSIDE if the specification has none there. */
core_element sepax__core_find(core_element parent, const char *name);
const char *sepax__core_name(core_element which);

/* Refuse attributes that the specification does not have, and name those that are passed over. */
bool sepax__core_check_attributes(part_xml *x, core_element which, const part_element *e);

/* Name in the account what is passed over: "slic3rpe:mmu_segmentation attributes". */
bool sepax__core_name_foreign(part_xml *x, const char *prefix, const char *name, const char *what);

/* Find an attribute of the specification. */
bool sepax__core_attribute(const part_element *e, const char *name, part_attribute *a);

bool sepax__core_number(part_xml *x, const part_attribute *given, double *value);

/* A whole number in 0 ... 2^31 - 1. */
bool sepax__core_whole(part_xml *x, const part_attribute *given, size_t *value);

/* The same of an attribute that the element must have. */
bool sepax__core_required_whole(part_xml *x, core_element which, const part_element *e,
                                const char *name, size_t *value);

/* True of the namespace of the specification; attributes of it have none. */
static inline bool sepax__is_core(const char *space) {
  return space == NULL || strcmp(space, CORE_SPACE) == 0;
}

static inline bool sepax__is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

#endif
