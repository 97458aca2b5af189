/* SPDX-License-Identifier: MIT */
/* cutting_first.c - before the stock is cut: the size of its cells, and what is there. */
#include "path/stock/cutting.h"
#include "path/stock/cutting_state.h"
#include "util/error.h"
#include "util/vector.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS_MOST = 1500, BRICKS_MOST = 1 << 28 };

/* Arcs of profiles are polygons that are no farther from them than this part of a cell. */
static const double arc_error = 0x1p-8;

/* ------------------------------------------------------------------------- choices */

/* A tenth of the smallest radius, or 0.2 mm; but no more than CELLS_MOST cells along the stock, as
 * long as the default depth suits the tool. */
static double default_cell(const path_body *stock, double radius) {
  double longest = 0;
  for (int i = 0; i < 3; i++) {
    longest = fmax(longest, stock->most[i] - stock->least[i]);
  }
  double cell = fmin(2e-4, radius / 10);
  return fmin(fmax(cell, longest / CELLS_MOST), radius / 5);
}

/* Say so before the stock is filled if that takes a minute or more, or a gigabyte: only the user
 * can tell whether it is worth it. About 0.2 microseconds and 12 bytes go to a brick of 8 x 8 x 8
 * cells, and 12 microseconds and 300 bytes to one at the surface. `least`: of the radii of the
 * tools. */
static bool announce(const path_scene *scene, double least, sepax_error *error) {
  const path_body *b = &scene->body[scene->stock.body];
  double cell = scene->stock.cell;
  double bricks = 1;
  double border = 0;
  for (int i = 0; i < 3; i++) {
    bricks *= ceil((b->most[i] - b->least[i]) / (8 * cell));
  }
  for (size_t n = 0; n < b->mesh.count; n++) {
    const double(*v)[3] = (const double(*)[3])b->mesh.facet[n].v;
    double to[2][3];
    double normal[3];
    for (int i = 0; i < 3; i++) {
      to[0][i] = v[1][i] - v[0][i];
      to[1][i] = v[2][i] - v[0][i];
    }
    vector_cross(to[0], to[1], normal);
    border += vector_length(normal) / 2 / (64 * cell * cell);
  }
  if (bricks > BRICKS_MOST) {
    return sepax_fail(
        error, SEPAX_ERROR_LIMIT,
        "cells: the stock has %.2g cells of %.6g mm, more than %.2g; give --cells=%.2gmm, "
        "or a smaller stock",
        512 * bricks, cell * 1e3, 512.0 * BRICKS_MOST,
        1.1 * cell * cbrt(bricks / BRICKS_MOST) * 1e3);
  }
  double seconds = 2e-7 * bricks + 1.2e-5 * border;
  double bytes = 12 * bricks + 300 * border;
  if (seconds < 60 && bytes < 1e9) {
    return true;
  }
  fprintf(stderr,
          "sepax path: stock: %.2g cells of %.6g mm take about %.2g GB and %.0f s to fill; ",
          512 * bricks, cell * 1e3, bytes * 1e-9, seconds);
  if (cell < least / 8) {
    fprintf(stderr, "--cells=%.6gmm takes an eighth\n", 2 * cell * 1e3);
  } else {
    fprintf(stderr,
            "the smallest tool needs cells below %.6g mm, so only a smaller stock takes less\n",
            least / 4 * 1e3);
  }
  return true;
}

bool path_cutting_begin(path_scene *scene, const path_question *q, sepax_error *error) {
  double least = INFINITY;
  for (size_t n = 0; n < scene->pairs; n++) {
    path_pair *pair = &scene->pair[n];
    const path_body *tool = &scene->body[pair->body[0]];
    if (tool->role == NULL || strcmp(tool->role, "core") == 0 ||
        strcmp(path_body_name(scene, pair->body[1]), q->stock) != 0) {
      continue;
    }
    pair->by_cells = true;
    scene->stock.body = pair->body[1];
    if (tool->turned_part == NC_FLUTES) {
      least = fmin(least, tool->turned->diameter / 2 * 1e-3);
    }
  }
  if (isinf(least)) {
    return q->left == NULL ||
           sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "left: no tool with flutes is in the spindle on the path, so nothing of the "
                      "stock is cut; leave --left out");
  }
  path_stock *s = &scene->stock;
  s->cell = q->cell.length > 0 ? q->cell.length : default_cell(&scene->body[s->body], least);
  s->depth = q->depth.text != NULL ? q->depth.length : 2 * s->cell;
  if (!(s->depth < least / 2)) {
    return sepax_fail(
        error, SEPAX_ERROR_ARGUMENT,
        "depth: %.6g mm, with cells of %.6g mm, is half of the radius of the smallest tool, %.6g "
        "mm, or more, so nothing would be proved; give smaller --cells or a smaller --depth",
        s->depth * 1e3, s->cell * 1e3, least * 1e3);
  }
  return q->first != NULL || announce(scene, least, error);
}

