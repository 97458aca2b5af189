/* model.h - the objects of the model parts of a 3MF package (private). */
#ifndef SEPAX_MODEL_H
#define SEPAX_MODEL_H

#include "archive/part_xml.h"

#include <stdint.h>

/* p' = p m of a row (x y z 1): three rows that turn and scale, one that moves. */
typedef struct {
  double m[4][3];
  bool identity, mirrors;
} model_matrix;

/* An object that an object has as a component, or that the file builds. */
typedef struct {
  size_t part, id;
  size_t in; /* the part that says so, and its line */
  int line;
  model_matrix at;
} model_use;

typedef struct {
  size_t part, id;
  int line;
  bool is_mesh, is_other; /* else of components; its type is "other", which is not built */
  size_t first, count;    /* of its triangles or components */
  size_t vertex;          /* the first of its vertices */
  /* Of place.c: */
  size_t weight, visits; /* the triangles that one of it makes; components visited for that */
  size_t height;         /* components below each other */
  bool entered, done, placed;
} model_object;

typedef struct {
  package p;
  size_t root;
  double (*vertex)[3];
  uint32_t (*triangle)[3];
  model_object *object;
  model_use *component, *item;
  size_t vertices, triangles, objects, components, items;
  size_t vertex_space, triangle_space, object_space, component_space, item_space;
} model;

/* Read a model part: its objects, and of the root its items and its unit. Marks the parts that it
 * refers to in p.part[].is_model. */
bool sepax__model_read(model *m, size_t part);

/* "1 0 0 0 1 0 0 0 1 0 0 0". */
bool sepax__model_matrix(const part_xml *x, const part_attribute *a, model_matrix *at);

/* Place what the items build; *unplaced gets the triangles of the other objects. */
bool sepax__model_place(model *m, size_t *unplaced);

/* What an extension is to the reader, by its namespace. READ: nothing in it has a surface but what
 * is read. SURFACES: what it adds has a surface, so it is refused. LEFT_OUT: unknown, or other ways
 * to make the same object; refused where the file requires it. */
typedef enum { EXTENSION_READ, EXTENSION_SURFACES, EXTENSION_LEFT_OUT } extension_kind;
extension_kind sepax__model_extension(const char *space);

#define CORE_SPACE "http://schemas.microsoft.com/3dmanufacturing/core/2015/02"
#define PRODUCTION_SPACE "http://schemas.microsoft.com/3dmanufacturing/production/2015/06"

#endif
