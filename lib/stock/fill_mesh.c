/* SPDX-License-Identifier: MIT */
/* fill_mesh.c - the solid of a closed mesh as a first stock.
 *
 * First all cells that touch a triangle are marked. No triangle lies between two neighbouring cells
 * that are not marked, so a region of such cells is wholly inside or wholly outside. The winding
 * number of the middle of one cell decides for its region; the nearest triangle is half a cell away
 * or more, so that the number is whole but for rounding. */
#include "stock/mark.h"

#include "util/error.h"
#include "util/list.h"
#include "util/vector.h"

#include <math.h>
#include <string.h>

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

/* Cells that have been reached, and whose neighbours wait: those of the region of a cell of a
 * brick, or all cells of a row of bricks along x. */
typedef struct {
  uint32_t at[3], bricks;
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
  const sepax__stock_watch *watch; /* or NULL */
  double reached;                  /* bricks */
} flood;

/* The share of the time that marking takes, for a box. */
static const double marking = 0.3;

static bool add_seed(flood *f, const size_t at[3], size_t bricks, uint32_t cell) {
  seeds *to = &f->next;
  seed *grown = list_grow(to->item, &to->capacity, to->count, sizeof *grown);
  if (grown == NULL) {
    return false;
  }
  to->item = grown;
  to->item[to->count++] =
      (seed){{(uint32_t)at[0], (uint32_t)at[1], (uint32_t)at[2]}, (uint32_t)bricks, cell};
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

static const uint64_t whole_brick[BRICK] = {UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX,
                                            UINT64_MAX, UINT64_MAX, UINT64_MAX, UINT64_MAX};

/* Reach the bricks without a mark along x, from one of them as far as there are any. Rows, because
 * bricks beside each other are near in memory. */
static bool reach_row(flood *f, const size_t from[3]) {
  size_t at[3] = {from[0], from[1], from[2]};
  const uint32_t *row = f->done->brick + brick_at(f->done, at) - from[0];
  size_t end = from[0];
  while (at[0] > 0 && row[at[0] - 1] == BRICK_EMPTY) {
    at[0]--;
  }
  while (end < f->done->bricks[0] && row[end] == BRICK_EMPTY) {
    end++;
  }
  if (!add_seed(f, at, end - at[0], ALL)) {
    return false;
  }
  f->reached += (double)(end - at[0]);
  for (; at[0] < end; at[0]++) {
    if (!reach_cells(f, at, whole_brick)) {
      return false;
    }
  }
  return true;
}

/* Reach what is behind `cells` of a brick. A brick without a mark is reached as a whole. */
static bool reach_beside(flood *f, const size_t at[3], const uint64_t cells[BRICK]) {
  for (int side = 0; side < 6; side++) {
    size_t to[3] = {at[0], at[1], at[2]};
    to[side / 2] += side % 2 == 1 ? 1 : (size_t)-1;
    if (to[side / 2] >= f->done->bricks[side / 2]) { /* also one below 0 */
      continue;
    }
    uint32_t state = f->done->brick[brick_at(f->done, to)];
    if (state == BRICK_FULL) {
      continue;
    }
    uint64_t there[BRICK];
    uint64_t any = 0;
    behind(cells, side / 2, side % 2 == 1, there);
    for (int z = 0; z < BRICK; z++) {
      there[z] &= ~brick_layer(f->done, brick_at(f->done, to), z);
      any |= there[z];
    }
    if (any != 0 && state == BRICK_EMPTY) {
      if (!reach_row(f, to)) {
        return false;
      }
      continue;
    }
    for (size_t n = 0; n < BRICK_CELLS && any != 0; n++) {
      if ((there[n / (BRICK * BRICK)] >> n % (BRICK * BRICK) & 1) != 0 &&
          !add_seed(f, to, 1, (uint32_t)n)) {
        return false;
      }
    }
  }
  return true;
}

static bool reach_seed(flood *f, const seed *from) {
  size_t at[3] = {from->at[0], from->at[1], from->at[2]};
  const size_t n = from->cell % BRICK_CELLS;
  const size_t in[3] = {n % BRICK, n / BRICK % BRICK, n / (BRICK * BRICK)};
  uint64_t done[BRICK];
  uint64_t cells[BRICK];
  if (from->cell == ALL) {
    bool ok = true;
    for (uint32_t k = 0; k < from->bricks && ok; k++, at[0]++) {
      ok = reach_beside(f, at, whole_brick);
    }
    return ok;
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
  cells_middle(f->done, at, in, 1, p);
  double winding = winding_of(mesh, p);
  double whole = round(winding);
  if (!(fabs(winding - whole) <= 1e-6)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the stock's mesh winds %g times around (%g, %g, %g): it is open, or has "
                      "triangles turned round; close it, turn them",
                      winding, p[0], p[1], p[2]);
  }
  f->inside = whole != 0;
  bool ok = add_seed(f, at, 1, (uint32_t)cell);
  while (ok && f->next.count > 0) {
    seeds wave = f->next;
    f->next = f->wave;
    f->wave = wave;
    f->next.count = 0;
    if (f->watch != NULL) {
      double all = (double)(f->done->bricks[0] * f->done->bricks[1]) * (double)f->done->bricks[2];
      f->watch->show(f->watch->context, marking + (1 - marking) * fmin(1, f->reached / all));
    }
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

/* In an outer bound, what is marked is part of the result. */
static bool add_marked(flood *f, sepax_error *error) {
  size_t at[3];
  const sepax__stock *s = f->done;
  for (at[2] = 0; at[2] < s->bricks[2] && f->result->bound == SEPAX__STOCK_OUTER; at[2]++) {
    for (at[1] = 0; at[1] < s->bricks[1]; at[1]++) {
      for (at[0] = 0; at[0] < s->bricks[0]; at[0]++) {
        uint64_t layer[BRICK];
        if (s->brick[brick_at(s, at)] == BRICK_EMPTY) {
          continue;
        }
        sepax__brick_get(s, at, layer);
        if (!add_cells(f->result, at, layer)) {
          return sepax__stock_no_memory(error);
        }
      }
    }
  }
  return true;
}

bool sepax__stock_fill_mesh(sepax__stock *stock, const sepax_soup *mesh,
                            const sepax__stock_watch *watch, sepax_error *error) {
  flood f = {.result = stock, .watch = watch};
  sepax__stock_facts facts = {.cell = stock->cell};
  for (int i = 0; i < 3; i++) {
    facts.box[0][i] = stock->origin[i];
    facts.box[1][i] = stock->origin[i] + (double)(stock->bricks[i] * BRICK) * stock->cell;
  }
  bool ok = sepax__stock_new(&f.done, SEPAX__STOCK_OUTER, facts.box, stock->cell, error) &&
            sepax__stock_mark(f.done, mesh, watch, marking, error) && add_marked(&f, error) &&
            flood_all(&f, mesh, error);
  sepax__stock_free(f.done);
  sepax_release(f.wave.item);
  sepax_release(f.next.item);
  return ok;
}
