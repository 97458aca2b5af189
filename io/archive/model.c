/* SPDX-License-Identifier: MIT */
/* model.c - a model part of a 3MF package: its objects and items, element by element. */
#include "archive/model.h"
#include "archive/core.h"
#include "util/list.h"

#include <string.h>

enum { DEPTH_MOST = 257 };

/* The state while a part is read. */
typedef struct {
  model *m;
  core_element open[DEPTH_MOST]; /* the open elements */
  size_t depth;
  size_t foreign; /* number of open elements from an element of another namespace on */
  unsigned seen;  /* bits of the elements that a model has only once and that were seen */
  unsigned in_object;
} reading;

static mesh_builder *builder(const part_xml *x) { return x->p->b; }

/* ------------------------------------------------------------------------- the model */

static bool read_unit(part_xml *x, reading *r, const part_element *e) {
  static const struct {
    const char *name;
    double mm;
  } units[] = {{"micron", 0.001}, {"millimeter", 1}, {"centimeter", 10},
               {"inch", 25.4},    {"foot", 304.8},   {"meter", 1000}};
  sepax_mesh_account *account = &builder(x)->account;
  part_attribute a;
  size_t n = 1;
  if (sepax__core_attribute(e, "unit", &a)) {
    n = 0;
    while (n < 6 && !sepax__part_value_is(&a, units[n].name)) {
      n++;
    }
  }
  if (n == 6) {
    return sepax__part_xml_fail(x,
                                "unit=\"%.*s\": give micron, millimeter, centimeter, inch, foot or "
                                "meter",
                                (int)(a.length < 40 ? a.length : 40), a.value);
  }
  if (x->part == r->m->root) {
    snprintf(account->unit, sizeof account->unit, "%s", units[n].name);
    account->unit_mm = units[n].mm;
  }
  return account->unit_mm == units[n].mm ||
         sepax__part_xml_fail(
             x, "its unit is %s, but the unit of the root part is %s; export it again",
             units[n].name, account->unit);
}

static const char *space_of_prefix(const part_element *e, const char *prefix, size_t length) {
  for (int n = 0; n < e->space_count; n++) {
    const char *declared = (const char *)e->spaces[2 * n];
    if (declared != NULL && strlen(declared) == length && memcmp(declared, prefix, length) == 0) {
      return (const char *)e->spaces[2 * n + 1];
    }
  }
  return NULL;
}

static bool require_extension(part_xml *x, const part_element *e, const char *prefix,
                              size_t length) {
  const char *space = space_of_prefix(e, prefix, length);
  int shown = (int)(length < 40 ? length : 40);
  if (space == NULL) {
    return sepax__part_xml_fail(x,
                                "it requires the extension \"%.*s\", but has no namespace of this "
                                "prefix; export it again",
                                shown, prefix);
  }
  return sepax__is_core(space) || sepax__model_extension(space) == EXTENSION_READ ||
         sepax__part_xml_fail(x,
                              "it requires the extension %.*s (%.100s), which is not read; export "
                              "triangles alone",
                              shown, prefix, space);
}

static bool read_model(part_xml *x, reading *r, const part_element *e) {
  part_attribute a;
  if (sepax__core_attribute(e, "requiredextensions", &a)) {
    size_t at = 0;
    while (at < a.length) {
      size_t length = 0;
      while (at + length < a.length && !sepax__is_blank(a.value[at + length])) {
        length++;
      }
      if (length > 0 && !require_extension(x, e, a.value + at, length)) {
        return false;
      }
      at += length + 1;
    }
  }
  return read_unit(x, r, e);
}

/* ------------------------------------------------------------------ objects and items */

static bool read_object(part_xml *x, reading *r, const part_element *e) {
  static const char *const types[] = {"model", "solidsupport", "support", "surface", "other"};
  model *m = r->m;
  part_attribute a;
  size_t id = 0;
  size_t type = 0;
  if (!sepax__core_required_whole(x, CORE_OBJECT, e, "id", &id)) {
    return false;
  }
  if (sepax__core_attribute(e, "type", &a)) {
    while (type < 5 && !sepax__part_value_is(&a, types[type])) {
      type++;
    }
  }
  if (type == 5) {
    return sepax__part_xml_fail(
        x, "object %zu: type=\"%.*s\": give model, solidsupport, support, surface or other", id,
        (int)(a.length < 40 ? a.length : 40), a.value);
  }
  model_object *grown = list_grow(m->object, &m->object_space, m->objects, sizeof *grown);
  if (grown == NULL) {
    return sepax__builder_fail_memory(builder(x));
  }
  m->object = grown;
  m->object[m->objects++] = (model_object){
      .part = x->part, .id = id, .line = x->parser->input->line, .is_other = type == 4};
  r->in_object = 0;
  return (type != 1 && type != 2) ||
         sepax__builder_other(builder(x), "printing supports, which are read", 1);
}

