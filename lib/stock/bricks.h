/* SPDX-License-Identifier: MIT */
/* bricks.h - the cells of a stock: bricks of 8 x 8 x 8 bits, of which only those that are neither
 * empty nor full are stored (private). */
#ifndef SEPAX_STOCK_BRICKS_H
#define SEPAX_STOCK_BRICKS_H

#include "stock/stock.h"

enum {
  BRICK = 8,         /* cells along a side of a brick, and bricks along a side of a region */
  BRICK_CELLS = 512, /* of a brick */
};
#define BRICK_EMPTY UINT32_MAX
#define BRICK_FULL (UINT32_MAX - 1)
#define BLOCK_NONE UINT32_MAX

/* Cell (x, y, z) of a brick is bit 8 y + x of layer[z]. */
typedef struct {
  uint64_t layer[BRICK];
  uint32_t next; /* of the blocks that are not used */
  uint32_t spare;
} brick_block;

struct sepax__stock {
  sepax__stock_bound bound;
  double origin[3], cell;
  size_t bricks[3], regions[3]; /* along the axes */
  uint32_t *brick;              /* EMPTY, FULL, or the number of its block */
  uint32_t *busy;               /* bricks of each region that are not empty */
  brick_block *block;
  size_t blocks, capacity;
  uint32_t unused; /* the first block that is not used, or BLOCK_NONE */
};

static inline size_t brick_at(const sepax__stock *s, const size_t at[3]) {
  return (at[2] * s->bricks[1] + at[1]) * s->bricks[0] + at[0];
}

static inline size_t region_of(const sepax__stock *s, const size_t at[3]) {
  return (at[2] / BRICK * s->regions[1] + at[1] / BRICK) * s->regions[0] + at[0] / BRICK;
}

/* The layer z of a brick, whatever its state. */
static inline uint64_t brick_layer(const sepax__stock *s, size_t brick, int z) {
  uint32_t state = s->brick[brick];
  return state == BRICK_EMPTY ? 0 : state == BRICK_FULL ? UINT64_MAX : s->block[state].layer[z];
}

/* All layers of a brick, and setting them. sepax__brick_put keeps the counts; it fails without
 * memory, which can only happen if an empty or full brick becomes a mixed one. */
void sepax__brick_get(const sepax__stock *s, const size_t at[3], uint64_t layer[BRICK]);
bool sepax__brick_put(sepax__stock *s, const size_t at[3], const uint64_t layer[BRICK]);

bool sepax__stock_no_memory(sepax_error *error);

#endif
