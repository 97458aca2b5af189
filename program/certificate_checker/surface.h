/* surface.h - the triangles of a body, in the coordinates of its link. */
#ifndef CERTIFICATE_SURFACE_H
#define CERTIFICATE_SURFACE_H

#include "vector.h"

#include <stddef.h>

typedef struct {
  vec at[3];
} triangle;

typedef struct {
  triangle *triangle;
  size_t count;
  size_t *element; /* first triangle of each collision element */
  size_t elements;
  vec low, high;  /* box */
  double radius;  /* no point is farther from the link's origin */
  double rounded; /* how far its polyhedra of cylinders and spheres stand out of these, at most */
} surface;

/* What follows is one more collision element. */
void surface_element(surface *s);

/* STL, binary or ASCII; scaled, then posed. */
void surface_stl(surface *s, const char *file, point scale, pose at);
void surface_box(surface *s, point size, pose at);

/* Polyhedra that hold them. */
void surface_cylinder(surface *s, long double radius, long double length, pose at);
void surface_sphere(surface *s, long double radius, pose at);

/* Box and radius, when all elements are there. */
void surface_finish(surface *s);

#endif
