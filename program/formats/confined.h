/* confined.h - readers that may hang, crash or take all memory on a file that is none (private). */
#ifndef SEPAX_CONFINED_H
#define SEPAX_CONFINED_H

#include "sepax.h"

/* A mesh may be so long. */
#define CONFINED_BYTES_MOST ((size_t)1 << 30)

/* Fails on what is no file, is empty or longer than that. */
bool confined_size(const char *path, size_t *bytes, sepax_error *error);

/* Let `read` fill the mesh in a process of its own, of which memory and time are limited by the
 * file's length. Fails where it fails, is ended, or leaves no triangle, and where confined_size
 * does. */
bool confined_read(sepax_soup *mesh, const char *path,
                   bool (*read)(sepax_soup *mesh, const char *path, sepax_error *error),
                   sepax_error *error);

#endif
