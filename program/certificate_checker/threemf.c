/* SPDX-License-Identifier: MIT */
/* threemf.c - 3MF: the core specification and its production extension, read with libzip. */
#include "mesh.h"
#include "report.h"
#include "tree.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <zip.h>

#define CORE "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#define PRODUCTION "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"
#define MATERIALS "http://schemas.microsoft.com/3dmanufacturing/material/2015/02"
#define SETS "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07"
#define MODEL_TYPE "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"
#define RELATIONSHIPS "http://schemas.openxmlformats.org/package/2006/relationships"

/* A package of some bytes may unpack to, or place, more than any memory holds. */
enum { UNPACKED_MOST = 1 << 30, DEPTH_MOST = 64, PLACED_MOST = 1000000 };

typedef struct {
  char *name; /* from the root of the package, without a slash before it */
  xmlNode *root;
} part;

typedef struct {
  char *part; /* its part and number */
  long number;
  bool placed;
  bool other;  /* of type "other": not to be built */
  bool turned; /* inside out, so its triangles are turned round */
  point *vertex;
  size_t vertices;
  size_t (*triangle)[3];
  size_t triangles;
  xmlNode *components;
} object;

typedef struct {
  mesh *m;
  zip_t *zip;
  part *part;
  size_t parts, unpacked;
  object *object;
  size_t objects;
  size_t placed;
} package3;

/* The whole of a part; NULL if there is no such part. */
static char *unpack(package3 *p, const char *name, size_t *length) {
  zip_stat_t about;
  zip_stat_init(&about);
  const zip_int64_t index = zip_name_locate(p->zip, name, ZIP_FL_NOCASE);
  if (index < 0)
    return NULL;
  if (zip_stat_index(p->zip, (zip_uint64_t)index, 0, &about) != 0 || !(about.valid & ZIP_STAT_SIZE))
    cannot("%s: %s: cannot be unpacked", p->m->file, name);
  if (about.size > UNPACKED_MOST - p->unpacked)
    cannot("%s: %s: unpacks to more than 1 GiB", p->m->file, name);
  p->unpacked += (size_t)about.size;
  zip_file_t *in = zip_fopen_index(p->zip, (zip_uint64_t)index, 0);
  char *bytes = memory(NULL, (size_t)about.size + 1, 1);
  /* Read to its end, where libzip compares the sum of the part. */
  if (in == NULL || zip_fread(in, bytes, about.size) != (zip_int64_t)about.size ||
      zip_fread(in, bytes + about.size, 1) != 0)
    cannot("%s: %s: cannot be unpacked", p->m->file, name);
  zip_fclose(in);
  *length = (size_t)about.size;
  bytes[*length] = 0;
  return bytes;
}

static xmlNode *document(package3 *p, const char *name) {
  size_t length = 0;
  char *bytes = unpack(p, name, &length);
  if (bytes == NULL)
    cannot("%s: has no part %s", p->m->file, name);
  xmlNode *root = tree_root(p->m->file, bytes, length);
  free(bytes);
  return root;
}

static char *required(const package3 *p, const xmlNode *node, const char *name) {
  char *text = tree_attribute(node, name, NULL);
  if (text == NULL)
    cannot("%s:%ld: %s without %s", p->m->file, tree_line(node), (const char *)node->name, name);
  return text;
}

static long double number_of(const package3 *p, const xmlNode *node, const char *name) {
  char *text = required(p, node, name);
  const char *next = text;
  const long double value = mesh_number(p->m, &next, 0, tree_line(node));
  if (next[strspn(next, " \t\r\n")] != 0)
    cannot("%s:%ld: %s=\"%.30s\"", p->m->file, tree_line(node), name, text);
  xmlFree(text);
  return value;
}

static long whole_of(const package3 *p, const xmlNode *node, const char *name) {
  const long double value = number_of(p, node, name);
  if (!(value >= 0 && value < 2147483648.0L) || value != floorl(value))
    cannot("%s:%ld: %s=\"%Lg\"", p->m->file, tree_line(node), name, value);
  return (long)value;
}

/* ------------------------------------------------------------------- the parts */

static bool is_known(const char *space) {
  static const char *const known[] = {CORE, PRODUCTION, MATERIALS, SETS};
  for (size_t n = 0; space != NULL && n < sizeof known / sizeof *known; n++) {
    if (strcmp(space, known[n]) == 0)
      return true;
  }
  return false;
}

