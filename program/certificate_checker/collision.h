/* SPDX-License-Identifier: MIT */
/* collision.h - the collision elements of a link. */
#ifndef CERTIFICATE_COLLISION_H
#define CERTIFICATE_COLLISION_H

#include "surface.h"
#include "urdf.h"

/* Adds the surface of a collision element to a body, and counts the element. */
void collision_read(urdf_file *u, xmlNode *node, surface *body);

#endif
