/* SPDX-License-Identifier: MIT */
#include "touch.h"

/* All of a lies strictly on one side of all of b. */
static bool separates(axis n, const point *a, int count_a, const point *b, int count_b) {
  wide low[2] = {dot(n, a[0]), dot(n, b[0])};
  wide high[2] = {low[0], low[1]};
  for (int k = 1; k < count_a || k < count_b; k++) {
    for (int body = 0; body < 2; body++) {
      if (k < (body == 0 ? count_a : count_b)) {
        wide at = dot(n, body == 0 ? a[k] : b[k]);
        low[body] = at < low[body] ? at : low[body];
        high[body] = at > high[body] ? at : high[body];
      }
    }
  }
  return high[0] < low[1] || high[1] < low[0];
}

void probe_corners(point p, point corner[4]) {
  for (int k = 0; k < 4; k++) {
    corner[k] = p;
    if (k > 0) {
      corner[k].x[k - 1]++;
    }
  }
}

/* Near the probe, which has a corner at the origin. */
static bool triangle_is_apart(const point v[3]) {
  static const point probe[4] = {{{0, 0, 0}}, {{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}};
  static const point normals[4] = {{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{1, 1, 1}}};
  for (int k = 0; k < 4; k++) {
    if (separates(axis_of(normals[k]), v, 3, probe, 4)) {
      return true;
    }
  }
  if (separates(normal(v), v, 3, probe, 4)) {
    return true;
  }
  for (int i = 0; i < 4; i++) {
    for (int j = i + 1; j < 4; j++) {
      for (int k = 0; k < 3; k++) {
        axis n = cross(axis_of(minus(probe[j], probe[i])), axis_of(minus(v[(k + 1) % 3], v[k])));
        if (separates(n, v, 3, probe, 4)) {
          return true;
        }
      }
    }
  }
  return false;
}

bool probe_is_free(const soup *s, point p) {
  for (size_t i = 0; i < s->count; i++) {
    const point *t = s->t[i].v;
    const point v[3] = {minus(t[0], p), minus(t[1], p), minus(t[2], p)};
    if (!triangle_is_apart(v)) {
      return false;
    }
  }
  return true;
}

bool triangles_touch(const triangle *a, const triangle *b) {
  axis n[2] = {normal(a->v), normal(b->v)};
  if (separates(n[0], a->v, 3, b->v, 3) || separates(n[1], a->v, 3, b->v, 3)) {
    return false;
  }
  for (int i = 0; i < 3; i++) {
    axis e = axis_of(minus(a->v[(i + 1) % 3], a->v[i]));
    axis f = axis_of(minus(b->v[(i + 1) % 3], b->v[i]));
    /* In one plane, the edges' normals in the plane are the axes. */
    if (separates(cross(n[0], e), a->v, 3, b->v, 3) ||
        separates(cross(n[1], f), a->v, 3, b->v, 3)) {
      return false;
    }
    for (int j = 0; j < 3; j++) {
      axis other = axis_of(minus(b->v[(j + 1) % 3], b->v[j]));
      if (separates(cross(e, other), a->v, 3, b->v, 3)) {
        return false;
      }
    }
  }
  return true;
}
