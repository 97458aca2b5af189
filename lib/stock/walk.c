/* SPDX-License-Identifier: MIT */
/* walk.c - from a way to its pieces, and from a piece to the bricks that it may reach. */
#include "stock/walk.h"

#include <math.h>

double sepax__stock_extent(const sepax__stock *s) {
  double most = 0;
  for (int i = 0; i < 3; i++) {
    double end = s->origin[i] + (double)(s->bricks[i] * BRICK) * s->cell;
    most += fmax(fabs(s->origin[i]), fabs(end));
  }
  return most;
}

/* ------------------------------------------------------------------ bricks */

typedef struct {
  const sepax__stock *s;
  const sweep *reached;
  bool empty;
  size_t from[3], to[3]; /* bricks in the sweep's box */
} walk;

static bool misses(const walk *w, const size_t first[3], int cells) {
  double p[3];
  double q[3];
  double reach;
  cube_middle(w->s, first, cells, p);
  sweep_point(w->reached, p, q);
  return sepax__sweep_locate(w->reached, q, cells / 2.0 * w->s->cell, &reach) == SWEEP_OUTSIDE;
}

/* The bricks of a region that lie in the sweep's box. */
static bool walk_region(const walk *w, const size_t region[3], brick_visitor *visit,
                        void *context) {
  size_t from[3];
  size_t to[3];
  size_t at[3];
  for (int i = 0; i < 3; i++) {
    size_t first = region[i] * BRICK;
    from[i] = first > w->from[i] ? first : w->from[i];
    to[i] = first + BRICK < w->to[i] ? first + BRICK : w->to[i];
  }
  for (at[2] = from[2]; at[2] < to[2]; at[2]++) {
    for (at[1] = from[1]; at[1] < to[1]; at[1]++) {
      for (at[0] = from[0]; at[0] < to[0]; at[0]++) {
        const size_t cell[3] = {at[0] * BRICK, at[1] * BRICK, at[2] * BRICK};
        if ((w->empty || w->s->brick[brick_at(w->s, at)] != BRICK_EMPTY) &&
            !misses(w, cell, BRICK) && !visit(context, at)) {
          return false;
        }
      }
    }
  }
  return true;
}

/* Bricks that meet the box of the sweep; false if there are none. */
static bool clip(walk *w) {
  const sepax__stock *s = w->s;
  for (int i = 0; i < 3; i++) {
    double side = BRICK * s->cell;
    double from = floor((w->reached->box[0][i] - s->origin[i]) / side - 0x1p-10);
    double to = floor((w->reached->box[1][i] - s->origin[i]) / side + 0x1p-10) + 1;
    if (!(from < (double)s->bricks[i]) || !(to > 0)) {
      return false;
    }
    w->from[i] = (size_t)fmax(from, 0);
    w->to[i] = (size_t)fmin(to, (double)s->bricks[i]);
  }
  return true;
}

bool sepax__stock_walk(const sepax__stock *s, const sweep *reached, bool empty,
                       brick_visitor *visit, void *context) {
  enum { REGION = BRICK * BRICK };
  walk w = {.s = s, .reached = reached, .empty = empty};
  if (!clip(&w)) {
    return true;
  }
  size_t at[3];
  for (at[2] = w.from[2] / BRICK; at[2] * BRICK < w.to[2]; at[2]++) {
    for (at[1] = w.from[1] / BRICK; at[1] * BRICK < w.to[1]; at[1]++) {
      for (at[0] = w.from[0] / BRICK; at[0] * BRICK < w.to[0]; at[0]++) {
        const size_t brick[3] = {at[0] * BRICK, at[1] * BRICK, at[2] * BRICK};
        const size_t cell[3] = {at[0] * REGION, at[1] * REGION, at[2] * REGION};
        if ((empty || s->busy[region_of(s, brick)] != 0) && !misses(&w, cell, REGION) &&
            !walk_region(&w, at, visit, context)) {
          return false;
        }
      }
    }
  }
  return true;
}

/* ------------------------------------------------------------------- cells */

unsigned sepax__row_mask(const sweep *s, const sweep_row *row, unsigned asked, double half,
                         double cell, bool inside) {
  unsigned mask = 0;
  unsigned left = asked;
  double per_cell = 1 / cell;
  while (left != 0) {
    int n = __builtin_ctz(left);
    double q[3];
    double reach;
    row_point(row, n, q);
    sweep_side side = sepax__sweep_locate(s, q, half, &reach);
    /* points nearer than `reach` are on the same side; 2^-20 covers the rounding of their places */
    double more = reach * per_cell * (1 - 0x1p-20);
    int same = 1 + (more < BRICK ? (int)more : BRICK);
    unsigned run = ((1U << same) - 1) << n;
    mask |= side == (inside ? SWEEP_INSIDE : SWEEP_OUTSIDE) ? run : 0;
    left &= ~run;
  }
  return mask & asked;
}

/* ------------------------------------------------------------------ pieces */

enum { DIVIDED_MOST = 20 };

double sepax__stock_fine(const sepax__stock *s, double tolerance) {
  return fmax(s->cell / 8 - tolerance, s->cell / 32);
}

/* A part of the way that waits, and the deviation of the part that it was half of. */
typedef struct {
  double from, to, before;
} part;

void sepax__stock_pieces(const sepax__stock_way *way, double fine, piece_visitor *visit,
                         void *context) {
  part waiting[DIVIDED_MOST + 2] = {{0, 1, INFINITY}};
  int depth[DIVIDED_MOST + 2] = {0};
  int count = 1;
  while (count > 0) {
    part p = waiting[--count];
    int deep = depth[count];
    sepax__stock_piece piece;
    way->piece(way->context, p.from, p.to, &piece);
    bool last =
        piece.deviation <= fine || deep == DIVIDED_MOST || piece.deviation > 0.875 * p.before;
    if (visit(context, &piece, last) || last) {
      continue;
    }
    double middle = p.from / 2 + p.to / 2;
    depth[count] = depth[count + 1] = deep + 1;
    waiting[count++] = (part){middle, p.to, piece.deviation};
    waiting[count++] = (part){p.from, middle, piece.deviation};
  }
}

void sepax__stock_straight(const void *context, double from, double to, sepax__stock_piece *piece) {
  const sepax__stock_piece *whole = context;
  *piece = *whole;
  for (int i = 0; i < 3; i++) {
    piece->at.translation[i] += from * whole->way[i];
    piece->way[i] = (to - from) * whole->way[i];
  }
}
