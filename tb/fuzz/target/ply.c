/* SPDX-License-Identifier: MIT */
/* ply.c - PLY files. */
#include "fuzz/mesh.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_mesh(data, size, "input.ply");
  return 0;
}
