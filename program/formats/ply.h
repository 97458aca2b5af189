/* ply.h - PLY files that are cut off, which assimp does not notice (private). */
#ifndef SEPAX_PLY_H
#define SEPAX_PLY_H

#include "sepax.h"

/* The file has a head, and behind it as many lines (of text) or bytes at least as its elements,
 * lists being those of triangles, take. */
bool ply_is_whole(const char *path, sepax_error *error);

#endif
