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

/* A <node> or <visual_scene>: how many triangles one of it makes, how many children are visited for
 * that, and how many levels it has. The _private of its xmlNode is its number here, and one more.
 */
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

/* The value of an attribute, of the document; NULL without it. */
const char *sepax__dae_attribute(const xmlNode *node, const char *name);
/* The text in an element; "" without any. */
const char *sepax__dae_text(const xmlNode *node);

/* The next number of a text: 1, 0 where there is none, -1 where it is something else. */
int sepax__dae_next_real(const char **text, double *value);
int sepax__dae_next_whole(const char **text, size_t *value);
/* All of the `count` numbers in an element, no more. */
bool sepax__dae_reals(const dae *d, const xmlNode *node, double *value, size_t count);
/* The attribute as a whole number; without it, `otherwise`. */
bool sepax__dae_whole(const dae *d, const xmlNode *node, const char *name, size_t *value);

/* dae_schema.c: all elements on the way to the triangles are as in the schema; lists what has an
 * id, nodes and geometries; names libraries without a surface, and the unit. */
bool sepax__dae_check(dae *d);
/* The element `name` that the attribute ("#id") of `from` refers to; NULL, and fails. */
xmlNode *sepax__dae_refer(const dae *d, const xmlNode *from, const char *attribute,
                          const char *name);

/* dae_mesh.c: the triangles and the faces of a geometry. */
bool sepax__dae_mesh(dae *d, dae_geometry *g);

/* dae_scene.c: the geometries where the scene places them. */
bool sepax__dae_place(dae *d);

#endif
