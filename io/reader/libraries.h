/* SPDX-License-Identifier: MIT */
/* libraries.h - libraries that read files, of which a build may lack some (private).
 *
 * Code that calls libxml2 is in io/xml and io/robot/libxml2, code that calls libzip in io/archive.
 * Where the library is missing, make compiles a file of a folder `missing` instead, which has the
 * same functions; they fail. */
#ifndef SEPAX_LIBRARIES_H
#define SEPAX_LIBRARIES_H

#include "sepax.h"

enum { NEEDS_LIBXML2 = 1, NEEDS_LIBZIP = 2 };

/* Which of the two files was compiled. */
extern const bool sepax__libxml2_here;
extern const bool sepax__libzip_here;

/* True where this build has all `libraries`. If not, fails and says which format cannot be read,
 * and what to install. */
bool sepax__libraries_here(int libraries, const char *path, const char *format, sepax_error *error);

#endif
