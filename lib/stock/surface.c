/* SPDX-License-Identifier: MIT */
/* surface.c - the surface of the cells of a stock, as a mesh of rectangles.
 *
 * The faces of cells in one plane, turned to one side, become rectangles greedily: from the first
 * face as far as there are faces along one axis, then as far as there are whole rows along the
 * other. A rectangle may end in the middle of another one's edge. All places of corners along an
 * axis are computed alike, so such a corner is exactly on the edge, and the edges of the triangles
 * cancel as segments. */
#include "stock/bricks.h"

#include "util/error.h"
#include "util/memory.h"

#include <string.h>

typedef struct {
  const sepax__stock *s;
  sepax_soup *soup; /* NULL: only counted */
  size_t count;     /* triangles */
  /* Faces in the planes of a layer of bricks across `axis`, turned to `sign`: a bit for each, in
   * rows of `words` along the axis after it. */
  int axis, sign;
  uint64_t *plane[BRICK];
  size_t words, rows;
  bool any[BRICK];
} surface;

/* The cells of a layer whose neighbour along an axis, in a direction of 1 or -1, is not there. */
static uint64_t bare(const sepax__stock *s, const size_t at[3], int z, int axis, int sign,
                     uint64_t here) {
  const uint64_t first = 0x0101010101010101U; /* x = 0 of all rows */
  uint64_t next = 0;                          /* the layer in the brick beside */
  size_t beside[3] = {at[0], at[1], at[2]};
  beside[axis] += sign > 0 ? 1 : (size_t)-1;
  int layer = axis == 2 ? z + sign : z;
  bool leaves = axis < 2 || layer < 0 || layer >= BRICK;
  if (leaves && beside[axis] < s->bricks[axis]) {
    next = brick_layer(s, brick_at(s, beside), (layer + BRICK) % BRICK);
  }
  if (axis == 2) {
    return here & ~(leaves ? next : brick_layer(s, brick_at(s, at), layer));
  }
  if (axis == 1) {
    return here & ~(sign > 0 ? here >> BRICK | next << (BRICK * (BRICK - 1))
                             : here << BRICK | next >> (BRICK * (BRICK - 1)));
  }
  uint64_t moved = sign > 0 ? (here & ~first) >> 1 | (next & first) << (BRICK - 1)
                            : (here & ~(first << (BRICK - 1))) << 1 | (next >> (BRICK - 1) & first);
  return here & ~moved;
}

/* ------------------------------------------------------------------ planes */

/* Enter the faces of a brick in the planes. */
static void enter_brick(surface *f, const size_t at[3]) {
  const int u = (f->axis + 1) % 3;
  const int v = (f->axis + 2) % 3;
  for (int z = 0; z < BRICK; z++) {
    uint64_t here = brick_layer(f->s, brick_at(f->s, at), z);
    uint64_t faces = here == 0 ? 0 : bare(f->s, at, z, f->axis, f->sign, here);
    for (; faces != 0; faces &= faces - 1) {
      size_t n = (size_t)__builtin_ctzll(faces);
      const size_t in[3] = {n % BRICK, n / BRICK, (size_t)z};
      size_t column = at[u] * BRICK + in[u];
      size_t row = at[v] * BRICK + in[v];
      f->plane[in[f->axis]][row * f->words + column / 64] |= (uint64_t)1 << column % 64;
      f->any[in[f->axis]] = true;
    }
  }
}

/* The first column from `from` on whose bit is `set`, or the end of the row. */
static size_t next_column(const surface *f, const uint64_t *row, size_t from, bool set) {
  size_t word = from / 64;
  uint64_t skipped = ((uint64_t)1 << from % 64) - 1;
  while (word < f->words) {
    uint64_t bits = (set ? row[word] : ~row[word]) & ~skipped;
    if (bits != 0) {
      return word * 64 + (size_t)__builtin_ctzll(bits);
    }
    skipped = 0;
    word++;
  }
  return f->words * 64;
}

static void clear_columns(uint64_t *row, size_t from, size_t to) {
  for (size_t word = from / 64; word * 64 < to; word++) {
    uint64_t low = word * 64 < from ? UINT64_MAX << from % 64 : UINT64_MAX;
    uint64_t high = to - word * 64 < 64 ? ((uint64_t)1 << (to - word * 64)) - 1 : UINT64_MAX;
    row[word] &= ~(low & high);
  }
}

