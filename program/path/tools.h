/* SPDX-License-Identifier: MIT */
/* tools.h - the tools of a program as bodies on one link. */
#ifndef SEPAX_PATH_TOOLS_H
#define SEPAX_PATH_TOOLS_H

#include "path/common/parts.h"

/* Find the link of the tools, and read the tools that the path names. The path is there. */
bool path_tools_read(path_scene *scene, const path_question *q, sepax_error *error);

/* Make bodies of the flutes, shank and holder of each tool, behind the bodies of links. */
bool path_tools_bodies(path_scene *scene, const path_question *q, sepax_error *error);

#endif
