/* libraries.h - libraries that read files, of which a build may lack some (private).
 *
 * Code that calls a library is in a folder of its name. Where the library is missing, make compiles
 * missing/LIBRARY.c instead, which has the same functions; they fail. */
#ifndef SEPAX_LIBRARIES_H
#define SEPAX_LIBRARIES_H

#include "sepax.h"

enum { NEEDS_ASSIMP = 1, NEEDS_LIBXML2 = 2 };

/* Which of the two files was compiled. */
extern const bool format_assimp_here;
extern const bool format_libxml2_here;

/* True where this build has all `libraries`. If not, fails and says which format cannot be read,
 * and what to install. */
bool format_has(int libraries, const char *path, const char *format, sepax_error *error);

#endif
