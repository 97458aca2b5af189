/* confined.h - readers that may hang, crash or take all memory on a file that is none (private). */
#ifndef SEPAX_CONFINED_H
#define SEPAX_CONFINED_H

#include "sepax.h"

/* Let `read` fill the mesh in a process of its own, of which memory and time are limited by the
 * file's length. Fails where it fails, is ended, or leaves no triangle; on what is no file, is
 * empty or longer than 1 GiB. */
bool confined_read(sepax_mesh *mesh, const char *path,
                   bool (*read)(sepax_mesh *mesh, const char *path, sepax_error *error),
                   sepax_error *error);

#endif
