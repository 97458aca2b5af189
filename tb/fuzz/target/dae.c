/* SPDX-License-Identifier: MIT */
/* dae.c - DAE files. */
#include "fuzz/mesh.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_mesh(data, size, "input.dae");
  return 0;
}
