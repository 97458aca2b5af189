/* SPDX-License-Identifier: MIT */
/* libzip.c - in place of io/archive in a build without libzip, or without libxml2. */
#include "reader/format_table.h"

#include <string.h>

const bool sepax__libzip_here = false;

bool sepax__threemf_is(const char *bytes, size_t size) {
  return size > 4 && memcmp(bytes, "PK\3\4", 4) == 0;
}

bool sepax__threemf_read(mesh_builder *b, size_t *faces) {
  *faces = 0;
  return sepax__libraries_here(NEEDS_LIBXML2 | NEEDS_LIBZIP, b->path, "3MF", b->error);
}

bool sepax__threemf_count(const mesh_builder *b, size_t *faces) {
  *faces = 0;
  return sepax__libraries_here(NEEDS_LIBXML2 | NEEDS_LIBZIP, b->path, "3MF", b->error);
}
