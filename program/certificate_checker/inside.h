/* inside.h - is a part of one body inside the other? */
#ifndef CERTIFICATE_INSIDE_H
#define CERTIFICATE_INSIDE_H

#include "surface.h"

#include <stdbool.h>

/* Of a surface: a vertex of each part, triangles that hang together by edges; and which triangles
 * are of closed parts, each of whose edges belongs to an even number of triangles. */
typedef struct {
  const surface *body;
  vec *sample;
  size_t samples;
  bool *closed;     /* of each triangle */
  bool *consistent; /* of each collision element: its closed parts' edges are run both ways alike */
} shell;

shell shell_of(const surface *s);

/* Of bodies whose surfaces share no point: is a part of a, in the pose `at`, inside an element of
 * b? Inside is what a ray leaves through an odd number of triangles; where the triangles' sides are
 * consistent, what they wind around. */
bool shell_inside(const shell *a, const shell *b, pose at);

#endif
