/* SPDX-License-Identifier: MIT */
/* fuzz.h - what the fuzz targets share. A target reads any bytes as what it is named after; it must
 * neither crash nor leak, and what it accepts must be what the headers say. */
#ifndef FUZZ_H
#define FUZZ_H

#include "sepax_models.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Ends the run as a finding. */
#define REQUIRE(condition)                                                    \
  do {                                                                        \
    if (!(condition)) {                                                       \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      abort();                                                                \
    }                                                                         \
  } while (0)

/* The reader accepts the input, without a message, or refuses it in one line. Gives `ok`. */
bool fuzz_answer(bool ok, const sepax_error *error);
extern size_t fuzz_accepted;

/* These bytes as a file of the current folder. */
void fuzz_file(const char *name, const uint8_t *data, size_t size);

#endif
