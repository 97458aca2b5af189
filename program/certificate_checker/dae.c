/* SPDX-License-Identifier: MIT */
/* dae.c - COLLADA 1.4 and 1.5: what the scene places of polygons. */
#include "mesh.h"
#include "report.h"
#include "tree.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

/* A scene of some bytes may place a geometry without end. */
enum { DEPTH_MOST = 200, PLACED_MOST = 1000000 };

typedef struct {
  char *id;
  xmlNode *node;
  bool placed; /* a geometry whose faces are counted */
} named;

typedef struct {
  mesh *m;
  named *named;
  size_t count;
  size_t placed;
} dae;

typedef struct {
  const point *vertex;
  size_t vertices;
  placement at;
  size_t *index; /* of vertices, of the element at hand */
  size_t indices;
} geometry;

static void find_names(dae *d, xmlNode *root) {
  for (xmlNode *n = root; n != NULL;) {
    char *id = n->type == XML_ELEMENT_NODE ? tree_attribute(n, "id", NULL) : NULL;
    if (id != NULL) {
      GROW(d->named, d->count);
      d->named[d->count++] = (named){id, n, false};
    }
    if (n->type == XML_ELEMENT_NODE && n->children != NULL) {
      n = n->children;
      continue;
    }
    while (n != NULL && n != root && n->next == NULL)
      n = n->parent;
    n = n == NULL || n == root ? NULL : n->next;
  }
}

/* The element that node's attribute refers to, which has one of the names. */
static xmlNode *target(const dae *d, const xmlNode *node, const char *attribute, const char *name) {
  char *url = tree_attribute(node, attribute, NULL);
  if (url == NULL || *url != '#')
    cannot("%s:%ld: %s without a %s in this file", d->m->file, tree_line(node),
           (const char *)node->name, attribute);
  xmlNode *found = NULL;
  for (size_t n = 0; n < d->count; n++) {
    if (strcmp(d->named[n].id, url + 1) != 0)
      continue;
    if (found != NULL)
      cannot("%s: two elements with the id %s", d->m->file, url + 1);
    found = d->named[n].node;
  }
  if (found == NULL || !tree_is(found, name))
    cannot("%s:%ld: no %s %s", d->m->file, tree_line(node), name, url);
  xmlFree(url);
  return found;
}

static long double *numbers_in(const dae *d, xmlNode *node, size_t *count) {
  char *text = (char *)xmlNodeGetContent(node);
  long double *value = NULL;
  *count = 0;
  for (const char *next = text; next != NULL;) {
    next += strspn(next, " \t\r\n");
    if (*next == 0)
      break;
    GROW(value, *count);
    value[(*count)++] = mesh_number(d->m, &next, 0, tree_line(node));
  }
  xmlFree(text);
  return value;
}

static size_t whole(const dae *d, const xmlNode *node, long double value) {
  if (!(value >= 0 && value < 0x1p53L) || value != floorl(value))
    cannot("%s:%ld: no whole number: %Lg", d->m->file, tree_line(node), value);
  return (size_t)value;
}

static size_t size_of(const dae *d, const xmlNode *node, const char *name, size_t otherwise) {
  char *text = tree_attribute(node, name, NULL);
  const char *next = text;
  const size_t value =
      text == NULL ? otherwise : whole(d, node, mesh_number(d->m, &next, 0, tree_line(node)));
  xmlFree(text);
  return value;
}

/* -------------------------------------------------------------------- vertices */

/* The positions of a source: entries of an array that an accessor picks by its stride; of its
 * params those with a name. */
