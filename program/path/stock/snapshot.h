/* SPDX-License-Identifier: MIT */
/* snapshot.h - pictures of the stock as it is cut, for the page. */
#ifndef SEPAX_PATH_SNAPSHOT_H
#define SEPAX_PATH_SNAPSHOT_H

#include "path/common/parts.h"
#include "stock/stock.h"

/* Is a picture due before the motion that ends in a line? */
bool path_snapshot_due(const path_scene *scene, size_t line);

/* Take a picture: the surface of the stock in coarse cells. */
bool path_snapshot_take(path_scene *scene, const sepax__stock *stock, size_t line,
                        sepax_error *error);

#endif
