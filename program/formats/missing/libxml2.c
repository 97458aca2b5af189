/* SPDX-License-Identifier: MIT */
/* libxml2.c - in place of formats/libxml2 in a build without libxml2. */
#include "formats/formats.h"
#include "reader/libraries.h"

bool format_urdf_read(format_robot *robot, const char *path, const format_package *package,
                      size_t packages, sepax_error *error) {
  (void)package;
  (void)packages;
  *robot = (format_robot){0};
  return sepax__libraries_here(NEEDS_LIBXML2, path, "URDF", error);
}

bool format_srdf_read(bool *compared, const sepax_mechanism *m, format_srdf *srdf, const char *path,
                      sepax_error *error) {
  (void)compared;
  (void)m;
  if (srdf != NULL) {
    *srdf = (format_srdf){0};
  }
  return sepax__libraries_here(NEEDS_LIBXML2, path, "SRDF", error);
}