/* Without an extension that is required, a model is another one. */
static void check_required(const package3 *p, xmlNode *root) {
  char *text = tree_attribute(root, "requiredextensions", NULL);
  for (char *at = text; at != NULL;) {
    at += strspn(at, " \t\r\n");
    const size_t length = strcspn(at, " \t\r\n");
    if (length == 0)
      break;
    char *prefix = text_copy(at, length);
    const xmlNs *space = xmlSearchNs(root->doc, root, (const xmlChar *)prefix);
    if (space == NULL || !is_known((const char *)space->href))
      cannot("%s: needs the extension %s", p->m->file,
             space == NULL ? prefix : (const char *)space->href);
    free(prefix);
    at += length;
  }
  xmlFree(text);
}

static void read_mesh(const package3 *p, xmlNode *node, object *o) {
  for (xmlNode *list = tree_element(node->children); list != NULL;
       list = tree_element(list->next)) {
    const bool vertices = tree_is_of(list, "vertices", CORE);
    if (!vertices && !tree_is_of(list, "triangles", CORE)) {
      if (list->ns == NULL || strcmp((const char *)list->ns->href, CORE) == 0)
        cannot("%s:%ld: unknown element %s", p->m->file, tree_line(list), (const char *)list->name);
      continue; /* of an extension that is not required */
    }
    for (xmlNode *n = tree_element(list->children); n != NULL; n = tree_element(n->next)) {
      if (!tree_is_of(n, vertices ? "vertex" : "triangle", CORE))
        cannot("%s:%ld: unknown element %s", p->m->file, tree_line(n), (const char *)n->name);
      if (vertices) {
        GROW(o->vertex, o->vertices);
        o->vertex[o->vertices++] =
            (point){number_of(p, n, "x"), number_of(p, n, "y"), number_of(p, n, "z")};
      } else {
        GROW(o->triangle, o->triangles);
        size_t *corner = o->triangle[o->triangles++];
        corner[0] = (size_t)whole_of(p, n, "v1");
        corner[1] = (size_t)whole_of(p, n, "v2");
        corner[2] = (size_t)whole_of(p, n, "v3");
      }
    }
  }
  for (size_t n = 0; n < 3 * o->triangles; n++) {
    if (o->triangle[n / 3][n % 3] >= o->vertices)
      cannot("%s:%ld: no vertex %zu", p->m->file, tree_line(node), o->triangle[n / 3][n % 3]);
  }
}

/* ------------------------------------------------------ meshes that are inside out */

typedef struct {
  point at;
  size_t number; /* that of the vertex in the file, or of the first with the same coordinates */
} numbered;

static int by_place(const void *a, const void *b) {
  const point p = ((const numbered *)a)->at;
  const point q = ((const numbered *)b)->at;
  const long double way = p.x != q.x ? p.x - q.x : p.y != q.y ? p.y - q.y : p.z - q.z;
  return (way > 0) - (way < 0);
}

static int by_ends(const void *a, const void *b) {
  const size_t *p = a;
  const size_t *q = b;
  return p[0] != q[0] ? (p[0] > q[0]) - (p[0] < q[0]) : (p[1] > q[1]) - (p[1] < q[1]);
}

/* Are there as many edges from each vertex to each other one as back? Vertices in one place are
 * one. */
static bool edges_cancel(const object *o) {
  numbered *v = memory(NULL, o->vertices, sizeof *v);
  size_t *first = memory(NULL, o->vertices, sizeof *first);
  size_t(*ahead)[2] = memory(NULL, 3 * o->triangles, sizeof *ahead);
  size_t(*back)[2] = memory(NULL, 3 * o->triangles, sizeof *back);
  for (size_t n = 0; n < o->vertices; n++)
    v[n] = (numbered){o->vertex[n], n};
  qsort(v, o->vertices, sizeof *v, by_place);
  for (size_t n = 0; n < o->vertices; n++) {
    const bool same = n > 0 && by_place(&v[n - 1], &v[n]) == 0;
    first[v[n].number] = same ? first[v[n - 1].number] : v[n].number;
  }
  for (size_t n = 0; n < 3 * o->triangles; n++) {
    const size_t *corner = o->triangle[n / 3];
    ahead[n][0] = back[n][1] = first[corner[n % 3]];
    ahead[n][1] = back[n][0] = first[corner[(n + 1) % 3]];
  }
  qsort(ahead, 3 * o->triangles, sizeof *ahead, by_ends);
  qsort(back, 3 * o->triangles, sizeof *back, by_ends);
  const bool same = memcmp(ahead, back, 3 * o->triangles * sizeof *ahead) == 0;
  free(v);
  free(first);
  free(ahead);
  free(back);
  return same;
}

/* A closed surface whose volume is negative has its outer side inside. 3MF calls it empty; a file
 * that builds it means a body. */
