/* SPDX-License-Identifier: MIT */
/* touch.h - do triangles and probes touch? Exact, by axes that separate them. */
#ifndef MATERIAL_TOUCH_H
#define MATERIAL_TOUCH_H

#include "soup.h"

/* A probe at p: the tetrahedron of p and the three points one step beside it. */
void probe_corners(point p, point corner[4]);

/* True if the probe touches no triangle. It may be false though none is touched. */
bool probe_is_free(const soup *s, point p);

/* Do two triangles that have an area touch or cross? */
bool triangles_touch(const triangle *a, const triangle *b);

#endif
