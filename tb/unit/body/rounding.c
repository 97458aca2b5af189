/* SPDX-License-Identifier: MIT */
/* rounding.c - the oriented boxes of body/fit.c as gcc compiles them with -O3: a small triangle is
 * in its box as the box is stored. gcc 12 has taken the axes before they were rounded to floats,
 * and the centre where it inlines less (rounding_called.c). */
#if !defined(__clang__) && !defined(OTHER_OPTIONS)
#pragma GCC optimize("O3")
#endif
#define sepax__body_fit body_fit_of_test
#include "body/fit.c" /* NOLINT(bugprone-suspicious-include): compiled once more */

#include "harness.h"

CASE(triangles_are_in_boxes_as_stored) {
  for (int n = 0; n < 1000; n++) {
    facet_points v[1];
    oriented r;
    for (int k = 0; k < 9; k++) {
      v[0][k / 3][k % 3] = 0.9 + 1e-8 * random_unit();
    }
    fit_triangle(v, &r);
    for (int k = 0; k < 9; k++) {
      double along = 0;
      for (int i = 0; i < 3; i++) {
        along += (double)r.axis[k / 3][i] * (v[0][k % 3][i] - (double)r.centre[i]);
      }
      assert_true(fabs(along) <= (double)r.half[k / 3] + 0x1p-50);
    }
  }
}
