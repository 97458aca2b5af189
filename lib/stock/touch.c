/* SPDX-License-Identifier: MIT */
/* touch.c - do shapes touch cells on a way?
 *
 * A piece is free if the sweep of the shape, made larger by the deviation and the tolerance, is
 * proved to miss every cell that is there: then no point of the shape is in a cell at any time of
 * the piece. Otherwise the piece is divided, until the deviation is small beside a cell. */
#include "stock/walk.h"

#include "util/error.h"

#include <math.h>
#include <string.h>

typedef struct {
  const sepax__stock *s;
  const sepax__stock_shape *shape; /* of the caller */
  sepax__stock_shape shrunk;
  size_t shapes;
  double shrink, tolerance, extent;
  bool all;  /* go on after the first cell */
  bool last; /* of the piece */
  sweep made;
  sepax__stock_touch *found;
  sepax_error *error;
  bool failed;
} search;

static void enclose_cells(search *c, const size_t at[3], int y, int z, unsigned cells) {
  for (int x = 0; x < BRICK; x++) {
    const int in[3] = {x, y, z};
    for (int i = 0; i < 3 && (cells >> x & 1) != 0; i++) {
      double low = c->s->origin[i] + (double)(at[i] * BRICK + (size_t)in[i]) * c->s->cell;
      c->found->box[0][i] = fmin(c->found->box[0][i], low);
      c->found->box[1][i] = fmax(c->found->box[1][i], low + c->s->cell);
    }
  }
}

static bool test_row(search *c, const size_t at[3], int y, int z, unsigned there) {
  const double in[3] = {0.5, y + 0.5, z + 0.5};
  double p[3];
  for (int i = 0; i < 3; i++) {
    p[i] = c->s->origin[i] + ((double)(at[i] * BRICK) + in[i]) * c->s->cell;
  }
  sweep_row row = row_of(&c->made, p, c->s->cell);
  unsigned missed = sepax__row_mask(&c->made, &row, there, c->s->cell / 2, c->s->cell, false);
  unsigned touched = there & ~missed;
  if (touched == 0) {
    return true;
  }
  c->found->free = false;
  if (c->last) {
    enclose_cells(c, at, y, z, touched);
  }
  return c->last && c->all;
}

static bool test_brick(void *context, const size_t at[3]) {
  search *c = context;
  uint64_t layer[BRICK];
  sepax__brick_get(c->s, at, layer);
  for (int z = 0; z < BRICK; z++) {
    for (int y = 0; y < BRICK; y++) {
      unsigned there = layer[z] >> (BRICK * y) & 0xff;
      if (there != 0 && !test_row(c, at, y, z, there)) {
        return false;
      }
    }
  }
  return true;
}

/* A piece that touches is divided; the last verdict stands. */
static bool test_piece(void *context, const sepax__stock_piece *piece, bool last) {
  search *c = context;
  if (c->failed || (!c->found->free && !c->all)) {
    return true;
  }
  bool before = c->found->free;
  c->found->free = true;
  c->last = last;
  for (size_t n = 0; n < c->shapes && !c->failed && (c->found->free || (last && c->all)); n++) {
    c->shrunk = c->shape[n];
    sepax__stock_shape_shrink(&c->shrunk, c->shrink);
    c->failed = !sepax__sweep_make(&c->made, &c->shrunk, piece, c->tolerance + piece->deviation, 1,
                                   c->extent, 0x1p-8 * c->s->cell, c->error);
    if (!c->failed) {
      sepax__stock_walk(c->s, &c->made, false, test_brick, c);
    }
  }
  bool touched = !c->found->free;
  c->found->free = before && (!touched || !last);
  return !touched;
}

static bool arguments_are_valid(const search *c, sepax_error *error) {
  if (c->s->bound != SEPAX__STOCK_OUTER) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "only an outer bound proves that a way is free");
  }
  if (!isfinite(c->tolerance) || c->tolerance < 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "the tolerance of a way must be 0 or more");
  }
  for (size_t n = 0; n < c->shapes; n++) {
    if (!(c->shrink >= 0) || !(c->shrink < c->shape[n].radius / 2)) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "a depth of %g says nothing of a tool of radius %g: it must be below half "
                        "of the radius; take smaller cells",
                        c->shrink, c->shape[n].radius);
    }
  }
  return true;
}

