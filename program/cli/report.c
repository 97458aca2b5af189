/* report.c - what check and size print of a scene, as text and as JSON. */
#include "cli/report.h"

#include "util/error.h"

#include <stdlib.h>

/* A double is told from its neighbours by 17 digits, many by fewer. */
enum { DIGITS_FEWEST = 9, DIGITS_ALL = 17 };

report_number report_exactly(double value) {
  report_number number;
  int digits = DIGITS_FEWEST;
  do {
    snprintf(number.text, sizeof number.text, "%.*g", digits, value);
  } while (strtod(number.text, NULL) != value && ++digits <= DIGITS_ALL);
  return number;
}

void report_print_file(char object, int width, const char *path, size_t triangles) {
  printf("%-*c%s, %zu triangles\n", width, object, path, triangles);
}

void report_print_grid(int width, const sepax_grid *grid) {
  printf("%-*sW = %d, 1 LSB = %s, origin %s,%s,%s\n", width, "grid", grid->word,
         report_exactly(grid->resolution).text, report_exactly(grid->offset[0]).text,
         report_exactly(grid->offset[1]).text, report_exactly(grid->offset[2]).text);
}

json_t *report_scene(const char *const path[2], const size_t count[2], const sepax_grid *grid) {
  return json_pack("{s:{s:s, s:I}, s:{s:s, s:I}, s:{s:i, s:f, s:[f, f, f]}}", "a", "file", path[0],
                   "triangles", (json_int_t)count[0], "b", "file", path[1], "triangles",
                   (json_int_t)count[1], "grid", "word", grid->word, "resolution", grid->resolution,
                   "origin", grid->offset[0], grid->offset[1], grid->offset[2]);
}

void report_print_json(json_t *report) {
  json_dumpf(report, stdout, JSON_INDENT(1) | JSON_REAL_PRECISION(DIGITS_ALL));
  putchar('\n');
  json_decref(report);
}

bool report_names_printable(const char *const path[2], sepax_error *error) {
  for (int i = 0; i < 2; i++) {
    json_t *name = json_string(path[i]);
    json_decref(name);
    if (name == NULL) {
      return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                        "%.300s: the name is not UTF-8; rename the file", path[i]);
    }
  }
  return true;
}
