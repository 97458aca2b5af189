/* SPDX-License-Identifier: MIT */
/* fuzz.c - what the fuzz targets share. */
#include "fuzz/fuzz.h"

#include <stdio.h>
#include <string.h>

size_t fuzz_accepted;

bool fuzz_answer(bool ok, const sepax_error *error) {
  REQUIRE(ok == (error->text[0] == '\0') && ok == (error->code == SEPAX_OK));
  REQUIRE(strchr(error->text, '\n') == NULL);
  fuzz_accepted += ok;
  return ok;
}

void fuzz_file(const char *name, const uint8_t *data, size_t size) {
  FILE *out = fopen(name, "wb");
  REQUIRE(out != NULL);
  REQUIRE(fwrite(data, 1, size, out) == size);
  REQUIRE(fclose(out) == 0);
}
