/* meshes.c - OBJ, PLY, 3MF and DAE files, which a process of its own reads; the first byte chooses
 * the format. */
#include "formats/formats.h"
#include "fuzz/fuzz.h"

#include <math.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const char *const name[] = {"input.obj", "input.ply", "input.3mf", "input.dae"};
  if (size == 0) {
    return 0;
  }
  const char *file = name[data[0] & 3];
  fuzz_file(file, data + 1, size - 1);
  sepax_soup mesh;
  sepax_error error = {0};
  bool ok = fuzz_answer(format_mesh_read(&mesh, file, &error), &error);
  if (ok) {
    REQUIRE(mesh.count > 0);
    for (size_t n = 0; n < 9 * mesh.count; n++) {
      REQUIRE(isfinite(mesh.facet[n / 9].v[n % 9 / 3][n % 3]));
    }
    sepax_soup_free(&mesh);
  }
  return 0;
}
