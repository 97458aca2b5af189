/* SPDX-License-Identifier: MIT */
/* surface.h - the triangles of a body, in the coordinates of its link. */
#ifndef CERTIFICATE_SURFACE_H
#define CERTIFICATE_SURFACE_H

#include "mesh.h"

typedef struct {
  vec at[3];
} triangle;

/* A collision element; or the hull of a bent polygon of one, which is a solid. */
typedef struct {
  size_t first; /* triangle */
  bool hull;
} surface_part;

typedef struct {
  triangle *triangle;
  size_t count;
  surface_part *element;
  size_t elements;
  vec low, high;  /* box */
  double radius;  /* no point is farther from the link's origin */
  double rounded; /* how far polyhedra and hulls stand out of what they hold, at most */
} surface;

/* What follows is one more collision element. */
void surface_element(surface *s);

/* Scaled, then posed. */
void surface_mesh(surface *s, mesh *m, point scale, pose at);
void surface_box(surface *s, point size, pose at);

/* Polyhedra that hold them. */
void surface_cylinder(surface *s, long double radius, long double length, pose at);
void surface_sphere(surface *s, long double radius, pose at);
void surface_capsule(surface *s, long double radius, long double length, pose at);

/* Box and radius, when all elements are there. */
void surface_finish(surface *s);

#endif
