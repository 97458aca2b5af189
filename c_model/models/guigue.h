/* SPDX-License-Identifier: MIT */
/* guigue.h - the test of Guigue and Devillers (Fast and Robust Triangle-Triangle Overlap Test
 * Using Orientation Predicates, 2003), which reads nothing but signs; the predicates are the
 * caller's (private). Vertices 0 ... 2 are A's, 3 ... 5 B's. Neither triangle is without area. */
#ifndef SEPAX_GUIGUE_H
#define SEPAX_GUIGUE_H

#include <stdbool.h>

/* The sign of (s - p) . ((q - p) x (r - p)). */
typedef int guigue_orient3d(void *points, int p, int q, int r, int s);
/* The verdict if one plane holds all vertices. */
typedef bool guigue_coplanar(void *points);

/* The vertex that the other plane, or two vertices in it, separates from the others, and the sign
 * of its side; 0 if all three vertices are in the plane. The vertices must not all be on one
 * side. */
static inline int guigue_lone(const int side[3], int *lone) {
  int above = (side[0] > 0) + (side[1] > 0) + (side[2] > 0);
  int below = (side[0] < 0) + (side[1] < 0) + (side[2] < 0);
  if (above + below == 0) {
    return 0;
  }
  int sign = above > 0 ? 1 : -1;
  int with_sign = above > 0 ? above : below;
  for (int k = 0; k < 3; k++) {
    if ((side[k] == sign) == (with_sign == 1)) {
      *lone = k;
    }
  }
  return with_sign == 1 ? sign : -sign;
}

/* Six orient3d tell on which side of the other's plane each vertex is. Each triangle meets the line
 * of both planes in an interval between the two edges of its lone vertex. Two more orient3d tell
 * whether one interval ends before the other begins. */
static inline bool guigue_collide(void *points, guigue_orient3d *orient3d,
                                  guigue_coplanar *coplanar) {
  int sign[2];
  int v[2][3];
  for (int t = 0; t < 2; t++) {
    int own = 3 * t;
    int other = 3 - own;
    int side[3];
    for (int k = 0; k < 3; k++) {
      side[k] = orient3d(points, other, other + 1, other + 2, own + k);
    }
    if (side[0] != 0 && side[0] == side[1] && side[0] == side[2]) {
      return false;
    }
    int lone = 0;
    sign[t] = guigue_lone(side, &lone);
    for (int k = 0; k < 3; k++) {
      v[t][k] = own + (lone + k) % 3;
    }
  }
  if (sign[0] == 0 || sign[1] == 0) {
    return coplanar(points);
  }
  /* Order the vertices so that both lone vertices are above the other's plane. */
  for (int t = 0; t < 2; t++) {
    if (sign[t] < 0) {
      int kept = v[1 - t][1];
      v[1 - t][1] = v[1 - t][2];
      v[1 - t][2] = kept;
    }
  }
  return orient3d(points, v[0][0], v[0][1], v[1][0], v[1][1]) <= 0 &&
         orient3d(points, v[0][0], v[0][2], v[1][2], v[1][0]) <= 0;
}

#endif
