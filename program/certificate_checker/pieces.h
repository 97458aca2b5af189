/* SPDX-License-Identifier: MIT */
/* pieces.h - which parts of a collision element may touch or overlap each other. */
#ifndef CERTIFICATE_PIECES_H
#define CERTIFICATE_PIECES_H

#include "surface.h"

/* Of count triangles t, no point of which is farther than `radius` from the origin: part[n] is a
 * triangle that stands for the part of triangle n. Parts get the same piece[part[n]], unless they
 * are proved to have no point in common, also by way of others. */
void pieces_find(size_t *piece, const triangle *t, size_t count, double radius, const size_t *part);

#endif