bool sepax__stock_test(const sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                       const sepax__stock_way *way, double shrink, double tolerance, bool all,
                       sepax__stock_touch *found, sepax_error *error) {
  *found = (sepax__stock_touch){
      true, {{INFINITY, INFINITY, INFINITY}, {-INFINITY, -INFINITY, -INFINITY}}};
  search c = {.s = stock,
              .shape = shape,
              .shapes = shapes,
              .shrink = shrink,
              .tolerance = tolerance,
              .all = all,
              .extent = sepax__stock_extent(stock),
              .found = found,
              .error = error};
  c.failed = !arguments_are_valid(&c, error);
  if (!c.failed) {
    sepax__stock_pieces(way, sepax__stock_fine(stock, tolerance), test_piece, &c);
  }
  if (found->free || c.failed) {
    memset(found->box, 0, sizeof found->box);
    found->free = !c.failed;
  }
  return !c.failed;
}

bool sepax__stock_depth(const sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                        const sepax__stock_way *way, double tolerance, double depth[2],
                        sepax_error *error) {
  double most = INFINITY;
  for (size_t n = 0; n < shapes; n++) {
    most = fmin(most, shape[n].radius / 2 * (1 - 0x1p-40));
  }
  depth[0] = -1;
  depth[1] = INFINITY;
  double at = 0;
  for (;;) {
    sepax__stock_touch found;
    if (!sepax__stock_test(stock, shape, shapes, way, at, tolerance, false, &found, error)) {
      return false;
    }
    depth[found.free ? 1 : 0] = at;
    if (depth[1] == 0 || depth[0] == most || depth[1] - depth[0] <= stock->cell / 4) {
      return true;
    }
    at = depth[1] == INFINITY ? fmin(most, fmax(2 * at, stock->cell)) : depth[0] / 2 + depth[1] / 2;
  }
}

/* ---------------------------------------------------------------- collisions */

typedef struct {
  search c;
  bool *hit;
  double *at;
} hitting;

/* A cell of the inner bound whose middle is in the sweep of the shape as it certainly is. */
static bool hit_brick(void *context, const size_t at[3]) {
  hitting *h = context;
  const sepax__stock *s = h->c.s;
  uint64_t layer[BRICK];
  sepax__brick_get(s, at, layer);
  for (int n = 0; n < BRICK_CELLS; n++) {
    const int in[3] = {n % BRICK, n / BRICK % BRICK, n / (BRICK * BRICK)};
    if (layer[in[2]] >> (BRICK * in[1] + in[0]) & 1) {
      double q[3];
      double reach;
      double p[3];
      for (int i = 0; i < 3; i++) {
        p[i] = s->origin[i] + ((double)(at[i] * BRICK + (size_t)in[i]) + 0.5) * s->cell;
      }
      sweep_point(&h->c.made, p, q);
      if (sepax__sweep_locate(&h->c.made, q, 0, &reach) == SWEEP_INSIDE) {
        *h->hit = true;
        memcpy(h->at, p, sizeof p);
        return false;
      }
    }
  }
  return true;
}

static bool hit_piece(void *context, const sepax__stock_piece *piece, bool last) {
  hitting *h = context;
  for (size_t n = 0; n < h->c.shapes && !h->c.failed && !*h->hit; n++) {
    h->c.failed =
        !sepax__sweep_make(&h->c.made, &h->c.shape[n], piece, -(h->c.tolerance + piece->deviation),
                           -1, h->c.extent, 0x1p-8 * h->c.s->cell, h->c.error);
    if (!h->c.failed) {
      sepax__stock_walk(h->c.s, &h->c.made, false, hit_brick, h);
    }
  }
  return h->c.failed || *h->hit || last;
}

bool sepax__stock_hit(const sepax__stock *stock, const sepax__stock_shape *shape, size_t shapes,
                      const sepax__stock_way *way, double tolerance, bool *hit, double at[3],
                      sepax_error *error) {
  hitting h = {.c = {.s = stock,
                     .shape = shape,
                     .shapes = shapes,
                     .tolerance = tolerance,
                     .extent = sepax__stock_extent(stock),
                     .error = error},
               .hit = hit,
               .at = at};
  *hit = false;
  if (stock->bound != SEPAX__STOCK_INNER) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "only an inner bound proves a collision");
  }
  if (!isfinite(tolerance) || tolerance < 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT, "the tolerance of a way must be 0 or more");
  }
  sepax__stock_pieces(way, sepax__stock_fine(stock, tolerance), hit_piece, &h);
  return !h.c.failed;
}
