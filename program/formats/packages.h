/* packages.h - where the meshes of a URDF are (private). */
#ifndef SEPAX_PACKAGES_H
#define SEPAX_PACKAGES_H

#include "formats/formats.h"

typedef struct {
  const char *urdf;
  const format_package *package;
  size_t packages;
} format_places;

/* The file that a URDF calls by this name, by sepax_allocate: a path, from the folder of the URDF
 * where it is relative; file://; package://NAME/..., by `package`, or in NAME beside the URDF or
 * beside a folder above it, or in such a folder that is called NAME. Fails where no file is. */
bool format_find_mesh(const format_places *places, const char *name, char **path,
                      sepax_error *error);

#endif
