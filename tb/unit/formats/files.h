/* SPDX-License-Identifier: MIT */
/* files.h - small files of text in the scratch folder. */
#ifndef FILES_H
#define FILES_H

#include "formats/formats.h"
#include "harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The path of a file of the scratch folder; the text of two calls ago is overwritten. */
static inline const char *in_folder(const char *name) {
  static char paths[2][PATH_BYTES];
  static int turn;
  turn = 1 - turn;
  snprintf(paths[turn], sizeof paths[turn], "%s/%s", folder, name);
  return paths[turn];
}

static inline const char *put_bytes(const char *name, const char *text, size_t size) {
  const char *at = in_folder(name);
  FILE *out = fopen(at, "wb");
  assert_non_null(out);
  assert_int_equal(fwrite(text, 1, size, out), size);
  assert_int_equal(fclose(out), 0);
  return at;
}

static inline const char *put_file(const char *name, const char *text) {
  return put_bytes(name, text, strlen(text));
}

#endif
