/* SPDX-License-Identifier: MIT */
/* dae_mesh.c - the triangles and the faces of a COLLADA geometry. */
#include "util/text.h"
#include "xml/dae.h"

#include <string.h>

/* The geometry while it is read. */
typedef struct {
  dae *d;
  dae_geometry *g;
  const xmlNode *vertices; /* whose positions these are */
  double (*position)[3];
  size_t positions;
} meshing;

/* The inputs of a primitive: numbers of an index, and which of them is that of the vertex. */
typedef struct {
  size_t stride, vertex;
} strides;

/* ------------------------------------------------------------------------ positions */

/* Where x, y and z are in an element of the accessor. Numbers of parameters without a name are not
 * used; but where none has a name, the first three are. */
static bool find_axes(const dae *d, const xmlNode *accessor, size_t axis[3]) {
  size_t named = 0;
  size_t at = 0;
  size_t by_name[3] = {SIZE_MAX, SIZE_MAX, SIZE_MAX};
  for (const xmlNode *param = sepax__xml_child(accessor, "param"); param != NULL;
       param = sepax__xml_next(param, "param"), at++) {
    const char *name = sepax__dae_attribute(param, "name");
    if (name != NULL && name[0] != '\0') {
      if (named < 3) {
        axis[named] = at;
      }
      named++;
      if (name[1] == '\0' && name[0] >= 'X' && name[0] <= 'Z') {
        by_name[name[0] - 'X'] = at;
      }
    }
  }
  if (named == 0 && (at == 0 || at == 3)) {
    axis[0] = 0;
    axis[1] = 1;
    axis[2] = 2;
    return true;
  }
  if (by_name[0] != SIZE_MAX && by_name[1] != SIZE_MAX && by_name[2] != SIZE_MAX) {
    memcpy(axis, by_name, sizeof by_name);
  }
  return named == 3 || sepax__dae_fail(d, accessor,
                                       "<accessor> of positions with %zu parameters; export three, "
                                       "X, Y and Z",
                                       named != 0 ? named : at);
}

static bool read_accessor(meshing *m, const xmlNode *accessor, const double *value, size_t values) {
  const dae *d = m->d;
  size_t count = 0;
  size_t offset = 0;
  size_t stride = 1;
  size_t axis[3];
  if (!sepax__dae_whole(d, accessor, "count", &count) ||
      !sepax__dae_whole(d, accessor, "offset", &offset) ||
      !sepax__dae_whole(d, accessor, "stride", &stride) || !find_axes(d, accessor, axis)) {
    return false;
  }
  for (int k = 0; k < 3; k++) {
    if (axis[k] >= stride) {
      return sepax__dae_fail(d, accessor, "<accessor stride=\"%zu\"> of positions; export 3",
                             stride);
    }
  }
  if (count > 0 && (offset > values || (values - offset) / stride < count - 1 ||
                    values - offset - (count - 1) * stride < stride)) {
    return sepax__dae_fail(d, accessor,
                           "<accessor> takes %zu elements of %zu numbers from number %zu, but the "
                           "array has %zu; export it again",
                           count, stride, offset, values);
  }
  m->position = sepax_allocate((count + 1) * sizeof *m->position);
  if (m->position == NULL) {
    return sepax__builder_fail_memory(d->b);
  }
  m->positions = count;
  for (size_t n = 0; n < count; n++) {
    for (int k = 0; k < 3; k++) {
      m->position[n][k] = value[offset + n * stride + axis[k]];
    }
  }
  return true;
}

static bool read_source(meshing *m, const xmlNode *source) {
  const dae *d = m->d;
  const xmlNode *common = sepax__xml_child(source, "technique_common");
  const xmlNode *accessor = sepax__xml_child(common, "accessor");
  if (accessor == NULL) {
    return sepax__dae_fail(d, source,
                           "<source> of positions without an <accessor>; export it again");
  }
  const xmlNode *array = sepax__dae_refer(d, accessor, "source", "float_array");
  size_t count = 0;
  if (array == NULL || !sepax__dae_whole(d, array, "count", &count)) {
    return false;
  }
  /* Each number but the last has two characters at least. */
  if (count > strlen(sepax__dae_text(array)) / 2 + 1) {
    return sepax__dae_fail(d, array,
                           "<float_array count=\"%zu\"> has fewer numbers; export it again", count);
  }
  double *value = sepax_allocate((count + 1) * sizeof *value);
  if (value == NULL) {
    return sepax__builder_fail_memory(d->b);
  }
  bool ok = sepax__dae_reals(d, array, value, count) && read_accessor(m, accessor, value, count);
  sepax_release(value);
  return ok;
}

