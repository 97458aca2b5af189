/* SPDX-License-Identifier: MIT */
/* dae_schema.c - the elements of COLLADA on the way to triangles, and what has no surface. */
#include "util/list.h"
#include "util/text.h"
#include "xml/dae.h"

#include <string.h>
#include <strings.h>

#define PRIMITIVES " triangles polylist polygons tristrips trifans lines linestrips "

/* Names have a blank before and behind. What has no line here is not looked into: it has no
 * surface. */
static const struct {
  const char *name, *attributes, *children;
} schema[] = {
    {"library_geometries", " id name ", " asset geometry extra "},
    {"geometry", " id name ", " asset mesh convex_mesh spline brep extra "},
    {"mesh", " ", " source vertices" PRIMITIVES "extra "},
    {"convex_mesh", " convex_hull_of ", " source vertices" PRIMITIVES "extra "},
    {"source", " id name ",
     " asset float_array int_array bool_array Name_array IDREF_array SIDREF_array token_array "
     "technique_common technique "},
    {"float_array", " id name count digits magnitude ", " "},
    {"technique_common", " ", " accessor "},
    {"accessor", " count offset source stride ", " param "},
    {"param", " name sid type semantic ", " "},
    {"vertices", " id name ", " input extra "},
    {"input", " semantic source offset set ", " "},
    {"triangles", " name count material ", " input p extra "},
    {"polylist", " name count material ", " input vcount p extra "},
    {"polygons", " name count material ", " input p ph extra "},
    {"tristrips", " name count material ", " input p extra "},
    {"trifans", " name count material ", " input p extra "},
    {"lines", " name count material ", " input p extra "},
    {"linestrips", " name count material ", " input p extra "},
    {"p", " ", " "},
    {"vcount", " ", " "},
    {"library_nodes", " id name ", " asset node extra "},
    {"library_visual_scenes", " id name ", " asset visual_scene extra "},
    {"visual_scene", " id name ", " asset node evaluate_scene extra "},
    {"node", " id name sid type layer ",
     " asset lookat matrix rotate scale skew translate instance_camera instance_controller "
     "instance_geometry instance_light instance_node node extra "},
    {"matrix", " sid ", " "},
    {"rotate", " sid ", " "},
    {"scale", " sid ", " "},
    {"translate", " sid ", " "},
    {"instance_geometry", " url sid name ", " bind_material extra "},
    {"instance_controller", " url sid name ", " skeleton bind_material extra "},
    {"instance_node", " url sid name ", " extra "},
    {"library_controllers", " id name ", " asset controller extra "},
    {"controller", " id name ", " asset skin morph extra "},
    {"skin", " source ", " bind_shape_matrix source joints vertex_weights extra "},
    {"bind_shape_matrix", " ", " "},
    {"scene", " ",
     " instance_physics_scene instance_visual_scene instance_kinematics_scene extra "},
    {"instance_visual_scene", " url sid name ", " extra "},
};
enum { SCHEMA = sizeof schema / sizeof schema[0] };

/* Elements without a surface, and how they are named; of a library, what is in it is counted. */
static const struct {
  const char *name, *what;
  bool is_library;
} others[] = {
    {"extra", "extra elements", false},
    {"technique", "techniques of other programs", false},
    {"evaluate_scene", "evaluations of scenes", false},
    {"bind_material", "bound materials", false},
    {"instance_camera", "placed cameras", false},
    {"instance_light", "placed lights", false},
    {"instance_physics_scene", "placed physics", false},
    {"instance_kinematics_scene", "placed kinematics", false},
    {"library_animations", "animations", true},
    {"library_animation_clips", "animation clips", true},
    {"library_cameras", "cameras", true},
    {"library_lights", "lights", true},
    {"library_materials", "materials", true},
    {"library_effects", "effects", true},
    {"library_images", "images", true},
    {"library_force_fields", "force fields", true},
    {"library_physics_materials", "physics materials", true},
    {"library_physics_models", "physics models", true},
    {"library_physics_scenes", "physics scenes", true},
    {"library_articulated_systems", "kinematics", true},
    {"library_kinematics_models", "kinematics", true},
    {"library_kinematics_scenes", "kinematics", true},
    {"library_joints", "kinematics", true},
    {"library_formulas", "formulas", true},
};
enum { OTHERS = sizeof others / sizeof others[0] };

static bool has_word(const char *words, const char *word) {
  size_t length = strlen(word);
  const char *at = strstr(words, word);
  while (at != NULL && !(at > words && at[-1] == ' ' && at[length] == ' ')) {
    at = strstr(at + 1, word);
  }
  return at != NULL;
}

static size_t find_schema(const char *name) {
  size_t n = 0;
  while (n < SCHEMA && strcmp(schema[n].name, name) != 0) {
    n++;
  }
  return n;
}

/* -------------------------------------------------------------------------------- asset */

