/* polygon.h - a polygon as triangles (private). */
#ifndef SEPAX_POLYGON_H
#define SEPAX_POLYGON_H

#include <stdbool.h>
#include <stddef.h>

/* A polygon of `count` (4 or more) corners as count - 2 triangles, three numbers of corners each.
 * *bent tells whether its corners are in no common plane. False where it cannot be divided. */
bool sepax__polygon_divide(const double (*corner)[3], size_t count, size_t (*triangle)[3],
                           bool *bent);

#endif
