/* SPDX-License-Identifier: MIT */
/* cutter.c - parts of tools as convex solids of revolution. */
#include "path/stock/cutter.h"
#include "util/error.h"

#include <stdlib.h>

bool path_cutter_make(path_cutter *cutter, const nc_turned_tool *tool, nc_tool_part part,
                      double error_most, sepax_error *error) {
  const turned_profile *profile = &tool->part[part];
  const bool joined[2] = {part != NC_FLUTES, true};
  turned_profile placed = {calloc(profile->points, sizeof *placed.point), profile->points};
  *cutter = (path_cutter){.inside = {0}};
  if (placed.point == NULL) {
    return sepax_fail(error, SEPAX_ERROR_MEMORY, "no memory for the shapes of tools");
  }
  for (size_t n = 0; n < profile->points; n++) { /* from mm above the tip to metres on the link */
    const turned_point *p = &profile->point[n];
    placed.point[n] = (turned_point){(p->z - tool->length) * 1e-3, p->r * 1e-3, p->bend * 1e-3};
  }
  bool ok = sepax__stock_shapes_make(&placed, joined, error_most, &cutter->inside, &cutter->outside,
                                     error);
  free(placed.point);
  return ok;
}

void path_cutter_free(path_cutter *cutter) {
  sepax__stock_shapes_free(&cutter->inside);
  sepax__stock_shapes_free(&cutter->outside);
}