static bool name_input(const dae *d, const char *semantic) {
  char what[60];
  snprintf(what, sizeof what, "inputs %.30s", semantic);
  return sepax__builder_other(d->b, what, 1);
}

static bool read_vertices(meshing *m, const xmlNode *vertices) {
  const dae *d = m->d;
  const xmlNode *position = NULL;
  for (const xmlNode *input = sepax__xml_child(vertices, "input"); input != NULL;
       input = sepax__xml_next(input, "input")) {
    const char *semantic = sepax__dae_attribute(input, "semantic");
    bool is_position = semantic != NULL && strcmp(semantic, "POSITION") == 0;
    if (is_position && position != NULL) {
      return sepax__dae_fail(d, input, "a second input POSITION; leave one of them out");
    }
    position = is_position ? input : position;
    if (!is_position && !name_input(d, semantic != NULL ? semantic : "")) {
      return false;
    }
  }
  if (position == NULL) {
    return sepax__dae_fail(d, vertices, "<vertices> without an input POSITION; export it again");
  }
  const xmlNode *source = sepax__dae_refer(d, position, "source", "source");
  m->vertices = vertices;
  return source != NULL && read_source(m, source);
}

static bool read_inputs(meshing *m, const xmlNode *primitive, strides *s) {
  const dae *d = m->d;
  const xmlNode *vertex = NULL;
  for (const xmlNode *input = sepax__xml_child(primitive, "input"); input != NULL;
       input = sepax__xml_next(input, "input")) {
    const char *semantic = sepax__dae_attribute(input, "semantic");
    size_t offset = 0;
    if (semantic == NULL || sepax__dae_attribute(input, "offset") == NULL ||
        !sepax__dae_whole(d, input, "offset", &offset) || offset > 255) {
      return sepax__dae_fail(d, input,
                             "<input> without a semantic and an offset of 0 ... 255; export it "
                             "again");
    }
    bool is_vertex = strcmp(semantic, "VERTEX") == 0;
    if (is_vertex && vertex != NULL) {
      return sepax__dae_fail(d, input, "a second input VERTEX; leave one of them out");
    }
    if (is_vertex) {
      vertex = input;
      s->vertex = offset;
    } else if (!name_input(d, semantic)) {
      return false;
    }
    s->stride = offset + 1 > s->stride ? offset + 1 : s->stride;
  }
  if (vertex == NULL) {
    return sepax__dae_fail(d, primitive, "<%s> without an input VERTEX; export it again",
                           (const char *)primitive->name);
  }
  const xmlNode *vertices = sepax__dae_refer(d, vertex, "source", "vertices");
  if (vertices == NULL) {
    return false;
  }
  if (m->vertices == NULL) {
    return read_vertices(m, vertices);
  }
  return m->vertices == vertices ||
         sepax__dae_fail(d, vertex, "a second <vertices> in one mesh; give one");
}

/* ------------------------------------------------------------------------ primitives */

static bool fail_index(const meshing *m, const xmlNode *p, int got, const char *text) {
  if (got == 0) {
    return sepax__dae_fail(m->d, p, "<p> has too few indices; export it again");
  }
  size_t length = strcspn(text, " \t\r\n");
  return sepax__dae_fail(m->d, p, "<p>: an index is \"%.*s\"; give whole numbers",
                         (int)(length < 30 ? length : 30), text);
}

/* Read the corner at *text into corner `to` of the builder. Returns 1; 0 if there is no further
 * index; -1 on failure. */
static int read_corner(meshing *m, const xmlNode *p, const strides *s, const char **text,
                       size_t to) {
  for (size_t n = 0; n < s->stride; n++) {
    size_t index = 0;
    int got = sepax__dae_next_whole(text, &index);
    if (got != 1) {
      return got == 0 && n == 0 ? 0 : (fail_index(m, p, got, *text), -1);
    }
    if (n == s->vertex && index >= m->positions) {
      sepax__dae_fail(m->d, p, "<p>: index %zu, but there are %zu vertices; export it again", index,
                      m->positions);
      return -1;
    }
    if (n == s->vertex) {
      memcpy(m->d->b->corner[to], m->position[index], sizeof m->position[index]);
    }
  }
  return 1;
}

static bool read_corners(meshing *m, const xmlNode *p, const strides *s, const char **text,
                         size_t count) {
  for (size_t n = 0; n < count; n++) {
    if (!sepax__builder_corners(m->d->b, n + 1)) {
      return false;
    }
    int got = read_corner(m, p, s, text, n);
    if (got != 1) {
      return got == 0 ? fail_index(m, p, 0, *text) : false;
    }
  }
  return true;
}

