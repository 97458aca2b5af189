/* SPDX-License-Identifier: MIT */
/* libxml2.c - in place of io/xml and io/robot/libxml2 in a build without libxml2. */
#include "reader/format_table.h"
#include "sepax_robot.h"

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

bool sepax_robot_read(sepax_robot *robot, const char *path, const sepax_robot_reading *how,
                      sepax_error *error) {
  (void)how;
  *robot = (sepax_robot){0};
  return sepax__libraries_here(NEEDS_LIBXML2, path, "URDF", error);
}

bool sepax_srdf_read(bool *compared, const sepax_mechanism *m, sepax_srdf *srdf, const char *path,
                     sepax_error *error) {
  (void)compared;
  (void)m;
  if (srdf != NULL) {
    *srdf = (sepax_srdf){0};
  }
  return sepax__libraries_here(NEEDS_LIBXML2, path, "SRDF", error);
}