static point *positions(const dae *d, const xmlNode *input, size_t *count) {
  xmlNode *source = target(d, input, "source", "source");
  xmlNode *accessor = tree_child(tree_child(source, "technique_common"), "accessor");
  if (accessor == NULL)
    cannot("%s:%ld: source without an accessor", d->m->file, tree_line(source));
  size_t place[3] = {0};
  size_t named_params = 0;
  size_t params = 0;
  for (xmlNode *n = tree_child(accessor, "param"); n != NULL; n = tree_from(n->next, "param")) {
    char *name = tree_attribute(n, "name", NULL);
    if (name != NULL && *name != 0 && named_params++ < 3)
      place[named_params - 1] = params;
    params++;
    xmlFree(name);
  }
  /* Params without any name are X, Y and Z in this order. */
  for (size_t n = 0; named_params == 0 && n < 3; n++)
    place[n] = n;
  const size_t offset = size_of(d, accessor, "offset", 0);
  const size_t stride = size_of(d, accessor, "stride", 1);
  *count = size_of(d, accessor, "count", 0);
  xmlNode *array = target(d, accessor, "source", "float_array");
  size_t length = 0;
  long double *value = numbers_in(d, array, &length);
  const bool right = params >= 3 && (named_params == 0 || named_params == 3) && stride >= params &&
                     size_of(d, array, "count", length) == length && *count <= length &&
                     offset <= length && stride <= length + 1 &&
                     *count * stride <= length - offset + (stride - params);
  if (!right)
    cannot("%s:%ld: an accessor that is not of three coordinates, or beyond its array", d->m->file,
           tree_line(accessor));
  point *vertex = memory(NULL, *count, sizeof *vertex);
  for (size_t n = 0; n < *count; n++) {
    const long double *v = value + offset + n * stride;
    vertex[n] = (point){v[place[0]], v[place[1]], v[place[2]]};
  }
  free(value);
  return vertex;
}

static point *vertices_of(const dae *d, xmlNode *body, size_t *count) {
  xmlNode *vertices = tree_child(body, "vertices");
  for (xmlNode *n = tree_child(vertices, "input"); n != NULL; n = tree_from(n->next, "input")) {
    char *semantic = tree_attribute(n, "semantic", NULL);
    const bool is = semantic != NULL && strcmp(semantic, "POSITION") == 0;
    xmlFree(semantic);
    if (is)
      return positions(d, n, count);
  }
  cannot("%s:%ld: no vertices with positions", d->m->file, tree_line(body));
}

/* -------------------------------------------------------------------- polygons */

/* Where in each group of indices that of a vertex is; *stride: the length of a group. */
static size_t vertex_offset(const dae *d, xmlNode *node, xmlNode *body, size_t *stride) {
  size_t found = SIZE_MAX;
  *stride = 0;
  for (xmlNode *n = tree_child(node, "input"); n != NULL; n = tree_from(n->next, "input")) {
    char *semantic = tree_attribute(n, "semantic", NULL);
    const size_t offset = size_of(d, n, "offset", 0);
    if (offset > 1000)
      cannot("%s:%ld: an offset of %zu", d->m->file, tree_line(n), offset);
    if (semantic != NULL && strcmp(semantic, "VERTEX") == 0) {
      if (found != SIZE_MAX || target(d, n, "source", "vertices") != tree_child(body, "vertices"))
        cannot("%s:%ld: not the vertices of this mesh", d->m->file, tree_line(n));
      found = offset;
    }
    *stride = offset + 1 > *stride ? offset + 1 : *stride;
    xmlFree(semantic);
  }
  if (found == SIZE_MAX)
    cannot("%s:%ld: no VERTEX", d->m->file, tree_line(node));
  return found;
}

/* The corners of a <p>. */
static point *corners_of(const dae *d, const geometry *g, xmlNode *p, size_t offset, size_t stride,
                         size_t *count) {
  size_t length = 0;
  long double *value = numbers_in(d, p, &length);
  if (length % stride != 0)
    cannot("%s:%ld: %zu indices, not a multiple of %zu", d->m->file, tree_line(p), length, stride);
  *count = length / stride;
  point *corner = memory(NULL, *count, sizeof *corner);
  for (size_t n = 0; n < *count; n++) {
    const size_t index = whole(d, p, value[n * stride + offset]);
    if (index >= g->vertices)
      cannot("%s:%ld: no vertex %zu", d->m->file, tree_line(p), index);
    corner[n] = placement_apply(&g->at, g->vertex[index]);
  }
  free(value);
  return corner;
}

/* Polygons of these numbers of corners one behind the other. */
static void read_polygons(const dae *d, const xmlNode *node, const point *corner, size_t count,
                          const long double *sizes, size_t polygons) {
  size_t from = 0;
  for (size_t n = 0; n < polygons; n++) {
    const size_t size = sizes == NULL ? 3 : whole(d, node, sizes[n]);
    if (size == 0 || size > count - from)
      cannot("%s:%ld: not as many indices as polygons need", d->m->file, tree_line(node));
    /* A point or a segment is a triangle without an area. */
    const point thin[3] = {corner[from], corner[from + (size == 2)], corner[from + (size == 2)]};
    mesh_polygon(d->m, size < 3 ? thin : corner + from, size < 3 ? 3 : size);
    d->m->faces++;
    from += size;
  }
  if (from != count)
    cannot("%s:%ld: more indices than polygons need", d->m->file, tree_line(node));
}

