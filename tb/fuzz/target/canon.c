/* SPDX-License-Identifier: MIT */
/* canon.c - canonical motion of an NC program, and its rows. */
#include "fuzz/fuzz.h"
#include "nc/nc.h"

#include <math.h>

static void require_sound(const nc_motion *m) {
  REQUIRE(m->rows > 0 && m->joints == m->program.joints);
  REQUIRE(m->row[0].begins == NC_FIRST);
  for (size_t n = 0; n < m->rows * m->joints; n++) {
    REQUIRE(isfinite(m->value[n]));
    REQUIRE(m->deviation[n] >= 0 && isfinite(m->deviation[n]));
    REQUIRE(m->blending[n] >= 0 && isfinite(m->blending[n]));
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static const nc_rules rules = {.linear = 1e-3, .angular = 1e-3, .ignore_limits = true};
  nc_motion motion;
  sepax_error error = {0};
  FILE *in = tmpfile();
  REQUIRE(in != NULL && fwrite(data, 1, size, in) == size);
  rewind(in);
  if (fuzz_answer(nc_motion_read(&motion, in, "input", &rules, &error), &error)) {
    require_sound(&motion);
    nc_motion_free(&motion);
  }
  fclose(in);
  return 0;
}
