/* SPDX-License-Identifier: MIT */
/* read.h - the mesh of bytes (private). */
#ifndef SEPAX_READ_H
#define SEPAX_READ_H

#include "sepax_io.h"

/* Like sepax_mesh_read, but on the bytes of a file, followed by a '\0'. `name` stands for its path
 * in messages, and its ending for the format if the content is unclear. */
bool sepax__mesh_parse(sepax_soup *soup, sepax_mesh_account *account, const char *bytes,
                       size_t size, const char *name, const sepax_mesh_reading *how,
                       sepax_error *error);

#endif
