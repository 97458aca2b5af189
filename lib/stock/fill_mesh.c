/* SPDX-License-Identifier: MIT */
/* fill_mesh.c - the solid of a closed mesh as a first stock.
 *
 * First all cells that touch a triangle are marked. No triangle lies between two neighbouring cells
 * that are not marked, so a region of such cells is wholly inside or wholly outside. The winding
 * number of the middle of one cell decides for its region; the nearest triangle is half a cell away
 * or more, so that the number is whole but for rounding. */
#include "stock/bricks.h"

#include "util/error.h"
#include "util/list.h"
#include "util/vector.h"

#include <math.h>
#include <string.h>

/* --------------------------------------------------------------- triangles */

/* May the triangle, counted from the middle of a cube of half side h, touch the cube? True unless
 * one of the 13 axes separates them. An axis is compared with 2^-40 of the size of the triangle,
 * seen from the cube, to spare. The middle of the cube is rounded by less than 2^-51 of its
 * coordinates, which are at most 2^30 cells, and h has 2^-20 of a cell to spare. */
static bool axis_separates(const double v[3][3], const double axis[3], double h) {
  double low = INFINITY;
  double high = -INFINITY;
  for (int k = 0; k < 3; k++) {
    double at = vector_dot(v[k], axis);
    low = at < low ? at : low; /* fmin and fmax are calls */
    high = at > high ? at : high;
  }
  double size = 0;
  for (int i = 0; i < 3; i++) {
    size += fabs(axis[i]) * (fabs(v[0][i]) + fabs(v[1][i]) + fabs(v[2][i]) + h);
  }
  double wide = (fabs(axis[0]) + fabs(axis[1]) + fabs(axis[2])) * h + 0x1p-40 * size;
  return low > wide || high < -wide;
}

