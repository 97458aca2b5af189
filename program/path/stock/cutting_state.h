/* SPDX-License-Identifier: MIT */
/* cutting_state.h - what the files share that follow the stock as it is cut. */
#ifndef SEPAX_PATH_CUTTING_STATE_H
#define SEPAX_PATH_CUTTING_STATE_H

#include "path/stock/cutter.h"
#include "path/common/parts.h"

typedef struct {
  path_scene *scene;
  const path_question *q;
  path_pair *of[NC_TOOL_PARTS]; /* pairs of the tool at hand; NULL: it has no such part */
  path_cutter *cutter;          /* of all bodies */
  sepax__stock *outer, *inner;
  sepax__stock_joints joints;
  double *value; /* memory of `joints`, and of the ends of a part of a motion */
  size_t line;   /* the motion ends in this line */
  bool alone;    /* no motion ends or begins in the line; its pose is tested */
  /* Of the part of a tool at hand: what was found, and how deep it is. */
  report_verdict found;
  double depth[2];
  size_t looks; /* closer looks that were taken */
  /* What is left as a body, for bodies that are no part of a tool. */
  path_body left;
  bool nothing_left; /* it has no cell */
  bool stale;        /* material was cut since it was made */
  size_t made;       /* how often it was made */
} path_cutting;

/* What is there before the first motion: cutters of all bodies, both bounds of the stock, and
 * memory. Fails also if the depth is too large for a tool, or a file does not suit. */
bool path_cutting_fill(path_cutting *c, sepax_error *error);

/* Find the pairs of the tool of the motion at hand; false if it has none. */
bool path_cutting_find_pairs(path_cutting *c);

/* The way from the part `from` of the motion at hand to `to`, of the tool of a pair. It is in `c`
 * until the next call. */
sepax__stock_way path_cutting_way(path_cutting *c, const path_pair *pair, double from, double to);

/* Does the motion at hand remove material? */
bool path_cutting_cuts(const path_cutting *c);

/* How far the tool may be from the linear motion of the joints, in metres. */
double path_cutting_tolerance(const path_cutting *c);

static inline const path_cutter *path_cutting_cutter(const path_cutting *c, const path_pair *pair) {
  return &c->cutter[pair->body[0]];
}

/* Does a closer look, with cells of a quarter of the side around what was touched, prove that the
 * tool of a pair is free between two parts of the motion at hand? It heals seams: walls of cells
 * between two cuts that overlap by less than a cell. *is_free stays as it is if there were too many
 * looks, or what is looked at is too large. Cost: all cuts of the path so far, near that place. */
bool path_cutting_look_closer(path_cutting *c, path_pair *pair, double from, double to,
                              double shrink, double tolerance, bool *is_free, sepax_error *error);

/* Is a body outside of the stock's mesh, and does it stay away from it on the whole motion at hand?
 */
bool path_cutting_is_outside(path_cutting *c, const path_pair *pair, bool *outside,
                             sepax_error *error);

/* Decide the pairs of the stock and bodies that are no part of a tool, in the motion at hand:
 * before it cuts, whether they are free; after it, whether those that are not meet material. At the
 * end the stock decides each pair that was not free of its first mesh. */
bool path_cutting_others(path_cutting *c, sepax_error *error);
void path_cutting_others_meet(path_cutting *c);
void path_cutting_end_others(path_cutting *c);

/* Write what is left, as --left says. */
bool path_cutting_write_left(const path_cutting *c, sepax_error *error);

#endif
