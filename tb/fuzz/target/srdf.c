/* SPDX-License-Identifier: MIT */
/* srdf.c - SRDF files. */
#include "fuzz/robot.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static sepax_robot robot;
  if (robot.mechanism.links == 0) {
    read_robot(&robot);
  }
  bool compared[16];
  sepax_error error = {0};
  REQUIRE(robot.mechanism.links == 4);
  memset(compared, 1, sizeof compared);
  fuzz_file("input.srdf", data, size);
  bool ok =
      fuzz_answer(sepax_srdf_read(compared, &robot.mechanism, NULL, "input.srdf", &error), &error);
  for (int n = 0; ok && n < 16; n++) {
    REQUIRE(compared[n] == compared[n % 4 * 4 + n / 4]);
  }
  return 0;
}
