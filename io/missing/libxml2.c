/* SPDX-License-Identifier: MIT */
/* libxml2.c - in place of io/xml in a build without libxml2. */
#include "reader/format_table.h"

#include <string.h>

const bool sepax__libxml2_here = false;

/* True for any XML, so that the message says that libxml2 is missing. */
bool sepax__dae_is(const char *bytes, size_t size) {
  bytes += size >= 3 && memcmp(bytes, "\xef\xbb\xbf", 3) == 0 ? 3 : 0;
  return strncmp(bytes, "<?xml", 5) == 0 || strncmp(bytes, "<COLLADA", 8) == 0;
}

bool sepax__dae_read(mesh_builder *b, size_t *faces) {
  *faces = 0;
  return sepax__libraries_here(NEEDS_LIBXML2, b->path, "DAE", b->error);
}

bool sepax__dae_count(const mesh_builder *b, size_t *faces) {
  *faces = 0;
  return sepax__libraries_here(NEEDS_LIBXML2, b->path, "DAE", b->error);
}
