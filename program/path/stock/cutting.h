/* SPDX-License-Identifier: MIT */
/* cutting.h - the stock as it is cut: pairs of parts of tools and the stock are decided motion by
 * motion, against what the motions before have left. */
#ifndef SEPAX_PATH_CUTTING_H
#define SEPAX_PATH_CUTTING_H

#include "path/common/parts.h"

/* Mark the pairs that the stock as it is cut decides, and choose the size of cells and the depth.
 * Needs --stock and --tools. */
bool path_cutting_begin(path_scene *scene, const path_question *q, sepax_error *error);

/* Go along the path, test and cut. Fills in the verdicts of the marked pairs. */
bool path_cutting_run(path_scene *scene, const path_question *q, sepax_error *error);

#endif