static bool may_touch(const sepax_facet *facet, const double middle[3], double h) {
  double v[3][3];
  double edge[3][3];
  for (int k = 0; k < 3; k++) {
    for (int i = 0; i < 3; i++) {
      v[k][i] = facet->v[k][i] - middle[i];
      edge[k][i] = facet->v[(k + 1) % 3][i] - facet->v[k][i];
    }
  }
  for (int i = 0; i < 3; i++) {
    const double unit[3] = {i == 0, i == 1, i == 2};
    if (axis_separates(v, unit, h)) {
      return false;
    }
  }
  double normal[3];
  vector_cross(edge[0], edge[1], normal);
  if (axis_separates(v, normal, h)) {
    return false;
  }
  for (int n = 0; n < 9; n++) {
    const double unit[3] = {n / 3 == 0, n / 3 == 1, n / 3 == 2};
    double axis[3];
    vector_cross(unit, edge[n % 3], axis);
    if (axis_separates(v, axis, h)) {
      return false;
    }
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

static void middle_of(const sepax__stock *s, const size_t at[3], const size_t in[3], double cells,
                      double p[3]) {
  for (int i = 0; i < 3; i++) {
    p[i] = s->origin[i] + ((double)(at[i] * BRICK + in[i]) + cells / 2) * s->cell;
  }
}

/* Mark the cells that the triangle may touch, of a cube of a brick: of `side` cells, the first one
 * `in`. A cell's cube is 2^-20 of a cell larger. */
static void mark_cube(const sepax__stock *marked, const sepax_facet *facet, const size_t at[3],
                      const size_t in[3], size_t side, uint64_t layer[BRICK]) {
  double p[3];
  uint64_t bit = (uint64_t)1 << (BRICK * in[1] + in[0]);
  if (side == 1 && (layer[in[2]] & bit) != 0) {
    return;
  }
  middle_of(marked, at, in, (double)side, p);
  if (!may_touch(facet, p, (double)side * marked->cell * (0.5 + 0x1p-20))) {
    return;
  }
  if (side == 1) {
    layer[in[2]] |= bit;
    return;
  }
  for (size_t n = 0; n < 8; n++) {
    const size_t part[3] = {in[0] + (n & 1) * side / 2, in[1] + (n >> 1 & 1) * side / 2,
                            in[2] + (n >> 2) * side / 2};
    mark_cube(marked, facet, at, part, side / 2, layer);
  }
}

static bool mark_brick(sepax__stock *marked, const sepax_facet *facet, const size_t at[3]) {
  const size_t none[3] = {0, 0, 0};
  uint64_t layer[BRICK];
  sepax__brick_get(marked, at, layer);
  mark_cube(marked, facet, at, none, BRICK, layer);
  return sepax__brick_put(marked, at, layer);
}

static bool mark_triangle(sepax__stock *marked, const sepax_facet *facet) {
  size_t range[3][2];
  for (int i = 0; i < 3; i++) {
    if (!clip(marked, facet, i, BRICK * marked->cell, marked->bricks[i], range[i])) {
      return true;
    }
  }
  size_t at[3];
  for (at[2] = range[2][0]; at[2] < range[2][1]; at[2]++) {
    for (at[1] = range[1][0]; at[1] < range[1][1]; at[1]++) {
      for (at[0] = range[0][0]; at[0] < range[0][1]; at[0]++) {
        if (!mark_brick(marked, facet, at)) {
          return false;
        }
      }
    }
  }
  return true;
}

/* ----------------------------------------------------------------- winding */

/* How often the triangles wind around a point: the sum of the solid angles at which they are seen,
 * by the formula of Van Oosterom and Strackee. */
static double winding_of(const sepax_soup *mesh, const double p[3]) {
  double sum = 0;
  for (size_t n = 0; n < mesh->count; n++) {
    double v[3][3];
    double length[3];
    double normal[3];
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        v[k][i] = mesh->facet[n].v[k][i] - p[i];
      }
      length[k] = vector_length(v[k]);
    }
    vector_cross(v[1], v[2], normal);
    double below = length[0] * length[1] * length[2] + vector_dot(v[0], v[1]) * length[2] +
                   vector_dot(v[1], v[2]) * length[0] + vector_dot(v[2], v[0]) * length[1];
    sum += 2 * atan2(vector_dot(v[0], normal), below);
  }
  return sum / (4 * 0x1.921fb54442d18p1);
}

/* ----------------------------------------------------------------- regions */

/* A brick some of whose cells have been reached, and whose neighbours wait: those of one cell, or
 * of all cells. */
typedef struct {
  uint32_t at[3];
  uint32_t cell; /* of the brick, or ALL */
} seed;

enum { ALL = BRICK_CELLS };

typedef struct {
  seed *item;
  size_t count, capacity;
} seeds;

/* Cells that are marked or have been reached are in `done`. A region is flooded in waves: the seeds
 * of one wave reach those of the next, so only its front is kept. */
typedef struct {
  sepax__stock *done, *result;
  seeds wave, next;
  bool inside;
} flood;

