/* SPDX-License-Identifier: MIT */
/* write_file.h - files that are whole or not there (private). */
#ifndef SEPAX_WRITE_FILE_H
#define SEPAX_WRITE_FILE_H

#include "sepax.h"

#include <stdio.h>

/* Let `write` fill a new file beside `path`, then rename it to `path`; a false of `write`,
 * like any failure, leaves nothing new and one line that names the path. Fails also where
 * path is there but no file. */
bool sepax_write_file(const char *path, bool (*write)(FILE *out, const void *context),
                      const void *context, sepax_error *error);

/* Whether a file could be begun there now; where not, the line that sepax_write_file would leave.
 */
bool sepax__write_file_possible(const char *path, sepax_error *error);

#endif
