/* SPDX-License-Identifier: MIT */
/* groups.c - counts by groups of lanes, and what their spread says of the mean. */
#include "harness.h"
#include "power/gates.h"

#include <math.h>

CASE(lanes_by_groups) {
  gates_count count = {0};
  uint64_t expected[GATES_GROUPS] = {0};
  sepax_random random = {1};
  for (int round = 0; round < 1000; round++) {
    uint64_t lanes = sepax_random_next(&random);
    lanes = round == 0 ? 0 : round == 1 ? ~UINT64_C(0) : lanes;
    gates_tally(count, lanes);
    for (int l = 0; l < GATES_LANES; l++) {
      expected[l / (GATES_LANES / GATES_GROUPS)] += lanes >> l & 1;
    }
    assert_memory_equal(count, expected, sizeof expected);
  }
}

CASE(standard_error) {
  /* squares of 3, 1, 1, 1, 1, 0, 2, 3: 26; sqrt(26 / 7 / 8) = 0.681385 of a mean of 10 */
  const double eight[GATES_GROUPS] = {7, 9, 9, 9, 11, 10, 12, 13};
  const double same[GATES_GROUPS] = {3, 3, 3, 3, 3, 3, 3, 3};
  const double none[GATES_GROUPS] = {0};
  assert_true(fabs(gates_error(eight) - 0.0681385) < 1e-7);
  assert_true(gates_error(same) == 0);
  assert_true(gates_error(none) == 0);
}
