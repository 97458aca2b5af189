/* SPDX-License-Identifier: MIT */
/* float_sat.h - Algorithm 1 in floating point, for one type (private; float.c
 * includes it once per type with REAL and NAME(x) defined). */

typedef struct {
  REAL x, y, z;
} NAME(vec);

static void NAME(load)(NAME(vec) p[6], const sepax_tri *a, const sepax_tri *b) {
  for (int i = 0; i < 6; i++) {
    const sepax_vec *v = i < 3 ? &a->v[i] : &b->v[i - 3];
    p[i] = (NAME(vec)){(REAL)v->x, (REAL)v->y, (REAL)v->z};
  }
}

static NAME(vec) NAME(subtract)(NAME(vec) p, NAME(vec) q) {
  return (NAME(vec)){p.x - q.x, p.y - q.y, p.z - q.z};
}

static NAME(vec) NAME(cross)(NAME(vec) p, NAME(vec) q) {
  return (NAME(vec)){p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}

static void NAME(project)(NAME(vec) axis, const NAME(vec) p[6], REAL out[6]) {
  for (int i = 0; i < 6; i++) {
    out[i] = axis.x * p[i].x + axis.y * p[i].y + axis.z * p[i].z;
  }
}

static REAL NAME(least)(const REAL p[3]) {
  REAL low = p[0] < p[1] ? p[0] : p[1];
  return low < p[2] ? low : p[2];
}

static REAL NAME(greatest)(const REAL p[3]) {
  REAL high = p[0] > p[1] ? p[0] : p[1];
  return high > p[2] ? high : p[2];
}

static bool NAME(disjoint)(const REAL p[6]) {
  return NAME(greatest)(p) < NAME(least)(p + 3) || NAME(greatest)(p + 3) < NAME(least)(p);
}

static bool NAME(separates)(NAME(vec) axis, const NAME(vec) p[6]) {
  REAL projection[6];
  NAME(project)(axis, p, projection);
  return NAME(disjoint)(projection);
}

static bool NAME(collide)(const sepax_tri *a, const sepax_tri *b) {
  NAME(vec) p[6];
  NAME(vec) edge[6];
  NAME(load)(p, a, b);
  for (int i = 0; i < 6; i++) {
    edge[i] = NAME(subtract)(p[i % 3 == 2 ? i - 2 : i + 1], p[i]);
  }
  NAME(vec) normal[2] = {NAME(cross)(edge[0], edge[1]), NAME(cross)(edge[3], edge[4])};
  REAL on_na[6];
  NAME(project)(normal[0], p, on_na);
  if (NAME(disjoint)(on_na) || NAME(separates)(normal[1], p)) {
    return false;
  }
  bool coplanar = on_na[0] == on_na[3] && on_na[1] == on_na[4] && on_na[2] == on_na[5];
  for (int i = 0; i < (coplanar ? 6 : 9); i++) {
    NAME(vec)
    axis =
        coplanar ? NAME(cross)(normal[i / 3], edge[i]) : NAME(cross)(edge[i / 3], edge[3 + i % 3]);
    if (NAME(separates)(axis, p)) {
      return false;
    }
  }
  return true;
}
