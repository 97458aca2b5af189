/* SPDX-License-Identifier: MIT */
/* core.c - the elements of the core specification of 3MF, and their attributes. */
#include "archive/core.h"
#include "util/text.h"

#include <string.h>

#define XML_SPACE "http://www.w3.org/XML/1998/namespace"

#define IN(element) (1u << CORE_##element)

/* For each element: the elements that it may be in, and its attributes. Attributes after '|' have
 * no surface and are named in the account. Slicers write some of them without a prefix, for how
 * triangles are painted and how items are arranged. */
static const struct {
  const char *name;
  unsigned parents;
  const char *attributes;
} core[CORE_ELEMENTS] = {
    [CORE_MODEL] = {"model", IN(OUTSIDE), " unit requiredextensions recommendedextensions "},
    [CORE_METADATA] = {"metadata", IN(MODEL) | IN(METADATAGROUP) | IN(RESOURCES) | IN(OBJECT),
                       " name preserve type "},
    [CORE_RESOURCES] = {"resources", IN(MODEL), " "},
    [CORE_BASEMATERIALS] = {"basematerials", IN(RESOURCES), " id displaypropertiesid "},
    [CORE_BASE] = {"base", IN(BASEMATERIALS), " name displaycolor displaypropertiesid "},
    [CORE_OBJECT] = {"object", IN(RESOURCES),
                     " id type thumbnail partnumber name pid pindex | instances_count "},
    [CORE_METADATAGROUP] = {"metadatagroup", IN(OBJECT) | IN(ITEM), " "},
    [CORE_MESH] = {"mesh", IN(OBJECT), " "},
    [CORE_VERTICES] = {"vertices", IN(MESH), " "},
    [CORE_VERTEX] = {"vertex", IN(VERTICES), " x y z "},
    [CORE_TRIANGLES] = {"triangles", IN(MESH), " "},
    [CORE_TRIANGLE] = {"triangle", IN(TRIANGLES),
                       " v1 v2 v3 p1 p2 p3 pid | paint_color paint_supports paint_seam "
                       "paint_fuzzy_skin face_property "},
    [CORE_COMPONENTS] = {"components", IN(OBJECT), " "},
    [CORE_COMPONENT] = {"component", IN(COMPONENTS), " objectid transform "},
    [CORE_BUILD] = {"build", IN(MODEL), " "},
    [CORE_ITEM] = {"item", IN(BUILD),
                   " objectid transform partnumber printable | auto_drop instances_count "},
};

core_element sepax__core_find(core_element parent, const char *name) {
  for (int n = CORE_MODEL; n < CORE_ELEMENTS; n++) {
    if ((core[n].parents & 1u << parent) != 0 && strcmp(core[n].name, name) == 0) {
      return (core_element)n;
    }
  }
  return CORE_OUTSIDE;
}

const char *sepax__core_name(core_element which) { return core[which].name; }

/* "slic3rpe:mmu_segmentation attributes". */
bool sepax__core_name_foreign(part_xml *x, const char *prefix, const char *name, const char *what) {
  char text[60];
  snprintf(text, sizeof text, "%.16s%s%.27s %s", prefix != NULL ? prefix : "",
           prefix != NULL ? ":" : "", name, what);
  return sepax__builder_other(x->p->b, text, 1);
}

/* ---------------------------------------------------------------------- attributes */

static bool check_core_attribute(part_xml *x, core_element which, const char *name) {
  char word[64];
  const char *all = core[which].attributes;
  const char *bar = strchr(all, '|');
  snprintf(word, sizeof word, " %.60s ", name);
  const char *found = strstr(all, word);
  if (found == NULL || strchr(name, ' ') != NULL || name[0] == '|') {
    return sepax__part_xml_fail(x, "<%s %.40s=...> is not in the specification; export it again",
                                core[which].name, name);
  }
  return bar == NULL || found < bar || sepax__core_name_foreign(x, NULL, name, "attributes");
}

bool sepax__core_check_attributes(part_xml *x, core_element which, const part_element *e) {
  for (int n = 0; n < e->attributes; n++) {
    part_attribute a = sepax__part_attribute(e, n);
    bool uuid = a.space != NULL && strcmp(a.space, PRODUCTION_SPACE) == 0;
    bool path =
        uuid && strcmp(a.name, "path") == 0 && (which == CORE_ITEM || which == CORE_COMPONENT);
    bool ok = true;
    if (a.prefix != NULL && a.space == NULL) {
      ok = sepax__part_xml_fail(x, "%.40s:%.40s has a prefix without a namespace; export it again",
                                a.prefix, a.name);
    } else if (sepax__is_core(a.space)) {
      ok = check_core_attribute(x, which, a.name);
    } else if (strcmp(a.space, ALTERNATIVES_SPACE) == 0 && strcmp(a.name, "MustUnderstand") == 0) {
      ok =
          sepax__part_xml_fail(x, "MustUnderstand=\"%.*s\" is not read; export the file without it",
                               (int)(a.length < 60 ? a.length : 60), a.value);
    } else if (!path && strcmp(a.space, XML_SPACE) != 0) {
      ok = sepax__core_name_foreign(x, a.prefix, a.name, "attributes");
    }
    if (!ok) {
      return false;
    }
  }
  return true;
}

bool sepax__core_attribute(const part_element *e, const char *name, part_attribute *a) {
  for (int n = 0; n < e->attributes; n++) {
    *a = sepax__part_attribute(e, n);
    if (sepax__is_core(a->space) && strcmp(a->name, name) == 0) {
      return true;
    }
  }
  return false;
}

static void trim(part_attribute *a) {
  while (a->length > 0 && sepax__is_blank(a->value[0])) {
    a->value++;
    a->length--;
  }
  while (a->length > 0 && sepax__is_blank(a->value[a->length - 1])) {
    a->length--;
  }
}

bool sepax__core_number(part_xml *x, const part_attribute *given, double *value) {
  part_attribute a = *given;
  trim(&a);
  return (a.length > 0 && sepax__number(a.value, a.length, value)) ||
         sepax__part_xml_fail(x, "%s=\"%.*s\": give a finite number", a.name,
                              (int)(a.length < 40 ? a.length : 40), a.value);
}

/* Read a whole number in 0 ... 2^31 - 1. */
bool sepax__core_whole(part_xml *x, const part_attribute *given, size_t *value) {
  part_attribute a = *given;
  size_t number = 0;
  trim(&a);
  bool ok = a.length > 0 && a.length <= 10;
  for (size_t n = 0; n < a.length && ok; n++) {
    ok = a.value[n] >= '0' && a.value[n] <= '9';
    number = 10 * number + (size_t)(a.value[n] - '0');
  }
  *value = number;
  return (ok && number <= INT32_MAX) ||
         sepax__part_xml_fail(x, "%s=\"%.*s\": give a whole number of 0 ... 2147483647", a.name,
                              (int)(a.length < 40 ? a.length : 40), a.value);
}

bool sepax__core_required_whole(part_xml *x, core_element which, const part_element *e,
                                const char *name, size_t *value) {
  part_attribute a;
  if (!sepax__core_attribute(e, name, &a)) {
    return sepax__part_xml_fail(x, "<%s> without %s=\"...\"; export it again", core[which].name,
                                name);
  }
  return sepax__core_whole(x, &a, value);
}
