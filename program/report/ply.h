/* SPDX-License-Identifier: MIT */
/* ply.h - bodies as a PLY file (binary, coordinates as doubles), for any mesh viewer. */
#ifndef SEPAX_REPORT_PLY_H
#define SEPAX_REPORT_PLY_H

#include "sepax.h"

#include <stdio.h>

/* A body in one colour (red, green, blue). Marked faces have another colour. */
typedef struct {
  const sepax_soup *mesh;
  const sepax_pose *pose; /* NULL: as in its file */
  uint8_t colour[3], marked_colour[3];
  const bool *marked; /* marked[n]: face n is marked; NULL: no face is */
} report_ply_body;

typedef struct {
  const report_ply_body *body;
  size_t bodies;
  bool numbered; /* each face has the number of its body as a property "body" */
  /* Prints lines that begin with "comment ". */
  bool (*print_comments)(FILE *out, const void *context);
  const void *context;
} report_ply;

/* Write the file, with three vertices for each face. On failure an existing file is unchanged. */
bool report_ply_write(const report_ply *ply, const char *path, sepax_error *error);

#endif