static bool add_seed(flood *f, const size_t at[3], uint32_t cell) {
  seeds *to = &f->next;
  seed *grown = list_grow(to->item, &to->capacity, to->count, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  to->item = grown;
  to->item[to->count++] = (seed){{(uint32_t)at[0], (uint32_t)at[1], (uint32_t)at[2]}, cell};
  return true;
}

/* Add cells of a brick to a stock. */
static bool add_cells(sepax__stock *s, const size_t at[3], const uint64_t cells[BRICK]) {
  uint64_t layer[BRICK];
  sepax__brick_get(s, at, layer);
  for (int z = 0; z < BRICK; z++) {
    layer[z] |= cells[z];
  }
  return sepax__brick_put(s, at, layer);
}

static bool reach_cells(flood *f, const size_t at[3], const uint64_t cells[BRICK]) {
  return add_cells(f->done, at, cells) && (!f->inside || add_cells(f->result, at, cells));
}

/* All cells of the region that can be reached within a brick, from one of them. */
static void spread(const uint64_t done[BRICK], const size_t in[3], uint64_t cells[BRICK]) {
  const uint64_t first = 0x0101010101010101U; /* x = 0 of all rows */
  for (size_t z = 0; z < BRICK; z++) {
    cells[z] = z == in[2] ? (uint64_t)1 << (BRICK * in[1] + in[0]) : 0;
  }
  for (bool more = true; more;) {
    more = false;
    for (int z = 0; z < BRICK; z++) {
      uint64_t c = cells[z];
      c |= (c & ~(first << 7)) << 1 | (c & ~first) >> 1 | c << BRICK | c >> BRICK;
      c |= (z > 0 ? cells[z - 1] : 0) | (z < BRICK - 1 ? cells[z + 1] : 0);
      c &= ~done[z];
      more = more || c != cells[z];
      cells[z] = c;
    }
  }
}

/* The cells of a brick beside, behind the faces of `cells` in a direction along an axis. */
static void behind(const uint64_t cells[BRICK], int axis, bool up, uint64_t to[BRICK]) {
  const uint64_t first = 0x0101010101010101U; /* x = 0 of all rows */
  for (int z = 0; z < BRICK; z++) {
    uint64_t c = cells[z];
    to[z] = axis == 0 ? (up ? c >> (BRICK - 1) & first : (c & first) << (BRICK - 1))
                      : (up ? c >> BRICK * (BRICK - 1) : c << BRICK * (BRICK - 1));
  }
  if (axis == 2) {
    memset(to, 0, BRICK * sizeof *to);
    to[up ? 0 : BRICK - 1] = cells[up ? BRICK - 1 : 0];
  }
}

/* Reach what is behind `cells` of a brick. A brick without a mark is reached as a whole. */
static bool reach_beside(flood *f, const size_t at[3], const uint64_t cells[BRICK]) {
  const uint64_t whole[BRICK] = {UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX,
                                 UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX};
  for (int side = 0; side < 6; side++) {
    size_t to[3] = {at[0], at[1], at[2]};
    to[side / 2] += side % 2 == 1 ? 1 : (size_t)-1;
    if (to[side / 2] >= f->done->bricks[side / 2]) { /* also one below 0 */
      continue;
    }
    uint64_t there[BRICK];
    uint64_t any = 0;
    behind(cells, side / 2, side % 2 == 1, there);
    for (int z = 0; z < BRICK; z++) {
      there[z] &= ~brick_layer(f->done, brick_at(f->done, to), z);
      any |= there[z];
    }
    if (any != 0 && f->done->brick[brick_at(f->done, to)] == BRICK_EMPTY) {
      if (!reach_cells(f, to, whole) || !add_seed(f, to, ALL)) {
        return false;
      }
      continue;
    }
    for (size_t n = 0; n < BRICK_CELLS && any != 0; n++) {
      if ((there[n / (BRICK * BRICK)] >> n % (BRICK * BRICK) & 1) != 0 &&
          !add_seed(f, to, (uint32_t)n)) {
        return false;
      }
    }
  }
  return true;
}

static bool reach_seed(flood *f, const seed *from) {
  const size_t at[3] = {from->at[0], from->at[1], from->at[2]};
  const size_t n = from->cell % BRICK_CELLS;
  const size_t in[3] = {n % BRICK, n / BRICK % BRICK, n / (BRICK * BRICK)};
  uint64_t done[BRICK];
  uint64_t cells[BRICK];
  if (from->cell == ALL) {
    memset(cells, 0xff, sizeof cells);
    return reach_beside(f, at, cells);
  }
  sepax__brick_get(f->done, at, done);
  if (done[in[2]] >> (BRICK * in[1] + in[0]) & 1) {
    return true;
  }
  spread(done, in, cells);
  return reach_cells(f, at, cells) && reach_beside(f, at, cells);
}

/* The region of a cell: all of it is inside or outside. */
static bool flood_region(flood *f, const sepax_soup *mesh, const size_t at[3], size_t cell,
                         sepax_error *error) {
  const size_t in[3] = {cell % BRICK, cell / BRICK % BRICK, cell / (BRICK * BRICK)};
  double p[3];
  middle_of(f->done, at, in, 1, p);
  double winding = winding_of(mesh, p);
  double whole = round(winding);
  if (!(fabs(winding - whole) <= 1e-6)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the stock's mesh winds %g times around (%g, %g, %g): it is open, or has "
                      "triangles turned round; close it, turn them",
                      winding, p[0], p[1], p[2]);
  }
  f->inside = whole != 0;
  bool ok = add_seed(f, at, (uint32_t)cell);
  while (ok && f->next.count > 0) {
    seeds wave = f->next;
    f->next = f->wave;
    f->wave = wave;
    f->next.count = 0;
    for (size_t n = 0; n < f->wave.count && ok; n++) {
      ok = reach_seed(f, &f->wave.item[n]);
    }
  }
  return ok || sepax__stock_no_memory(error);
}

