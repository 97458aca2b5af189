/* SPDX-License-Identifier: MIT */
/* csv.c - paths of joints; the first byte chooses the rules. */
#include "fuzz/robot.h"

#include <math.h>

static void require_sound(const format_motion *motion, const sepax_mechanism *m, bool limits) {
  REQUIRE(motion->lines > 0 && motion->joints == m->joints);
  for (size_t n = 0; n < motion->lines; n++) {
    const double *value = motion->value + n * motion->joints;
    REQUIRE(n == 0 || motion->line[n] > motion->line[n - 1]);
    for (size_t j = 0; j < m->joints; j++) {
      REQUIRE(isfinite(value[j]));
      REQUIRE(!limits || (value[j] >= m->joint[j].lower && value[j] <= m->joint[j].upper));
    }
  }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
  static sepax_robot robot;
  if (robot.mechanism.links == 0) {
    read_robot(&robot);
  }
  if (size == 0) {
    return 0;
  }
  const format_motion_rules rules = {.hold = (data[0] & 1) != 0,
                                     .ignore_limits = (data[0] & 2) != 0};
  format_motion motion;
  sepax_error error = {0};
  fuzz_file("input.csv", data + 1, size - 1);
  bool ok = fuzz_answer(format_motion_read(&motion, &robot.mechanism, &rules, "input.csv", &error),
                        &error);
  if (ok) {
    require_sound(&motion, &robot.mechanism, !rules.ignore_limits);
    format_motion_free(&motion);
  }
  return 0;
}
