/* SPDX-License-Identifier: MIT */
/* snapshot.c - pictures of the stock as it is cut. They are samples of the cells, so coarse that a
 * page holds some of them. */
#include "path/stock/snapshot.h"
#include "util/error.h"

#include <math.h>
#include <stdlib.h>

enum { CELLS = 56 }; /* along the longest side */

bool path_snapshot_due(const path_scene *scene, size_t line) {
  size_t taken = scene->stock.snapshots;
  return taken < PATH_SNAPSHOTS && line * PATH_SNAPSHOTS >= taken * scene->motion.lines;
}

typedef struct {
  bool *is_there;
  size_t count[3];
  double low[3], cell;
} samples;

static bool at(const samples *s, const long n[3]) {
  for (int i = 0; i < 3; i++) {
    if (n[i] < 0 || n[i] >= (long)s->count[i]) {
      return false;
    }
  }
  return s->is_there[((size_t)n[2] * s->count[1] + (size_t)n[1]) * s->count[0] + (size_t)n[0]];
}

/* The two triangles of the face of a cell in a direction, seen from outside counter-clockwise. */
static void add_face(const samples *s, sepax_soup *mesh, const long n[3], int axis, bool high) {
  static const int around[6] = {0, 1, 2, 0, 2, 3};
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  double corner[4][3];
  for (int k = 0; k < 4; k++) {
    bool on_u = high ? k == 1 || k == 2 : k >= 2;
    bool on_v = high ? k >= 2 : k == 1 || k == 2;
    corner[k][axis] = s->low[axis] + s->cell * (double)(n[axis] + high);
    corner[k][u] = s->low[u] + s->cell * (double)(n[u] + on_u);
    corner[k][v] = s->low[v] + s->cell * (double)(n[v] + on_v);
  }
  for (int k = 0; k < 6; k++) {
    for (int i = 0; i < 3; i++) {
      mesh->facet[mesh->count + (size_t)(k / 3)].v[k % 3][i] = corner[around[k]][i];
    }
  }
  mesh->count += 2;
}

/* Add the faces between cells that are there and cells that are not; or count them. */
static size_t add_faces(const samples *s, sepax_soup *mesh) {
  size_t faces = 0;
  long n[3];
  for (n[2] = 0; n[2] < (long)s->count[2]; n[2]++) {
    for (n[1] = 0; n[1] < (long)s->count[1]; n[1]++) {
      for (n[0] = 0; n[0] < (long)s->count[0]; n[0]++) {
        for (int side = 0; side < 6 && at(s, n); side++) {
          long other[3] = {n[0], n[1], n[2]};
          other[side / 2] += side % 2 == 1 ? 1 : -1;
          if (!at(s, other)) {
            faces++;
            if (mesh != NULL) {
              add_face(s, mesh, n, side / 2, side % 2 == 1);
            }
          }
        }
      }
    }
  }
  return faces;
}

static bool take_samples(samples *s, const sepax__stock *stock) {
  sepax__stock_facts facts = sepax__stock_look(stock);
  double longest = 0;
  for (int i = 0; i < 3; i++) {
    longest = fmax(longest, facts.box[1][i] - facts.box[0][i]);
    s->low[i] = facts.box[0][i];
  }
  s->cell = fmax(longest / CELLS, facts.cell);
  for (int i = 0; i < 3; i++) {
    s->count[i] = (size_t)ceil((facts.box[1][i] - facts.box[0][i]) / s->cell);
  }
  s->is_there = calloc(s->count[0] * s->count[1], s->count[2]);
  if (s->is_there == NULL) {
    return false;
  }
  for (size_t n = 0; n < s->count[0] * s->count[1] * s->count[2]; n++) {
    size_t cell[3] = {n % s->count[0], n / s->count[0] % s->count[1],
                      n / s->count[0] / s->count[1]};
    double point[3];
    for (int i = 0; i < 3; i++) {
      point[i] = s->low[i] + ((double)cell[i] + 0.5) * s->cell;
    }
    s->is_there[n] = sepax__stock_has(stock, point);
  }
  return true;
}

bool path_snapshot_take(path_scene *scene, const sepax__stock *stock, size_t line,
                        sepax_error *error) {
  samples s = {0};
  path_snapshot *to = &scene->stock.snapshot[scene->stock.snapshots];
  *to = (path_snapshot){.line = line};
  bool ok = take_samples(&s, stock);
  size_t faces = ok ? add_faces(&s, NULL) : 0;
  to->mesh.facet = ok ? sepax_allocate((2 * faces + 1) * sizeof *to->mesh.facet) : NULL;
  if (to->mesh.facet != NULL) {
    add_faces(&s, &to->mesh);
    scene->stock.snapshots++;
  }
  free(s.is_there);
  return to->mesh.facet != NULL ||
         sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for pictures of the stock");
}
