/* report.h - what check and size print of a scene, as text and as JSON. */
#ifndef SEPAX_REPORT_H
#define SEPAX_REPORT_H

#include "sepax_design.h"

#include <jansson.h>

/* The shortest decimals, 9 digits at least, that strtod reads back as the same value: a grid that
 * is printed and given again is the same grid. */
typedef struct {
  char text[32];
} report_number;
report_number report_exactly(double value);

/* Lines of text; the name at the left takes `width` characters. */
void report_print_file(char object, int width, const char *path, size_t triangles);
void report_print_grid(int width, const sepax_grid *grid);

/* {"a": ..., "b": ..., "grid": ...}; a new reference. */
json_t *report_scene(const char *const path[2], const size_t count[2], const sepax_grid *grid);

/* Print with 17 digits, and release. */
void report_print_json(json_t *report);

/* JSON is UTF-8. Fails if the name of a file is not. */
bool report_names_printable(const char *const path[2], sepax_error *error);

#endif
