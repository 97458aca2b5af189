/* SPDX-License-Identifier: MIT */
/* slow_clocks.c - registers follow the clock: at a slower clock a design never has more latency,
 * flip-flops or gates, by its own counts; what is reached at the slowest; fast clocks chain
 * nothing.
 */
#include "exact/exact.h"
#include "harness.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { CONFIGURATIONS = FEWER(25) };

static exact_plan *plan;
static sepax_design design; /* of the plan */

/* Plan a design; false if its clock is too short. */
static bool plan_of(const char *options, exact_counts *counts) {
  design = design_of("%s", options);
  free(plan);
  plan = malloc(sizeof *plan);
  assert_non_null(plan);
  fault = (sepax_error){.code = SEPAX_OK};
  if (!exact_plan_make(plan, &design, &fault)) {
    assert_non_null(strstr(fault.text, "too short"));
    return false;
  }
  *counts = exact_count(plan);
  return true;
}

static const char *const targets[] = {"asic", "asic", "asic", "asic", "ice40",
                                      "ecp5", "xc7",  "xcup", "gowin"};
/* The last one is refused for an FPGA. */
static const char *const more[] = {"",
                                   "",
                                   " --coplanar=flag",
                                   " --clearance=2",
                                   " --clearance=1 --warning=5",
                                   " --early-out=boxes",
                                   " --lanes=2",
                                   " --stream=pair",
                                   " --registered-ready=on"};

/* Options but the clock. */
static void draw(char *text, size_t size) {
  int ii = random_below(2) == 0 ? 1 + 2 * random_below(2) : 1 + random_below(18);
  const char *target = targets[random_below(9)];
  const char *last = strcmp(target, "asic") != 0 ? ""
                     : random_below(6) == 0      ? " --clock-gating=on"
                     : random_below(6) == 0      ? " --corner=slow"
                                                 : "";
  snprintf(text, size, "--word=%d --ii=%d --target=%s%s%s", 5 + random_below(28), ii, target,
           more[random_below(strcmp(target, "asic") == 0 ? 9 : 8)], last);
}

/* Clocks from the fastest to the slowest, with steps of the user's and odd ones. */
CASE(never_more) {
  static const char *const clocks[] = {"2",   "2.05",  "2.5", "3",  "3.14", "4",   "4.7", "5",
                                       "5.9", "6",     "7.3", "8",  "9.9",  "10",  "12",  "15",
                                       "20",  "21.35", "30",  "50", "75",   "100", "1000"};
  int compared = 0;
  int smaller = 0;
  for (int n = 0; n < CONFIGURATIONS; n++) {
    char options[160];
    draw(options, sizeof options);
    exact_counts before = {0};
    for (size_t i = 0; i < sizeof clocks / sizeof clocks[0]; i++) {
      char whole[200];
      exact_counts now;
      snprintf(whole, sizeof whole, "%s --clock-ns=%s", options, clocks[i]);
      if (!plan_of(whole, &now)) {
        assert_int_equal(before.latency,
                         0); /* a slower clock is not refused where a faster is not */
        continue;
      }
      if (before.latency > 0) {
        compared++;
        smaller += now.flip_flops < before.flip_flops;
        if (now.latency > before.latency || now.flip_flops > before.flip_flops ||
            now.gates > before.gates) {
          fail_msg("%s: latency %d, %d flip-flops, %d thirds of a gate; at %s ns %d, %d, %d", whole,
                   now.latency, now.flip_flops, now.gates, clocks[i - 1], before.latency,
                   before.flip_flops, before.gates);
        }
      }
      before = now;
    }
  }
  assert_true(compared > 10 * CONFIGURATIONS && smaller > CONFIGURATIONS);
}

static void expect(const char *options, int latency, int flip_flops) {
  exact_counts counts = {0};
  assert_true(plan_of(options, &counts));
  if (counts.latency != latency || counts.flip_flops != flip_flops) {
    fail_msg("%s: latency %d, %d flip-flops; expected %d, %d", options, counts.latency,
             counts.flip_flops, latency, flip_flops);
  }
}

/* The flip-flops are those that Yosys counts in these designs (make area). */
CASE(counts_of_known_designs) {
  expect("--word=12 --ii=1 --clock-ns=2", 9, 2829);
  expect("--word=18 --ii=1 --clock-ns=2", 9, 4089);
  expect("--word=12 --ii=1 --clock-ns=20", 4, 463);
  expect("--word=12 --ii=1 --clock-ns=100", 4, 463);
  expect("--word=18 --ii=1 --clock-ns=20", 4, 679);
}

/* Adders that are chains of full adders: at clocks that have time for them, and fewer gates. */
CASE(ripple) {
  static const struct {
    const char *options;
    bool ripple;
  } row[] = {
      {"--word=12 --ii=1 --clock-ns=5", false},        {"--word=12 --ii=1 --clock-ns=10", true},
      {"--word=18 --ii=1 --clock-ns=10", true},        {"--word=18 --ii=3 --clock-ns=5", false},
      {"--word=18 --ii=3 --clock-ns=10", true},        {"--word=32 --ii=1 --clock-ns=10", false},
      {"--word=32 --ii=9 --clock-ns=20", true},        {"--word=12 --lanes=2 --clock-ns=20", false},
      {"--word=12 --clearance=1 --clock-ns=20", false}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    exact_counts counts = {0};
    assert_true(plan_of(row[i].options, &counts));
    assert_int_equal(plan->ripple, row[i].ripple);
    if (plan->ripple) {
      plan->ripple = false;
      assert_true(counts.gates < exact_count(plan).gates);
    }
  }
}

CASE(fast_clocks_chain_nothing) {
  for (int word = 5; word <= 20; word += 5) {
    for (int ii = 1; ii <= 9; ii += 2) {
      char options[80];
      exact_counts counts;
      snprintf(options, sizeof options, "--word=%d --ii=%d --clock-ns=2", word, ii);
      if (plan_of(options, &counts)) {
        assert_int_equal(plan->stages.chained, 0);
      }
    }
  }
}

/* What is chained by the delay model ends in the period that was asked for. */
CASE(chains_end_in_their_period) {
  for (int tenths = 21; tenths <= 120; tenths += 3) {
    char options[80];
    exact_counts counts;
    snprintf(options, sizeof options, "--word=%d --ii=%d --clock-ns=%d.%d", 6 + tenths % 15,
             1 + tenths % 4, tenths / 10, tenths % 10);
    if (plan_of(options, &counts) && plan->stages.chained != 0) {
      double time = exact_chain_time(plan, plan->stages.chained);
      if (time > tenths / 10.0) {
        fail_msg("%s: a chain of %g ns", options, time);
      }
    }
  }
}