static bool check_unit(dae *d, const xmlNode *unit, bool first) {
  sepax_mesh_account *account = &d->b->account;
  const char *name = sepax__dae_attribute(unit, "name");
  const char *text = sepax__dae_attribute(unit, "meter");
  double meter = 1;
  if (text != NULL) {
    size_t blank = strspn(text, " \t\r\n");
    size_t length = strcspn(text + blank, " \t\r\n");
    if (!sepax__number(text + blank, length, &meter) || !(meter > 0)) {
      return sepax__dae_fail(d, unit, "<unit meter=\"%.40s\">: give a length above 0", text);
    }
  }
  static const char *const metres[] = {"meter", "metre", "meters", "metres", "m"};
  bool agrees = name == NULL || text != NULL;
  for (size_t n = 0; n < sizeof metres / sizeof metres[0] && !agrees; n++) {
    agrees = strcasecmp(name, metres[n]) == 0;
  }
  if (!agrees) {
    return sepax__dae_fail(
        d, unit, "<unit name=\"%.40s\"> without meter=\"...\", which is then 1; give it", name);
  }
  if (first) {
    account->unit_mm = 1000 * meter;
    if (name != NULL) {
      snprintf(account->unit, sizeof account->unit, "%.23s", name);
    } else {
      snprintf(account->unit, sizeof account->unit, "%.9g m", meter);
    }
  }
  return account->unit_mm == 1000 * meter ||
         sepax__dae_fail(d, unit, "a unit of %g m in a document of %g m; export it in one unit",
                         meter, account->unit_mm / 1000);
}

/* As robots' programs do, up_axis is not applied. */
static bool check_asset(dae *d, const xmlNode *asset, bool first) {
  const xmlNode *unit = sepax__xml_child(asset, "unit");
  const xmlNode *axis = sepax__xml_child(asset, "up_axis");
  if (unit != NULL && !check_unit(d, unit, first)) {
    return false;
  }
  if (axis != NULL) {
    char what[60];
    const char *text = sepax__dae_text(axis);
    text += strspn(text, " \t\r\n");
    int length = (int)strcspn(text, " \t\r\n");
    bool known = length == 4 && strchr("XYZ", text[0]) != NULL && strncmp(text + 1, "_UP", 3) == 0;
    if (!known || text[4 + strspn(text + 4, " \t\r\n")] != '\0') {
      return sepax__dae_fail(d, axis, "<up_axis> is \"%.40s\"; give X_UP, Y_UP or Z_UP", text);
    }
    snprintf(what, sizeof what, "up_axis %.4s, which is not applied", text);
    return text[0] == 'Z' || sepax__builder_other(d->b, what, 1);
  }
  return true;
}

/* ----------------------------------------------------------------------------- elements */

static bool list(dae *d, xmlNode *node) {
  const char *name = (const char *)node->name;
  const char *id = sepax__dae_attribute(node, "id");
  if (id != NULL) {
    dae_id *grown = list_grow(d->id, &d->id_space, d->ids, sizeof *grown);
    if (grown == NULL) {
      return sepax__builder_fail_memory(d->b);
    }
    d->id = grown;
    d->id[d->ids++] = (dae_id){name, id, node};
  }
  if (strcmp(name, "geometry") == 0) {
    dae_geometry *grown = list_grow(d->geometry, &d->geometry_space, d->geometries, sizeof *grown);
    if (grown == NULL) {
      return sepax__builder_fail_memory(d->b);
    }
    d->geometry = grown;
    d->geometry[d->geometries++] = (dae_geometry){.node = node};
    node->_private = (void *)d->geometries;
  }
  if (strcmp(name, "node") == 0 || strcmp(name, "visual_scene") == 0) {
    dae_node *grown = list_grow(d->node, &d->node_space, d->nodes, sizeof *grown);
    if (grown == NULL) {
      return sepax__builder_fail_memory(d->b);
    }
    d->node = grown;
    d->node[d->nodes++] = (dae_node){0};
    node->_private = (void *)d->nodes;
  }
  return true;
}

static bool check_attributes(const dae *d, const xmlNode *node, const char *known) {
  for (const xmlAttr *a = node->properties; a != NULL; a = a->next) {
    const char *name = (const char *)a->name;
    const char *space = a->ns != NULL ? (const char *)a->ns->href : NULL;
    bool ok = space == NULL ? has_word(known, name)
                            : strcmp(space, "http://www.w3.org/XML/1998/namespace") == 0 ||
                                  strcmp(space, "http://www.w3.org/2001/XMLSchema-instance") == 0;
    if (!ok) {
      return sepax__dae_fail(d, node, "<%.40s %.40s=...> is not of COLLADA; export it again",
                             (const char *)node->name, name);
    }
  }
  return true;
}

static bool in_space(const dae *d, const xmlNode *node) {
  return node->ns != NULL &&
         strcmp((const char *)node->ns->href, (const char *)d->file.root->ns->href) == 0;
}

static bool name_other(const dae *d, const xmlNode *node) {
  for (int n = 0; n < OTHERS; n++) {
    if (sepax__xml_is(node, others[n].name)) {
      size_t count = others[n].is_library ? 0 : 1;
      const xmlNode *inside = others[n].is_library ? sepax__xml_child(node, NULL) : NULL;
      for (; inside != NULL; inside = sepax__xml_next(inside, NULL)) {
        count += !sepax__xml_is(inside, "asset") && !sepax__xml_is(inside, "extra");
      }
      return count == 0 || sepax__builder_other(d->b, others[n].what, count);
    }
  }
  return true;
}

