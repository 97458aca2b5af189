/* SPDX-License-Identifier: MIT */
/* reference.c - the exact reference verdict: the separating axis theorem on 128-bit integers,
 * relative to vertex A_1. Its decisions are its own, so that it checks exact.c.
 *
 * If the six vertices span space, a separating axis is among N_A, N_B and the nine e x f: the
 * Minkowski difference of the triangles is then a polytope whose facets have those normals, or lies
 * in a plane that one of them is normal to. If they do not, two coplanar (or degenerate) triangles
 * are separated iff an edge or their AABBs separate them in one of the three coordinate
 * projections.
 *
 * Widths at W = 32: relative coordinates and edges 33 + 1 bits, axes 68,
 * projections 103. */
#include "sepax_models.h"
#include "util/wide.h"

static wide min3(wide p, wide q, wide r) {
  wide least = p < q ? p : q;
  return least < r ? least : r;
}

static wide max3(wide p, wide q, wide r) { return -min3(-p, -q, -r); }

static bool disjoint(const wide a[3], const wide b[3]) {
  return max3(a[0], a[1], a[2]) < min3(b[0], b[1], b[2]) ||
         max3(b[0], b[1], b[2]) < min3(a[0], a[1], a[2]);
}

static bool separates(wide_vec axis, const wide_vec p[6]) {
  wide projection[6];
  for (int i = 0; i < 6; i++) {
    projection[i] = wide_dot(axis, p[i]);
  }
  return disjoint(projection, projection + 3);
}

static bool aabbs_disjoint(const wide_vec p[6]) {
  return separates((wide_vec){{1, 0, 0}}, p) || separates((wide_vec){{0, 1, 0}}, p) ||
         separates((wide_vec){{0, 0, 1}}, p);
}

/* True if the six vertices are in one plane; p[0] is the origin. */
static bool coplanar(const wide_vec p[6]) {
  for (int i = 1; i < 6; i++) {
    for (int j = i + 1; j < 6; j++) {
      wide_vec n = wide_cross(p[i], p[j]);
      if (wide_is_zero(n)) {
        continue;
      }
      for (int k = 1; k < 6; k++) {
        if (wide_dot(n, p[k]) != 0) {
          return false;
        }
      }
      return true;
    }
  }
  return true;
}

static bool separated_in_space(const wide_vec p[6], const wide_vec edge[6]) {
  if (separates(wide_cross(edge[0], edge[1]), p) || separates(wide_cross(edge[3], edge[4]), p)) {
    return true;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 3; j < 6; j++) {
      if (separates(wide_cross(edge[i], edge[j]), p)) {
        return true;
      }
    }
  }
  return false;
}

static bool separated_in_plane(const wide_vec p[6], const wide_vec edge[6]) {
  for (int i = 0; i < 6; i++) {
    wide_vec e = edge[i];
    if (separates((wide_vec){{-e.c[1], e.c[0], 0}}, p) ||
        separates((wide_vec){{0, -e.c[2], e.c[1]}}, p) ||
        separates((wide_vec){{e.c[2], 0, -e.c[0]}}, p)) {
      return true;
    }
  }
  return false;
}

bool sepax_reference(const sepax_tri *a, const sepax_tri *b) {
  wide_vec origin = wide_from(a->v[0]);
  wide_vec p[6];
  for (int i = 0; i < 6; i++) {
    sepax_vec v = i < 3 ? a->v[i] : b->v[i - 3];
    p[i] = wide_sub(wide_from(v), origin);
  }
  if (aabbs_disjoint(p)) {
    return false;
  }
  wide_vec edge[6];
  for (int i = 0; i < 6; i++) {
    int next = i % 3 == 2 ? i - 2 : i + 1;
    edge[i] = wide_sub(p[next], p[i]);
  }
  return coplanar(p) ? !separated_in_plane(p, edge) : !separated_in_space(p, edge);
}
