/* SPDX-License-Identifier: MIT */
/* stl.c - STL files, text and binary, by the reader of meshes and by that of libsepax; what this
 * reads can be written and read again. */
#include "fuzz/mesh.h"

#include <math.h>
#include <string.h>

static void require_finite(const sepax_soup *mesh) {
  REQUIRE(mesh->count > 0);
  for (size_t n = 0; n < mesh->count; n++) {
    for (int k = 0; k < 3; k++) {
      REQUIRE(isfinite(mesh->normal[n][k]));
      for (int i = 0; i < 3; i++) {
        REQUIRE(isfinite(mesh->facet[n].v[k][i]));
      }
    }
  }
}

static void require_again(const sepax_soup *mesh) {
  sepax_soup again;
  sepax_error error = {0};
  REQUIRE(sepax_stl_write(mesh, "again.stl", true, &error));
  REQUIRE(sepax_stl_read(&again, "again.stl", true, &error));
  REQUIRE(again.count == mesh->count);
  for (size_t n = 0; n < mesh->count; n++) {
    for (int k = 0; k < 3; k++) {
      for (int i = 0; i < 3; i++) {
        REQUIRE(again.facet[n].v[k][i] == mesh->facet[n].v[k][i]);
      }
    }
  }
  sepax_soup_free(&again);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  fuzz_mesh(data, size, "input.stl");
  if (size % 4 != 0) { /* files are slow */
    return 0;
  }
  sepax_soup mesh;
  sepax_error error = {0};
  fuzz_file("input.stl", data, size);
  bool ok = fuzz_answer(sepax_stl_read(&mesh, "input.stl", true, &error), &error);
  if (ok) {
    require_finite(&mesh);
    if (size % 16 == 0) {
      require_again(&mesh);
    }
    sepax_soup_free(&mesh);
  }
  return 0;
}