static bool read_once(part_xml *x, unsigned *seen, core_element which) {
  bool again = (*seen & 1u << which) != 0;
  *seen |= 1u << which;
  return !again ||
         sepax__part_xml_fail(x, "a second <%s>; leave one of them out", sepax__core_name(which));
}

/* The object that is being read. */
static model_object *current(const reading *r) { return &r->m->object[r->m->objects - 1]; }

static bool read_mesh_or_components(part_xml *x, reading *r, core_element which) {
  model_object *o = current(r);
  if (!read_once(x, &r->in_object, which)) {
    return false;
  }
  if ((r->in_object & 1u << CORE_MESH) != 0 && (r->in_object & 1u << CORE_COMPONENTS) != 0) {
    return sepax__part_xml_fail(x, "object %zu has a mesh and components; give one of them", o->id);
  }
  o->is_mesh = which == CORE_MESH;
  o->first = which == CORE_MESH ? r->m->triangles : r->m->components;
  o->vertex = r->m->vertices;
  return true;
}

static bool read_vertex(part_xml *x, reading *r, const part_element *e) {
  model *m = r->m;
  double v[3];
  unsigned got = 0;
  for (int n = 0; n < e->attributes; n++) {
    part_attribute a = sepax__part_attribute(e, n);
    if (sepax__is_core(a.space)) {
      int axis = a.name[0] - 'x';
      if (!sepax__core_number(x, &a, &v[axis])) {
        return false;
      }
      got |= 1u << axis;
    }
  }
  if (got != 7) {
    return sepax__part_xml_fail(x, "<vertex> without x, y and z; export it again");
  }
  double(*grown)[3] = list_grow(m->vertex, &m->vertex_space, m->vertices, sizeof *grown);
  if (grown == NULL) {
    return sepax__builder_fail_memory(builder(x));
  }
  m->vertex = grown;
  memcpy(m->vertex[m->vertices++], v, sizeof v);
  return true;
}

static bool read_triangle(part_xml *x, reading *r, const part_element *e) {
  model *m = r->m;
  uint32_t corner[3];
  size_t vertices = m->vertices - current(r)->vertex;
  unsigned got = 0;
  for (int n = 0; n < e->attributes; n++) {
    part_attribute a = sepax__part_attribute(e, n);
    if (sepax__is_core(a.space) && a.name[0] == 'v') {
      size_t index;
      int k = a.name[1] - '1';
      if (!sepax__core_whole(x, &a, &index)) {
        return false;
      }
      if (index >= vertices) {
        return sepax__part_xml_fail(x, "%s=\"%zu\", but the mesh has %zu vertices; export it again",
                                    a.name, index, vertices);
      }
      corner[k] = (uint32_t)index;
      got |= 1u << k;
    }
  }
  if (got != 7) {
    return sepax__part_xml_fail(x, "<triangle> without v1, v2 and v3; export it again");
  }
  uint32_t(*grown)[3] = list_grow(m->triangle, &m->triangle_space, m->triangles, sizeof *grown);
  if (grown == NULL) {
    return sepax__builder_fail_memory(builder(x));
  }
  m->triangle = grown;
  memcpy(m->triangle[m->triangles++], corner, sizeof corner);
  current(r)->count++;
  return true;
}

/* Read the part that p:path names; without p:path it is this part. */
static bool read_path(part_xml *x, const part_element *e, size_t *part) {
  *part = x->part;
  for (int n = 0; n < e->attributes; n++) {
    part_attribute a = sepax__part_attribute(e, n);
    if (sepax__is_core(a.space) || strcmp(a.space, PRODUCTION_SPACE) != 0 ||
        strcmp(a.name, "path") != 0) {
      continue;
    }
    char path[1024];
    snprintf(path, sizeof path, "%.*s", (int)(a.length < 1023 ? a.length : 1023), a.value);
    long found = path[0] == '/' ? sepax__package_find(x->p, path) : NO_PART;
    if (found == NO_PART) {
      return sepax__part_xml_fail(
          x, "%.20s:path=\"%.80s\" is no part of the package; export it again", a.prefix, path);
    }
    *part = (size_t)found;
    x->p->part[found].is_model = true;
  }
  return true;
}

static bool read_use(part_xml *x, core_element which, const part_element *e, model_use **list,
                     size_t *count, size_t *space) {
  model_use use = {.in = x->part, .line = x->parser->input->line, .at = {.identity = true}};
  part_attribute a;
  if (!sepax__core_required_whole(x, which, e, "objectid", &use.id) ||
      !read_path(x, e, &use.part) ||
      (sepax__core_attribute(e, "transform", &a) && !sepax__model_matrix(x, &a, &use.at))) {
    return false;
  }
  model_use *grown = list_grow(*list, space, *count, sizeof *grown);
  if (grown == NULL) {
    return sepax__builder_fail_memory(builder(x));
  }
  *list = grown;
  grown[(*count)++] = use;
  return true;
}

