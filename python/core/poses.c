/* SPDX-License-Identifier: MIT */
/* poses.c - matrices of Python as poses. */
#include "core.h"
#include "util/error.h"

#include <string.h>

static bool is(double x, int whole) { return x >= whole && x <= whole; }

bool core_pose(const core_poses *poses, size_t n, sepax_pose *to, const sepax_pose **pose,
               sepax_error *error) {
  *pose = NULL;
  if (poses->matrix == NULL) {
    return true;
  }
  double m[16];
  memcpy(m, poses->matrix[poses->count == 1 ? 0 : n], sizeof m);
  if (!is(m[12], 0) || !is(m[13], 0) || !is(m[14], 0) || !is(m[15], 1)) {
    return sepax_fail(error, SEPAX_ERROR_ARGUMENT,
                      "the last row of the matrix is %g %g %g %g, not 0 0 0 1; the translation "
                      "is its last column: transpose it if it is a row",
                      m[12], m[13], m[14], m[15]);
  }
  for (int i = 0; i < 3; i++) {
    memcpy(to->rotation[i], m + 4 * i, sizeof to->rotation[i]);
    to->translation[i] = m[4 * i + 3];
  }
  *pose = to;
  return sepax_pose_valid(to, error);
}
