/* reference.c - the exact reference verdict: the separating axis theorem on 128-bit
 * integers, relative to vertex A_1.
 *
 * If the six vertices span space, a separating axis is among N_A, N_B and the
 * nine e x f: the Minkowski difference of the triangles is then a polytope whose
 * facets have those normals, or lies in a plane that one of them is normal to.
 * If they do not, two coplanar (or degenerate) triangles are separated iff they
 * are in one of the three coordinate projections, by an edge or by their boxes.
 *
 * Widths at W = 32: relative coordinates and edges 33 + 1 bits, axes 68,
 * projections 103. */
#include "sepax.h"

typedef __int128 wide;

typedef struct {
  wide x, y, z;
} wide_vec;

static wide_vec subtract(wide_vec p, wide_vec q) {
  return (wide_vec){p.x - q.x, p.y - q.y, p.z - q.z};
}

static wide_vec cross(wide_vec p, wide_vec q) {
  return (wide_vec){p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

static wide dot(wide_vec p, wide_vec q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

static wide min3(wide p, wide q, wide r) {
  wide least = p < q ? p : q;
  return least < r ? least : r;
}

static wide max3(wide p, wide q, wide r) { return -min3(-p, -q, -r); }

static bool apart(const wide a[3], const wide b[3]) {
  return max3(a[0], a[1], a[2]) < min3(b[0], b[1], b[2]) ||
         max3(b[0], b[1], b[2]) < min3(a[0], a[1], a[2]);
}

static bool separates(wide_vec axis, const wide_vec p[6]) {
  wide projection[6];
  for (int i = 0; i < 6; i++) {
    projection[i] = dot(axis, p[i]);
  }
  return apart(projection, projection + 3);
}

static bool boxes_apart(const wide_vec p[6]) {
  return separates((wide_vec){1, 0, 0}, p) || separates((wide_vec){0, 1, 0}, p) ||
         separates((wide_vec){0, 0, 1}, p);
}

/* p[0] is the origin. */
static bool coplanar(const wide_vec p[6]) {
  for (int i = 1; i < 6; i++) {
    for (int j = i + 1; j < 6; j++) {
      wide_vec n = cross(p[i], p[j]);
      if (n.x == 0 && n.y == 0 && n.z == 0) {
        continue;
      }
      for (int k = 1; k < 6; k++) {
        if (dot(n, p[k]) != 0) {
          return false;
        }
      }
      return true;
    }
  }
  return true;
}

static bool separated_in_space(const wide_vec p[6], const wide_vec edge[6]) {
  if (separates(cross(edge[0], edge[1]), p) || separates(cross(edge[3], edge[4]), p)) {
    return true;
  }
  for (int i = 0; i < 3; i++) {
    for (int j = 3; j < 6; j++) {
      if (separates(cross(edge[i], edge[j]), p)) {
        return true;
      }
    }
  }
  return false;
}

static bool separated_in_plane(const wide_vec p[6], const wide_vec edge[6]) {
  for (int i = 0; i < 6; i++) {
    wide_vec e = edge[i];
    if (separates((wide_vec){-e.y, e.x, 0}, p) || separates((wide_vec){0, -e.z, e.y}, p) ||
        separates((wide_vec){e.z, 0, -e.x}, p)) {
      return true;
    }
  }
  return false;
}

bool sepax_reference(const sepax_tri *a, const sepax_tri *b) {
  wide_vec origin = {a->v[0].x, a->v[0].y, a->v[0].z};
  wide_vec p[6];
  for (int i = 0; i < 6; i++) {
    sepax_vec v = i < 3 ? a->v[i] : b->v[i - 3];
    p[i] = subtract((wide_vec){v.x, v.y, v.z}, origin);
  }
  if (boxes_apart(p)) {
    return false;
  }
  wide_vec edge[6];
  for (int i = 0; i < 6; i++) {
    int next = i % 3 == 2 ? i - 2 : i + 1;
    edge[i] = subtract(p[next], p[i]);
  }
  return coplanar(p) ? !separated_in_plane(p, edge) : !separated_in_space(p, edge);
}
