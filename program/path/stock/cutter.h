/* SPDX-License-Identifier: MIT */
/* cutter.h - parts of tools as convex solids of revolution, for the stock as it is cut. */
#ifndef SEPAX_PATH_CUTTER_H
#define SEPAX_PATH_CUTTER_H

#include "nc/tools.h"
#include "stock/stock.h"

/* The shapes of a part of a tool, in metres, in the coordinates of the tool's link. The part lies
 * in the union of `outside`, and the union of `inside` lies in the part. */
typedef struct {
  sepax__stock_shapes inside, outside;
} path_cutter;

/* Shrinking leaves the faces between parts of a tool. Arcs are exact to `error_most`. */
bool path_cutter_make(path_cutter *cutter, const nc_turned_tool *tool, nc_tool_part part,
                      double error_most, sepax_error *error);
void path_cutter_free(path_cutter *cutter);

#endif
