/* SPDX-License-Identifier: MIT */
/* threemf.c - the reader of 3MF: the package, its model parts, their objects where it builds them.
 *
 * All parts named .model are read, and those that p:path refers to, so that a mesh that nothing
 * refers to is counted as unplaced, and is not passed over. */
#include "archive/model.h"
#include "reader/format_table.h"

#include <string.h>
#include <strings.h>

const bool sepax__libzip_here = true;

#define RELATIONS_SPACE "http://schemas.openxmlformats.org/package/2006/relationships"
#define MODEL_TYPE "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"

bool sepax__threemf_is(const char *bytes, size_t size) {
  return size > 4 && memcmp(bytes, "PK\3\4", 4) == 0;
}

/* -------------------------------------------------------------------- relationships */

typedef struct {
  long root;
} relations;

static bool is_attribute(const part_attribute *a, const char *name) {
  return a->space == NULL && a->prefix == NULL && strcmp(a->name, name) == 0;
}

static bool read_relation(part_xml *x, const part_element *e) {
  relations *found = x->context;
  char target[1024] = "";
  bool is_model = false;
  bool outside = false;
  for (int n = 0; n < e->attributes; n++) {
    part_attribute a = sepax__part_attribute(e, n);
    if (is_attribute(&a, "Target")) {
      snprintf(target, sizeof target, "%.*s", (int)(a.length < 1023 ? a.length : 1023), a.value);
    }
    is_model = is_model || (is_attribute(&a, "Type") && sepax__part_value_is(&a, MODEL_TYPE));
    outside = outside || (is_attribute(&a, "TargetMode") && sepax__part_value_is(&a, "External"));
  }
  if (!is_model) {
    return true;
  }
  /* A name of a part has no "//" in it; that of a place elsewhere has a scheme before it. */
  if (outside || strstr(target, "://") != NULL) {
    return sepax__part_xml_fail(x, "its model %.80s is outside of the package; export it again",
                                target);
  }
  if (found->root != NO_PART) {
    return sepax__part_xml_fail(x, "a second model, %.80s; leave one of them out", target);
  }
  found->root = sepax__package_find(x->p, target);
  return found->root != NO_PART ||
         sepax__part_xml_fail(x, "its model %.80s is not in the package; export it again", target);
}

static bool start_relation(part_xml *x, const part_element *e) {
  bool ours = e->space != NULL && strcmp(e->space, RELATIONS_SPACE) == 0;
  if (x->depth == 1) {
    return (ours && strcmp(e->name, "Relationships") == 0) ||
           sepax__part_xml_fail(x, "its root is no <Relationships> of %s; export it again",
                                RELATIONS_SPACE);
  }
  return !ours || strcmp(e->name, "Relationship") != 0 || read_relation(x, e);
}

static void end_relation(part_xml *x) { (void)x; }

static bool find_root(model *m) {
  relations found = {.root = NO_PART};
  long part = sepax__package_find(&m->p, "/_rels/.rels");
  if (part == NO_PART) {
    return sepax__builder_fail(m->p.b, "the archive has no part _rels/.rels, so it is no 3MF; give "
                                       "a 3MF, or what is in the archive");
  }
  part_xml x = {.p = &m->p,
                .part = (size_t)part,
                .start = start_relation,
                .end = end_relation,
                .context = &found};
  if (!sepax__part_xml_read(&x)) {
    return false;
  }
  m->root = (size_t)found.root;
  return found.root != NO_PART ||
         sepax__package_fail(&m->p, (size_t)part, 0,
                             "it has no relationship to a 3dmodel, so it is no 3MF; export it "
                             "again");
}

/* ---------------------------------------------------------------------------- parts */

static bool ends_with(const char *name, const char *ending) {
  size_t length = strlen(name);
  size_t size = strlen(ending);
  return length >= size && strcasecmp(name + length - size, ending) == 0;
}

/* What macOS puts into archives beside the files is no part. */
static bool is_model_name(const char *name) {
  return ends_with(name, ".model") && strncmp(name, "__MACOSX/", 9) != 0;
}

static bool read_parts(model *m) {
  package *p = &m->p;
  if (!sepax__model_read(m, m->root)) {
    return false;
  }
  for (size_t n = 0; n < p->parts; n++) {
    p->part[n].is_model = p->part[n].is_model || is_model_name(p->part[n].name);
  }
  bool again = true;
  while (again) {
    again = false;
    for (size_t n = 0; n < p->parts; n++) {
      if (p->part[n].is_model && !p->part[n].was_read) {
        if (!sepax__model_read(m, n)) {
          return false;
        }
        again = true;
      }
    }
  }
  return true;
}

static bool name_other_parts(const package *p) {
  static const char *const images[] = {".png", ".jpg", ".jpeg"};
  for (size_t n = 0; n < p->parts; n++) {
    const char *name = p->part[n].name;
    bool image = false;
    for (int i = 0; i < 3; i++) {
      image = image || ends_with(name, images[i]);
    }
    bool named = !p->part[n].was_read && !ends_with(name, ".rels") &&
                 strcasecmp(name, "[Content_Types].xml") != 0;
    if (named && !sepax__builder_other(
                     p->b, image ? "images" : "parts of the package that are no models", 1)) {
      return false;
    }
  }
  return true;
}

bool sepax__threemf_read(mesh_builder *b, size_t *faces) {
  model m = {0};
  bool ok = sepax__package_open(&m.p, b) && find_root(&m) && read_parts(&m) &&
            sepax__model_place(&m, &b->account.unplaced) && name_other_parts(&m.p) &&
            sepax__slicer_volumes(&m.p);
  *faces = m.triangles;
  sepax__package_close(&m.p);
  sepax_release(m.vertex);
  sepax_release(m.triangle);
  sepax_release(m.object);
  sepax_release(m.component);
  sepax_release(m.item);
  return ok;
}