/* ----------------------------------------------------------------------- the stock */

/* What an earlier program has left. Nothing of it is certainly material. */
static bool read_first(path_cutting *c, sepax_error *error) {
  path_stock *s = &c->scene->stock;
  if (!sepax__stock_read(&c->outer, c->q->first, error)) {
    return false;
  }
  sepax__stock_facts facts = sepax__stock_look(c->outer);
  if (facts.bound != SEPAX__STOCK_OUTER || fabs(facts.cell - s->cell) > 1e-9 * s->cell) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "%.300s: has cells of %.9g mm, not of %.9g mm; give --cells=%.9gmm",
                      c->q->first, facts.cell * 1e3, s->cell * 1e3, facts.cell * 1e3);
  }
  s->cell = facts.cell;
  return true;
}

typedef struct {
  cli_progress progress;
  uint64_t before; /* of PERMILLE, this bound */
} filling;

enum { PERMILLE = 1000 };

static void show(void *context, double share) {
  filling *f = context;
  cli_progress_show(&f->progress, f->before + (uint64_t)(share * PERMILLE / 2));
}

static bool fill(path_cutting *c, filling *f, sepax__stock **stock, sepax__stock_bound bound,
                 sepax_error *error) {
  const path_body *b = &c->scene->body[c->scene->stock.body];
  const sepax__stock_watch watch = {show, f};
  double box[2][3];
  memcpy(box[0], b->least, sizeof box[0]);
  memcpy(box[1], b->most, sizeof box[1]);
  f->before = bound == SEPAX__STOCK_OUTER ? 0 : PERMILLE / 2;
  return sepax__stock_new(stock, bound, box, c->scene->stock.cell, error) &&
         sepax__stock_fill_mesh(*stock, &b->mesh, &watch, error);
}

/* Flutes and shanks must be thicker than four times the depth. */
static bool suits_depth(const path_cutting *c, size_t body, sepax_error *error) {
  const path_body *b = &c->scene->body[body];
  const sepax__stock_shapes *shapes = &c->cutter[body].outside;
  double depth = c->scene->stock.depth;
  for (size_t n = 0; n < shapes->count && b->turned_part != NC_HOLDER; n++) {
    if (!(depth < shapes->shape[n].radius / 2)) {
      return sepax_fail(
          error, SEPAX_ERROR_ARGUMENT,
          "depth: %.6g mm is half of the radius of %.60s, %.6g mm, or more, so nothing "
          "would be proved; give smaller --cells or a smaller --depth",
          depth * 1e3, path_body_name(c->scene, body), shapes->shape[n].radius * 1e3);
    }
  }
  return true;
}

bool path_cutting_fill(path_cutting *c, sepax_error *error) {
  path_scene *scene = c->scene;
  size_t joints = scene->motion.joints + 1;
  c->value = calloc(5 * joints, sizeof *c->value);
  c->cutter = calloc(scene->bodies, sizeof *c->cutter);
  if (c->value == NULL || c->cutter == NULL) {
    sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the stock");
    return false;
  }
  for (int k = 0; k < 3; k++) {
    c->joints.value[k] = c->value + (size_t)k * joints;
  }
  c->joints.mechanism = &scene->robot.mechanism;
  c->joints.mount = (sepax_pose){{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
  const path_body *stock = &scene->body[scene->stock.body];
  if (stock->open > 0) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "stock: the mesh of %.60s has holes; give a closed mesh",
                      path_body_name(scene, scene->stock.body));
  }
  for (size_t n = 0; n < scene->bodies; n++) {
    const path_body *b = &scene->body[n];
    if (b->role != NULL && (!path_cutter_make(&c->cutter[n], b->turned, b->turned_part,
                                              arc_error * scene->stock.cell, error) ||
                            !suits_depth(c, n, error))) {
      return false;
    }
  }
  if (c->q->first != NULL) {
    return read_first(c, error);
  }
  filling f = {.progress = cli_progress_begin("thousandths of the stock filled", PERMILLE)};
  bool ok = fill(c, &f, &c->outer, SEPAX__STOCK_OUTER, error) &&
            fill(c, &f, &c->inner, SEPAX__STOCK_INNER, error);
  scene->stock.seconds = cli_progress_end(&f.progress);
  return ok;
}
