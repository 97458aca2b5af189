/* SPDX-License-Identifier: MIT */
/* estimate.c - estimates of designs that were mapped: latency, flip-flops and gates of recorded
 * mappings lie in their intervals; the latency is that of the generator; what is not known. */
#include "estimate.h"
#include "generate.h"
#include "harness.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static sepax_estimate estimate_of(const char *options, sepax_design *design) {
  sepax_estimate e;
  *design = design_of("%s", options);
  fault = (sepax_error){.code = SEPAX_OK};
  assert_works(sepax_estimate_design(design, &e, &fault));
  return e;
}

/* Mapped by synth/area/map to Nangate45, typical (docs/developers/results/area). */
CASE(mapped_designs) {
  static const struct {
    const char *options;
    int latency, flip_flops;
    double gates;
  } row[] = {{"--word=12 --ii=1 --clock-ns=2", 9, 2829, 83800},
             {"--word=18 --ii=1 --clock-ns=2", 9, 4089, 150500},
             {"--word=18 --ii=3 --clock-ns=2", 15, 3294, 73500},
             {"--word=12 --ii=1 --clock-ns=20", 4, 463, 65400},
             {"--word=18 --ii=1 --clock-ns=20", 4, 679, 121900},
             {"--word=18 --ii=3 --clock-ns=10", 10, 2297, 63700}};
  for (size_t i = 0; i < LENGTH(row); i++) {
    sepax_design design;
    sepax_estimate e = estimate_of(row[i].options, &design);
    assert_true(e.gates_known);
    if (e.latency != row[i].latency || fabs(e.gates - row[i].gates) > e.gates_error ||
        fabs(e.flip_flops - row[i].flip_flops) > e.flip_flops_error) {
      fail_msg("%s: latency %d, %g +- %g flip-flops, %g +- %g GE", row[i].options, e.latency,
               e.flip_flops, e.flip_flops_error, e.gates, e.gates_error);
    }
    assert_true(e.gates_error < 0.1 * e.gates && e.flip_flops_error < 0.1 * e.flip_flops);
  }
}

CASE(latency_is_that_of_the_generator) {
  static const char *const options[] = {"--word=8 --ii=3 --clock-ns=7",
                                        "--word=9 --ii=7 --extent-a=50 --extent-b=60",
                                        "--word=7 --ii=2 --clearance=1 --warning=3",
                                        "--word=8 --lanes=3 --clock-ns=4",
                                        "--word=8 --tree=on --clock-ns=4",
                                        "--word=8 --stream=pair",
                                        "--word=8 --ii=1 --target=ecp5 --clock-ns=9",
                                        "--word=8 --arch=paper",
                                        "--word=8 --arch=conference"};
  for (size_t i = 0; i < LENGTH(options); i++) {
    sepax_design design;
    sepax_estimate e = estimate_of(options[i], &design);
    char where[PATH_BYTES];
    snprintf(where, sizeof where, "%s/%zu", folder, i);
    assert_works(sepax_generate(&design, where, &(sepax_output){NULL}, &fault));
    assert_int_equal(e.latency, design.latency);
    bool cells =
        design.config.arch == SEPAX_ARCH_EXACT && design.config.target == SEPAX_TARGET_ASIC;
    assert_int_equal(e.gates_known, cells);
  }
}

CASE(rates) {
  sepax_design design;
  sepax_estimate e = estimate_of("--word=12 --ii=3 --clock-ns=4 --lanes=8 --cores=2", &design);
  assert_true(fabs(e.pairs - 2e9 / 12) < 1 && fabs(e.compared - 2e9) < 1);
  assert_true(e.memory_bits == sepax_memory_bits(&design.config) && e.memory_bits > 0);
}

CASE(refused) {
  sepax_estimate e;
  sepax_design design = design_of("--word=18 --clock-ns=0.6");
  assert_false(sepax_estimate_design(&design, &e, &fault));
  assert_non_null(strstr(fault.text, "too short"));
  fault = (sepax_error){.code = SEPAX_OK};
  design = design_of("--arch=float64");
  assert_false(sepax_estimate_design(&design, &e, &fault));
  assert_non_null(strstr(fault.text, "has no hardware"));
  fault = (sepax_error){.code = SEPAX_OK};
}
