/* SPDX-License-Identifier: MIT */
/* solid_meshes.h - closed meshes with short coordinates, part by part. */
#ifndef SOLID_MESHES_H
#define SOLID_MESHES_H

#include "harness.h"

#include <stdlib.h>
#include <string.h>

static inline void add_triangle(sepax_soup *m, const double p[3], const double q[3],
                                const double r[3]) {
  m->facet = realloc(m->facet, (m->count + 1) * sizeof *m->facet);
  assert_non_null(m->facet);
  sepax_facet *f = &m->facet[m->count++];
  memset(f, 0, sizeof *f);
  memcpy(f->v[0], p, sizeof f->v[0]);
  memcpy(f->v[1], q, sizeof f->v[1]);
  memcpy(f->v[2], r, sizeof f->v[2]);
}

static inline void add_quad(sepax_soup *m, double v[4][3]) {
  int k = random_below(2);
  add_triangle(m, v[k], v[k + 1], v[k + 2]);
  add_triangle(m, v[k], v[k + 2], v[(k + 3) % 4]);
}

static inline void turn_round(sepax_facet *f) {
  double keep[3];
  memcpy(keep, f->v[1], sizeof keep);
  memcpy(f->v[1], f->v[2], sizeof keep);
  memcpy(f->v[2], keep, sizeof keep);
}

/* Each face in `cells` x `cells` squares. */
static inline void add_cells(sepax_soup *m, const double low[3], const double high[3], int cells) {
  for (int k = 0; k < 6 * cells * cells; k++) {
    int axis = k % 3;
    int side = k / 3 % 2;
    const int at[2] = {k / 6 % cells, k / 6 / cells};
    double v[4][3];
    for (int n = 0; n < 4; n++) {
      const int u[2] = {at[0] + (n == 1 || n == 2), at[1] + (n >= 2)};
      v[n][axis] = side != 0 ? high[axis] : low[axis];
      for (int w = 0; w < 2; w++) {
        int i = (axis + 1 + w) % 3;
        int step = u[side != 0 ? w : !w];
        v[n][i] = step == 0 ? low[i] : step == cells ? high[i] : (low[i] + high[i]) / 2;
      }
    }
    add_quad(m, v);
  }
}

static inline void add_box(sepax_soup *m, const double c[3], double r, int cells) {
  const double low[3] = {c[0] - r, c[1] - r, c[2] - r};
  const double high[3] = {c[0] + r, c[1] + r, c[2] + r};
  add_cells(m, low, high, cells);
}

static inline void add_octahedron(sepax_soup *m, const double c[3], double r) {
  for (int k = 0; k < 8; k++) {
    double v[3][3];
    for (int n = 0; n < 3; n++) {
      memcpy(v[n], c, sizeof v[n]);
      v[n][n] += (k >> n & 1) != 0 ? -r : r;
    }
    int odd = (k ^ k >> 1 ^ k >> 2) & 1;
    add_triangle(m, v[0], v[1 + odd], v[2 - odd]);
  }
}

/* Of 4 x 4 quads, its tube square. Its bands have no area where flat. */
static inline void add_torus(sepax_soup *m, const double c[3], double major, double minor) {
  static const int turn_of[4][2] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int k = 0; k < 16; k++) {
    double v[4][3];
    for (int n = 0; n < 4; n++) {
      const int *around = turn_of[(k / 4 + (n == 1 || n == 2)) % 4];
      const int *tube = turn_of[(k + (n >= 2)) % 4];
      double at = major + minor * tube[0];
      v[n][0] = c[0] + at * around[0];
      v[n][1] = c[1] + at * around[1];
      v[n][2] = c[2] + minor * tube[1];
    }
    add_quad(m, v);
  }
}

/* Two triangles that share an edge get its middle as a third vertex, on one side only, and a
 * triangle without area between: the mesh stays closed. */
static inline void split_edge(sepax_soup *m) {
  sepax_facet *f = &m->facet[random_below((int)m->count)];
  double v[3][3];
  double middle[3];
  memcpy(v, f->v, sizeof v);
  for (int i = 0; i < 3; i++) {
    middle[i] = v[0][i] / 2 + v[1][i] / 2;
  }
  memcpy(f->v[1], middle, sizeof middle);
  add_triangle(m, middle, v[1], v[2]);
  add_triangle(m, v[0], v[1], middle);
}

/* An edge of a triangle gets a vertex, its neighbour does not. */
static inline void tear_edge(sepax_soup *m) {
  sepax_facet *f = &m->facet[random_below((int)m->count)];
  double share = (1 + random_below(3)) / 4.0;
  double v[3][3];
  double at[3];
  int k = random_below(3);
  for (int n = 0; n < 3; n++) {
    memcpy(v[n], f->v[(n + k) % 3], sizeof v[n]);
  }
  for (int i = 0; i < 3; i++) {
    at[i] = v[0][i] + share * (v[1][i] - v[0][i]);
  }
  memcpy(f->v[0], v[0], sizeof at);
  memcpy(f->v[1], at, sizeof at);
  memcpy(f->v[2], v[2], sizeof at);
  add_triangle(m, at, v[1], v[2]);
}

/* A triangle without area: an edge of another, and a point of it. */
static inline void add_segment(sepax_soup *m) {
  double v[3][3];
  memcpy(v, m->facet[random_below((int)m->count)].v, sizeof v);
  for (int i = 0; i < 3; i++) {
    v[2][i] = v[0][i] + 0.75 * (v[1][i] - v[0][i]);
  }
  add_triangle(m, v[0], v[1], v[2]);
}

static inline void add_block(sepax_soup *m, const double low[3], const double high[3],
                             bool inside_out) {
  size_t first = m->count;
  add_cells(m, low, high, 1);
  for (size_t n = first; n < m->count && inside_out; n++) {
    turn_round(&m->facet[n]);
  }
}

#endif
