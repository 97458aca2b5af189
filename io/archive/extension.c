/* SPDX-License-Identifier: MIT */
/* extension.c - which extensions of 3MF are read. */
#include "archive/core.h"
#include "archive/model.h"

#include <string.h>

/* Namespaces that are read as a whole: materials colour surfaces, and sets of triangles only name
 * them. */
static const char *const read_spaces[] = {
    PRODUCTION_SPACE,
    "http://schemas.microsoft.com/3dmanufacturing/material/2015/02",
    "http://schemas.microsoft.com/3dmanufacturing/trianglesets/2021/07",
};

/* Parts of the names of namespaces, in every version, that add surfaces or encrypt content. */
static const char *const surface_spaces[] = {
    "/3dmanufacturing/beamlattice/",       "/3dmanufacturing/displacement/",
    "/3dmanufacturing/booleanoperations/", "/3dmanufacturing/volumetric/",
    "/3dmanufacturing/implicit/",          "/3dmanufacturing/securecontent/",
};

extension_kind sepax__model_extension(const char *space) {
  for (size_t n = 0; n < sizeof read_spaces / sizeof read_spaces[0]; n++) {
    if (strcmp(space, read_spaces[n]) == 0) {
      return EXTENSION_READ;
    }
  }
  for (size_t n = 0; n < sizeof surface_spaces / sizeof surface_spaces[0]; n++) {
    if (strstr(space, surface_spaces[n]) != NULL) {
      return EXTENSION_SURFACES;
    }
  }
  return EXTENSION_LEFT_OUT;
}
