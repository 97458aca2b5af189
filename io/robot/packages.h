/* SPDX-License-Identifier: MIT */
/* packages.h - finds the mesh files of a URDF (private). */
#ifndef SEPAX_PACKAGES_H
#define SEPAX_PACKAGES_H

#include "robot/robot.h"

typedef struct {
  const char *urdf;
  const sepax_package *package;
  size_t packages;
} mesh_places;

/* Find the file that a URDF calls `name`; the path is allocated by sepax_allocate. `name` is a path
 * (relative to the folder of the URDF), file://, or package://NAME/... A package is the folder
 * given in `package`, a folder NAME beside the URDF or beside a folder above it, or such a folder
 * itself. Fails if no file exists. */
bool sepax__find_mesh(const mesh_places *places, const char *name, char **path, sepax_error *error);

#endif
