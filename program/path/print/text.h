/* SPDX-License-Identifier: MIT */
/* text.h - what the parts of the text output share: text.c, text_scene.c (what was read) and
 * text_tools.c (tools and stock). */
#ifndef SEPAX_PATH_TEXT_H
#define SEPAX_PATH_TEXT_H

#include "path/common/parts.h"

enum { PATH_WIDTH = 7 };

double path_mm(double length);

/* "line 17 (0.1 s)", or "part.ngc:127, rapid, line 17 (0.1 s)"; `pair`: whose motion in that line
 * is meant, or NULL. */
void path_print_line(const path_scene *scene, const path_pair *pair, size_t line);

/* "; least clearance ... mm in line 17, from ... to ..." */
void path_print_least(const path_scene *scene, const path_pair *pair);

/* The files, bodies, tools, pairs and the path. */
void path_print_scene(const path_scene *scene, const path_question *q);

/* The flutes shrunk by --gouge, and the finished part. */
bool path_is_core(const path_scene *scene, const path_pair *pair);

/* A pair that the stock as it is cut decides: what follows its name. */
void path_print_stock_pair(const path_scene *scene, const path_pair *pair);

/* Free pairs of a tool share a row, because there are many. */
bool path_is_in_summary(const path_scene *scene, const path_pair *pair);
void path_print_tool(const path_scene *scene, size_t tool, int width);

/* What is left of the stock; violations by the lines of the program, the worst first. */
void path_print_feeds(const path_scene *scene); /* tools that cut nothing */
void path_print_stock(const path_scene *scene);
void path_print_violations(const path_scene *scene);

#endif