static bool is_inside_out(const object *o) {
  long double volume = 0;
  long double size = 0;
  for (size_t n = 0; n < o->triangles; n++) {
    point at[3];
    for (int k = 0; k < 3; k++)
      at[k] = point_minus(o->vertex[o->triangle[n][k]], o->vertex[o->triangle[0][0]]);
    volume += point_dot(at[0], point_cross(at[1], at[2]));
    size += point_length(at[0]) * point_length(at[1]) * point_length(at[2]);
  }
  return volume < -1e-15L * size && edges_cancel(o);
}

static void read_object(package3 *p, char *name, xmlNode *node) {
  object o = {.part = name, .number = whole_of(p, node, "id")};
  for (size_t n = 0; n < p->objects; n++) {
    if (p->object[n].number == o.number && strcasecmp(p->object[n].part, name) == 0)
      cannot("%s:%ld: two objects %ld", p->m->file, tree_line(node), o.number);
  }
  char *kind = tree_attribute(node, "type", NULL);
  o.other = kind != NULL && strcmp(kind, "other") == 0;
  xmlFree(kind);
  int bodies = 0;
  for (xmlNode *n = tree_element(node->children); n != NULL; n = tree_element(n->next)) {
    if (tree_is_of(n, "mesh", CORE)) {
      bodies++;
      read_mesh(p, n, &o);
    } else if (tree_is_of(n, "components", CORE)) {
      bodies++;
      o.components = n;
    } else if (!tree_is_of(n, "metadatagroup", CORE) && !tree_is_of(n, "metadata", CORE)) {
      cannot("%s:%ld: unknown element %s", p->m->file, tree_line(n), (const char *)n->name);
    }
  }
  if (bodies != 1)
    cannot("%s:%ld: object %ld: not one mesh", p->m->file, tree_line(node), o.number);
  o.turned = is_inside_out(&o);
  GROW(p->object, p->objects);
  p->object[p->objects++] = o;
}

/* `name` without a slash before it; each part is read once. */
static part *part_named(package3 *p, const char *name) {
  for (size_t n = 0; n < p->parts; n++) {
    if (strcasecmp(p->part[n].name, name) == 0)
      return &p->part[n];
  }
  const part new = {text_copy(name, strlen(name)), document(p, name)};
  if (!tree_is_of(new.root, "model", CORE))
    cannot("%s: %s: is no model of the 3MF core specification", p->m->file, name);
  check_required(p, new.root);
  GROW(p->part, p->parts);
  p->part[p->parts++] = new;
  for (xmlNode *n = tree_element(new.root->children); n != NULL; n = tree_element(n->next)) {
    const bool resources = tree_is_of(n, "resources", CORE);
    if (!resources && !tree_is_of(n, "build", CORE) && !tree_is_of(n, "metadata", CORE) &&
        (n->ns == NULL || strcmp((const char *)n->ns->href, CORE) == 0))
      cannot("%s:%ld: unknown element %s", p->m->file, tree_line(n), (const char *)n->name);
    for (xmlNode *of = resources ? tree_element(n->children) : NULL; of != NULL;
         of = tree_element(of->next)) {
      if (tree_is_of(of, "object", CORE))
        read_object(p, new.name, of);
      else if (tree_is_of(of, (const char *)of->name, CORE) && !tree_is(of, "basematerials") &&
               !tree_is(of, "metadata"))
        cannot("%s:%ld: unknown element %s", p->m->file, tree_line(of), (const char *)of->name);
    }
  }
  return &p->part[p->parts - 1];
}

/* -------------------------------------------------------------------- the build */

/* Twelve numbers: a row vector times a matrix of four rows. */
static placement transform_of(const package3 *p, const xmlNode *node) {
  char *text = tree_attribute(node, "transform", NULL);
  if (text == NULL)
    return PLACEMENT_NONE;
  long double v[12];
  const char *next = text;
  for (int n = 0; n < 12; n++)
    v[n] = mesh_number(p->m, &next, 0, tree_line(node));
  if (next[strspn(next, " \t\r\n")] != 0)
    cannot("%s:%ld: transform of more than twelve numbers", p->m->file, tree_line(node));
  xmlFree(text);
  return (placement){{{v[0], v[3], v[6]}, {v[1], v[4], v[7]}, {v[2], v[5], v[8]}},
                     {v[9], v[10], v[11]}};
}

static void place(package3 *p, const char *in, const xmlNode *node, placement at, int depth);

