/* SPDX-License-Identifier: MIT */
/* mark.c - the cells that the triangles of a mesh may touch. */
#include "stock/mark.h"

#include "util/error.h"
#include "util/vector.h"

#include <math.h>

/* A triangle and the axes that may separate it from a cube: of the cube's faces, of its own plane,
 * and across an edge of both. */
enum { AXES = 13, ALL_AXES = (1 << AXES) - 1 };

typedef struct {
  const sepax_facet *facet;
  double axis[AXES][3];
} triangle;

static triangle triangle_of(const sepax_facet *facet) {
  triangle t = {.facet = facet};
  double edge[3][3];
  for (int k = 0; k < 3; k++) {
    t.axis[k][k] = 1;
    for (int i = 0; i < 3; i++) {
      edge[k][i] = facet->v[(k + 1) % 3][i] - facet->v[k][i];
    }
  }
  vector_cross(edge[0], edge[1], t.axis[3]);
  for (int n = 0; n < 9; n++) {
    vector_cross(t.axis[n / 3], edge[n % 3], t.axis[4 + n]);
  }
  return t;
}

typedef enum { SEPARATES, DECIDES_NOTHING, IS_OPEN } axis_side;

/* Does an axis separate the triangle, counted from the middle of a cube of half side h, from the
 * cube? It is compared with 2^-40 of the size of the triangle, seen from the cube, to spare. The
 * middle of the cube is rounded by less than 2^-51 of its coordinates, which are at most 2^30
 * cells, and h has 2^-20 of a cell to spare. DECIDES_NOTHING: it separates no cube in this one,
 * either, because the triangle reaches beyond this one on both sides. */
static axis_side axis_separates(const double v[3][3], const double axis[3], double h) {
  double low = INFINITY;
  double high = -INFINITY;
  double size = 0;
  for (int k = 0; k < 3; k++) {
    double at = vector_dot(v[k], axis);
    low = at < low ? at : low; /* fmin and fmax are calls */
    high = at > high ? at : high;
    size += fabs(axis[k]) * (fabs(v[0][k]) + fabs(v[1][k]) + fabs(v[2][k]) + h);
  }
  double wide = (fabs(axis[0]) + fabs(axis[1]) + fabs(axis[2])) * h + 0x1p-40 * size;
  if (low > wide || high < -wide) {
    return SEPARATES;
  }
  return low <= -wide && high >= wide ? DECIDES_NOTHING : IS_OPEN;
}

/* May the triangle touch the cube with this middle and half side? Only `axes` are asked; those that
 * need not be asked of cubes in this one are taken out. */
static bool may_touch(const triangle *t, const double middle[3], double h, unsigned *axes) {
  double v[3][3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      v[k][i] = t->facet->v[k][i] - middle[i];
    }
  }
  for (unsigned left = *axes; left != 0; left &= left - 1) {
    int n = __builtin_ctz(left);
    axis_side side = axis_separates((const double(*)[3])v, t->axis[n], h);
    if (side == SEPARATES) {
      return false;
    }
    *axes &= side == DECIDES_NOTHING ? ~(1U << n) : ALL_AXES;
  }
  return true;
}

/* Bricks or cells along an axis that the triangle's box meets, of `count` with the side `side`. */
static bool clip(const sepax__stock *s, const sepax_facet *facet, int i, double side, size_t count,
                 size_t range[2]) {
  double low = fmin(facet->v[0][i], fmin(facet->v[1][i], facet->v[2][i]));
  double high = fmax(facet->v[0][i], fmax(facet->v[1][i], facet->v[2][i]));
  double from = floor((low - s->origin[i]) / side - 0x1p-18);
  double to = floor((high - s->origin[i]) / side + 0x1p-18) + 1;
  if (!(from < (double)count) || !(to > 0)) {
    return false;
  }
  range[0] = (size_t)fmax(from, 0);
  range[1] = (size_t)fmin(to, (double)count);
  return true;
}

/* Mark the cells that the triangle may touch, of a cube of a brick: of `side` cells, the first one
 * `in`. A cell's cube is 2^-20 of a cell larger. */
static void mark_cube(const sepax__stock *marked, const triangle *t, const size_t at[3],
                      const size_t in[3], size_t side, unsigned axes, uint64_t layer[BRICK]) {
  double p[3];
  uint64_t bit = (uint64_t)1 << (BRICK * in[1] + in[0]);
  if (side == 1 && (layer[in[2]] & bit) != 0) {
    return;
  }
  cells_middle(marked, at, in, (double)side, p);
  if (!may_touch(t, p, (double)side * marked->cell * (0.5 + 0x1p-20), &axes)) {
    return;
  }
  if (side == 1) {
    layer[in[2]] |= bit;
    return;
  }
  for (size_t n = 0; n < 8; n++) {
    const size_t part[3] = {in[0] + (n & 1) * side / 2, in[1] + (n >> 1 & 1) * side / 2,
                            in[2] + (n >> 2) * side / 2};
    mark_cube(marked, t, at, part, side / 2, axes, layer);
  }
}

static bool mark_brick(sepax__stock *marked, const triangle *t, const size_t at[3]) {
  const size_t none[3] = {0, 0, 0};
  uint64_t layer[BRICK];
  sepax__brick_get(marked, at, layer);
  mark_cube(marked, t, at, none, BRICK, ALL_AXES, layer);
  return sepax__brick_put(marked, at, layer);
}

/* `share` of the marking was done before this triangle, and it is the part `own` of it. */
static bool mark_triangle(sepax__stock *marked, const sepax_facet *facet,
                          const sepax__stock_watch *watch, double share, double own) {
  size_t range[3][2];
  const triangle t = triangle_of(facet);
  for (int i = 0; i < 3; i++) {
    if (!clip(marked, facet, i, BRICK * marked->cell, marked->bricks[i], range[i])) {
      return true;
    }
  }
  double rows = (double)(range[2][1] - range[2][0]) * (double)(range[1][1] - range[1][0]);
  double done = 0;
  size_t at[3];
  for (at[2] = range[2][0]; at[2] < range[2][1]; at[2]++) {
    for (at[1] = range[1][0]; at[1] < range[1][1]; at[1]++) {
      for (at[0] = range[0][0]; at[0] < range[0][1]; at[0]++) {
        if (!mark_brick(marked, &t, at)) {
          return false;
        }
      }
      done += 1 / rows;
      if (watch != NULL) {
        watch->show(watch->context, share + own * done);
      }
    }
  }
  return true;
}

/* Twice the area of a triangle; a part of the marking that it is about. */
static double area_of(const sepax_facet *facet) {
  const triangle t = triangle_of(facet);
  return vector_length(t.axis[3]);
}

bool sepax__stock_mark(sepax__stock *marked, const sepax_soup *mesh,
                       const sepax__stock_watch *watch, double most, sepax_error *error) {
  double all = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    for (int k = 0; k < 9; k++) {
      if (!isfinite(mesh->facet[n].v[k / 3][k % 3])) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "triangle %zu of the stock's mesh has a number not finite", n);
      }
    }
    all += area_of(&mesh->facet[n]);
  }
  double share = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    double own = all > 0 ? most * area_of(&mesh->facet[n]) / all : 0;
    if (!mark_triangle(marked, &mesh->facet[n], watch, share, own)) {
      return sepax__stock_no_memory(error);
    }
    share += own;
  }
  return true;
}
