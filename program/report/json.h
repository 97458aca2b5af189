/* SPDX-License-Identifier: MIT */
/* json.h - what commands print as JSON. */
#ifndef SEPAX_REPORT_JSON_H
#define SEPAX_REPORT_JSON_H

#include "sepax_grid.h"

#include <jansson.h>

/* A new object {"a": ..., "b": ..., "grid": ...} about two mesh files, whose lengths are in mm. */
json_t *report_scene(const char *const path[2], const size_t count[2], const sepax_grid *grid);

void report_set_count(json_t *to, const char *key, size_t count);

/* Print the report with 17 digits, and release it. */
void report_print_json(json_t *report);

/* Fails if the name of a file is not UTF-8, because JSON must be. */
bool report_names_printable(const char *const path[2], sepax_error *error);

#endif
