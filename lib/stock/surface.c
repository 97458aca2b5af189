/* SPDX-License-Identifier: MIT */
/* surface.c - the surface of the cells of a stock, as a mesh. */
#include "stock/bricks.h"

#include "util/error.h"

#include <string.h>

typedef struct {
  const sepax__stock *s;
  sepax_soup *soup; /* NULL: only counted */
  size_t count;     /* triangles */
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

/* Two triangles of a cell's face, turned outward. */
static void add_face(surface *f, const size_t cell[3], int axis, int sign) {
  static const int turn[2][6][2] = {{{0, 0}, {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}},
                                    {{0, 0}, {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}};
  for (int k = 0; k < 6; k++) {
    size_t corner[3] = {cell[0], cell[1], cell[2]};
    corner[axis] += sign > 0;
    corner[(axis + 1) % 3] += (size_t)turn[sign > 0][k][0];
    corner[(axis + 2) % 3] += (size_t)turn[sign > 0][k][1];
    for (int i = 0; i < 3; i++) {
      f->soup->facet[f->count + (size_t)k / 3].v[k % 3][i] =
          f->s->origin[i] + (double)corner[i] * f->s->cell;
    }
  }
}

static void add_faces(surface *f, const size_t at[3], int z, int axis, int sign, uint64_t faces) {
  for (; faces != 0; faces &= faces - 1) {
    if (f->soup != NULL) {
      size_t n = (size_t)__builtin_ctzll(faces);
      const size_t cell[3] = {at[0] * BRICK + n % BRICK, at[1] * BRICK + n / BRICK,
                              at[2] * BRICK + (size_t)z};
      add_face(f, cell, axis, sign);
    }
    f->count += 2;
  }
}

static void add_brick(surface *f, const size_t at[3]) {
  for (int z = 0; z < BRICK; z++) {
    uint64_t here = brick_layer(f->s, brick_at(f->s, at), z);
    for (int side = 0; side < 6 && here != 0; side++) {
      int sign = side % 2 == 0 ? 1 : -1;
      add_faces(f, at, z, side / 2, sign, bare(f->s, at, z, side / 2, sign, here));
    }
  }
}

static void add_bricks(surface *f) {
  size_t at[3];
  const size_t *bricks = f->s->bricks;
  for (at[2] = 0; at[2] < bricks[2]; at[2]++) {
    for (at[1] = 0; at[1] < bricks[1]; at[1]++) {
      for (at[0] = 0; at[0] < bricks[0]; at[0]++) {
        add_brick(f, at);
      }
    }
  }
}

bool sepax__stock_mesh(const sepax__stock *stock, size_t most, sepax_soup *soup,
                       sepax_error *error) {
  memset(soup, 0, sizeof *soup);
  surface f = {.s = stock};
  add_bricks(&f);
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
  add_bricks(&f);
  return true;
}