static void place_object(package3 *p, const object *o, const placement *at, int depth) {
  p->m->turned = placement_mirrors(at) != o->turned;
  for (size_t n = 0; n < o->triangles; n++) {
    point corner[3];
    for (int k = 0; k < 3; k++)
      corner[k] = placement_apply(at, o->vertex[o->triangle[n][k]]);
    mesh_polygon(p->m, corner, 3);
  }
  for (xmlNode *n = o->components == NULL ? NULL : tree_element(o->components->children); n != NULL;
       n = tree_element(n->next)) {
    if (!tree_is_of(n, "component", CORE))
      cannot("%s:%ld: unknown element %s", p->m->file, tree_line(n), (const char *)n->name);
    place(p, o->part, n, *at, depth + 1);
  }
}

/* An item or component of the part `in`. The objects are copied as more may be read. */
static void place(package3 *p, const char *in, const xmlNode *node, placement at, int depth) {
  if (depth > DEPTH_MOST || ++p->placed > PLACED_MOST)
    cannot("%s:%ld: too many components, or a circle of them", p->m->file, tree_line(node));
  char *path = tree_attribute(node, "path", PRODUCTION);
  const char *name = path != NULL ? part_named(p, path + (*path == '/'))->name : in;
  const long number = whole_of(p, node, "objectid");
  const placement own = transform_of(p, node);
  const placement all = placement_product(&at, &own);
  xmlFree(path);
  for (size_t n = 0; n < p->objects; n++) {
    const object o = p->object[n];
    if (o.number != number || strcasecmp(o.part, name) != 0)
      continue;
    p->m->faces += o.placed ? 0 : o.triangles;
    p->object[n].placed = true;
    if (o.other && depth == 0)
      cannot("%s:%ld: builds an object of type other", p->m->file, tree_line(node));
    place_object(p, &o, &all, depth);
    return;
  }
  cannot("%s:%ld: no object %ld", p->m->file, tree_line(node), number);
}

static long double unit_of(const package3 *p, const xmlNode *root) {
  static const struct {
    const char *name;
    long double mm;
  } UNIT[] = {{"micron", 0.001L}, {"millimeter", 1}, {"centimeter", 10},
              {"inch", 25.4L},    {"foot", 304.8L},  {"meter", 1000}};
  char *text = tree_attribute(root, "unit", NULL);
  long double mm = text == NULL ? 1 : 0;
  for (size_t n = 0; text != NULL && n < sizeof UNIT / sizeof *UNIT; n++) {
    if (strcmp(text, UNIT[n].name) == 0)
      mm = UNIT[n].mm;
  }
  if (mm == 0)
    cannot("%s: unknown unit %s", p->m->file, text);
  xmlFree(text);
  return mm;
}

static char *start_part(package3 *p) {
  xmlNode *root = document(p, "_rels/.rels");
  char *target = NULL;
  for (xmlNode *n = tree_element(root->children); n != NULL; n = tree_element(n->next)) {
    char *kind =
        tree_is_of(n, "Relationship", RELATIONSHIPS) ? tree_attribute(n, "Type", NULL) : NULL;
    if (kind != NULL && strcmp(kind, MODEL_TYPE) == 0) {
      if (target != NULL)
        cannot("%s: two models to start with", p->m->file);
      target = required(p, n, "Target");
    }
    xmlFree(kind);
  }
  if (target == NULL)
    cannot("%s: has no model", p->m->file);
  tree_free(root);
  return target;
}

void mesh_3mf(mesh *m, const char *bytes, size_t length) {
  package3 p = {.m = m};
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t *source = zip_source_buffer_create(bytes, length, 0, &error);
  p.zip = source == NULL ? NULL : zip_open_from_source(source, ZIP_RDONLY, &error);
  if (p.zip == NULL)
    cannot("%s: is no ZIP archive: %s", m->file, zip_error_strerror(&error));
  char *target = start_part(&p);
  part start = *part_named(&p, target + (*target == '/'));
  m->unit_mm = unit_of(&p, start.root);
  xmlNode *build = tree_child(start.root, "build");
  for (xmlNode *n = build == NULL ? NULL : tree_element(build->children); n != NULL;
       n = tree_element(n->next)) {
    if (!tree_is_of(n, "item", CORE))
      cannot("%s:%ld: unknown element %s", m->file, tree_line(n), (const char *)n->name);
    place(&p, start.name, n, PLACEMENT_NONE, 0);
  }
  for (size_t n = 0; n < p.objects; n++) {
    free(p.object[n].vertex);
    free(p.object[n].triangle);
  }
  for (size_t n = 0; n < p.parts; n++) {
    if (unit_of(&p, p.part[n].root) != m->unit_mm)
      cannot("%s: %s: has another unit", m->file, p.part[n].name);
    tree_free(p.part[n].root);
    free(p.part[n].name);
  }
  xmlFree(target);
  free(p.object);
  free(p.part);
  zip_close(p.zip);
}
