/* SPDX-License-Identifier: MIT */
/* cutter.h - parts of tools as convex solids of revolution, for the stock as it is cut. */
#ifndef SEPAX_PATH_CUTTER_H
#define SEPAX_PATH_CUTTER_H

#include "nc/tools.h"
#include "stock/stock.h"

/* A part of a tool is the union of these shapes, in metres, in the coordinates of the tool's link.
 * shape[n] of `outside` encloses a piece of it; `inside` lies within it. */
typedef struct {
  sepax__stock_shape *inside, *outside;
  size_t count;
} path_cutter;

/* The shapes of a part. Limits between parts and between shapes are `joined`: shrinking leaves
 * them. No point of a surface is farther than `error_most` from the true one, but inside of arcs
 * that bulge towards the axis. The tip of the flutes is not joined. */
bool path_cutter_make(path_cutter *cutter, const nc_turned_tool *tool, nc_tool_part part,
                      double error_most, sepax_error *error);
void path_cutter_free(path_cutter *cutter);

#endif
