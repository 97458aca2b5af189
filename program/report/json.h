/* json.h - what commands print as JSON. */
#ifndef SEPAX_REPORT_JSON_H
#define SEPAX_REPORT_JSON_H

#include "sepax_grid.h"

#include <jansson.h>

/* {"a": ..., "b": ..., "grid": ...} of two STL files, whose unit is 1 mm; a new reference. */
json_t *report_scene(const char *const path[2], const size_t count[2], const sepax_grid *grid);

void report_set_count(json_t *to, const char *key, size_t count);

/* Print with 17 digits, and release. */
void report_print_json(json_t *report);

/* JSON is UTF-8. Fails if the name of a file is not. */
bool report_names_printable(const char *const path[2], sepax_error *error);

#endif