/* All corners of a <p>; at most 2^31 bytes of it are there. */
static bool read_all_corners(meshing *m, const xmlNode *p, const strides *s, size_t *count) {
  const char *text = sepax__dae_text(p);
  int got = 1;
  for (*count = 0; got == 1; *count += got == 1) {
    if (!sepax__builder_corners(m->d->b, *count + 1)) {
      return false;
    }
    got = read_corner(m, p, s, &text, *count);
  }
  return got == 0;
}

static bool ends(const meshing *m, const xmlNode *node, const char *text) {
  return text[strspn(text, " \t\r\n")] == '\0' ||
         sepax__dae_fail(m->d, node, "<%s> has more numbers than its count says; export it again",
                         (const char *)node->name);
}

/* One or two corners are a triangle without an area: a point or a segment of the surface. */
static bool make_polygon(meshing *m, const xmlNode *p, size_t count, size_t number) {
  mesh_builder *b = m->d->b;
  if (count == 0) {
    return sepax__dae_fail(m->d, p, "polygon %zu has no corners; leave it out", number);
  }
  if (!sepax__builder_corners(b, 3)) {
    return false;
  }
  for (size_t n = count; n < 3; n++) {
    memcpy(b->corner[n], b->corner[n - 1], sizeof b->corner[n]);
  }
  m->g->faces++;
  return sepax__builder_polygon(b, count < 3 ? 3 : count, (size_t)xmlGetLineNo(p), "polygon",
                                number);
}

/* The only <p>, or NULL in a primitive of nothing. */
static bool find_p(const meshing *m, const xmlNode *primitive, const char *name, size_t count,
                   xmlNode **p) {
  if (!sepax__xml_single(&m->d->file, primitive, name, p, m->d->b->error)) {
    return false;
  }
  return *p != NULL || count == 0 ||
         sepax__dae_fail(m->d, primitive, "<%s count=\"%zu\"> without <%s>; export it again",
                         (const char *)primitive->name, count, name);
}

static bool read_triangles(meshing *m, const xmlNode *primitive, const strides *s, size_t count) {
  xmlNode *p = NULL;
  if (!find_p(m, primitive, "p", count, &p) || p == NULL) {
    return p == NULL && count == 0;
  }
  const char *text = sepax__dae_text(p);
  for (size_t n = 0; n < count; n++) {
    if (!read_corners(m, p, s, &text, 3) || !make_polygon(m, p, 3, n)) {
      return false;
    }
  }
  return ends(m, p, text);
}

static bool read_polylist(meshing *m, const xmlNode *primitive, const strides *s, size_t count) {
  xmlNode *p = NULL;
  xmlNode *sizes = NULL;
  if (!find_p(m, primitive, "p", count, &p) || !find_p(m, primitive, "vcount", count, &sizes)) {
    return false;
  }
  const char *text = p != NULL ? sepax__dae_text(p) : "";
  const char *size = sizes != NULL ? sepax__dae_text(sizes) : "";
  for (size_t n = 0; n < count; n++) {
    size_t corners = 0;
    if (sepax__dae_next_whole(&size, &corners) != 1) {
      return sepax__dae_fail(m->d, sizes,
                             "<vcount> has %zu whole numbers, not %zu; export it again", n, count);
    }
    if (!read_corners(m, p, s, &text, corners) || !make_polygon(m, p, corners, n)) {
      return false;
    }
  }
  return (sizes == NULL || ends(m, sizes, size)) && (p == NULL || ends(m, p, text));
}

typedef enum { POLYGONS, STRIPS, FANS } many;

static bool make_strip(meshing *m, const xmlNode *p, size_t count, many kind) {
  mesh_builder *b = m->d->b;
  if (count < 3) {
    return sepax__dae_fail(m->d, p, "a strip or fan of %zu vertices; leave it out", count);
  }
  m->g->faces++;
  for (size_t n = 2; n < count; n++) {
    /* Every other triangle of a strip runs the other way round. */
    size_t first = kind == FANS ? 0 : n % 2 == 0 ? n - 2 : n - 1;
    size_t second = kind == STRIPS && n % 2 != 0 ? n - 2 : n - 1;
    double v[3][3];
    memcpy(v[0], b->corner[first], sizeof v[0]);
    memcpy(v[1], b->corner[second], sizeof v[1]);
    memcpy(v[2], b->corner[n], sizeof v[2]);
    if (!sepax__builder_triangle(b, (const double(*)[3])v)) {
      return false;
    }
  }
  return true;
}