/* Two triangles of a rectangle, turned outward: cells from ... to - 1 along both axes. */
static void add_rectangle(surface *f, size_t layer, const size_t from[2], const size_t to[2]) {
  static const int turn[2][6][2] = {{{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}},
                                    {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};
  for (int k = 0; k < 6 && f->soup != NULL; k++) {
    size_t corner[3];
    corner[f->axis] = layer + (f->sign > 0);
    for (int i = 0; i < 2; i++) {
      corner[(f->axis + 1 + i) % 3] = turn[f->sign > 0][k][i] == 0 ? from[i] : to[i];
    }
    for (int i = 0; i < 3; i++) {
      f->soup->facet[f->count + (size_t)k / 3].v[k % 3][i] =
          f->s->origin[i] + (double)corner[i] * f->s->cell;
    }
  }
  f->count += 2;
}

/* Take all faces out of a plane, as rectangles. */
static void empty_plane(surface *f, uint64_t *plane, size_t layer) {
  for (size_t row = 0; row < f->rows; row++) {
    uint64_t *bits = plane + row * f->words;
    for (;;) {
      const size_t from[2] = {next_column(f, bits, 0, true), row};
      size_t to[2] = {next_column(f, bits, from[0], false), row + 1};
      if (from[0] == f->words * 64) {
        break;
      }
      clear_columns(bits, from[0], to[0]);
      while (to[1] < f->rows && (plane[to[1] * f->words + from[0] / 64] >> from[0] % 64 & 1) != 0 &&
             next_column(f, plane + to[1] * f->words, from[0], false) >= to[0]) {
        clear_columns(plane + to[1] * f->words, from[0], to[0]);
        to[1]++;
      }
      add_rectangle(f, layer, from, to);
    }
  }
}

static void add_layer(surface *f, size_t layer) {
  const int u = (f->axis + 1) % 3;
  const int v = (f->axis + 2) % 3;
  size_t at[3];
  memset(f->any, 0, sizeof f->any);
  at[f->axis] = layer;
  for (at[v] = 0; at[v] < f->s->bricks[v]; at[v]++) {
    for (at[u] = 0; at[u] < f->s->bricks[u]; at[u]++) {
      enter_brick(f, at);
    }
  }
  for (size_t n = 0; n < BRICK; n++) {
    if (f->any[n]) {
      empty_plane(f, f->plane[n], layer * BRICK + n);
    }
  }
}

static bool add_all(surface *f) {
  for (int side = 0; side < 6; side++) {
    f->axis = side / 2;
    f->sign = side % 2 == 0 ? 1 : -1;
    f->words = (f->s->bricks[(f->axis + 1) % 3] * BRICK + 63) / 64;
    f->rows = f->s->bricks[(f->axis + 2) % 3] * BRICK;
    uint64_t *bits = sepax__zeroed(BRICK * f->rows * f->words, sizeof *bits);
    if (bits == NULL) {
      return false;
    }
    for (size_t n = 0; n < BRICK; n++) {
      f->plane[n] = bits + n * f->rows * f->words;
    }
    for (size_t layer = 0; layer < f->s->bricks[f->axis]; layer++) {
      add_layer(f, layer);
    }
    sepax_release(bits);
  }
  return true;
}

bool sepax__stock_mesh(const sepax__stock *stock, size_t most, sepax_soup *soup,
                       sepax_error *error) {
  memset(soup, 0, sizeof *soup);
  surface f = {.s = stock};
  if (!add_all(&f)) {
    return sepax__stock_no_memory(error);
  }
  if (f.count > most) {
    return sepax_fail(error, SEPAX_ERROR_LIMIT,
                      "the surface of the stock has %zu triangles, more than %zu; take larger "
                      "cells, or write the stock itself",
                      f.count, most);
  }
  if (f.count == 0) {
    return true;
  }
  soup->facet = sepax_allocate(f.count * sizeof *soup->facet);
  if (soup->facet == NULL) {
    return sepax__stock_no_memory(error);
  }
  soup->count = f.count;
  f = (surface){.s = stock, .soup = soup};
  if (!add_all(&f)) {
    sepax_soup_free(soup);
    return sepax__stock_no_memory(error);
  }
  return true;
}