/* Depth is that of the document, 256 at most. */
static bool check_element(dae *d, xmlNode *node) {
  size_t row = find_schema((const char *)node->name);
  if (row == SCHEMA) {
    return sepax__xml_is(node, "asset") ? check_asset(d, node, false) : name_other(d, node);
  }
  if (!check_attributes(d, node, schema[row].attributes) || !list(d, node)) {
    return false;
  }
  for (xmlNode *child = sepax__xml_child(node, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    if (!in_space(d, child) || !has_word(schema[row].children, (const char *)child->name)) {
      return sepax__dae_fail(d, child, "<%.40s> in <%.40s> is not of COLLADA; export it again",
                             (const char *)child->name, (const char *)node->name);
    }
    if (!check_element(d, child)) {
      return false;
    }
  }
  return true;
}

static int compare_ids(const void *left, const void *right) {
  const dae_id *a = left;
  const dae_id *b = right;
  int order = strcmp(a->name, b->name);
  return order != 0 ? order : strcmp(a->id, b->id);
}

/* An element of the root; *first tells whether no asset came before. */
static bool check_library(dae *d, xmlNode *child, bool *first) {
  static const char libraries[] =
      " library_geometries library_nodes library_visual_scenes library_controllers scene ";
  const char *name = (const char *)child->name;
  int n = 0;
  while (n < OTHERS && strcmp(others[n].name, name) != 0) {
    n++;
  }
  bool is_asset = strcmp(name, "asset") == 0;
  if (!in_space(d, child) || (!is_asset && !has_word(libraries, name) && n == OTHERS)) {
    return sepax__dae_fail(d, child, "<%.40s> in <COLLADA> is not of COLLADA; export it again",
                           name);
  }
  bool ok = is_asset ? check_asset(d, child, *first) : check_element(d, child);
  *first = *first && !is_asset;
  return ok;
}

bool sepax__dae_check(dae *d) {
  snprintf(d->b->account.unit, sizeof d->b->account.unit, "meter");
  d->b->account.unit_mm = 1000;
  if (!check_attributes(d, d->file.root, " version ")) {
    return false;
  }
  bool first = true;
  for (xmlNode *child = sepax__xml_child(d->file.root, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    if (!check_library(d, child, &first)) {
      return false;
    }
  }
  if (d->ids > 0) {
    qsort(d->id, d->ids, sizeof *d->id, compare_ids);
  }
  return true;
}

/* --------------------------------------------------------------------------- references */

static const xmlNode *geometry_around(const xmlNode *node) {
  while (node != NULL && !(node->type == XML_ELEMENT_NODE && sepax__xml_is(node, "geometry"))) {
    node = node->parent;
  }
  return node;
}

/* Of elements with one id, which some exporters write, that of the same geometry; NULL if there are
 * more, or none. */
static xmlNode *nearest(const dae *d, const dae_id *found, const xmlNode *from) {
  enum { SAME_MOST = 1000 };
  const xmlNode *geometry = geometry_around(from);
  const dae_id *first = found;
  const dae_id *end = found + 1;
  while (first > d->id && found - first < SAME_MOST && compare_ids(first - 1, found) == 0) {
    first--;
  }
  while (end < d->id + d->ids && end - found < SAME_MOST && compare_ids(end, found) == 0) {
    end++;
  }
  xmlNode *only = end - first == 1 ? found->node : NULL;
  size_t near = 0;
  for (const dae_id *n = first; n < end && geometry != NULL && end - first > 1; n++) {
    if (geometry_around(n->node) == geometry) {
      near++;
      only = n->node;
    }
  }
  return near > 1 ? NULL : only;
}

static const dae_id *find_id(const dae *d, const char *name, const char *id) {
  dae_id key = {.name = name, .id = id};
  return d->ids > 0 ? bsearch(&key, d->id, d->ids, sizeof key, compare_ids) : NULL;
}

xmlNode *sepax__dae_refer(const dae *d, const xmlNode *from, const char *attribute,
                          const char *name) {
  const char *url = sepax__dae_attribute(from, attribute);
  const char *element = (const char *)from->name;
  if (url == NULL) {
    sepax__dae_fail(d, from, "<%.40s> without %s=\"...\"; export it again", element, attribute);
    return NULL;
  }
  if (url[0] != '#') {
    sepax__dae_fail(d, from,
                    "<%.40s %s=\"%.60s\"> refers to another file, which is not read; put it into "
                    "this one",
                    element, attribute, url);
    return NULL;
  }
  const dae_id *found = find_id(d, name, url + 1);
  if (found == NULL) {
    sepax__dae_fail(d, from, "<%.40s %s=\"%.60s\">: no <%s> has this id; export it again", element,
                    attribute, url, name);
    return NULL;
  }
  xmlNode *node = nearest(d, found, from);
  if (node == NULL) {
    sepax__dae_fail(d, found->node, "two <%s id=\"%.60s\">; give each its own id", name, found->id);
  }
  return node;
}