/* One <p> for each element. */
static bool read_many(meshing *m, const xmlNode *primitive, const strides *s, size_t count,
                      many kind) {
  const xmlNode *hole = sepax__xml_child(primitive, "ph");
  size_t found = 0;
  if (hole != NULL) {
    return sepax__dae_fail(m->d, hole, "a polygon with holes (<ph>) is not read; export triangles");
  }
  for (const xmlNode *p = sepax__xml_child(primitive, "p"); p != NULL;
       p = sepax__xml_next(p, "p")) {
    size_t corners = 0;
    if (!read_all_corners(m, p, s, &corners) ||
        !(kind == POLYGONS ? make_polygon(m, p, corners, found)
                           : make_strip(m, p, corners, kind))) {
      return false;
    }
    found++;
  }
  return found == count ||
         sepax__dae_fail(m->d, primitive, "<%s count=\"%zu\"> has %zu of them; export it again",
                         (const char *)primitive->name, count, found);
}

static bool read_primitive(meshing *m, const xmlNode *primitive) {
  const char *name = (const char *)primitive->name;
  bool is_line = strcmp(name, "lines") == 0 || strcmp(name, "linestrips") == 0;
  strides s = {0};
  size_t count = 0;
  if (sepax__dae_attribute(primitive, "count") == NULL) {
    return sepax__dae_fail(m->d, primitive, "<%s> without a count; export it again", name);
  }
  if (!sepax__dae_whole(m->d, primitive, "count", &count)) {
    return false;
  }
  if (is_line) {
    return sepax__builder_other(m->d->b, name, count);
  }
  if (!read_inputs(m, primitive, &s)) {
    return false;
  }
  if (strcmp(name, "triangles") == 0) {
    return read_triangles(m, primitive, &s, count);
  }
  if (strcmp(name, "polylist") == 0) {
    return read_polylist(m, primitive, &s, count);
  }
  return read_many(m, primitive, &s, count,
                   strcmp(name, "polygons") == 0    ? POLYGONS
                   : strcmp(name, "tristrips") == 0 ? STRIPS
                                                    : FANS);
}

/* ---------------------------------------------------------------------------- geometry */

/* Find the mesh of a geometry; a convex mesh may have one of its own. */
static bool find_mesh(const dae *d, const xmlNode *geometry, const xmlNode **mesh) {
  *mesh = NULL;
  for (const xmlNode *child = sepax__xml_child(geometry, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    const char *name = (const char *)child->name;
    if (strcmp(name, "asset") == 0 || strcmp(name, "extra") == 0) {
      continue;
    }
    if (strcmp(name, "spline") == 0 || strcmp(name, "brep") == 0) {
      return sepax__dae_fail(d, child, "<%s> is not read; export a mesh", name);
    }
    if (sepax__dae_attribute(child, "convex_hull_of") != NULL) {
      return sepax__dae_fail(
          d, child, "a convex hull of another mesh is not read; export the hull as a mesh");
    }
    if (*mesh != NULL) {
      return sepax__dae_fail(d, child, "a second mesh in one <geometry>; leave one of them out");
    }
    *mesh = child;
  }
  return *mesh != NULL || sepax__dae_fail(d, geometry, "<geometry> without a mesh; leave it out");
}

static bool read_mesh(meshing *m, const xmlNode *mesh) {
  for (const xmlNode *child = sepax__xml_child(mesh, NULL); child != NULL;
       child = sepax__xml_next(child, NULL)) {
    bool is_primitive = !sepax__xml_is(child, "source") && !sepax__xml_is(child, "vertices") &&
                        !sepax__xml_is(child, "extra");
    if (is_primitive && !read_primitive(m, child)) {
      return false;
    }
  }
  return true;
}

/* The builder's soup belongs to this geometry until its triangles are taken away here. */
bool sepax__dae_mesh(dae *d, dae_geometry *g) {
  meshing m = {.d = d, .g = g};
  mesh_builder *b = d->b;
  const xmlNode *mesh = NULL;
  bool ok = find_mesh(d, g->node, &mesh) && read_mesh(&m, mesh);
  sepax_release(m.position);
  if (!ok || b->soup.count == 0) {
    return ok;
  }
  sepax_facet *less = sepax_resize(b->soup.facet, b->soup.count * sizeof *less);
  g->facet = less != NULL ? less : b->soup.facet;
  g->count = b->soup.count;
  b->soup.facet = NULL;
  b->soup.count = 0;
  b->capacity = 0;
  return true;
}
