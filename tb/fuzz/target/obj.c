/* SPDX-License-Identifier: MIT */
/* obj.c - OBJ files. */
#include "fuzz/mesh.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_mesh(data, size, "input.obj");
  return 0;
}