static bool flood_brick(flood *f, const sepax_soup *mesh, const size_t at[3], sepax_error *error) {
  for (size_t n = 0; n < BRICK_CELLS; n++) {
    uint64_t layer = brick_layer(f->done, brick_at(f->done, at), (int)(n / (BRICK * BRICK)));
    if ((layer >> n % (BRICK * BRICK) & 1) == 0 && !flood_region(f, mesh, at, n, error)) {
      return false;
    }
  }
  return true;
}

static bool flood_all(flood *f, const sepax_soup *mesh, sepax_error *error) {
  size_t at[3];
  const sepax__stock *s = f->done;
  for (at[2] = 0; at[2] < s->bricks[2]; at[2]++) {
    for (at[1] = 0; at[1] < s->bricks[1]; at[1]++) {
      for (at[0] = 0; at[0] < s->bricks[0]; at[0]++) {
        if (s->brick[brick_at(s, at)] != BRICK_FULL && !flood_brick(f, mesh, at, error)) {
          return false;
        }
      }
    }
  }
  return true;
}

/* What is marked, and in an outer bound also part of the result. */
static bool mark_all(flood *f, const sepax_soup *mesh, sepax_error *error) {
  for (size_t n = 0; n < mesh->count; n++) {
    for (int k = 0; k < 9; k++) {
      if (!isfinite(mesh->facet[n].v[k / 3][k % 3])) {
        return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "triangle %zu of the stock's mesh has a number not finite", n);
      }
    }
    if (!mark_triangle(f->done, &mesh->facet[n])) {
      return sepax__stock_no_memory(error);
    }
  }
  size_t at[3];
  const sepax__stock *s = f->done;
  for (at[2] = 0; at[2] < s->bricks[2] && f->result->bound == SEPAX__STOCK_OUTER; at[2]++) {
    for (at[1] = 0; at[1] < s->bricks[1]; at[1]++) {
      for (at[0] = 0; at[0] < s->bricks[0]; at[0]++) {
        uint64_t layer[BRICK];
        sepax__brick_get(s, at, layer);
        if (s->brick[brick_at(s, at)] != BRICK_EMPTY && !add_cells(f->result, at, layer)) {
          return sepax__stock_no_memory(error);
        }
      }
    }
  }
  return true;
}

bool sepax__stock_fill_mesh(sepax__stock *stock, const sepax_soup *mesh, sepax_error *error) {
  flood f = {.result = stock};
  sepax__stock_facts facts = {.cell = stock->cell};
  for (int i = 0; i < 3; i++) {
    facts.box[0][i] = stock->origin[i];
    facts.box[1][i] = stock->origin[i] + (double)(stock->bricks[i] * BRICK) * stock->cell;
  }
  bool ok = sepax__stock_new(&f.done, SEPAX__STOCK_OUTER, facts.box, stock->cell, error) &&
            mark_all(&f, mesh, error) && flood_all(&f, mesh, error);
  sepax__stock_free(f.done);
  sepax_release(f.wave.item);
  sepax_release(f.next.item);
  return ok;
}