static void read_primitive(const dae *d, const geometry *g, xmlNode *node, xmlNode *body) {
  size_t stride = 0;
  size_t elements = 0;
  const size_t declared = size_of(d, node, "count", SIZE_MAX);
  size_t offset = 0;
  long double *sizes = NULL;
  size_t polygons = 0;
  if (declared != 0)
    offset = vertex_offset(d, node, body, &stride);
  for (xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    if (tree_is(n, "vcount") && tree_is(node, "polylist")) {
      free(sizes);
      sizes = numbers_in(d, n, &polygons);
    } else if (tree_is(n, "p") && declared != 0) {
      size_t count = 0;
      point *corner = corners_of(d, g, n, offset, stride, &count);
      const long double all = (long double)count;
      if (tree_is(node, "triangles")) {
        read_polygons(d, n, corner, count, NULL, count / 3);
        elements += count / 3;
      } else if (tree_is(node, "polylist")) {
        read_polygons(d, n, corner, count, sizes, polygons);
        elements += polygons;
      } else if (tree_is(node, "polygons")) {
        read_polygons(d, n, corner, count, &all, 1);
        elements++;
      } else {
        d->m->faces += tree_is(node, "trifans") ? mesh_fan(d->m, corner, count)
                                                : mesh_strip(d->m, corner, count);
        elements++;
      }
      free(corner);
    } else if (!tree_is(n, "input") && !tree_is(n, "extra") && !tree_is(n, "p")) {
      cannot("%s:%ld: %s in %s", d->m->file, tree_line(n), (const char *)n->name,
             (const char *)node->name);
    }
  }
  free(sizes);
  if (declared != SIZE_MAX && declared != elements)
    cannot("%s:%ld: %zu %s, not %zu", d->m->file, tree_line(node), elements,
           (const char *)node->name, declared);
}

static bool is_one_of(const xmlNode *node, const char *const *names) {
  while (*names != NULL && !tree_is(node, *names))
    names++;
  return *names != NULL;
}

static void read_geometry(dae *d, xmlNode *node, const placement *at) {
  static const char *const WITH[] = {"triangles", "polylist", "polygons",
                                     "tristrips", "trifans",  NULL};
  static const char *const WITHOUT[] = {"source", "vertices", "lines", "linestrips", "extra", NULL};
  xmlNode *body = tree_child(node, "mesh");
  body = body == NULL ? tree_child(node, "convex_mesh") : body;
  if (body == NULL)
    cannot("%s:%ld: geometry without a mesh", d->m->file, tree_line(node));
  char *hull = tree_attribute(body, "convex_hull_of", NULL);
  if (hull != NULL)
    cannot("%s:%ld: convex_hull_of", d->m->file, tree_line(body));
  geometry g = {.at = *at};
  d->m->turned = placement_mirrors(at);
  point *vertex = vertices_of(d, body, &g.vertices);
  g.vertex = vertex;
  for (xmlNode *n = tree_element(body->children); n != NULL; n = tree_element(n->next)) {
    if (is_one_of(n, WITH))
      read_primitive(d, &g, n, body);
    else if (!is_one_of(n, WITHOUT))
      cannot("%s:%ld: unknown element %s", d->m->file, tree_line(n), (const char *)n->name);
  }
  free(vertex);
}

/* Its faces count once, however often it is placed. */
static void place_geometry(dae *d, xmlNode *node, const placement *at) {
  const size_t before = d->m->faces;
  read_geometry(d, node, at);
  for (size_t n = 0; n < d->count; n++) {
    if (d->named[n].node != node)
      continue;
    if (d->named[n].placed)
      d->m->faces = before;
    d->named[n].placed = true;
  }
}

/* ------------------------------------------------------------------------ scene */

