/* SPDX-License-Identifier: MIT */
/* draws.h - random poses and meshes of the tests of bodies. */
#ifndef DRAWS_H
#define DRAWS_H

#include "harness.h"
#include "sepax_models.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The rotation of quaternion w, x, y, z. */
static inline sepax_pose turned(double w, double x, double y, double z) {
  double n = 2 / (w * w + x * x + y * y + z * z);
  return (sepax_pose){{{1 - n * (y * y + z * z), n * (x * y - w * z), n * (x * z + w * y)},
                       {n * (x * y + w * z), 1 - n * (x * x + z * z), n * (y * z - w * x)},
                       {n * (x * z - w * y), n * (y * z + w * x), 1 - n * (x * x + y * y)}},
                      {0, 0, 0}};
}

/* Any rotation; a translation of up to `away`. */
static inline sepax_pose turned_and_moved(double away) {
  sepax_pose p = turned(random_unit(), random_unit(), random_unit(), random_unit());
  for (int i = 0; i < 3; i++) {
    p.translation[i] = away * random_unit();
  }
  return p;
}

/* Triangles of some size strewn in a cube; every tenth has no area. */
static inline sepax_soup strewn(size_t count, double size, double step) {
  sepax_soup mesh = {.facet = calloc(count, sizeof(sepax_facet)), .count = count};
  assert_non_null(mesh.facet);
  for (size_t n = 0; n < count; n++) {
    for (int k = 0; k < 9; k++) {
      double *x = &mesh.facet[n].v[k / 3][k % 3];
      *x = k < 3 ? random_unit() : mesh.facet[n].v[0][k % 3] + size * random_unit();
      *x = step > 0 ? step * round(*x / step) : *x;
    }
    if (n % 10 == 0) {
      memcpy(mesh.facet[n].v[2], mesh.facet[n].v[1], sizeof mesh.facet[n].v[1]);
    }
  }
  return mesh;
}

#endif
