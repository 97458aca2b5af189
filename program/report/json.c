/* SPDX-License-Identifier: MIT */
/* json.c - what commands print as JSON. */
#include "report/json.h"
#include "util/error.h"

#include <stdio.h>

void report_set_count(json_t *to, const char *key, size_t count) {
  json_object_set_new(to, key, json_integer((json_int_t)count));
}

json_t *report_scene(const char *const path[2], const size_t count[2], const sepax_grid *grid) {
  return json_pack("{s:{s:s, s:I}, s:{s:s, s:I}, s:{s:i, s:f, s:[f, f, f]}}", "a", "file", path[0],
                   "triangles", (json_int_t)count[0], "b", "file", path[1], "triangles",
                   (json_int_t)count[1], "grid", "word", grid->word, "lsb_mm", grid->resolution,
                   "origin_mm", grid->offset[0], grid->offset[1], grid->offset[2]);
}

void report_print_json(json_t *report) {
  enum { DIGITS_ALL = 17 }; /* enough digits to tell a double from its neighbours */
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