static placement placed_by(const dae *d, xmlNode *node) {
  size_t count = 0;
  long double *v = numbers_in(d, node, &count);
  placement a = PLACEMENT_NONE;
  const bool matrix = tree_is(node, "matrix") || tree_is(node, "bind_shape_matrix");
  const bool rotate = tree_is(node, "rotate");
  if (count != (matrix ? 16 : rotate ? 4 : 3))
    cannot("%s:%ld: %s of %zu numbers", d->m->file, tree_line(node), (const char *)node->name,
           count);
  if (matrix) {
    if (v[12] != 0 || v[13] != 0 || v[14] != 0 || v[15] != 1)
      cannot("%s:%ld: a matrix whose last row is not 0 0 0 1", d->m->file, tree_line(node));
    for (int n = 0; n < 3; n++)
      a.row[n] = (point){v[4 * n], v[4 * n + 1], v[4 * n + 2]};
    a.shift = (point){v[3], v[7], v[11]};
  } else if (rotate) { /* degrees */
    const point axis = {v[0], v[1], v[2]};
    const long double length = point_length(axis);
    if (!(length > 0))
      cannot("%s:%ld: a rotation about no axis", d->m->file, tree_line(node));
    const quaternion q = quaternion_about(point_times(1 / length, axis),
                                          v[3] * 3.14159265358979323846264338327950288L / 180);
    const point x = quaternion_turn(q, (point){1, 0, 0});
    const point y = quaternion_turn(q, (point){0, 1, 0});
    const point z = quaternion_turn(q, (point){0, 0, 1});
    a = (placement){{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}, {0, 0, 0}};
  } else if (tree_is(node, "translate")) {
    a.shift = (point){v[0], v[1], v[2]};
  } else { /* scale */
    a = (placement){{{v[0], 0, 0}, {0, v[1], 0}, {0, 0, v[2]}}, {0, 0, 0}};
  }
  free(v);
  return a;
}

/* Of a skinned mesh the shape in which it was bound. */
static void read_controller(dae *d, xmlNode *node, const placement *at) {
  xmlNode *skin = tree_child(node, "skin");
  if (skin == NULL)
    cannot("%s:%ld: a controller that is no skin", d->m->file, tree_line(node));
  xmlNode *bind = tree_child(skin, "bind_shape_matrix");
  const placement own = bind == NULL ? PLACEMENT_NONE : placed_by(d, bind);
  const placement all = placement_product(at, &own);
  place_geometry(d, target(d, skin, "source", "geometry"), &all);
}

static void read_node(dae *d, xmlNode *node, placement at, int depth) {
  static const char *const PLACES[] = {"matrix", "translate", "rotate", "scale", NULL};
  static const char *const WITHOUT[] = {"asset",          "extra",          "instance_camera",
                                        "instance_light", "evaluate_scene", NULL};
  if (depth > DEPTH_MOST || ++d->placed > PLACED_MOST)
    cannot("%s:%ld: too many nodes, or a circle of them", d->m->file, tree_line(node));
  for (xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    if (is_one_of(n, PLACES)) {
      const placement own = placed_by(d, n);
      at = placement_product(&at, &own);
    } else if (tree_is(n, "node")) {
      read_node(d, n, at, depth + 1);
    } else if (tree_is(n, "instance_node")) {
      read_node(d, target(d, n, "url", "node"), at, depth + 1);
    } else if (tree_is(n, "instance_geometry")) {
      place_geometry(d, target(d, n, "url", "geometry"), &at);
    } else if (tree_is(n, "instance_controller")) {
      read_controller(d, target(d, n, "url", "controller"), &at);
    } else if (!is_one_of(n, WITHOUT)) {
      cannot("%s:%ld: unknown element %s", d->m->file, tree_line(n), (const char *)n->name);
    }
  }
}

void mesh_dae(mesh *m, const char *bytes, size_t length) {
  dae d = {.m = m};
  xmlNode *root = tree_root(m->file, bytes, length);
  if (!tree_is(root, "COLLADA"))
    cannot("%s: has no COLLADA", m->file);
  find_names(&d, root);
  m->unit_mm = 1000;
  xmlNode *unit = tree_child(tree_child(root, "asset"), "unit");
  char *meter = unit == NULL ? NULL : tree_attribute(unit, "meter", NULL);
  const char *next = meter;
  if (meter != NULL)
    m->unit_mm = 1000 * mesh_number(m, &next, 0, tree_line(unit));
  if (!(m->unit_mm > 0))
    cannot("%s: a unit of %Lg mm", m->file, m->unit_mm);
  xmlFree(meter);
  xmlNode *instance = tree_child(tree_child(root, "scene"), "instance_visual_scene");
  if (instance == NULL)
    cannot("%s: has no scene", m->file);
  read_node(&d, target(&d, instance, "url", "visual_scene"), PLACEMENT_NONE, 0);
  for (size_t n = 0; n < d.count; n++)
    xmlFree(d.named[n].id);
  free(d.named);
  tree_free(root);
}
