/* SPDX-License-Identifier: MIT */
/* poses.c - text files of poses. */
#include "fuzz/fuzz.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  sepax_poses poses;
  sepax_error error = {0};
  fuzz_file("input.txt", data, size);
  bool ok = fuzz_answer(sepax_poses_read(&poses, "input.txt", &error), &error);
  if (ok) {
    REQUIRE(poses.count > 0);
    for (size_t n = 0; n < poses.count; n++) {
      REQUIRE(sepax_pose_valid(&poses.pose[n], &error));
    }
    sepax_poses_free(&poses);
  }
  return 0;
}
