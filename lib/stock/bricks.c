/* SPDX-License-Identifier: MIT */
/* bricks.c - the cells of a stock. */
#include "stock/bricks.h"

#include "util/error.h"
#include "util/memory.h"

#include <math.h>
#include <string.h>

enum { BRICKS_MOST = 1 << 28 };

bool sepax__stock_no_memory(sepax_error *error) {
  return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the cells of the stock");
}

static bool box_is_valid(const double box[2][3], double cell, sepax_error *error) {
  bool ok = isfinite(cell) && cell > 0;
  for (int i = 0; i < 3; i++) {
    ok = ok && isfinite(box[0][i]) && isfinite(box[1][i]) && box[0][i] < box[1][i];
  }
  return ok || sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                          "the stock needs a box with a volume and cells of a size above 0");
}

/* Along each axis as many bricks as cover the box; one whose last 2^-20 of a cell is missing still
 * covers it. */
static bool count_bricks(sepax__stock *s, const double box[2][3], sepax_error *error) {
  double all = 1;
  for (int i = 0; i < 3; i++) {
    double count = fmax(1, ceil((box[1][i] - box[0][i]) / s->cell / BRICK - 0x1p-23));
    double most = fmax(fabs(box[0][i]), fabs(box[1][i]));
    all *= count;
    if (!(all <= BRICKS_MOST) || most * 0x1p-30 > s->cell) {
      return sepax_fail(error, SEPAX_ERROR_LIMIT,
                        "cells of %g are too small for this stock: it has more than %d bricks of "
                        "8 x 8 x 8 cells, or is more than 2^30 cells from the origin; take larger "
                        "cells",
                        s->cell, BRICKS_MOST);
    }
    s->origin[i] = box[0][i];
    s->bricks[i] = (size_t)count;
    s->regions[i] = (s->bricks[i] + BRICK - 1) / BRICK;
  }
  return true;
}

bool sepax__stock_new(sepax__stock **stock, sepax__stock_bound bound, const double box[2][3],
                      double cell, sepax_error *error) {
  sepax__stock s = {.bound = bound, .cell = cell, .unused = BLOCK_NONE};
  *stock = NULL;
  if (!box_is_valid(box, cell, error) || !count_bricks(&s, box, error)) {
    return false;
  }
  size_t count = s.bricks[0] * s.bricks[1] * s.bricks[2];
  s.brick = sepax_allocate(count * sizeof *s.brick);
  s.busy = sepax__zeroed(s.regions[0] * s.regions[1] * s.regions[2], sizeof *s.busy);
  *stock = sepax_allocate(sizeof **stock);
  if (s.brick == NULL || s.busy == NULL || *stock == NULL) {
    sepax_release(s.brick);
    sepax_release(s.busy);
    sepax_release(*stock);
    *stock = NULL;
    return sepax__stock_no_memory(error);
  }
  memset(s.brick, 0xff, count * sizeof *s.brick); /* BRICK_EMPTY */
  **stock = s;
  return true;
}

void sepax__stock_free(sepax__stock *stock) {
  if (stock != NULL) {
    sepax_release(stock->brick);
    sepax_release(stock->busy);
    sepax_release(stock->block);
    sepax_release(stock);
  }
}

/* Room for one more mixed brick. False without memory. */
static bool reserve_block(sepax__stock *s) {
  if (s->unused != BLOCK_NONE || s->blocks < s->capacity) {
    return true;
  }
  size_t more = s->capacity == 0 ? 64 : s->capacity + s->capacity / 3;
  brick_block *grown = sepax_resize(s->block, more * sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  s->block = grown;
  s->capacity = more;
  return true;
}

static uint32_t take_block(sepax__stock *s) {
  uint32_t n = s->unused;
  if (n != BLOCK_NONE) {
    s->unused = s->block[n].next;
    return n;
  }
  return (uint32_t)s->blocks++;
}

void sepax__brick_get(const sepax__stock *s, const size_t at[3], uint64_t layer[BRICK]) {
  size_t brick = brick_at(s, at);
  for (int z = 0; z < BRICK; z++) {
    layer[z] = brick_layer(s, brick, z);
  }
}

bool sepax__brick_put(sepax__stock *s, const size_t at[3], const uint64_t layer[BRICK]) {
  uint32_t *state = &s->brick[brick_at(s, at)];
  uint64_t any = 0;
  uint64_t all = UINT64_MAX;
  for (int z = 0; z < BRICK; z++) {
    any |= layer[z];
    all &= layer[z];
  }
  uint32_t to = any == 0 ? BRICK_EMPTY : all == UINT64_MAX ? BRICK_FULL : 0;
  bool mixed = *state < BRICK_FULL;
  if (to == 0 && !mixed && !reserve_block(s)) {
    return false;
  }
  uint32_t *busy = &s->busy[region_of(s, at)];
  *busy = *busy - (*state != BRICK_EMPTY) + (to != BRICK_EMPTY);
  if (to == 0) {
    *state = mixed ? *state : take_block(s);
    memcpy(s->block[*state].layer, layer, sizeof s->block->layer);
    return true;
  }
  if (mixed) {
    s->block[*state].next = s->unused;
    s->unused = *state;
  }
  *state = to;
  return true;
}

sepax__stock_facts sepax__stock_look(const sepax__stock *stock) {
  const sepax__stock *s = stock;
  sepax__stock_facts facts = {.bound = s->bound, .cell = s->cell};
  size_t bricks = s->bricks[0] * s->bricks[1] * s->bricks[2];
  size_t regions = s->regions[0] * s->regions[1] * s->regions[2];
  for (int i = 0; i < 3; i++) {
    facts.box[0][i] = s->origin[i];
    facts.box[1][i] = s->origin[i] + (double)(s->bricks[i] * BRICK) * s->cell;
  }
  for (size_t n = 0; n < bricks; n++) {
    for (int z = 0; z < BRICK; z++) {
      facts.cells += (uint64_t)__builtin_popcountll(brick_layer(s, n, z));
    }
  }
  facts.bytes = sizeof *s + bricks * sizeof *s->brick + regions * sizeof *s->busy +
                s->capacity * sizeof *s->block;
  return facts;
}

bool sepax__stock_has(const sepax__stock *stock, const double point[3]) {
  size_t at[3];
  unsigned in[3];
  for (int i = 0; i < 3; i++) {
    double n = floor((point[i] - stock->origin[i]) / stock->cell);
    if (!(n >= 0 && n < (double)(stock->bricks[i] * BRICK))) {
      return false;
    }
    at[i] = (size_t)n / BRICK;
    in[i] = (unsigned)((size_t)n % BRICK);
  }
  return brick_layer(stock, brick_at(stock, at), (int)in[2]) >> (BRICK * in[1] + in[0]) & 1;
}
