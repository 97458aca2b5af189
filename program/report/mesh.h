/* SPDX-License-Identifier: MIT */
/* mesh.h - what a mesh file has, as text and as JSON. */
#ifndef SEPAX_REPORT_MESH_H
#define SEPAX_REPORT_MESH_H

#include "sepax_io.h"

#include <jansson.h>

/* A mesh file as it was read, and what became of it. */
typedef struct {
  sepax_mesh_account account;
  double unit_mm; /* --unit in mm; 0: not given */
  bool welded;
  sepax_weld weld; /* what welding changed; lengths in units of 10^unit metres */
  int unit;
} report_mesh;

/* True if there is nothing to say but the format and the number of triangles. */
bool report_mesh_is_plain(const report_mesh *mesh);

/* Print "FILE, 3MF, 24 triangles" and further facts in lines of their own. The name at the left
 * takes `width` characters. */
void report_print_mesh(const char *name, int width, const char *path, const report_mesh *mesh);

/* Set the same facts as keys of an object that already names the file. */
void report_set_mesh(json_t *to, const report_mesh *mesh);

#endif