static bool read_item(part_xml *x, reading *r, const part_element *e) {
  model *m = r->m;
  part_attribute a;
  if (x->part != m->root) { /* by the production extension, they are of no account */
    return sepax__builder_other(builder(x), "build items of other parts than the first", 1);
  }
  if (sepax__core_attribute(e, "printable", &a)) {
    bool no = sepax__part_value_is(&a, "0") || sepax__part_value_is(&a, "false");
    if (no && !sepax__builder_other(builder(x), "items not to be printed, which are read", 1)) {
      return false;
    }
  }
  return read_use(x, CORE_ITEM, e, &m->item, &m->items, &m->item_space);
}

/* ---------------------------------------------------------------------------- elements */

static bool read_core(part_xml *x, reading *r, core_element which, const part_element *e) {
  model *m = r->m;
  switch (which) {
  case CORE_MODEL:
    return read_model(x, r, e);
  case CORE_RESOURCES:
  case CORE_BUILD:
    return read_once(x, &r->seen, which);
  case CORE_OBJECT:
    return read_object(x, r, e);
  case CORE_MESH:
  case CORE_COMPONENTS:
    return read_mesh_or_components(x, r, which);
  case CORE_VERTICES:
    return read_once(x, &r->in_object, which);
  case CORE_TRIANGLES:
    return ((r->in_object & 1u << CORE_VERTICES) != 0 ||
            sepax__part_xml_fail(x, "<triangles> before <vertices>; export it again")) &&
           read_once(x, &r->in_object, which);
  case CORE_VERTEX:
    return read_vertex(x, r, e);
  case CORE_TRIANGLE:
    return read_triangle(x, r, e);
  case CORE_COMPONENT:
    current(r)->count++;
    return read_use(x, CORE_COMPONENT, e, &m->component, &m->components, &m->component_space);
  case CORE_ITEM:
    return read_item(x, r, e);
  case CORE_METADATA:
    return sepax__builder_other(builder(x), "metadata", 1);
  case CORE_BASE:
    return sepax__builder_other(builder(x), "base materials", 1);
  default:
    return true;
  }
}

/* Refuse text between elements, because it may be a damaged element. */
static bool text(part_xml *x) {
  const reading *r = x->context;
  return r->foreign > 0 || r->open[r->depth] == CORE_METADATA ||
         sepax__part_xml_fail(x, "text between elements; export it again");
}

static bool start_foreign(part_xml *x, reading *r, const part_element *e) {
  if (e->space != NULL && strcmp(e->space, ALTERNATIVES_SPACE) == 0) {
    return sepax__part_xml_fail(x, "<%.40s>: alternatives are not read; export it without them",
                                e->name);
  }
  if (e->space != NULL && sepax__model_extension(e->space) == EXTENSION_SURFACES) {
    return sepax__part_xml_fail(x,
                                "<%.40s> of the extension %.100s is not read; export triangles "
                                "alone",
                                e->name, e->space);
  }
  return r->foreign++ > 0 || sepax__core_name_foreign(x, e->prefix, e->name, "elements");
}

static bool start(part_xml *x, const part_element *e) {
  reading *r = x->context;
  core_element parent = r->open[r->depth];
  core_element which = CORE_OUTSIDE;
  if (r->foreign == 0 && e->space != NULL && strcmp(e->space, CORE_SPACE) == 0) {
    which = sepax__core_find(parent, e->name);
  }
  if (parent == CORE_OUTSIDE && r->depth == 0 && which != CORE_MODEL) {
    return sepax__part_xml_fail(x, "its root is no <model> of %s; export it as 3MF", CORE_SPACE);
  }
  if (r->foreign == 0 && which == CORE_OUTSIDE && sepax__is_core(e->space)) {
    return sepax__part_xml_fail(x, "<%.40s> in <%s> is not in the specification; export it again",
                                e->name, sepax__core_name(parent));
  }
  if (which == CORE_OUTSIDE) {
    return start_foreign(x, r, e);
  }
  r->open[++r->depth] = which;
  return sepax__core_check_attributes(x, which, e) && read_core(x, r, which, e);
}

static void end(part_xml *x) {
  reading *r = x->context;
  if (r->foreign > 0) {
    r->foreign--;
  } else {
    r->depth--;
  }
}

static bool check_objects(const model *m, size_t first) {
  for (size_t n = first; n < m->objects; n++) {
    const model_object *o = &m->object[n];
    if (!o->is_mesh && o->count == 0) {
      return sepax__package_fail(&m->p, o->part, o->line,
                                 "object %zu has neither a mesh nor components; leave it out",
                                 o->id);
    }
  }
  return true;
}

bool sepax__model_read(model *m, size_t part) {
  reading r = {.m = m};
  part_xml x = {.p = &m->p, .part = part, .start = start, .end = end, .text = text, .context = &r};
  size_t first = m->objects;
  m->p.part[part].was_read = true;
  if (!sepax__part_xml_read(&x) || !check_objects(m, first)) {
    return false;
  }
  return (r.seen & 1u << CORE_BUILD) != 0 || part != m->root ||
         sepax__package_fail(&m->p, part, 0, "it has no <build>; export it again");
}
