/* SPDX-License-Identifier: MIT */
/* dae.h - a COLLADA document while it is read (private). */
#ifndef SEPAX_DAE_H
#define SEPAX_DAE_H

#include "reader/builder.h"
#include "xml/xml.h"

/* An element that others refer to: by its name and its id. */
typedef struct {
  const char *name, *id;
  xmlNode *node;
} dae_id;

/* A geometry: its triangles in its own coordinates. */
typedef struct {
  xmlNode *node;
  sepax_facet *facet;
  size_t count, faces;
  bool placed;
} dae_geometry;

/* A <node> or <visual_scene>: the number of triangles that one use makes, of children visited for
 * that, and of its levels. The _private of its xmlNode is its number here plus one. */
typedef struct {
  size_t weight, visits, height;
  bool entered, done;
} dae_node;

typedef struct {
  mesh_builder *b;
  xml_file file;
  dae_id *id;
  dae_geometry *geometry;
  dae_node *node;
  size_t ids, geometries, nodes;
  size_t id_space, geometry_space, node_space;
} dae;

/* "PATH:LINE: ..."; false. */
bool sepax__dae_fail(const dae *d, const xmlNode *node, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* The value of an attribute, owned by the document; NULL if it is missing. */
const char *sepax__dae_attribute(const xmlNode *node, const char *name);
/* The text in an element; "" without any. */
const char *sepax__dae_text(const xmlNode *node);

/* Read the next number of a text. Returns 1; 0 if there is none; -1 if there is something else. */
int sepax__dae_next_real(const char **text, double *value);
int sepax__dae_next_whole(const char **text, size_t *value);
/* Read the `count` numbers of an element, which must have exactly these. */
bool sepax__dae_reals(const dae *d, const xmlNode *node, double *value, size_t count);
/* The attribute as a whole number; without it, `otherwise`. */
bool sepax__dae_whole(const dae *d, const xmlNode *node, const char *name, size_t *value);

/* dae_schema.c: check that all elements on the way to the triangles match the schema; list elements
 * with an id, nodes and geometries; count libraries without a surface; read the unit. */
bool sepax__dae_check(dae *d);
/* Find the element `name` that the attribute ("#id") of `from` refers to. NULL on failure. */
xmlNode *sepax__dae_refer(const dae *d, const xmlNode *from, const char *attribute,
                          const char *name);

/* dae_mesh.c: the triangles and the faces of a geometry. */
bool sepax__dae_mesh(dae *d, dae_geometry *g);

/* dae_scene.c: the geometries where the scene places them. */
bool sepax__dae_place(dae *d);

#endif
