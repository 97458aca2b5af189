/* mesh.h - what a mesh file has, as text and as JSON. */
#ifndef SEPAX_REPORT_MESH_H
#define SEPAX_REPORT_MESH_H

#include "sepax_io.h"

#include <jansson.h>

/* A file as it was read, and what became of it. */
typedef struct {
  sepax_mesh_account account;
  double unit_mm; /* what a unit of the file was taken to be; 0: that of the result */
  bool welded;
  sepax_weld weld; /* lengths in units of the result, which are 10^unit metres */
  int unit;
} report_mesh;

/* Is there more to say than the format and the number of triangles? */
bool report_mesh_is_plain(const report_mesh *mesh);

/* "FILE, 3MF, 24 triangles", and what else there is to say in lines of their own; the name at the
 * left takes `width` characters. */
void report_print_mesh(const char *name, int width, const char *path, const report_mesh *mesh);

/* The same as keys of an object that says which file it is. */
void report_set_mesh(json_t *to, const report_mesh *mesh);

#endif
