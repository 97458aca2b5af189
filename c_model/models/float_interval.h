/* SPDX-License-Identifier: MIT */
/* float_interval.h - the interval test of Moeller (A Fast Triangle-Triangle Intersection
 * Test, 1997) in floating point without tolerance, for one type (private; float.c includes
 * it once per type, behind float_sat.h). Each triangle cuts the line in which the two
 * planes intersect in an interval; they collide iff the intervals do. */

static REAL NAME(dot)(NAME(vec) p, NAME(vec) q) { return p.x * q.x + p.y * q.y + p.z * q.z; }

static REAL NAME(along)(NAME(vec) p, int axis) { return axis == 0 ? p.x : axis == 1 ? p.y : p.z; }

static int NAME(longest)(NAME(vec) p) {
  REAL x = p.x < 0 ? -p.x : p.x;
  REAL y = p.y < 0 ? -p.y : p.y;
  REAL z = p.z < 0 ? -p.z : p.z;
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

/* The vertex that is alone on its side of the other plane; -1 if all vertices are in the plane. */
static int NAME(alone)(const REAL side[3]) {
  if (side[0] * side[1] > 0) {
    return 2;
  }
  if (side[0] * side[2] > 0) {
    return 1;
  }
  if (side[1] * side[2] > 0 || side[0] != 0) {
    return 0;
  }
  return side[1] != 0 ? 1 : side[2] != 0 ? 2 : -1;
}

static void NAME(interval)(const NAME(vec) p[3], const REAL side[3], int one, int axis,
                           REAL ends[2]) {
  REAL from = NAME(along)(p[one], axis);
  for (int i = 0; i < 2; i++) {
    int other = (one + 1 + i) % 3;
    ends[i] = from + (NAME(along)(p[other], axis) - from) * side[one] / (side[one] - side[other]);
  }
  if (ends[0] > ends[1]) {
    REAL kept = ends[0];
    ends[0] = ends[1];
    ends[1] = kept;
  }
}

/* Twice the signed area of p, q, r in the projection along an axis. */
static REAL NAME(orient2d)(NAME(vec) p, NAME(vec) q, NAME(vec) r, int axis) {
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  return (NAME(along)(q, u) - NAME(along)(p, u)) * (NAME(along)(r, v) - NAME(along)(p, v)) -
         (NAME(along)(q, v) - NAME(along)(p, v)) * (NAME(along)(r, u) - NAME(along)(p, u));
}

/* Triangles with an area in one plane, projected along an axis: they are separated iff some edge
 * has the other triangle beyond it, its own third vertex not. */
static bool NAME(in_plane)(const NAME(vec) p[6], int axis) {
  for (int i = 0; i < 6; i++) {
    int own = i - i % 3;
    const NAME(vec) *q = &p[3 - own];
    NAME(vec) from = p[i];
    NAME(vec) to = p[own + (i + 1) % 3];
    REAL inner = NAME(orient2d)(from, to, p[own + (i + 2) % 3], axis);
    bool beyond = true;
    for (int k = 0; k < 3; k++) {
      REAL side = NAME(orient2d)(from, to, q[k], axis);
      beyond = beyond && ((inner > 0 && side < 0) || (inner < 0 && side > 0));
    }
    if (beyond) {
      return false;
    }
  }
  return true;
}

/* On which sides of the plane the three points are. True if all are on one side. */
static bool NAME(sides)(const NAME(vec) of[3], const NAME(vec) plane[3], NAME(vec) * normal,
                        REAL side[3]) {
  *normal = NAME(cross)(NAME(subtract)(plane[1], plane[0]), NAME(subtract)(plane[2], plane[0]));
  REAL level = NAME(dot)(*normal, plane[0]);
  for (int i = 0; i < 3; i++) {
    side[i] = NAME(dot)(*normal, of[i]) - level;
  }
  return side[0] * side[1] > 0 && side[0] * side[2] > 0;
}

static bool NAME(intervals_overlap)(const sepax_tri *a, const sepax_tri *b) {
  NAME(vec) p[6];
  NAME(vec) normal[2];
  REAL side[2][3];
  NAME(load)(p, a, b);
  if (NAME(sides)(p, p + 3, &normal[1], side[0]) || NAME(sides)(p + 3, p, &normal[0], side[1])) {
    return false;
  }
  int one[2] = {NAME(alone)(side[0]), NAME(alone)(side[1])};
  if (one[0] < 0 || one[1] < 0) {
    return NAME(in_plane)(p, NAME(longest)(normal[0]));
  }
  int axis = NAME(longest)(NAME(cross)(normal[0], normal[1]));
  REAL ends[2][2];
  NAME(interval)(p, side[0], one[0], axis, ends[0]);
  NAME(interval)(p + 3, side[1], one[1], axis, ends[1]);
  return !(ends[0][1] < ends[1][0] || ends[1][1] < ends[0][0]);
}
