/* SPDX-License-Identifier: MIT */
/* model.h - the objects of the model parts of a 3MF package (private). */
#ifndef SEPAX_MODEL_H
#define SEPAX_MODEL_H

#include "archive/part_xml.h"

#include <stdint.h>

/* The matrix m of p' = p m for a row (x y z 1): three rows rotate and scale, and the last one
 * moves. */
typedef struct {
  double m[4][3];
  bool identity, mirrors;
} model_matrix;

/* A use of an object: as a component of another object, or as an item that the file builds. */
typedef struct {
  size_t part, id;
  size_t in; /* the part with this use, and its line */
  int line;
  model_matrix at;
} model_use;

typedef struct {
  size_t part, id;
  int line;
  bool is_mesh, is_other; /* is_mesh: it has triangles, not components; is_other: its type is
                             "other", which is not built */
  size_t first, count;    /* its triangles or components */
  size_t vertex;          /* its first vertex */
  /* Of place.c: */
  size_t weight, visits; /* triangles that one use makes; components visited for that */
  size_t height;         /* levels of components */
  bool entered, done, placed;
  bool turned; /* its mesh is inside out, so its triangles are turned round */
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

/* Read a model part: its objects, and for the root part also its items and its unit. Marks parts
 * that it refers to in p.part[].is_model. */
bool sepax__model_read(model *m, size_t part);

/* Read a matrix, such as "1 0 0 0 1 0 0 0 1 0 0 0". */
bool sepax__model_matrix(const part_xml *x, const part_attribute *a, model_matrix *at);

/* Place the objects that the items build. *unplaced receives the number of triangles of all other
 * objects. */
bool sepax__model_place(model *m, size_t *unplaced);

/* Is the surface of the mesh closed, and wound so that its outer side is inside? Takes time with
 * its triangles. */
bool sepax__model_inside_out(const model *m, const model_object *o);

/* Name in the account the volumes that a slicer says are no material. */
bool sepax__slicer_volumes(package *p);

/* What the reader does with an extension, by its namespace. READ: all its surfaces are read.
 * SURFACES: it adds surfaces that are not read, so it is refused. LEFT_OUT: it is unknown or
 * describes the same object in another way; it is refused if the file requires it. */
typedef enum { EXTENSION_READ, EXTENSION_SURFACES, EXTENSION_LEFT_OUT } extension_kind;
extension_kind sepax__model_extension(const char *space);

#endif
